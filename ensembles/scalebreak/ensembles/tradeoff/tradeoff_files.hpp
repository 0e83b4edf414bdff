#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <scalebreak/ensembles/tradeoff/collision_tradeoff.hpp>
#include <scalebreak/ensembles/tradeoff/flow_tradeoff.hpp>
#include <scalebreak/ensembles/tradeoff/method_tradeoff.hpp>

namespace scalebreak {

/// Write tradeoff.csv, front.csv of a collision, plots and index.html into `out`; `title` names the scene. Returns the plots that could not be drawn.
std::vector<std::string> write_tradeoff(const CollisionTradeoff& study, const std::string& title, const std::filesystem::path& out);
std::vector<std::string> write_tradeoff(const FlowTradeoff& study, const std::string& title, const std::filesystem::path& out);
/// Writes tradeoff.csv, front_work.csv, front_time.csv, plots and index.html. `seed` is run.seed, for the rows.
std::vector<std::string> write_tradeoff(const MethodTradeoff& study, std::uint64_t seed, const std::string& title,
                                        const std::filesystem::path& out);

/// "error ∝ step_fraction^(1.02 ± 0.03)"; "too few settings to tell".
[[nodiscard]] std::string in_words(const ConvergenceOrder& order, const std::string& setting);

}  // namespace scalebreak
