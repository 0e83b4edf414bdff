#include <algorithm>
#include <map>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/particle_files/extended_xyz.hpp>
#include <scalebreak/particle_files/particle_columns.hpp>

namespace scalebreak {
namespace {

using enum column::Name;

using Remarks = std::map<std::string, std::string, std::less<>>;  ///< key to value, keys in small letters

std::string in_small_letters(std::string_view word) {
  std::string small(word);
  for (char& c : small) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return small;
}

/// The second line of a frame: key=value or key="several values".
Remarks remarks_of(std::string_view line, const std::string& where) {
  Remarks remarks;
  std::size_t at = 0;
  while ((at = line.find_first_not_of(" \t", at)) != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(" \t=", at), line.size());
    const std::string key = in_small_letters(line.substr(at, end - at));
    at = end;
    if (at == line.size() || line[at] != '=') continue;  // a word alone
    ++at;
    const bool quoted = at < line.size() && (line[at] == '"' || line[at] == '\'');
    const std::size_t first = quoted ? at + 1 : at;
    std::size_t last = quoted ? line.find(line[at], first) : line.find_first_of(" \t", first);
    if (quoted && last == std::string_view::npos) throw InputError(fmt::format("{}: {}: found a quote that does not end", where, key));
    last = std::min(last, line.size());
    remarks[key] = line.substr(first, last - first);
    at = std::min(last + (quoted ? 1 : 0), line.size());
  }
  return remarks;
}

struct Property {
  std::string_view name;
  std::size_t parts;
  column::Name first;
};
constexpr Property properties[] = {{"pos", 3, x},       {"radius", 1, radius},       {"velo", 3, vx},   {"vel", 3, vx},
                                   {"velocity", 3, vx}, {"angular_velocity", 3, wx}, {"mass", 1, mass}, {"material", 1, material}};

void add_columns(std::vector<ParticleRows::Column>& columns, std::string_view name, std::size_t parts, const std::string& where) {
  const auto known =
      std::find_if(std::begin(properties), std::end(properties), [&](const Property& p) { return p.name == in_small_letters(name); });
  const bool skipped = known == std::end(properties);
  if (!skipped && known->parts != parts)
    throw InputError(fmt::format("{}: Properties: found {} columns of {}; allowed: {}", where, parts, name, known->parts));
  for (std::size_t k = 0; k < parts; ++k) {
    const std::string label = parts == 1 ? std::string(name) : fmt::format("{} {}", name, k + 1);
    columns.push_back({label, skipped ? std::nullopt : std::optional(static_cast<column::Name>(known->first + k))});
  }
}

std::vector<ParticleRows::Column> columns_of(const Remarks& remarks, const std::string& where) {
  const auto given = remarks.find("properties");
  if (given == remarks.end())
    throw InputError(where + ": Properties is missing; allowed: an extended XYZ file, with Properties=pos:R:3:radius:R:1 at least");
  std::vector<std::string_view> parts;
  for (std::string_view rest = given->second;;) {
    const std::size_t colon = rest.find(':');
    parts.push_back(rest.substr(0, colon));
    if (colon == std::string_view::npos) break;
    rest.remove_prefix(colon + 1);
  }
  if (parts.size() % 3 != 0) throw InputError(fmt::format("{}: Properties: found {}; allowed: name:type:columns:…", where, given->second));
  std::vector<ParticleRows::Column> columns;
  constexpr std::size_t most_columns = 1000;
  for (std::size_t k = 0; k < parts.size(); k += 3) {
    const std::size_t width = read_count(parts[k + 2], where, "Properties");
    if (width > most_columns)
      throw InputError(fmt::format("{}: Properties: found {} columns; allowed: {} at most", where, width, most_columns));
    add_columns(columns, parts[k], width, where);
  }
  return columns;
}

std::vector<double> numbers_of(const Remarks& remarks, std::string_view key, std::size_t count, const std::string& where) {
  const auto given = remarks.find(key);
  std::vector<double> numbers;
  if (given == remarks.end()) return numbers;
  for (const std::string_view word : words_of(given->second)) numbers.push_back(read_number(word, where, std::string(key)));
  if (numbers.size() != count) throw InputError(fmt::format("{}: {}: found {} numbers; allowed: {}", where, key, numbers.size(), count));
  return numbers;
}

/// The cell of a frame, and its lower corner.
Eigen::Vector3d set_cell(Cell& cell, const Remarks& remarks, const std::string& where) {
  const auto a = numbers_of(remarks, "lattice", 9, where);
  const auto origin = numbers_of(remarks, "origin", 3, where);
  if (a.empty()) return Eigen::Vector3d::Zero();
  cell.size = {a[0], a[4], a[8]};
  if (!(cell.size.minCoeff() > 0)) throw InputError(where + ": lattice: found a length that is not positive; allowed: above 0");
  if (const auto pbc = remarks.find("pbc"); pbc != remarks.end()) {
    const auto words = words_of(pbc->second);
    if (words.size() != 3) throw InputError(fmt::format("{}: pbc: found {}; allowed: three of T and F", where, pbc->second));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (words[axis] != "T" && words[axis] != "F" && words[axis] != "1" && words[axis] != "0")
        throw InputError(fmt::format("{}: pbc: found {}; allowed: T or F", where, words[axis]));
      cell.boundary[axis] = words[axis] == "T" || words[axis] == "1" ? Boundary::periodic : Boundary::open;
    }
  }
  const double tilt = a[6];
  const bool sheared = cell.periodic(0) && cell.periodic(2) && tilt > -cell.size.x() && tilt < cell.size.x();
  if (a[1] != 0 || a[2] != 0 || a[3] != 0 || a[5] != 0 || a[7] != 0 || (tilt != 0 && !sheared))
    throw InputError(where + ": lattice: found a skew cell; allowed: a box, or one that is periodic and sheared along x across z");
  cell.shear_offset = tilt < 0 ? tilt + cell.size.x() : tilt;
  return origin.empty() ? Eigen::Vector3d::Zero() : Eigen::Vector3d(origin[0], origin[1], origin[2]);
}

}  // namespace

System read_extended_xyz(const std::string& file) {
  const std::string text = read_particle_file(file);
  const auto lines = lines_of(text);
  std::size_t last = 0, count = 0, next = 0;
  while (next < lines.size() && !words_of(lines[next]).empty()) {
    last = next;
    count = read_count(words_of(lines[last]).front(), place_in_file(file, last + 1), "number of particles");
    if (count > lines.size() || last + 2 + count > lines.size())
      throw InputError(fmt::format("{}: found {} lines after it; allowed: a remark and {}, one a particle", place_in_file(file, last + 1),
                                   lines.size() - last - 1, count));
    next = last + 2 + count;
  }
  if (next < lines.size() &&
      std::any_of(lines.begin() + static_cast<std::ptrdiff_t>(next), lines.end(), [](auto l) { return !words_of(l).empty(); }))
    throw InputError(
        fmt::format("{}: found an empty line; allowed: the number of particles of the next frame", place_in_file(file, next + 1)));
  if (count == 0) throw InputError(file + ": found no sphere; allowed: one at least");

  const std::string where = place_in_file(file, last + 2);
  const Remarks remarks = remarks_of(lines[last + 1], where);
  ParticleRows rows(columns_of(remarks, where), where);
  for (std::size_t k = last + 2; k < next; ++k) rows.add(words_of(lines[k]), place_in_file(file, k + 1));
  System system = rows.take();
  const Eigen::Vector3d corner = set_cell(system.cell, remarks, where);
  for (Eigen::Vector3d& position : system.position) position -= corner;
  if (const auto time = numbers_of(remarks, "time", 1, where); !time.empty()) system.time = time.front();
  return system;
}

}  // namespace scalebreak
