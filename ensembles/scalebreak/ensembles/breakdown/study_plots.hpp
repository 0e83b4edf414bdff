#pragma once

#include <string>
#include <vector>

#include <scalebreak/ensembles/breakdown/study_result.hpp>
#include <scalebreak/output/map_plot.hpp>
#include <scalebreak/output/plot.hpp>

namespace scalebreak {

/// A map of the deviation of each judged quantity: laws and factors along, points up, for each engine that was asked for. Those that no cell has
/// are left out.
[[nodiscard]] std::vector<MapPlot> deviation_maps(const StudyResult& study, const std::string& parameter, const std::string& title);

/// Values over the volume fraction or the parameter, deviations over the contacts that a sphere has at a time, the patch fraction over the same, and the
/// largest deviation over the cost. They read study.csv beside them.
[[nodiscard]] std::vector<Plot> study_plots(const StudyResult& study, const std::string& parameter, const std::string& title);

}  // namespace scalebreak
