#pragma once

#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <scalebreak/base/bytes.hpp>

namespace scalebreak {

/// Appends a list of plain values as they lie in the memory of this machine, behind their number.
template <class T, class Memory>
void put_list(std::string& bytes, const std::vector<T, Memory>& list) {
  put_text(bytes, {reinterpret_cast<const char*>(list.data()), list.size() * sizeof(T)});
}

/// Takes such a list off the front. WorkError where it is cut short.
template <class T, class Memory>
void take_list(std::string_view& bytes, std::vector<T, Memory>& list) {
  const std::string taken = take_text(bytes);
  list.resize(taken.size() / sizeof(T));
  if (!list.empty()) std::memcpy(static_cast<void*>(list.data()), taken.data(), list.size() * sizeof(T));  // nothing has no place
}

}  // namespace scalebreak
