#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <scalebreak/ensembles/run/run_flow.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// A measured quantity as a person reads it: "1.23e-05 ± 2e-07 m2/s2".
[[nodiscard]] std::string in_words(const Quantity& quantity);

/// Draws the series of a run over time and, between walls, the profiles over the height, and writes index.html, all beside the run's
/// files. Gives the names of plots that could not be drawn.
[[nodiscard]] std::vector<std::string> write_run_report(const Input& input, const RunOutcome& outcome, const std::filesystem::path& out);

}  // namespace scalebreak
