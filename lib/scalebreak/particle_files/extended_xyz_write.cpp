#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scalebreak/particle_files/extended_xyz.hpp>
#include <scalebreak/particle_files/particle_columns.hpp>

namespace scalebreak {

namespace {

/// How Properties names a column and those that follow it, or nothing within a vector.
const char* property_of(column::Name name) {
  switch (name) {
    case column::x: return "pos:R:3:";
    case column::radius: return "radius:R:1:";
    case column::vx: return "velo:R:3:";
    case column::wx: return "angular_velocity:R:3:";
    case column::mass: return "mass:R:1:";
    case column::material: return "material:I:1:";
    default: return "";
  }
}

}  // namespace

std::string extended_xyz(const System& system, const ParticleFields& fields) {
  const std::vector<column::Name> columns = columns_of(fields);
  std::string properties;
  for (const column::Name name : columns) properties += property_of(name);
  const Eigen::Vector3d& size = system.cell.size;
  const auto pbc = [&](int axis) { return system.cell.periodic(axis) ? 'T' : 'F'; };
  std::string text = fmt::format(
      "{}\nLattice=\"{:.17g} 0 0 0 {:.17g} 0 {:.17g} 0 {:.17g}\" Origin=\"0 0 0\" pbc=\"{} {} {}\" Time={:.17g} "
      "Properties={}id:I:1\n",
      system.count(), size.x(), size.y(), system.cell.shear_offset, size.z(), pbc(0), pbc(1), pbc(2), system.time, properties);
  for (std::size_t i = 0; i < system.count(); ++i)
    fmt::format_to(std::back_inserter(text), "{:.17g} {}\n", fmt::join(particle_row(system, i, columns), " "), i + 1);
  return text;
}

}  // namespace scalebreak
