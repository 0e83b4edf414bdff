#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <scalebreak/ensembles/prediction/model_fit.hpp>
#include <scalebreak/output/csv.hpp>

namespace scalebreak {

/// What rows are to a model: those that it was fitted to or that were held back from the fit, those of studies that it has not seen, or those of a study
/// that has not run.
enum class RowsAre { fitted_to, unseen, not_run };

/// A row for each row of the studies: predicted and measured deviation with their errors, what the row is to the model, and the groups.
[[nodiscard]] Csv prediction_csv(const DeviationModel& model, const TrainingRows& training, RowsAre rows = RowsAre::fitted_to);

/// How a model did on rows that it was not fitted to, one a quantity.
[[nodiscard]] std::vector<std::string> sentences(const std::map<std::string, Validation>& validation);

/// What is expected of the cells of a study that has not run, one a cell.
[[nodiscard]] std::vector<std::string> forecast_sentences(const DeviationModel& model, const TrainingRows& forecast);

/// Writes prediction.csv and, of rows that are measured, a plot of predicted over measured with error bars for each quantity. Returns the plots that could
/// not be drawn.
std::vector<std::string> write_rows(const DeviationModel& model, const TrainingRows& rows, RowsAre are, const std::filesystem::path& out);

}  // namespace scalebreak
