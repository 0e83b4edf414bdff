#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <scalebreak/ensembles/breakdown/study_result.hpp>
#include <scalebreak/output/csv.hpp>

namespace scalebreak {

/// A row for each quantity of each cell: what the cell is, the value, what the law claims, the deviation from it, all with standard errors, and what the cell cost.
[[nodiscard]] Csv study_csv(const StudyResult& study, const std::string& parameter);

/// What `scalebreak breakdown --json` prints; null where there is no number.
[[nodiscard]] nlohmann::json study_json(const StudyResult& study, const std::string& parameter);

/// Columns of study_csv, from 1, for plots.
namespace study_column {
inline constexpr const char *law = "1", *factor = "2", *engine = "3", *volume_fraction = "4", *value = "6", *quantity = "7",
                            *deviation = "13", *deviation_error = "14", *wall_time = "21", *measured_time = "18", *coordination = "23",
                            *patch_fraction = "24";
}  // namespace study_column

}  // namespace scalebreak
