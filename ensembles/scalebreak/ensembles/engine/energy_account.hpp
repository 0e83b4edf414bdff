#pragma once

#include <optional>
#include <string>

#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// Why the soft-sphere engine cannot close the account of energy of a flow, in words, or nothing where it can: where no law takes energy
/// (restitution 1, nothing that tears, nothing tangential, no rolling, no liquid), and no images move, whose work is known at samples
/// alone.
[[nodiscard]] std::optional<std::string> why_account_is_open(const Input& input);

}  // namespace scalebreak
