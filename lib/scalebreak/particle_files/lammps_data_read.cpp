#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <unordered_map>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/particle_files/lammps_data.hpp>
#include <scalebreak/particle_files/particle_columns.hpp>

namespace scalebreak {
namespace {

constexpr std::array<std::string_view, 3> bounds = {"xlo", "ylo", "zlo"};
constexpr std::array<const char*, 7> atom_columns = {"id", "type", "diameter", "density", "x", "y", "z"};
constexpr std::array<const char*, 7> velocity_columns = {"id", "vx", "vy", "vz", "omegax", "omegay", "omegaz"};

struct Atom {
  std::size_t id = 0;
  double radius = 0, mass = 0;
  std::uint8_t material = 0;
  Eigen::Vector3d position{0, 0, 0}, velocity{0, 0, 0}, spin{0, 0, 0};
};

class LammpsData {
 public:
  explicit LammpsData(const std::string& file) : file_(file), text_(read_particle_file(file)), lines_(lines_of(text_)) {}

  System read() {
    while (++at_ < lines_.size()) {  // the first line is a remark
      if (const auto words = words_here(); !words.empty()) read_header_or_section(words);
    }
    if (!count_) throw InputError(file_ + ": \"N atoms\" is missing; allowed: a LAMMPS data file of atom_style sphere");
    for (int axis = 0; axis < 3; ++axis) {
      if (!(cell_.size[axis] > 0)) throw InputError(fmt::format("{}: the bounds of the box along {} are missing", file_, "xyz"[axis]));
    }
    if (atoms_.empty()) throw InputError(file_ + ": the section Atoms is missing");
    return system();
  }

 private:
  [[nodiscard]] std::string where() const { return place_in_file(file_, at_ + 1); }
  [[nodiscard]] std::vector<std::string_view> words_here() const { return words_of(lines_[at_].substr(0, lines_[at_].find('#'))); }

  void read_header_or_section(const std::vector<std::string_view>& words) {
    if (words.size() == 2 && words[1] == "atoms") {
      count_ = read_count(words[0], where(), "atoms");
    } else if (words.size() == 4 && words[2].ends_with("lo") && words[3].ends_with("hi")) {
      read_bounds(words);
    } else if (words.size() == 6 && words[3] == "xy") {
      for (std::size_t k = 0; k < 3; ++k) {
        if (read_number(words[k], where(), "tilt") == 0) continue;
        throw InputError(fmt::format("{}: {}: found {}; allowed: 0, as a tilted box cannot be read", where(), words[3 + k], words[k]));
      }
    } else if (words[0] == "Atoms") {
      read_atoms();
    } else if (words[0] == "Velocities") {
      read_velocities();
    }
  }

  void read_bounds(const std::vector<std::string_view>& words) {
    const auto axis = std::find(bounds.begin(), bounds.end(), words[2]) - bounds.begin();
    if (axis == 3) return;
    const double low = read_number(words[0], where(), std::string(words[2])), high = read_number(words[1], where(), std::string(words[3]));
    if (!(high > low))
      throw InputError(fmt::format("{}: found {} to {}; allowed: the upper bound above the lower one", where(), low, high));
    corner_[axis] = low;
    cell_.size[axis] = high - low;
  }

  /// The next line of a section that has one for each atom, and its numbers.
  std::vector<double> row_of(const std::array<const char*, 7>& columns, const char* section, std::size_t images) {
    std::vector<std::string_view> words;
    while (words.empty() && ++at_ < lines_.size()) words = words_here();
    if (words.empty())
      throw InputError(fmt::format("{}: the section {} ends early; allowed: {} lines, one an atom", file_, section, *count_));
    if (words.size() != columns.size() && words.size() != columns.size() + images)
      throw InputError(fmt::format("{}: {}: found {} values; allowed: {}", where(), section, words.size(), fmt::join(columns, " ")));
    std::vector<double> row(1, 0);
    for (std::size_t k = 1; k < columns.size(); ++k) row.push_back(read_number(words[k], where(), columns[k]));
    id_ = read_count(words[0], where(), "id");
    return row;
  }

  void read_atoms() {
    const std::string_view line = lines_[at_];
    if (const auto hash = line.find('#'); hash != std::string_view::npos) {
      const auto style = words_of(line.substr(hash + 1));
      if (!style.empty() && style.front() != "sphere")
        throw InputError(fmt::format("{}: Atoms: found atom_style {}; allowed: sphere", where(), style.front()));
    }
    if (!count_) throw InputError(where() + ": Atoms: \"N atoms\" is missing above");
    for (std::size_t k = 0; k < *count_; ++k) {
      const auto row = row_of(atom_columns, "Atoms", 3);
      if (row[1] != 1 && row[1] != 2)
        throw InputError(fmt::format("{}: type: found {}; allowed: 1 for [material] or 2 for [second]", where(), row[1]));
      for (const std::size_t positive : {2u, 3u}) {
        if (!(row[positive] > 0))
          throw InputError(fmt::format("{}: {}: found {}; allowed: above 0", where(), atom_columns[positive], row[positive]));
      }
      const double radius = row[2] / 2, mass = row[3] * 4 * std::numbers::pi / 3 * radius * radius * radius;
      if (!index_.emplace(id_, atoms_.size()).second) throw InputError(fmt::format("{}: id: found {} twice; allowed: once", where(), id_));
      atoms_.push_back({id_, radius, mass, static_cast<std::uint8_t>(row[1] - 1), {row[4], row[5], row[6]}});
    }
  }

  void read_velocities() {
    if (atoms_.empty()) throw InputError(where() + ": Velocities: allowed: below the section Atoms");
    for (std::size_t k = 0; k < *count_; ++k) {
      const auto row = row_of(velocity_columns, "Velocities", 0);
      const auto found = index_.find(id_);
      if (found == index_.end()) throw InputError(fmt::format("{}: id: found {}; allowed: an id of the section Atoms", where(), id_));
      atoms_[found->second].velocity = {row[1], row[2], row[3]};
      atoms_[found->second].spin = {row[4], row[5], row[6]};
    }
  }

  System system() {
    std::sort(atoms_.begin(), atoms_.end(), [](const Atom& a, const Atom& b) { return a.id < b.id; });
    System all;
    all.cell = cell_;
    for (const Atom& atom : atoms_) {
      all.radius.push_back(atom.radius);
      all.mass.push_back(atom.mass);
      all.material.push_back(atom.material);
      all.position.emplace_back(atom.position - corner_);
      all.velocity.push_back(atom.velocity);
      all.spin.push_back(atom.spin);
    }
    return all;
  }

  std::string file_, text_;
  std::vector<std::string_view> lines_;
  std::size_t at_ = 0, id_ = 0;
  std::optional<std::size_t> count_;
  Cell cell_;
  Eigen::Vector3d corner_{0, 0, 0};
  std::vector<Atom> atoms_;
  std::unordered_map<std::size_t, std::size_t> index_;
};

}  // namespace

System read_lammps_data(const std::string& file) { return LammpsData(file).read(); }

}  // namespace scalebreak
