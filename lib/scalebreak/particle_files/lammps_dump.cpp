#include <scalebreak/particle_files/lammps_dump.hpp>

#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scalebreak/particle_files/lammps_box.hpp>
#include <scalebreak/particle_files/particle_columns.hpp>

namespace scalebreak {
namespace {

/// LAMMPS' names of the columns.
constexpr std::array<const char*, particle_columns> attributes = {"x",  "y",      "z",      "diameter", "vx",   "vy",
                                                                  "vz", "omegax", "omegay", "omegaz",   "mass", "type"};

const char* boundary_of(const Cell& cell, int axis) { return cell.periodic(axis) ? "pp" : "ff"; }

std::string box_of(const Cell& cell) {
  const std::string faces = fmt::format("{} {} {}", boundary_of(cell, 0), boundary_of(cell, 1), boundary_of(cell, 2));
  const double tilt = lammps_tilt(cell);
  if (tilt == 0)
    return fmt::format("ITEM: BOX BOUNDS {}\n0 {:.17g}\n0 {:.17g}\n0 {:.17g}\n", faces, cell.size.x(), cell.size.y(), cell.size.z());
  // A dump gives the bounds along x of the whole tilted box.
  return fmt::format("ITEM: BOX BOUNDS xy xz yz {}\n{:.17g} {:.17g} 0\n0 {:.17g} {:.17g}\n0 {:.17g} 0\n", faces, std::min(0.0, tilt),
                     cell.size.x() + std::max(0.0, tilt), cell.size.y(), tilt, cell.size.z());
}

}  // namespace

std::string lammps_dump(const System& system, std::uint64_t step, const ParticleFields& fields) {
  const std::vector<column::Name> columns = columns_of(fields);
  std::string text = fmt::format("ITEM: TIME\n{:.17g}\nITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\n{}ITEM: ATOMS id", system.time, step,
                                 system.count(), box_of(system.cell));
  for (const column::Name name : columns) text += std::string(" ") + attributes[name];
  text += '\n';
  for (std::size_t i = 0; i < system.count(); ++i) {
    std::vector<double> row = particle_row(system, i, columns);
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (columns[k] == column::radius) row[k] *= 2;
      if (columns[k] == column::material) row[k] += 1;
    }
    fmt::format_to(std::back_inserter(text), "{} {:.17g}\n", i + 1, fmt::join(row, " "));
  }
  return text;
}

}  // namespace scalebreak
