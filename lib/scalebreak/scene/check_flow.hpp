#pragma once

#include <string>

#include <scalebreak/scene/given.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// Is a key of [particles] or [cell] given?
[[nodiscard]] bool begins_flow(const Given& given);

/// Does this key stand in a flow only?
[[nodiscard]] bool of_flow_only(const std::string& dotted);

/// Does this key hold in a flow as it is? Not those of other scenes, what a particle file says itself, and what nothing uses.
[[nodiscard]] bool holds_in_flow(const Input& input, const std::string& dotted);

/// Throws InputError where a key of a flow is given beside a pair or bodies.
void refuse_flow_keys(const Given& given);

/// Throws InputError where a flow stands beside keys of a pair or bodies, or lacks what has no default.
void check_flow_is_whole(const Input& input, const Given& given);

/// Fills in what depends on other keys of a flow and looks for what cannot go together. Throws InputError.
void complete_and_check_flow(Input& input, const Given& given);

}  // namespace scalebreak
