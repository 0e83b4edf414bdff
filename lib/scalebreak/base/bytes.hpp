#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include <Eigen/Core>

#include <scalebreak/base/error.hpp>

namespace scalebreak {

/// Appends a value as it lies in the memory of this machine: for checkpoints.
template <class T>
requires std::is_arithmetic_v<T>
void put_bytes(std::string& bytes, T value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); }

/// Takes such a value off the front. WorkError where too little is left.
template <class T>
requires std::is_arithmetic_v<T>
void take_bytes(std::string_view& bytes, T& value) {
  if (bytes.size() < sizeof value) throw WorkError("a saved state is cut short; start from an earlier one");
  std::memcpy(&value, bytes.data(), sizeof value);
  bytes.remove_prefix(sizeof value);
}

/// A value that there may be none of.
template <class T>
requires std::is_arithmetic_v<T>
void put_bytes(std::string& bytes, const std::optional<T>& value) {
  put_bytes(bytes, value.has_value()), put_bytes(bytes, value.value_or(T{}));
}

template <class T>
requires std::is_arithmetic_v<T>
void take_bytes(std::string_view& bytes, std::optional<T>& value) {
  bool known = false;
  T taken{};
  take_bytes(bytes, known), take_bytes(bytes, taken);
  value = known ? std::optional(taken) : std::nullopt;
}

inline void put_bytes(std::string& bytes, const Eigen::ArrayXd& values) {
  put_bytes(bytes, values.size());
  for (const double value : values) put_bytes(bytes, value);
}

inline void take_bytes(std::string_view& bytes, Eigen::ArrayXd& values) {
  Eigen::Index size = 0;
  take_bytes(bytes, size);
  if (size < 0 || static_cast<std::size_t>(size) > bytes.size() / sizeof(double)) {
    throw WorkError("a saved state is cut short; start from an earlier one");
  }
  values.resize(size);
  for (double& value : values) take_bytes(bytes, value);
}

/// A text of any length, behind its length.
inline void put_text(std::string& bytes, std::string_view text) {
  put_bytes(bytes, static_cast<std::uint64_t>(text.size()));
  bytes.append(text);
}

[[nodiscard]] inline std::string take_text(std::string_view& bytes) {
  std::uint64_t size = 0;
  take_bytes(bytes, size);
  if (size > bytes.size()) throw WorkError("a saved state is cut short; start from an earlier one");
  std::string text(bytes.substr(0, size));
  bytes.remove_prefix(size);
  return text;
}

}  // namespace scalebreak
