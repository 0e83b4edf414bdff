#pragma once

#include <cstdint>
#include <random>

namespace scalebreak {

/// The next word of SplitMix64 (Steele, Lea & Flood 2014), which moves the state on.
[[nodiscard]] inline std::uint64_t split_mix(std::uint64_t& state) {
  std::uint64_t word = state += 0x9e3779b97f4a7c15;
  word = (word ^ (word >> 30)) * 0xbf58476d1ce4e5b9;
  word = (word ^ (word >> 27)) * 0x94d049bb133111eb;
  return word ^ (word >> 31);
}

/// A stream of random words of its own for each purpose and replica of a seed: whoever else draws, and how many threads there
/// are, changes nothing in it.
[[nodiscard]] inline std::mt19937_64 random_stream(std::uint64_t seed, std::uint64_t purpose, std::uint64_t replica) {
  std::uint64_t state = seed;
  for (const std::uint64_t next : {purpose, replica}) state = split_mix(state) ^ next;
  return std::mt19937_64(split_mix(state));
}

}  // namespace scalebreak
