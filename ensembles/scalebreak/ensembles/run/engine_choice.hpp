#pragma once

#include <string>

#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// The engine that a flow is run by, and why, in words.
struct EngineChoice {
  std::string engine, reason;
};

/// `engine` itself if it is one; of "auto", "hybrid" where it is expected to save more than its tables may take to make, else "dem". The
/// choice follows from the input alone. Throws InputError.
[[nodiscard]] EngineChoice choose_engine(const std::string& engine, const Input& input, int threads);

}  // namespace scalebreak
