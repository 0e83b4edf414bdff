#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scalebreak/particle_files/extended_xyz.hpp>
#include <scalebreak/particle_files/particle_columns.hpp>

namespace scalebreak {

std::string extended_xyz(const System& system) {
  const Eigen::Vector3d& size = system.cell.size;
  const auto pbc = [&](int axis) { return system.cell.periodic(axis) ? 'T' : 'F'; };
  std::string text = fmt::format(
      "{}\nLattice=\"{:.17g} 0 0 0 {:.17g} 0 {:.17g} 0 {:.17g}\" Origin=\"0 0 0\" pbc=\"{} {} {}\" Time={:.17g} "
      "Properties=pos:R:3:radius:R:1:velo:R:3:angular_velocity:R:3:mass:R:1:material:I:1:id:I:1\n",
      system.count(), size.x(), size.y(), system.cell.shear_offset, size.z(), pbc(0), pbc(1), pbc(2), system.time);
  for (std::size_t i = 0; i < system.count(); ++i)
    fmt::format_to(std::back_inserter(text), "{:.17g} {}\n", fmt::join(particle_row(system, i), " "), i + 1);
  return text;
}

}  // namespace scalebreak
