#include <scalebreak/particle_files/particle_columns.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/output/atomic_file.hpp>

namespace scalebreak {
namespace {

using enum column::Name;

constexpr std::array<const char*, particle_columns> meanings = {"x",
                                                                "y",
                                                                "z",
                                                                "radius",
                                                                "velocity along x",
                                                                "velocity along y",
                                                                "velocity along z",
                                                                "spin about x",
                                                                "spin about y",
                                                                "spin about z",
                                                                "mass",
                                                                "material"};

void check_value(column::Name what, double value, std::string_view word, const std::string& where, const std::string& name) {
  if ((what == radius || what == mass) && !(value > 0))
    throw InputError(fmt::format("{}: {}: found {}; allowed: above 0", where, name, word));
  if (what == material && value != 0 && value != 1)
    throw InputError(fmt::format("{}: {}: found {}; allowed: 0 for [material] or 1 for [second]", where, name, word));
}

}  // namespace

std::vector<column::Name> columns_of(const ParticleFields& fields) {
  std::array<bool, particle_columns> held{};
  const auto hold = [&](column::Name first, std::size_t count) { std::fill_n(held.begin() + first, count, true); };
  hold(x, 3);
  for (const ParticleField field : fields) {
    switch (field) {
      case ParticleField::radius: hold(radius, 1); break;
      case ParticleField::material: hold(material, 1); break;
      case ParticleField::velocity: hold(vx, 3); break;
      case ParticleField::spin: hold(wx, 3); break;
      case ParticleField::mass: hold(mass, 1); break;
    }
  }
  std::vector<column::Name> columns;
  for (std::size_t k = 0; k < particle_columns; ++k) {
    if (held[k]) columns.push_back(static_cast<column::Name>(k));
  }
  return columns;
}

std::vector<double> particle_row(const System& system, std::size_t i, const std::vector<column::Name>& columns) {
  const Eigen::Vector3d &p = system.position[i], &v = system.velocity[i], &w = system.spin[i];
  const std::array<double, particle_columns> all = {p.x(), p.y(), p.z(),          system.radius[i],
                                                    v.x(), v.y(), v.z(),          w.x(),
                                                    w.y(), w.z(), system.mass[i], static_cast<double>(system.material[i])};
  std::vector<double> row;
  for (const column::Name name : columns) row.push_back(all[name]);
  return row;
}

std::string place_in_file(const std::string& file, std::size_t line) { return fmt::format("{}, line {}", file, line); }

double read_number(std::string_view word, const std::string& where, const std::string& name) {
  const std::string_view digits = !word.empty() && word.front() == '+' ? word.substr(1) : word;
  double value = 0;
  const auto [end, failed] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (failed != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(value))
    throw InputError(fmt::format("{}: {}: found {}; allowed: a finite number", where, name, word.empty() ? "nothing" : word));
  return value;
}

std::size_t read_count(std::string_view word, const std::string& where, const std::string& name) {
  std::size_t value = 0;
  const auto [end, failed] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (failed != std::errc{} || end != word.data() + word.size())
    throw InputError(
        fmt::format("{}: {}: found {}; allowed: a whole number that is not negative", where, name, word.empty() ? "nothing" : word));
  return value;
}

std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view blanks = " \t\r";
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos; at = line.find_first_not_of(blanks, at)) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    lines.push_back(line.ends_with('\r') ? line.substr(0, line.size() - 1) : line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::string read_particle_file(const std::string& file) {
  auto text = read_file(file);
  if (!text) throw InputError(file + ": there is no such file, or it cannot be read");
  return std::move(*text);
}

ParticleRows::ParticleRows(std::vector<Column> columns, std::string where) : columns_(std::move(columns)) {
  std::array<bool, particle_columns> given{};
  for (const Column& column : columns_) {
    if (!column.holds) continue;
    if (std::exchange(given[*column.holds], true))
      throw InputError(fmt::format("{}: {}: found twice; allowed: one column for the {}", where, column.name, meanings[*column.holds]));
  }
  has_mass_ = given[mass];
  for (const column::Name needed : {x, y, z, radius}) {
    if (!given[needed]) throw InputError(fmt::format("{}: a column for the {} is missing", where, meanings[needed]));
  }
  for (const column::Name first : {vx, wx}) {
    const std::size_t parts = static_cast<std::size_t>(std::count(given.begin() + first, given.begin() + first + 3, true));
    if (parts == 0 || parts == 3) continue;
    const auto missing = static_cast<std::size_t>(std::find(given.begin() + first, given.begin() + first + 3, false) - given.begin());
    throw InputError(fmt::format("{}: a column for the {} is missing; allowed: all three components, or none", where, meanings[missing]));
  }
}

void ParticleRows::add(const std::vector<std::string_view>& words, const std::string& where) {
  if (words.size() != columns_.size())
    throw InputError(fmt::format("{}: found {} {}; allowed: {}, one a column", where, words.size(), words.size() == 1 ? "value" : "values",
                                 columns_.size()));
  std::array<double, particle_columns> row{};
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (!columns_[k].holds) continue;
    const column::Name what = *columns_[k].holds;
    row[what] = read_number(words[k], where, columns_[k].name);
    check_value(what, row[what], words[k], where, columns_[k].name);
  }
  system_.position.emplace_back(row[x], row[y], row[z]);
  system_.velocity.emplace_back(row[vx], row[vy], row[vz]);
  system_.spin.emplace_back(row[wx], row[wy], row[wz]);
  system_.radius.push_back(row[radius]);
  if (has_mass_) system_.mass.push_back(row[mass]);
  system_.material.push_back(static_cast<std::uint8_t>(row[material]));
}

}  // namespace scalebreak
