#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

namespace scalebreak {

/// Memory in large pages, where the system has them, for lists that are read in more than one place at a time: small pages would have to be
/// looked up again and again. Lists below half a page begin at a cache line, those of a few numbers where they may.
template <class T>
struct LargePages {
  using value_type = T;
  LargePages() = default;
  template <class Other>
  LargePages(const LargePages<Other>&) {}

  [[nodiscard]] T* allocate(std::size_t count) {
    constexpr std::size_t page = 2u << 20;
    const std::size_t wanted = count * sizeof(T), unit = wanted < page / 2 ? 64 : page, bytes = (wanted + unit - 1) / unit * unit;
    void* const memory = wanted < 1024 && alignof(T) <= alignof(std::max_align_t) ? std::malloc(wanted) : std::aligned_alloc(unit, bytes);
    if (memory == nullptr) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
    if (unit == page) madvise(memory, bytes, MADV_HUGEPAGE);  // advice: where it is not taken, all is as without
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }
  friend bool operator==(const LargePages&, const LargePages&) { return true; }
};

template <class T>
using LargeList = std::vector<T, LargePages<T>>;

}  // namespace scalebreak
