#pragma once

#include <stdexcept>

namespace scalebreak {

/// The input is wrong: one sentence for a person, with where, key, found and allowed. Exit status 2.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The work failed: one sentence with the physics that failed. Exit status 1.
struct WorkError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace scalebreak
