#pragma once

#include <cstdint>
#include <vector>

#include <scalebreak/dem/kernel/kernel.hpp>

namespace scalebreak::dem {

/// A contact as it is carried from one list of pairs to the next.
struct Remembered {
  std::uint32_t first = 0, second = 0;  ///< places of the spheres; of a wall's pair the second is not used
  std::uint8_t state = touching;
  double begun = 0;
  Quad slide, roll;
};

/// A list of near pairs with what they remember, as the kernel works on it.
struct Pairs {
  std::vector<std::uint32_t> first, second;  ///< second: packed
  std::vector<std::uint8_t> state;
  std::vector<double> reach_squared, begun;
  std::vector<std::uint32_t> row;
  std::vector<Quad> slide, roll;
  std::uint32_t count = 0;

  [[nodiscard]] PairsView view();
  /// Makes room for so many pairs in `first` and `second`.
  void reserve(std::size_t pairs);
  /// All pairs in `first` and `second` up to `pairs` are apart from now on.
  void reset(std::uint32_t pairs, bool slides, bool rolls);
  /// What is not apart, in the order of the list.
  [[nodiscard]] std::vector<Remembered> remember() const;
  /// Puts it back; both lists are sorted by their first spheres. `place` is called with the pair's number. Throws std::logic_error if a
  /// contact is not in the list.
  template <class Place>
  void recall(const std::vector<Remembered>& contacts, bool wall, Place place);
  [[nodiscard]] std::size_t bytes() const;

 private:
  [[nodiscard]] std::uint32_t find(const Remembered& contact, bool wall, std::uint32_t from) const;
  void put(std::uint32_t pair, const Remembered& contact);
};

template <class Place>
void Pairs::recall(const std::vector<Remembered>& contacts, bool wall, Place place) {
  std::uint32_t from = 0;
  for (const Remembered& contact : contacts) {
    while (from < count && first[from] < contact.first) ++from;
    const std::uint32_t pair = find(contact, wall, from);
    put(pair, contact);
    place(pair);
  }
}

}  // namespace scalebreak::dem
