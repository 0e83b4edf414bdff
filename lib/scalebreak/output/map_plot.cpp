#include <scalebreak/output/map_plot.hpp>

#include <algorithm>

#include <fmt/format.h>

#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/output/csv.hpp>
#include <scalebreak/output/gnuplot.hpp>

namespace scalebreak {
namespace {

std::string ticks(const std::vector<std::string>& names) {
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i) list += fmt::format("{}{} {}", i > 0 ? ", " : "", plain_text(names[i]), i);
  return list;
}

std::string script(const MapPlot& map) {
  std::string text = script_head(map.name, map.title, map.x_label, map.y_label);
  text += fmt::format("set cblabel {}\nset xtics ({}) rotate by 45 right\nset ytics ({})\n", quoted_text(map.value_label),
                      ticks(map.columns), ticks(map.rows));
  text += fmt::format("set xrange [-0.5:{}]\nset yrange [-0.5:{}]\nset cbrange [{}:{}]\nset key off\n",
                      static_cast<double>(map.columns.size()) - 0.5, static_cast<double>(map.rows.size()) - 0.5, -map.scale, map.scale);
  text += "set palette defined (-1 '#2166ac', -0.5 '#92c5de', 0 '#f7f7f7', 0.5 '#f4a582', 1 '#b2182b')\n";
  const double dark = 0.7 * map.scale;  // beyond it labels are white
  const std::string plot = fmt::format(
      "plot '{0}.csv' every ::1 using 1:2:(0.5):(0.5):3 with boxxyerror fs solid border lc rgb '#999999' fc palette, \\\n"
      "     '{0}.csv' every ::1 using (abs($3) > {1} ? NaN : $1):2:4 with labels font ',9', \\\n"
      "     '{0}.csv' every ::1 using (abs($3) > {1} ? $1 : NaN):2:4 with labels font ',9' textcolor rgb 'white'",
      map.name, dark);
  std::size_t longest = 0;
  for (const std::string& row : map.rows) longest = std::max(longest, row.size());
  const int columns = static_cast<int>(map.columns.size()), rows = static_cast<int>(map.rows.size());
  const int names = 8 * static_cast<int>(longest);
  return text + plot_twice(map.name, plot, std::max(500, 160 + names + 85 * columns), std::max(320, 190 + 42 * rows));
}

}  // namespace

bool draw(const MapPlot& map, const std::filesystem::path& folder) {
  Csv csv({"column", "row", fmt::format("value [{}]", map.value_label), "text", "column_name", "row_name"});
  for (const MapField& field : map.fields)
    csv.add({static_cast<double>(field.column), static_cast<double>(field.row), field.value, field.text, map.columns[field.column],
             map.rows[field.row]});
  write_file(folder / (map.name + ".csv"), csv.text());
  return draw_script(map.name, script(map), folder);
}

}  // namespace scalebreak
