#include <scalebreak/ensembles/breakdown/study_plots.hpp>

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include <scalebreak/ensembles/breakdown/study_files.hpp>
#include <scalebreak/ensembles/breakdown/study_quantities.hpp>
#include <scalebreak/ensembles/breakdown/verdicts.hpp>

namespace scalebreak {
namespace {

constexpr double deepest = 30;  ///< of a map's colours [%]

/// Position of a name in a list, to which it is added if it is new.
std::size_t place_of(std::vector<std::string>& names, const std::string& name) {
  const auto at = std::find(names.begin(), names.end(), name);
  if (at != names.end()) return static_cast<std::size_t>(at - names.begin());
  names.push_back(name);
  return names.size() - 1;
}

std::vector<std::string> engines_of(const StudyResult& study) {
  std::vector<std::string> engines;
  for (const StudyCell& cell : study.grid.cells) place_of(engines, cell.asked);
  return engines;
}

/// In per cent, large ones without decimals.
std::string label_of(const Measured& deviation) {
  const int digits = std::abs(deviation.value) < 1 ? 1 : 0;
  return fmt::format("{:+.{}f} ± {:.{}f}", 100 * deviation.value, digits, 100 * deviation.error, digits);
}

MapPlot map_of(const StudyResult& study, const std::string& quantity, const std::string& engine, const std::string& parameter) {
  MapPlot map{.x_label = "law and factor",
              .y_label = "",
              .value_label = "deviation [%]",
              .columns = {},
              .rows = {},
              .scale = deepest,
              .fields = {}};
  for (std::size_t i = 0; i < study.cells.size(); ++i) {
    const StudyCell& of = study.grid.cells[i];
    const Comparison* c = study.cells[i].deviation(quantity);
    if (of.asked != engine || !c || !std::isfinite(c->relative.value)) continue;
    const std::string point = of.point.name(parameter);
    map.fields.push_back({place_of(map.columns, fmt::format("{} {:g}", of.law, of.factor)),
                          place_of(map.rows, point.empty() ? "the scene" : point), 100 * c->relative.value, label_of(c->relative)});
  }
  return map;
}

/// Laws with their factors, in the order of the grid.
std::vector<std::pair<std::string, double>> laws_and_factors(const StudyResult& study) {
  std::vector<std::pair<std::string, double>> list;
  for (const StudyCell& cell : study.grid.cells) {
    const std::pair<std::string, double> pair{cell.law, cell.factor};
    if (std::find(list.begin(), list.end(), pair) == list.end()) list.push_back(pair);
  }
  return list;
}

std::string row_condition(const std::string& law, double factor, const std::string& quantity) {
  return fmt::format("strcol({}) eq '{}' && ${} == {:.17g} && strcol({}) eq '{}'", study_column::law, law, study_column::factor, factor,
                     study_column::quantity, quantity);
}

/// Of the legend.
std::string name_of(const std::string& law, double factor) {
  return law == "none" && factor == 1 ? "original" : fmt::format("{} {:g}", law, factor);
}

Plot over_points(const StudyResult& study, const StudyQuantity& quantity, const char* column, const std::string& label,
                 const std::string& title) {
  Plot plot{.name = fmt::format("{}_over_{}", quantity.name, column == study_column::value ? "parameter" : "volume_fraction"),
            .title = fmt::format("{}: {}", quantity.what, title),
            .x_label = label,
            .y_label = fmt::format("{} [{}]", quantity.what, quantity.unit),
            .log_y = true,
            .curves = {}};
  int style = 0;
  for (const auto& [law, factor] : laws_and_factors(study)) {
    plot.curves.push_back({.file = "study.csv",
                           .x = column,
                           .y = "(abs($9))",
                           .title = name_of(law, factor),
                           .points = true,
                           .style = style++,
                           .only = row_condition(law, factor, quantity.name),
                           .error = "10"});
  }
  return plot;
}

/// Deviations over a column, a mark a cell, by law.
Plot deviations_over(const StudyResult& study, const StudyQuantity& quantity, const std::string& column, const std::string& label,
                     const std::string& name, const std::string& title) {
  Plot plot{.name = fmt::format("{}_{}", quantity.name, name),
            .title = fmt::format("Deviation of the {}: {}", quantity.what, title),
            .x_label = label,
            .y_label = "deviation from what the law claims [%]",
            .log_x = true,
            .curves = {}};
  std::set<std::string> seen;
  int style = 1;
  for (const auto& [law, factor] : laws_and_factors(study)) {
    if ((law == "none" && factor == 1) || !seen.insert(law).second) continue;
    plot.curves.push_back(
        {.file = "study.csv",
         .x = column,
         .y = fmt::format("(100*${})", study_column::deviation),
         .title = law,
         .points = true,
         .style = style++,
         .only = fmt::format("strcol({}) eq '{}' && strcol({}) eq '{}'", study_column::law, law, study_column::quantity, quantity.name),
         .error = fmt::format("(100*${})", study_column::deviation_error)});
  }
  return plot;
}

/// Is there a deviation of it? The volume fraction of a closed cell has none.
bool judged(const StudyResult& study, const std::string& quantity) {
  return std::any_of(study.cells.begin(), study.cells.end(), [&](const CellResult& cell) {
    const Comparison* c = cell.deviation(quantity);
    return c && std::abs(c->relative.value) > 1e-9;
  });
}

Plot patch_plot(const StudyResult& study, const std::string& title) {
  Plot plot{.name = "patch_fraction",
            .title = "Contacts that need a patch: " + title,
            .x_label = "contact time x collision rate: contacts of a sphere at a time [-]",
            .y_label = "of all contacts, those integrated in a patch [-]",
            .log_x = true,
            .log_y = true,
            .curves = {}};
  int style = 0;
  for (const auto& [law, factor] : laws_and_factors(study))
    plot.curves.push_back({.file = "study.csv",
                           .x = study_column::coordination,
                           .y = study_column::patch_fraction,
                           .title = name_of(law, factor),
                           .points = true,
                           .style = style++,
                           .only = row_condition(law, factor, "temperature")});
  return plot;
}

}  // namespace

std::vector<MapPlot> deviation_maps(const StudyResult& study, const std::string& parameter, const std::string& title) {
  std::vector<MapPlot> maps;
  const auto engines = engines_of(study);
  for (const std::string& engine : engines) {
    for (const std::string& name : judged_quantities()) {
      MapPlot map = map_of(study, name, engine, parameter);
      if (map.fields.empty() || !judged(study, name)) continue;
      map.name = fmt::format("map_{}{}", name, engines.size() > 1 ? "_" + engine : "");
      map.title =
          fmt::format("Deviation of the {} in %: {}{}", study_quantity(name).what, title, engines.size() > 1 ? ", engine " + engine : "");
      maps.push_back(std::move(map));
    }
  }
  return maps;
}

std::vector<Plot> study_plots(const StudyResult& study, const std::string& parameter, const std::string& title) {
  std::vector<Plot> plots;
  std::set<double> fractions, values;
  bool patches = false;
  for (std::size_t i = 0; i < study.cells.size(); ++i) {
    const StudyPoint& point = study.grid.cells[i].point;
    if (point.volume_fraction) fractions.insert(*point.volume_fraction);
    if (point.value) values.insert(*point.value);
    patches = patches || study.cells[i].patch_fraction.has_value();
  }
  for (const std::string& name : judged_quantities()) {
    if (!judged(study, name)) continue;
    const StudyQuantity& quantity = study_quantity(name);
    if (fractions.size() > 1 && values.size() < 2)
      plots.push_back(over_points(study, quantity, study_column::volume_fraction, "volume fraction [-]", title));
    if (values.size() > 1 && fractions.size() < 2)
      plots.push_back(over_points(study, quantity, study_column::value, parameter + " [SI]", title));
    plots.push_back(deviations_over(study, quantity, study_column::coordination,
                                    "contact time x collision rate: contacts of a sphere at a time, in the scaled system [-]",
                                    "over_contacts", title));
    plots.push_back(deviations_over(study, quantity, fmt::format("(${}/${})", study_column::wall_time, study_column::measured_time),
                                    "cost: wall time over simulated time, one core [-]", "over_cost", title));
  }
  if (patches) plots.push_back(patch_plot(study, title));
  return plots;
}

}  // namespace scalebreak
