#include <scalebreak/contact/contact_laws.hpp>

#include <algorithm>
#include <utility>

namespace scalebreak {

bool ContactLaws::needs_overlap_root() const {
  const auto [in_coordinate, root_damped] = std::visit(
      []<class Law>(const Law&) { return std::pair(Law::traits.coordinate == Coordinate::overlap_root, RootDamped<Law>); }, normal);
  if (in_coordinate) return false;
  if (root_damped) return true;
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
  if (kind.traits().coordinate == Coordinate::overlap_root) laws.tangential.on_overlap = false;
  if (kind.traits().coordinate == Coordinate::overlap) laws.tangential.on_overlap = true;
  return laws;
}

}  // namespace scalebreak
