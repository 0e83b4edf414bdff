#pragma once

#include <string>
#include <vector>

#include <scalebreak/scene/input.hpp>
#include <scalebreak/scene/value.hpp>

namespace scalebreak {

/// Makes an Input of what was given; the last word on a key counts, so that settings follow the file. Fills in defaults:
/// [second] and [wall] from [material], the dashpot and the range from the normal law.
/// Throws InputError, one sentence: where, key, found, allowed; wrong values before missing ones before impossible
/// combinations.
[[nodiscard]] Input resolve_input(const std::vector<Assignment>& given);

/// The resolved input as TOML; reading it gives the same Input.
[[nodiscard]] std::string write_input(const Input& input);

/// Every key with its default, unit, meaning and what is allowed, as TOML.
[[nodiscard]] std::string describe_keys();

}  // namespace scalebreak
