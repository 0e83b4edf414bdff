#include <scalebreak/dem/lists/pairs.hpp>

#include <stdexcept>

namespace scalebreak::dem {

PairsView Pairs::view() {
  return {.count = count,
          .first = first.data(),
          .second = second.data(),
          .state = state.data(),
          .reach_squared = reach_squared.data(),
          .row = row.data(),
          .begun = begun.data(),
          .slide = slide.empty() ? nullptr : slide.data(),
          .roll = roll.empty() ? nullptr : roll.data()};
}

void Pairs::reserve(std::size_t pairs) {
  if (first.size() >= pairs) return;
  first.resize(pairs);
  second.resize(pairs);
}

void Pairs::reset(std::uint32_t pairs, bool slides, bool rolls) {
  count = pairs;
  state.assign(count, apart);
  reach_squared.resize(count);
  begun.resize(count);
  row.resize(count);
  // One more, so that a list without pairs still has histories.
  if (slides) slide.resize(count + 1);
  if (rolls) roll.resize(count + 1);
}

std::vector<Remembered> Pairs::remember() const {
  std::vector<Remembered> contacts;
  for (std::uint32_t k = 0; k < count; ++k) {
    if (state[k] == apart) continue;
    Remembered contact{.first = first[k], .second = sphere_of(second[k]), .state = state[k], .begun = begun[k]};
    if (!slide.empty()) contact.slide = slide[k];
    if (!roll.empty()) contact.roll = roll[k];
    contacts.push_back(contact);
  }
  return contacts;
}

std::uint32_t Pairs::find(const Remembered& contact, bool wall, std::uint32_t from) const {
  for (std::uint32_t k = from; k < count && first[k] == contact.first; ++k) {
    if (wall || sphere_of(second[k]) == contact.second) return k;
  }
  throw std::logic_error("a contact was lost when the list of near pairs was made anew");
}

void Pairs::put(std::uint32_t pair, const Remembered& contact) {
  state[pair] = contact.state;
  begun[pair] = contact.begun;
  if (!slide.empty()) slide[pair] = contact.slide;
  if (!roll.empty()) roll[pair] = contact.roll;
}

std::size_t Pairs::bytes() const {
  return (first.capacity() + second.capacity() + row.capacity()) * sizeof(std::uint32_t) + state.capacity() +
         (reach_squared.capacity() + begun.capacity()) * sizeof(double) + (slide.capacity() + roll.capacity()) * sizeof(Quad);
}

}  // namespace scalebreak::dem
