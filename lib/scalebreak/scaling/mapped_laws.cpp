#include <scalebreak/scaling/mapped_laws.hpp>

#include <cmath>

namespace scalebreak {

MappedLaws mapped_laws(const ContactKind& contact, const SurfaceKind& surface, const Bodies& original, const ScalingLaw& law, double factor,
                       std::array<bool, 2> fixed) {
  const Bodies evaluated = law.direct_force ? original : scaled_bodies(law, factor, original, contact.normal);
  NormalPair pair = evaluated.pair();
  SurfacePair surfaces = evaluated.surfaces();
  for (const std::size_t moves : {0, 1}) {
    if (!fixed[1 - moves]) continue;
    const Material& material = moves == 0 ? evaluated.first : evaluated.second;
    const double radius = evaluated.radius[moves];
    pair.mass = sphere_mass(radius, material.density);
    surfaces.rolling_inertia = 1.4 * pair.mass * radius * radius;
  }
  const auto power = [&](double exponent) { return std::pow(factor, exponent); };
  const ContactKind kind = effective_kind(contact, pair.surface_energy);
  MappedLaws mapped{.laws = contact_laws(kind, surface, pair, surfaces, power(law.adhesive_rolling)),
                    .radius = {evaluated.radius[0], original.against_wall() ? 0.0 : evaluated.radius[1]}};
  if (!law.direct_force) return mapped;
  mapped.length = power(-law.overlap);
  mapped.spin = factor;
  mapped.force = power(law.force);
  mapped.torque = power(law.torque);
  return mapped;
}

}  // namespace scalebreak
