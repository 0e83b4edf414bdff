#include <scalebreak/particle_files/lammps_dump.hpp>

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include <scalebreak/particle_files/lammps_box.hpp>

namespace scalebreak {
namespace {

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

std::string lammps_dump(const System& system, std::uint64_t step) {
  std::string text = fmt::format("ITEM: TIME\n{:.17g}\nITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\n{}", system.time, step,
                                 system.count(), box_of(system.cell));
  text += "ITEM: ATOMS id type diameter x y z vx vy vz omegax omegay omegaz\n";
  for (std::size_t i = 0; i < system.count(); ++i) {
    const Eigen::Vector3d &at = system.position[i], &v = system.velocity[i], &w = system.spin[i];
    fmt::format_to(std::back_inserter(text), "{} {} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n",
                   i + 1, system.material[i] + 1, 2 * system.radius[i], at.x(), at.y(), at.z(), v.x(), v.y(), v.z(), w.x(), w.y(), w.z());
  }
  return text;
}

}  // namespace scalebreak
