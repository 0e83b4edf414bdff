#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <scalebreak/ensembles/prediction/model_fit.hpp>
#include <scalebreak/output/csv.hpp>

namespace scalebreak {

/// A row for each row of the studies: predicted and measured deviation with their errors, whether it was held back, and the groups.
[[nodiscard]] Csv prediction_csv(const DeviationModel& model, const TrainingRows& training);

/// How the model does on what was held back, in sentences, one a quantity.
[[nodiscard]] std::vector<std::string> sentences(const DeviationModel& model);

/// Writes prediction.json, prediction.csv and a plot of predicted over measured with error bars. Returns the plots that could not be drawn.
std::vector<std::string> write_prediction(const DeviationModel& model, const TrainingRows& training, const std::filesystem::path& out);

}  // namespace scalebreak
