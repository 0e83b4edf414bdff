#include <scalebreak/contact/contact_laws.hpp>

#include <algorithm>

namespace scalebreak {

bool ContactLaws::needs_overlap_root() const {
  if (std::holds_alternative<Hertz<double>>(normal)) return false;
  if (std::holds_alternative<Jkr<double, DampingOn::overlap>>(normal)) return true;
  return (tangential.model == TangentialModel::mindlin && tangential.on_overlap) || rolling.on_overlap();
}

double ContactLaws::reach() const {
  const double stretched = std::visit([](const auto& law) { return -law.overlap(law.separation()); }, normal);
  return std::max({stretched, liquid.bridges() ? liquid.rupture : 0.0, 0.0});
}

ContactLaws contact_laws(const ContactKind& kind, const SurfaceKind& surface, const NormalPair& pair, const SurfacePair& surfaces,
                         double adhesive_rolling) {
  ContactLaws laws{.normal = normal_law(kind, pair),
                   .radius = pair.radius,
                   .tangential = Tangential::make(surface, pair, surfaces),
                   .rolling = Rolling::make(surface, kind, pair, surfaces, adhesive_rolling),
                   .liquid = Liquid::make(surface, pair, surfaces),
                   .arm = surface.torque_arm};
  // The two springs of a Hertz contact are one, and smooth in its contact radius.
  if (kind.normal == NormalModel::hertz) laws.tangential.on_overlap = false;
  if (kind.normal == NormalModel::linear) laws.tangential.on_overlap = true;
  return laws;
}

}  // namespace scalebreak
