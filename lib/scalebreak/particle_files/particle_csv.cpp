#include <scalebreak/particle_files/particle_csv.hpp>

#include <algorithm>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/output/csv.hpp>
#include <scalebreak/particle_files/particle_columns.hpp>

namespace scalebreak {
namespace {

const std::array<std::string, particle_columns> headers = {
    "x [m]",          "y [m]",          "z [m]",          "radius [m]", "velocity_x [m/s]", "velocity_y [m/s]", "velocity_z [m/s]",
    "spin_x [rad/s]", "spin_y [rad/s]", "spin_z [rad/s]", "mass [kg]",  "material [-]"};

std::string_view trimmed(std::string_view word) {
  constexpr std::string_view around = " \t\"";
  const std::size_t first = word.find_first_not_of(around);
  if (first == std::string_view::npos) return {};
  return word.substr(first, word.find_last_not_of(around) - first + 1);
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (;;) {
    const std::size_t comma = line.find(',');
    cells.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

std::string_view name_of(std::string_view header) { return trimmed(header.substr(0, header.find('['))); }

ParticleRows::Column column_of(std::string_view header, const std::string& where) {
  for (std::size_t k = 0; k < headers.size(); ++k) {
    if (header == headers[k]) return {headers[k], static_cast<column::Name>(k)};
    if (name_of(header) == name_of(headers[k]))
      throw InputError(fmt::format("{}: found the column {}; allowed: {}", where, header, headers[k]));
  }
  return {std::string(header), std::nullopt};
}

}  // namespace

std::string particles_csv(const System& system, const ParticleFields& fields) {
  const std::vector<column::Name> columns = columns_of(fields);
  std::vector<std::string> names;
  for (const column::Name name : columns) names.push_back(headers[name]);
  Csv csv(names);
  for (std::size_t i = 0; i < system.count(); ++i) {
    const auto row = particle_row(system, i, columns);
    csv.add({row.begin(), row.end()});
  }
  return csv.text();
}

System read_particles_csv(const std::string& file) {
  const std::string text = read_particle_file(file);
  const auto lines = lines_of(text);
  if (lines.empty()) throw InputError(file + ": found nothing; allowed: a line of headers and a line for each sphere");
  std::vector<ParticleRows::Column> columns;
  const std::string first = place_in_file(file, 1);
  for (const std::string_view header : cells_of(lines.front())) columns.push_back(column_of(header, first));
  ParticleRows rows(columns, first);
  for (std::size_t k = 1; k < lines.size(); ++k) {
    if (!trimmed(lines[k]).empty()) rows.add(cells_of(lines[k]), place_in_file(file, k + 1));
  }
  if (rows.count() == 0) throw InputError(file + ": found no sphere; allowed: one at least");
  return rows.take();
}

}  // namespace scalebreak
