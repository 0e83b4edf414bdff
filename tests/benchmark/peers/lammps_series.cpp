#include "lammps_series.hpp"

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/particle_files/particle_columns.hpp>

namespace scalebreak::peers {

std::vector<SeriesRow> read_series(const std::string& file) {
  const std::string text = read_particle_file(file);
  std::vector<SeriesRow> rows;
  std::size_t number = 0;
  for (const std::string_view line : lines_of(text)) {
    const std::string where = place_in_file(file, ++number);
    const auto words = words_of(line.substr(0, line.find('#')));
    if (words.empty()) continue;
    if (words.size() != 6)
      throw InputError(fmt::format("{}: found {} values; allowed: the 6 of decks/lammps_flow.in", where, words.size()));
    const auto value = [&](std::size_t k, const char* name) { return read_number(words[k], where, name); };
    rows.push_back({static_cast<long>(read_count(words[0], where, "step")), value(1, "temperature"), value(2, "rotational energy"),
                    value(3, "coordination"), value(4, "contact pressure"), value(5, "contact stress xz")});
  }
  if (rows.empty()) throw InputError(file + ": no rows; allowed: a series of decks/lammps_flow.in");
  return rows;
}

}  // namespace scalebreak::peers
