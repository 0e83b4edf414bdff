#include <scalebreak/output/gnuplot.hpp>

#include <cstdlib>
#include <string_view>

#include <fmt/format.h>

#include <scalebreak/output/atomic_file.hpp>

namespace scalebreak {
namespace {

std::string quoted(const std::string& text) {
  std::string safe = "'";
  for (const char c : text) safe += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return safe + "'";
}

}  // namespace

std::string quoted_text(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("''") : std::string(1, c == '\n' ? ' ' : c);
  return out + "'";
}

std::string plain_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("_^{}@&~\\").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return quoted_text(out);
}

std::string script_head(const std::string& name, const std::string& title, const std::string& x_label, const std::string& y_label) {
  return fmt::format("# gnuplot {0}.gp draws {0}.svg and {0}.png\nset datafile separator ','\nset encoding utf8\n", name) +
         fmt::format("set title {}\nset xlabel {}\nset ylabel {}\n", plain_text(title), quoted_text(x_label), quoted_text(y_label));
}

std::string plot_twice(const std::string& name, const std::string& plot, int width, int height) {
  return fmt::format("set terminal svg size {},{} dynamic background rgb 'white' font 'sans,13'\nset output '{}.svg'\n{}\n", width, height,
                     name, plot) +
         fmt::format("set terminal pngcairo size {},{} font 'sans,15'\nset output '{}.png'\nreplot\n", 3 * width / 2, 3 * height / 2, name);
}

bool draw_script(const std::string& name, const std::string& script, const std::filesystem::path& folder) {
  write_file(folder / (name + ".gp"), script);
  // A drawing of an earlier run must not pass for this one.
  for (const char* ending : {".svg", ".png"}) std::filesystem::remove(folder / (name + ending));
  const std::string command =
      fmt::format("cd {} && gnuplot {} >/dev/null 2>{}", quoted(folder.string()), quoted(name + ".gp"), quoted(name + ".log"));
  const bool drawn = std::system(command.c_str()) == 0;
  if (drawn) std::filesystem::remove(folder / (name + ".log"));
  return drawn;
}

}  // namespace scalebreak
