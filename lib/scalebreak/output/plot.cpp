#include <scalebreak/output/plot.hpp>

#include <algorithm>

#include <fmt/format.h>

#include <scalebreak/output/gnuplot.hpp>

namespace scalebreak {
namespace {

// Okabe & Ito's colours: told apart by everyone.
constexpr const char* colours[] = {"#000000", "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9",
                                   "#8B4513", "#7F7F7F", "#B0A000", "#6A3D9A", "#117733", "#882255"};

std::string curve_text(const Curve& curve) {
  const auto style = static_cast<std::size_t>(curve.style);
  const char* colour = colours[style % std::size(colours)];
  const std::string y =
      curve.only.empty() ? curve.y : fmt::format("({} ? ({}) : NaN)", curve.only, curve.y.front() == '(' ? curve.y : "$" + curve.y);
  // Marks shrink with the style, so that those which fall on each other still show.
  constexpr int marks[] = {7, 4, 6, 8, 10, 12, 14, 1, 2, 3};
  const std::string marked = curve.error.empty() ? "points" : "yerrorbars";
  const std::string look = curve.points ? fmt::format("with {} pt {} ps {:.2f} lw 1.6 lc rgb '{}'", marked, marks[style % std::size(marks)],
                                                      1.55 - 0.08 * static_cast<double>(style % 13), colour)
                                        : fmt::format("with lines lw {} lc rgb '{}'", style == 0 ? 2.5 : 1.8, colour);
  if (!curve.error.empty()) {
    const std::string bars = fmt::format("with yerrorbars{}", look.substr(look.find(" pt ")));
    return fmt::format("'{}' using {}:{}:{} {} title {}", curve.file, curve.x, y, curve.error, bars, plain_text(curve.title));
  }
  return fmt::format("'{}' using {}:{} {} title {}", curve.file, curve.x, y, look, plain_text(curve.title));
}

/// Marks stay off the frame: a first plot, of nothing, tells where they lie. Lines alone fill it.
std::string room_for_marks(const Plot& plot) {
  if (std::none_of(plot.curves.begin(), plot.curves.end(), [](const Curve& curve) { return curve.points; })) return "";
  const std::string room = plot.log_x
                               ? "m = (GPVAL_DATA_X_MAX/GPVAL_DATA_X_MIN)**0.04; set xrange [GPVAL_DATA_X_MIN/m:GPVAL_DATA_X_MAX*m]"
                               : "m = 0.04*(GPVAL_DATA_X_MAX - GPVAL_DATA_X_MIN); set xrange [GPVAL_DATA_X_MIN - m:GPVAL_DATA_X_MAX + m]";
  return "if (GPVAL_DATA_X_MAX > GPVAL_DATA_X_MIN) { " + room + " }\n";
}

/// Of a logarithmic axis over two decades or less, 2 and 5 have numbers too.
std::string numbers_of(const std::string& axis, const std::string& gnuplots) {
  return fmt::format("if (GPVAL_{1}_MAX < 101*GPVAL_{1}_MIN) {{ do for [e=-30:30] {{ set {0}tics add (2*10.0**e, 5*10.0**e) }} }}\n", axis,
                     gnuplots);
}

std::string script(const Plot& plot) {
  std::string text = script_head(plot.name, plot.title, plot.x_label, plot.y_label);
  if (plot.log_x) text += "set logscale x\nset format x '%h'\n";
  if (plot.log_y) text += "set logscale y\nset format y '%h'\n";
  if (plot.equal_scale) text += "set size ratio -1\n";
  text += "set xrange [*:*] noextend\nset grid lt 1 lw 0.7 lc rgb '#dddddd'\nset key outside right top Left reverse\n";
  std::string curves;
  for (std::size_t i = 0; i < plot.curves.size(); ++i) {
    if (i > 0) curves += ", \\\n     ";
    curves += curve_text(plot.curves[i]);
  }
  std::string ranges = room_for_marks(plot);
  if (plot.log_x) ranges += numbers_of("x", "X");
  if (plot.log_y) ranges += numbers_of("y", "Y");
  if (!ranges.empty()) text += "set terminal unknown\nplot " + curves + "\n" + ranges;
  return text + plot_twice(plot.name, "plot " + curves);
}

}  // namespace

bool draw(const Plot& plot, const std::filesystem::path& folder) { return draw_script(plot.name, script(plot), folder); }

}  // namespace scalebreak
