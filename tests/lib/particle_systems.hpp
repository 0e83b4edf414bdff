#pragma once

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <lib/surroundings.hpp>
#include <scalebreak/base/error.hpp>
#include <scalebreak/scene/system.hpp>

namespace scalebreak::tests {

/// Three spheres with numbers that need all their digits.
inline System three_spheres() {
  System system;
  system.time = 0.1;
  system.cell = {.size = {1.0 / 3, 0.7, 1.1}, .boundary = {Boundary::periodic, Boundary::open, Boundary::periodic}};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<double>(i);
    system.radius.push_back(1e-3 / (k + 3));
    system.material.push_back(static_cast<std::uint8_t>(i % 2));
    system.mass.push_back(std::numbers::pi * 1e-6 * (k + 1));
    system.position.emplace_back(0.1 * std::sqrt(k + 1), 0.1 * k + 1.0 / 7, std::exp(-k));
    system.velocity.emplace_back(-1.0 / (k + 7), 1e-30 * std::numbers::pi, 1e5 / 3);
    system.spin.emplace_back(std::sin(k), 0, -std::cos(k) * 1e4);
  }
  return system;
}

inline void expect_same_spheres(const System& read, const System& written) {
  EXPECT_EQ(read.radius, written.radius);
  EXPECT_EQ(read.mass, written.mass);
  EXPECT_EQ(read.material, written.material);
  EXPECT_EQ(read.position, written.position);
  EXPECT_EQ(read.velocity, written.velocity);
  EXPECT_EQ(read.spin, written.spin);
}

/// The sentence with which a file of that content is refused, without the folder.
template <class Read>
std::string refusal(Read read, const std::string& name, const std::string& content) {
  const TemporaryFolder folder;
  put_file(folder / name, content);
  try {
    (void)read((folder / name).string());
  } catch (const InputError& error) {
    std::string sentence = error.what();
    const std::string path = folder.path().string() + "/";
    if (const auto at = sentence.find(path); at != std::string::npos) sentence.erase(at, path.size());
    return sentence;
  }
  return "(accepted)";
}

template <class Read>
System read_back(Read read, const std::string& name, const std::string& content) {
  const TemporaryFolder folder;
  put_file(folder / name, content);
  return read((folder / name).string());
}

}  // namespace scalebreak::tests
