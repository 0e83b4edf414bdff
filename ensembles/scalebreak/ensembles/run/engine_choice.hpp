#pragma once

#include <string>

#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// The engine that a flow is run by, and why, in words.
struct EngineChoice {
  std::string engine, reason;
};

/// What tables of collisions take at most to be made, when they are asked for the first time [s].
inline constexpr double tables_seconds = 60;

/// `engine` itself if it is one; of "auto", "hybrid" where it is expected to save more than `worth` seconds, else "dem". The choice follows
/// from the input alone. Throws InputError.
[[nodiscard]] EngineChoice choose_engine(const std::string& engine, const Input& input, int threads, double worth = tables_seconds);

}  // namespace scalebreak
