#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scalebreak {

/// One field of a map; fields that are left out stay empty.
struct MapField {
  std::size_t column = 0, row = 0;
  double value = 0;  ///< its colour; beyond the ends of the scale it has that of the end
  std::string text;  ///< written into it
};

/// A table in colours, from blue below 0 over white to red above: columns and rows have names.
struct MapPlot {
  std::string name;  ///< of the files, without ending
  std::string title;
  std::string x_label, y_label, value_label;
  std::vector<std::string> columns, rows;
  double scale = 1;  ///< value of the deepest red
  std::vector<MapField> fields;
};

/// Writes `name.csv` and `name.gp` into `folder` and draws `name.svg` and `name.png`. False as `draw` of a Plot.
bool draw(const MapPlot& map, const std::filesystem::path& folder);

}  // namespace scalebreak
