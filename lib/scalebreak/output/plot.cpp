#include <scalebreak/output/plot.hpp>

#include <cstdlib>

#include <fmt/format.h>

#include <scalebreak/output/atomic_file.hpp>

namespace scalebreak {
namespace {

// Okabe & Ito's colours: told apart by everyone.
constexpr const char* colours[] = {"#000000", "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#8B4513", "#7F7F7F", "#B0A000", "#6A3D9A"};

std::string curve_text(const Curve& curve, std::size_t index) {
  const char* colour = colours[index % std::size(colours)];
  const std::string y = curve.only.empty() ? curve.y : fmt::format("({} ? ({}) : NaN)", curve.only, curve.y.front() == '(' ? curve.y : "$" + curve.y);
  const std::string style = curve.points ? fmt::format("with points pt {} ps 0.9 lw 1.5 lc rgb '{}'", index % 13 + 1, colour)
                                         : fmt::format("with lines lw 2 lc rgb '{}'", colour);
  return fmt::format("'{}' using {}:{} {} title \"{}\"", curve.file, curve.x, y, style, curve.title);
}

std::string script(const Plot& plot) {
  std::string text = fmt::format("# gnuplot {}.gp draws {}.svg and {}.png\nset datafile separator ','\nset encoding utf8\n", plot.name, plot.name, plot.name);
  text += fmt::format("set title \"{}\"\nset xlabel \"{}\"\nset ylabel \"{}\"\n", plot.title, plot.x_label, plot.y_label);
  if (plot.log_x) text += "set logscale x\nset format x '%h'\n";
  if (plot.log_y) text += "set logscale y\nset format y '%h'\n";
  text += "set grid lc rgb '#dddddd'\nset key outside right top\n";
  std::string curves;
  for (std::size_t i = 0; i < plot.curves.size(); ++i) {
    if (i > 0) curves += ", \\\n     ";
    curves += curve_text(plot.curves[i], i);
  }
  text += fmt::format("set terminal svg size 900,520 dynamic background rgb 'white' font 'sans,13'\nset output '{}.svg'\nplot {}\n", plot.name, curves);
  text += fmt::format("set terminal pngcairo size 1350,780 font 'sans,15'\nset output '{}.png'\nreplot\n", plot.name);
  return text;
}

std::string quoted(const std::string& text) {
  std::string safe = "'";
  for (const char c : text) safe += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return safe + "'";
}

}  // namespace

bool draw(const Plot& plot, const std::filesystem::path& folder) {
  write_file(folder / (plot.name + ".gp"), script(plot));
  const std::string command = fmt::format("cd {} && gnuplot {} >/dev/null 2>{}", quoted(folder.string()), quoted(plot.name + ".gp"), quoted(plot.name + ".log"));
  const bool drawn = std::system(command.c_str()) == 0;
  if (drawn) std::filesystem::remove(folder / (plot.name + ".log"));
  return drawn;
}

}  // namespace scalebreak
