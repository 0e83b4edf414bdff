#include <scalebreak/ensembles/prediction/prediction_report.hpp>

#include <cmath>

#include <fmt/format.h>

#include <scalebreak/collisions/normal/pair_collision.hpp>
#include <scalebreak/ensembles/breakdown/study_quantities.hpp>
#include <scalebreak/ensembles/prediction/prediction_file.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/output/plot.hpp>

namespace scalebreak {
namespace {

const QuantityModel& model_of(const DeviationModel& model, const std::string& quantity) {
  for (const QuantityModel& each : model.quantities) {
    if (each.quantity == quantity) return each;
  }
  return model.quantities.front();
}

const char* part_of(const DeviationModel& model, const TrainingRow& row) {
  if (beyond_model(row.scaled) > 0) return row.scaled.overlap > deep_overlap ? "too_deep" : "lumps";
  return held_back(model.seed, row.key) ? "held_back" : "fitted";
}

/// Predicted over measured ratios value/claim of one quantity, or of all, held back and fitted apart.
Plot plot_of(const DeviationModel& model, const std::string& quantity) {
  Plot plot{.name = "predicted_" + quantity,
            .title = fmt::format("{}: what the dimensionless groups say, over what was measured", study_quantity(quantity).what),
            .x_label = "measured value / claim",
            .y_label = "predicted value / claim",
            .log_x = true,
            .log_y = true,
            .curves = {}};
  const auto only = [&](const char* part) { return fmt::format("strcol(7) eq '{}' && strcol(6) eq '{}'", quantity, part); };
  plot.curves.push_back({.file = "prediction.csv", .x = "(1+$8)", .y = "(1+$8)", .title = "as measured"});
  plot.curves.push_back({.file = "prediction.csv",
                         .x = "(1+$8)",
                         .y = "(1+$10)",
                         .title = fmt::format("held back, {} cells", model.validation.at(quantity).rows),
                         .points = true,
                         .style = 1,
                         .only = only("held_back"),
                         .error = "(sqrt($9**2+$11**2))"});
  plot.curves.push_back({.file = "prediction.csv",
                         .x = "(1+$8)",
                         .y = "(1+$10)",
                         .title = "fitted",
                         .points = true,
                         .style = 2,
                         .only = only("fitted"),
                         .error = "(sqrt($9**2+$11**2))"});
  return plot;
}

}  // namespace

Csv prediction_csv(const DeviationModel& model, const TrainingRows& training) {
  std::vector<std::string> header = {"study",
                                     "law",
                                     "factor [-]",
                                     "point",
                                     "key",
                                     "part",
                                     "quantity",
                                     "measured [-]",
                                     "measured_error [-]",
                                     "predicted [-]",
                                     "predicted_error [-]"};
  for (const char* side : {"", "original_"}) {
    for (const auto& [name, value] : named_groups({})) header.push_back(fmt::format("{}{} [-]", side, name));
  }
  Csv csv(header);
  for (const TrainingRow& row : training.rows) {
    const Measured predicted = predict(model_of(model, row.quantity), row.original, row.scaled).deviation;
    std::vector<CsvCell> cells = {row.study,
                                  row.law,
                                  row.factor,
                                  row.point,
                                  fmt::format("{:016x}", row.key),
                                  std::string(part_of(model, row)),
                                  row.quantity,
                                  row.deviation.value,
                                  row.deviation.error,
                                  predicted.value,
                                  predicted.error};
    for (const ScaleGroups* groups : {&row.scaled, &row.original}) {
      for (const auto& [name, value] : named_groups(*groups)) cells.emplace_back(value);
    }
    csv.add(cells);
  }
  return csv;
}

std::vector<std::string> sentences(const DeviationModel& model) {
  std::vector<std::string> list;
  for (const QuantityModel& q : model.quantities) {
    const Validation& v = model.validation.at(q.quantity);
    list.push_back(fmt::format(
        "{}: {} rows held back, off by {:.1f} % rms, {:.2f} of the errors; within a factor 1.5 are {} of {} that deviate by more "
        "than 3 %, {} of {} without the enlarged",
        study_quantity(q.quantity).what, v.rows, 100 * v.rms, v.rms_over_error, v.within_factor, v.off, v.softened_within_factor,
        v.softened_off));
  }
  list.push_back(
      fmt::format("{} rows fitted, {} held back, {} cells of these deviate", model.rows_fitted, model.rows_held_back, model.cells_off));
  return list;
}

std::vector<std::string> write_prediction(const DeviationModel& model, const TrainingRows& training, const std::filesystem::path& out) {
  write_file(out / "prediction.json", model_json(model).dump(1) + "\n");
  write_file(out / "prediction.csv", prediction_csv(model, training).text());
  std::vector<std::string> missing;
  for (const QuantityModel& q : model.quantities) {
    const Plot plot = plot_of(model, q.quantity);
    if (!draw(plot, out)) missing.push_back(plot.name);
  }
  return missing;
}

}  // namespace scalebreak
