#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <scalebreak/ensembles/stability/stability_study.hpp>

namespace scalebreak {

/// A row a record: the largest stable step beside Rayleigh's and the oscillation's.
[[nodiscard]] std::string stability_csv(const StabilityStudy& study);
/// A row a trial.
[[nodiscard]] std::string trials_csv(const StabilityStudy& study);
/// The same as stability_csv as one object, with what was tried.
[[nodiscard]] nlohmann::json stability_json(const Input& input, const StabilityStudy& study);

/// A record as a person reads it.
[[nodiscard]] std::string in_words(const StabilityStudy& study, const StabilityRecord& record);

/// Writes stability.csv, trials.csv, the plots largest_step and energy_growth or motion_error, and index.html. Gives the names of plots that could not be
/// drawn.
[[nodiscard]] std::vector<std::string> write_stability_report(const Input& input, const StabilityStudy& study,
                                                              const std::filesystem::path& out);

}  // namespace scalebreak
