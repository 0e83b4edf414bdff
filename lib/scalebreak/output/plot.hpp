#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scalebreak {

/// One curve of a plot, read from a CSV file beside the plot.
struct Curve {
  std::string file;        ///< CSV, relative to the plot's folder
  std::string x, y;        ///< gnuplot expressions of the columns, "1" or "($3/$2)"
  std::string title;       ///< for the legend, taken as it stands
  bool points = false;     ///< marks instead of a line
  int style = 0;           ///< colour and mark; 0 is black, for what the others are compared with
  std::string only = {};   ///< a gnuplot condition on the columns, "strcol(1) eq 'rps'"; empty: every row
  std::string error = {};  ///< of marks: a gnuplot expression by which a bar goes up and down; empty: no bar
};

/// A plot: axes with units, a legend, one sentence that says what it shows.
struct Plot {
  std::string name;  ///< of the files, without ending
  std::string title;
  std::string x_label, y_label;
  bool log_x = false, log_y = false;
  std::vector<Curve> curves;
  bool equal_scale = false;  ///< a length is as long along x as along y: for drawings of places
};

/// Writes `name.gp` into `folder` and draws `name.svg` and `name.png` with gnuplot. False if gnuplot is not there
/// or fails; the script is kept in any case, so that the plot can be drawn by hand.
bool draw(const Plot& plot, const std::filesystem::path& folder);

}  // namespace scalebreak
