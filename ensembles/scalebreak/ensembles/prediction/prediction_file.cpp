#include <scalebreak/ensembles/prediction/prediction_file.hpp>

#include <cmath>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/base/version.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/scene/materials.hpp>

namespace scalebreak {
namespace {

using nlohmann::json;

constexpr int format = 1;

json terms_json(const QuantityModel& model) {
  json terms = json::object();
  for (std::size_t i = 0; i < term_count; ++i) {
    terms[deviation_terms[i].name] = {{"coefficient", model.coefficients[i]},
                                      {"error", std::sqrt(model.covariance[i][i])},
                                      {"fitted", model.fitted[i]},
                                      {"covariance", model.covariance[i]}};
  }
  return terms;
}

}  // namespace

json validation_json(const Validation& v) {
  return {{"rows", v.rows},
          {"rms", v.rms},
          {"rms_over_error", v.rms_over_error},
          {"off", v.off},
          {"within_factor_1_5", v.within_factor},
          {"softened_off", v.softened_off},
          {"softened_within_factor_1_5", v.softened_within_factor},
          {"share_within_factor_1_5", v.off > 0 ? json(static_cast<double>(v.within_factor) / static_cast<double>(v.off)) : json()}};
}

json model_json(const DeviationModel& model) {
  json quantities = json::object(), ranges = json::object(), terms = json::object();
  for (const QuantityModel& q : model.quantities) {
    const Validation& v = model.validation.at(q.quantity);
    quantities[q.quantity] = {
        {"size_excess", size_excess(q.quantity)}, {"terms", terms_json(q)}, {"scatter", q.scatter}, {"held_back", validation_json(v)}};
  }
  for (const auto& [name, range] : model.ranges) ranges[name] = {range.least, range.largest};
  for (const DeviationTerm& term : deviation_terms) terms[term.name] = term.what;
  json held_back = validation_json(together(model.validation));
  held_back["cells_off"] = model.cells_off;
  return {{"format", format},
          {"version", version()},
          {"terms", terms},
          {"quantities", quantities},
          {"ranges", ranges},
          {"split", {{"seed", model.seed}, {"rows_fitted", model.rows_fitted}, {"rows_held_back", model.rows_held_back}}},
          {"held_back", held_back},
          {"studies", model.studies},
          {"study_versions", model.versions}};
}

DeviationModel model_from_json(const json& from, const std::string& place) {
  DeviationModel model;
  try {
    if (from.at("format") != format)
      throw InputError(fmt::format("{}: format: found {}; allowed: {}", place, from.at("format").dump(), format));
    for (const auto& [name, entry] : from.at("quantities").items()) {
      QuantityModel q{.quantity = name, .scatter = entry.at("scatter")};
      for (std::size_t i = 0; i < term_count; ++i) {
        const json& term = entry.at("terms").at(deviation_terms[i].name);
        q.coefficients[i] = term.at("coefficient"), q.fitted[i] = term.at("fitted"), q.covariance[i] = term.at("covariance");
      }
      const json& v = entry.at("held_back");
      model.validation[name] = {v.at("rows"),
                                v.at("rms"),
                                v.at("rms_over_error"),
                                v.at("off"),
                                v.at("within_factor_1_5"),
                                v.at("softened_off"),
                                v.at("softened_within_factor_1_5")};
      model.quantities.push_back(q);
    }
    for (const auto& [name, range] : from.at("ranges").items()) model.ranges[name] = {range.at(0), range.at(1)};
    model.seed = from.at("split").at("seed");
    model.rows_fitted = from.at("split").at("rows_fitted"), model.rows_held_back = from.at("split").at("rows_held_back");
    model.cells_off = from.at("held_back").at("cells_off");
    model.studies = from.at("studies"), model.versions = from.at("study_versions");
  } catch (const json::exception& error) {
    throw InputError(
        fmt::format("{} is no fitted prediction ({}); allowed: what scalebreak advise --fit has written", place, error.what()));
  }
  return model;
}

std::filesystem::path default_model_path() { return data_folder() / "reference" / "prediction.json"; }

DeviationModel read_model(const std::filesystem::path& path) {
  const auto text = read_file(path);
  if (!text)
    throw InputError(
        fmt::format("{} cannot be read; allowed: a file that scalebreak advise --fit has written from finished studies", path.string()));
  return model_from_json(json::parse(*text, nullptr, false), path.string());
}

}  // namespace scalebreak
