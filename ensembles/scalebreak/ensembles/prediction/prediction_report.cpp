#include <scalebreak/ensembles/prediction/prediction_report.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scalebreak/collisions/normal/pair_collision.hpp>
#include <scalebreak/ensembles/breakdown/study_quantities.hpp>
#include <scalebreak/ensembles/prediction/cooling_prediction.hpp>
#include <scalebreak/ensembles/prediction/prediction_file.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/output/plot.hpp>

namespace scalebreak {
namespace {

const char* part_of(const DeviationModel& model, const TrainingRow& row, RowsAre are) {
  if (beyond_model(row.original, row.scaled) > 0) return row.scaled.overlap > deep_overlap ? "too_deep" : "lumps";
  if (are == RowsAre::fitted_to) {
    if (row.original.regime == FlowRegime::cooling) return "by_theory";
    return held_back(model.seed, row.key) ? "held_back" : "fitted";
  }
  return are == RowsAre::unseen ? "unseen" : "not_run";
}

CsvCell known(double value) { return std::isfinite(value) ? CsvCell(value) : CsvCell(); }

/// Predicted over measured ratios value/claim of one quantity, held back and fitted apart.
Plot plot_of(const std::string& quantity, RowsAre are) {
  Plot plot{.name = "predicted_" + quantity,
            .title = fmt::format("{}: what the dimensionless groups say, over what was measured", study_quantity(quantity).what),
            .x_label = "measured value / claim",
            .y_label = "predicted value / claim",
            .log_x = true,
            .log_y = true,
            .curves = {}};
  plot.curves.push_back({.file = "prediction.csv", .x = "(1+$8)", .y = "(1+$8)", .title = "as measured"});
  const auto points = [&](const char* part, const char* title, int style) {
    plot.curves.push_back({.file = "prediction.csv",
                           .x = "(1+$8)",
                           .y = "(1+$10)",
                           .title = title,
                           .points = true,
                           .style = style,
                           .only = fmt::format("strcol(7) eq '{}' && strcol(6) eq '{}'", quantity, part),
                           .error = "(sqrt($9**2+$11**2))"});
  };
  if (are == RowsAre::unseen) {
    points("unseen", "not seen by the fit", 1);
  } else {
    points("held_back", "held back", 1), points("fitted", "fitted", 2);
  }
  return plot;
}

}  // namespace

Csv prediction_csv(const DeviationModel& model, const TrainingRows& training, RowsAre are) {
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
    const Measured expected = predicted(model.quantities, row.quantity, row.original, row.scaled).deviation;
    std::vector<CsvCell> cells = {row.study,
                                  row.law,
                                  row.factor,
                                  row.point,
                                  fmt::format("{:016x}", row.key),
                                  std::string(part_of(model, row, are)),
                                  row.quantity,
                                  known(row.deviation.value),
                                  known(row.deviation.error),
                                  expected.value,
                                  expected.error};
    for (const ScaleGroups* groups : {&row.scaled, &row.original}) {
      for (const auto& [name, value] : named_groups(*groups)) cells.emplace_back(value);
    }
    csv.add(cells);
  }
  return csv;
}

std::vector<std::string> sentences(const std::map<std::string, Validation>& validation) {
  std::vector<std::string> list;
  const auto add = [&](const std::string& what, const Validation& v) {
    list.push_back(fmt::format(
        "{}: {} rows that were not fitted, off by {:.1f} % rms, {:.2f} of the errors; within a factor 1.5 are {} of {} that deviate by more "
        "than 3 %, {} of {} without the enlarged",
        what, v.rows, 100 * v.rms, v.rms_over_error, v.within_factor, v.off, v.softened_within_factor, v.softened_off));
  };
  for (const auto& [quantity, v] : validation) {
    if (v.rows > 0) add(study_quantity(quantity).what, v);
  }
  add("all together", together(validation));
  return list;
}

std::vector<std::string> forecast_sentences(const DeviationModel& model, const TrainingRows& forecast) {
  std::vector<std::string> list;
  std::uint64_t cell = 0;
  for (const TrainingRow& row : forecast.rows) {
    if (list.empty() || row.key != cell) {
      list.push_back(fmt::format("{} at {:g}{}{}: ", row.law, row.factor, row.point.empty() ? "" : ", ", row.point));
      if (beyond_model(row.original, row.scaled) > 0)
        list.back() += fmt::format("beyond the model ({}): ", part_of(model, row, RowsAre::not_run));
    } else {
      list.back() += ", ";
    }
    cell = row.key;
    const Measured off = predicted(model.quantities, row.quantity, row.original, row.scaled).deviation;
    list.back() += fmt::format("{} {:+.1f} % ± {:.1f} %", study_quantity(row.quantity).what, 100 * off.value, 100 * off.error);
  }
  return list;
}

std::vector<std::string> write_rows(const DeviationModel& model, const TrainingRows& rows, RowsAre are, const std::filesystem::path& out) {
  write_file(out / "prediction.csv", prediction_csv(model, rows, are).text());
  std::vector<std::string> missing;
  if (are == RowsAre::not_run) return missing;
  for (const QuantityModel& q : model.quantities) {
    if (std::none_of(rows.rows.begin(), rows.rows.end(), [&](const TrainingRow& row) { return row.quantity == q.quantity; })) continue;
    const Plot plot = plot_of(q.quantity, are);
    if (!draw(plot, out)) missing.push_back(plot.name);
  }
  return missing;
}

}  // namespace scalebreak
