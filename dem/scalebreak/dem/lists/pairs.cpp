#include <scalebreak/dem/lists/pairs.hpp>

#include <algorithm>
#include <stdexcept>

namespace scalebreak::dem {

namespace {

/// Beyond the last contact, so that whole packs can be read and written.
constexpr std::size_t spare = 8;

}  // namespace

ContactsView Contacts::view() {
  return {.count = count,
          .first = first.data(),
          .second = second.data(),
          .state = state.data(),
          .row = row.data(),
          .slide = slides ? slide.values().data() : nullptr,
          .roll = rolls ? roll.values().data() : nullptr};
}

Contact Contacts::get(std::uint32_t k) const {
  return {first[k], second[k], state[k], row[k], begun[k], slides ? slide.get(k) : Quad{}, rolls ? roll.get(k) : Quad{}};
}

void Contacts::put(std::uint32_t k, const Contact& contact) {
  first[k] = contact.first, second[k] = contact.second, state[k] = contact.state, row[k] = contact.row, begun[k] = contact.begun;
  if (slides) slide.put(k, contact.slide);
  if (rolls) roll.put(k, contact.roll);
}

void Contacts::add(const Contact& contact) {
  if (first.size() < count + 1 + spare) {
    const std::size_t room = count + count / 4 + 1 + spare;
    const auto grow = [&](auto& list) { list.reserve(room), list.resize(room); };
    grow(first), grow(second), grow(row), grow(state), grow(begun);
    if (slides) slide.grow(room);
    if (rolls) roll.grow(room);
  }
  put(count++, contact);
}

void Contacts::tidy() {
  std::vector<Contact> late;
  for (std::uint32_t k = sorted; k < count; ++k) {
    if (state[k] != apart) late.push_back(get(k));
  }
  std::stable_sort(late.begin(), late.end(), [](const Contact& a, const Contact& b) { return a.first < b.first; });
  std::uint32_t kept = 0;
  for (std::uint32_t k = 0; k < sorted; ++k) {
    if (state[k] == apart) continue;
    if (kept != k) put(kept, get(k));
    ++kept;
  }
  // From the back, so that nothing is overwritten before it has moved.
  count = sorted = kept + static_cast<std::uint32_t>(late.size());
  for (std::uint32_t to = count; !late.empty();) {
    if (kept > 0 && first[kept - 1] > late.back().first) {
      put(--to, get(--kept));
    } else {
      put(--to, late.back());
      late.pop_back();
    }
  }
}

std::size_t Contacts::bytes() const {
  return (first.capacity() + second.capacity() + row.capacity()) * sizeof(std::uint32_t) + state.capacity() +
         begun.capacity() * sizeof(double) + slide.bytes() + roll.bytes();
}

void Pairs::reserve(std::size_t pairs) {
  if (near_first.size() >= pairs) return;
  near_first.resize(pairs);
  near_second.resize(pairs);
}

void Pairs::part_contacts_from_near(bool wall) {
  std::uint32_t from = 0;
  for (std::uint32_t k = 0; k < contacts.count; ++k) {
    const std::uint32_t first = contacts.first[k], second = sphere_of(contacts.second[k]);
    while (from < near_count && near_first[from] < first) ++from;
    std::uint32_t pair = from;
    const auto is_it = [&] { return wall || (near_second[pair] != nowhere && sphere_of(near_second[pair]) == second); };
    while (pair < near_count && near_first[pair] == first && !is_it()) ++pair;
    if (pair == near_count || near_first[pair] != first)
      throw std::logic_error("a contact was lost when the list of near pairs was made anew");
    contacts.second[k] = near_second[pair];
    near_second[pair] = nowhere;
  }
  std::uint32_t kept = 0;
  for (std::uint32_t pair = 0; pair < near_count; ++pair) {
    near_first[kept] = near_first[pair], near_second[kept] = near_second[pair];
    kept += near_second[pair] != nowhere ? 1u : 0u;
  }
  near_count = kept;
}

std::size_t Pairs::bytes() const { return (near_first.capacity() + near_second.capacity()) * sizeof(std::uint32_t) + contacts.bytes(); }

}  // namespace scalebreak::dem
