#pragma once

#include <string>
#include <vector>

#include <scalebreak/output/plot.hpp>

namespace scalebreak {

/// A profiles.csv, relative to the folder of the plots, and what its curve is called.
struct ProfileFile {
  std::string file, title;
};

/// Velocity, volume fraction and temperature over the height, a curve a file. `header` is the first line of the files.
[[nodiscard]] std::vector<Plot> profile_plots(const std::string& header, const std::vector<ProfileFile>& files, const std::string& what);

}  // namespace scalebreak
