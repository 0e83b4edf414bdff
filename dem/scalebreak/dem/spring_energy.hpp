#pragma once

#include <algorithm>
#include <cmath>

#include <scalebreak/dem/law_rows.hpp>
#include <scalebreak/dem/lists/pairs.hpp>

namespace scalebreak::dem {

/// What the springs of all contacts of a list hold: normal, tangential and rolling, and a liquid's capillary force; with histories as they
/// are kept [J]. `gap_of(k)` is between the surfaces of contact k [m].
template <class Gap>
[[nodiscard]] double spring_energy(const Contacts& contacts, const LawRows& rows, Gap gap_of) {
  const double length = rows.mapped().length, scale = rows.mapped().force / length;
  const auto square_of = [](const Quad& v) { return v.x * v.x + v.y * v.y + v.z * v.z; };
  double energy = 0;
  for (std::uint32_t k = 0; k < contacts.count; ++k) {
    if (contacts.state[k] == apart) continue;
    const ContactLaws& laws = rows.rows()[contacts.row[k]];
    const double overlap = -gap_of(k) * length;
    if (laws.liquid.acts()) energy += scale * laws.liquid.capillary_energy(-overlap);
    if (contacts.state[k] != touching) continue;
    ContactPoint point{.overlap = overlap};
    std::visit(
        [&](const auto& law) {
          const double x = law.coordinate(overlap);
          energy += scale * law.energy(x);
          point.root = law.root_radius(x);
          point.overlap_root = std::sqrt(std::sqrt(laws.radius * std::max(overlap, 0.0)));
        },
        laws.normal);
    if (contacts.slides) energy += scale / 2 * laws.tangential.at(point).stiffness * square_of(contacts.slide.get(k));
    if (!contacts.rolls) continue;
    const SliderLaw rolling = laws.rolling.at(point);
    const double square = square_of(contacts.roll.get(k));
    if (rolling.stiffness > 0) energy += scale / 2 * (rolling.incremental ? square / rolling.stiffness : square * rolling.stiffness);
  }
  return energy;
}

}  // namespace scalebreak::dem
