#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

#include <scalebreak/ensembles/prediction/model_fit.hpp>

namespace scalebreak {

/// A fitted model as the JSON that is kept: coefficients with standard errors and covariances, ranges of the groups, seed of the split, how it did on the
/// cells held back, and the versions that ran the studies.
[[nodiscard]] nlohmann::json model_json(const DeviationModel& model);

/// How a model does on rows that it was not fitted to.
[[nodiscard]] nlohmann::json validation_json(const Validation& validation);

/// The model back. Throws InputError, naming `place`, where something is missing or the terms are others.
[[nodiscard]] DeviationModel model_from_json(const nlohmann::json& json, const std::string& place);

/// The folder data/reference has the model that the program goes by.
[[nodiscard]] std::filesystem::path default_model_path();

/// Reads a file. Throws InputError where it is missing or damaged.
[[nodiscard]] DeviationModel read_model(const std::filesystem::path& path);

}  // namespace scalebreak
