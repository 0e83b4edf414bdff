#pragma once

#include <cstdint>

#include <scalebreak/base/large_list.hpp>
#include <scalebreak/dem/kernel/kernel.hpp>

namespace scalebreak::dem {

/// A contact with all that it remembers.
struct Contact {
  std::uint32_t first = 0, second = 0;  ///< places of the spheres, the second packed; of a wall's contact it is not used
  std::uint8_t state = touching;
  std::uint32_t row = 0;
  double begun = 0;  ///< time of first touch [s]
  Quad slide, roll;
};

/// Vectors in the order that the kernel reads them in (see history_place).
class Histories {
 public:
  void grow(std::size_t contacts) {
    const std::size_t size = (contacts + history_stride - 1) / history_stride * 3 * history_stride;
    values_.reserve(size), values_.resize(size);
  }
  [[nodiscard]] Quad get(std::uint32_t k) const {
    const double* const x = values_.data() + history_place(k);
    return {x[0], x[history_stride], x[2 * history_stride], 0};
  }
  void put(std::uint32_t k, const Quad& v) {
    double* const x = values_.data() + history_place(k);
    x[0] = v.x, x[history_stride] = v.y, x[2 * history_stride] = v.z;
  }
  [[nodiscard]] LargeList<double>& values() { return values_; }
  [[nodiscard]] std::size_t bytes() const { return values_.capacity() * sizeof(double); }

 private:
  LargeList<double> values_;
};

/// The contacts of a list, as the kernel works on them.
struct Contacts {
  LargeList<std::uint32_t> first, second, row;
  LargeList<std::uint8_t> state;
  LargeList<double> begun;
  Histories slide, roll;
  std::uint32_t count = 0, sorted = 0;  ///< so many of them are in the order of their first spheres
  bool slides = false, rolls = false;   ///< do they remember these?

  [[nodiscard]] ContactsView view();
  [[nodiscard]] Contact get(std::uint32_t k) const;
  void put(std::uint32_t k, const Contact& contact);
  void add(const Contact& contact);
  /// Forgets what is apart, and puts the rest in the order of their first spheres.
  void tidy();
  void clear() { count = sorted = 0; }
  [[nodiscard]] std::size_t bytes() const;
};

/// Near pairs and contacts: the spheres that may act on each other before the list is made anew.
struct Pairs {
  LargeList<std::uint32_t> near_first, near_second;  ///< second: packed
  std::uint32_t near_count = 0;
  Contacts contacts;

  [[nodiscard]] NearView near() { return {near_count, near_first.data(), near_second.data()}; }
  [[nodiscard]] std::uint32_t count() const { return near_count + contacts.count; }
  /// Makes room for so many near pairs.
  void reserve(std::size_t pairs);
  /// Takes the contacts, which are tidy, out of the near pairs, and sees them in the image that the near pair has. Throws
  /// std::logic_error if a contact is not among the near pairs.
  void part_contacts_from_near(bool wall);
  [[nodiscard]] std::size_t bytes() const;
};

}  // namespace scalebreak::dem
