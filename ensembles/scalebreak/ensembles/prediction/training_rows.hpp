#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <scalebreak/ensembles/prediction/scale_groups.hpp>
#include <scalebreak/measure/flow_result.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// A judged quantity of a cell of a finished study.
struct TrainingRow {
  std::string study;  ///< name of its folder
  std::string law, point;
  double factor = 1;
  std::uint64_t key = 0;  ///< of the cell
  std::string quantity;
  ScaleGroups original, scaled;
  Measured deviation;   ///< value / claim − 1; NaN where it has not been measured
  std::string version;  ///< of the program that ran it
};

struct TrainingRows {
  std::vector<TrainingRow> rows;
  int without_error = 0;  ///< rows that were left out, since their errors are not known
};

/// Adds the rows of a study's folder: its study.csv, and input.toml, from which the groups of each cell follow. Throws InputError, with file and line, where the
/// two do not go together.
void add_study(TrainingRows& to, const std::filesystem::path& folder);

/// The rows that the study of an input would have, before it runs. Throws InputError where it is no study.
[[nodiscard]] TrainingRows forecast_rows(const Input& input, const std::string& name);

}  // namespace scalebreak
