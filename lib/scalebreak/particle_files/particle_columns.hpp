#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <scalebreak/scene/flow_input.hpp>
#include <scalebreak/scene/system.hpp>

namespace scalebreak {

/// What a file can say about a sphere, number by number.
namespace column {
enum Name : std::size_t { x, y, z, radius, vx, vy, vz, wx, wy, wz, mass, material };
}
inline constexpr std::size_t particle_columns = 12;

/// Those of a position and of the fields, in that order.
[[nodiscard]] std::vector<column::Name> columns_of(const ParticleFields& fields);

/// These numbers of a sphere, in SI.
[[nodiscard]] std::vector<double> particle_row(const System& system, std::size_t i, const std::vector<column::Name>& columns);

/// Where something stands in a file: "start.csv, line 3".
[[nodiscard]] std::string place_in_file(const std::string& file, std::size_t line);

/// A finite number, or InputError: where, name, found, allowed.
[[nodiscard]] double read_number(std::string_view word, const std::string& where, const std::string& name);

/// A whole number that is not negative, or InputError.
[[nodiscard]] std::size_t read_count(std::string_view word, const std::string& where, const std::string& name);

/// The words of a line between blanks.
[[nodiscard]] std::vector<std::string_view> words_of(std::string_view line);

/// The lines of a text, without their ends.
[[nodiscard]] std::vector<std::string_view> lines_of(std::string_view text);

/// A whole file, or InputError.
[[nodiscard]] std::string read_particle_file(const std::string& file);

/// Spheres that are read row by row. What a file does not give is zero, and `mass` stays empty.
class ParticleRows {
 public:
  struct Column {
    std::string name;                   ///< for messages, as it stands in the file
    std::optional<column::Name> holds;  ///< nothing: skipped
  };

  /// Throws InputError where a column stands twice, a vector is not whole, or position or radius is missing.
  ParticleRows(std::vector<Column> columns, std::string where);

  /// As many words as columns; finite numbers, radius and mass above 0, material 0 or 1; or InputError.
  void add(const std::vector<std::string_view>& words, const std::string& where);
  [[nodiscard]] std::size_t count() const { return system_.count(); }
  [[nodiscard]] System take() { return std::move(system_); }

 private:
  std::vector<Column> columns_;
  bool has_mass_ = false;
  System system_;
};

}  // namespace scalebreak
