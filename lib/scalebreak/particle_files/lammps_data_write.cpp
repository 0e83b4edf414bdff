#include <iterator>
#include <numbers>

#include <fmt/format.h>

#include <scalebreak/particle_files/lammps_box.hpp>
#include <scalebreak/particle_files/lammps_data.hpp>

namespace scalebreak {

std::string lammps_data(const System& system) {
  const Eigen::Vector3d& size = system.cell.size;
  std::string text = fmt::format(
      "LAMMPS data file of spheres, SI units\n\n{} atoms\n2 atom types\n\n0 {:.17g} xlo xhi\n0 {:.17g} ylo yhi\n0 {:.17g} zlo zhi\n",
      system.count(), size.x(), size.y(), size.z());
  if (const double tilt = lammps_tilt(system.cell); tilt != 0) text += fmt::format("0 {:.17g} 0 xy xz yz\n", tilt);
  text += "\nAtoms # sphere\n\n";
  for (std::size_t i = 0; i < system.count(); ++i) {
    const double r = system.radius[i], density = system.mass[i] / (4 * std::numbers::pi / 3 * r * r * r);
    const Eigen::Vector3d& at = system.position[i];
    fmt::format_to(std::back_inserter(text), "{} {} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", i + 1, system.material[i] + 1, 2 * r,
                   density, at.x(), at.y(), at.z());
  }
  text += "\nVelocities\n\n";
  for (std::size_t i = 0; i < system.count(); ++i) {
    const Eigen::Vector3d &v = system.velocity[i], &w = system.spin[i];
    fmt::format_to(std::back_inserter(text), "{} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", i + 1, v.x(), v.y(), v.z(), w.x(),
                   w.y(), w.z());
  }
  return text;
}

}  // namespace scalebreak
