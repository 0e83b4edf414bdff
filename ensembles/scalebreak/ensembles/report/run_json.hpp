#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include <scalebreak/ensembles/run/run_flow.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// Which laws act in a flow, and whether spins are followed and why.
[[nodiscard]] std::string modelled(const Input& input);

/// Where the contact time that bounds the step comes from: a table, or an exact collision, and then why.
[[nodiscard]] std::string contact_time_source(const ShortestContact& contact);

/// The result of a run as one object: what ran, how far, how fast, and every measured quantity with its error.
[[nodiscard]] nlohmann::json run_json(const Input& input, const RunOutcome& outcome);

}  // namespace scalebreak
