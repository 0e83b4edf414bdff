#pragma once

#include <filesystem>
#include <string>

namespace scalebreak {

/// A text between gnuplot's single quotes, in which no command is run and only the quote itself is special.
[[nodiscard]] std::string quoted_text(const std::string& text);

/// The same for a text that is no formula: gnuplot would read "_" as the start of an index.
[[nodiscard]] std::string plain_text(const std::string& text);

/// What every script begins with: what it draws, CSV as input, title and labels of the axes.
[[nodiscard]] std::string script_head(const std::string& name, const std::string& title, const std::string& x_label,
                                      const std::string& y_label);

/// The command "plot …" into name.svg and name.png.
[[nodiscard]] std::string plot_twice(const std::string& name, const std::string& plot, int width = 900, int height = 520);

/// Writes `name.gp` into `folder` and runs it there. False if gnuplot is not there or fails; then name.log says why. What an earlier script of the name drew is
/// gone in any case.
bool draw_script(const std::string& name, const std::string& script, const std::filesystem::path& folder);

}  // namespace scalebreak
