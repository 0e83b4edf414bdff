#include <scalebreak/ensembles/report/profile_plots.hpp>

#include <algorithm>
#include <sstream>

namespace scalebreak {
namespace {

/// From 1, as gnuplot counts; 0: not there.
std::size_t column_of(const std::string& header, const std::string& name) {
  std::istringstream cells(header);
  std::size_t column = 0;
  for (std::string cell; std::getline(cells, cell, ',');) {
    ++column;
    if (cell.rfind(name + " [", 0) == 0) return column;
  }
  return 0;
}

}  // namespace

std::vector<Plot> profile_plots(const std::string& header, const std::vector<ProfileFile>& files, const std::string& what) {
  struct Kind {
    const char *column, *title, *label;
  };
  constexpr Kind kinds[] = {{"velocity_x", "Velocity along the flow", "mean velocity along x [m/s]"},
                            {"volume_fraction", "Volume fraction", "volume fraction [-]"},
                            {"temperature", "Granular temperature", "temperature [m^2/s^2]"}};
  std::vector<Plot> plots;
  for (const Kind& kind : kinds) {
    const std::size_t column = column_of(header, kind.column);
    if (column == 0) continue;
    Plot plot{std::string("profile_") + kind.column,
              std::string(kind.title) + " over the height: " + what,
              "height z [m]",
              kind.label,
              false,
              false,
              {}};
    for (const ProfileFile& file : files)
      plot.curves.push_back({file.file, "1", std::to_string(column), file.title, false, static_cast<int>(plot.curves.size())});
    plots.push_back(plot);
  }
  return plots;
}

}  // namespace scalebreak
