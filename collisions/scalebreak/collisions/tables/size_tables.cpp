#include <scalebreak/collisions/tables/size_tables.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <scalebreak/collisions/tables/oblique_table_builder.hpp>
#include <scalebreak/collisions/tables/rolling_table_builder.hpp>

namespace scalebreak {
namespace {

/// Of the strengths of two tables of rolling, one to the next.
constexpr double rolling_step = 1.1;
/// m*R*²(1/I₁ + 1/I₂) of two equal spheres, and of a sphere and a wall.
constexpr double like_inertia = 0.625, wall_inertia = 2.5;
/// I + m r² of a solid sphere over I.
constexpr double rolling_over_own_inertia = 3.5;

/// Of a range, some radii evenly spread over its logarithm.
std::vector<double> radii_of(const RadiusRange& range) {
  constexpr int count = 32;
  std::vector<double> radii = {range.least};
  for (int k = 1; k < count && range.largest > range.least; ++k)
    radii.push_back(range.least * std::pow(range.largest / range.least, static_cast<double>(k) / (count - 1)));
  return radii;
}

}  // namespace

bool sizes_share_oblique(const ContactKind& kind, const SurfaceKind& surface, bool wall) {
  if (surface.tangential == TangentialModel::none) return true;
  if (surface.torque_arm == TorqueArm::contact && !wall) return false;
  return !(kind.adhesive() && surface.tangential == TangentialModel::linear);
}

SizeTables::SizeTables(const Input& input, const RadiusRange& first, const RadiusRange& second, const TableStore& store,
                       const PairTolerance& tolerance)
    : input_(input), tolerance_(tolerance) {
  const ScalingLaw& law = *find_scaling_law(input.scaling_law);
  size_ = size_factor(law, input.scaling_factor);
  adhesive_rolling_ = std::pow(input.scaling_factor, law.adhesive_rolling);
  pair_ = colliding_pair(input);
  surfaces_ = scaled_bodies(law, input.scaling_factor, input.colliding(), input.contact.normal).surfaces();
  const auto oblique = oblique_key(pair_.kind, pair_.surface, pair_.normal, surfaces_, solid_sphere_inertia,
                                   pair_.radius[0] / (pair_.radius[0] + pair_.radius[1]), tolerance.oblique);
  const bool slides = pair_.surface.tangential != TangentialModel::none, rolls = pair_.surface.rolling != RollingModel::none;
  if (pair_.surface.attraction != Attraction::none) {
    refusal_ = Refusal::liquid;
  } else if (law.direct_force || (slides && (!oblique.key || !sizes_share_oblique(pair_.kind, pair_.surface, pair_.wall))) ||
             (rolls && !rolling_key_of(pair_))) {
    refusal_ = Refusal::no_table;
  }
  if (refusal_ != Refusal::none) return;
  row_ = obtain_table({pair_.kind, tolerance.normal}, store).table.row(pair_.normal.damping_ratio);
  if (!row_) {
    refusal_ = Refusal::no_table;
    return;
  }
  if (slides) oblique_ = obtain_oblique_table(*oblique.key, store).table;
  if (rolls) obtain_rolling_tables(first, second, store);
}

CollidingPair SizeTables::resized(double radius1, double radius2) const {
  CollidingPair pair = pair_;
  const std::array<double, 2> radius = {radius1, radius2};
  for (std::size_t i = 0; i < (pair.wall ? 1u : 2u); ++i) {
    const double ratio = radius[i] / pair.radius[i], cube = ratio * ratio * ratio;
    pair.radius[i] = radius[i], pair.mass[i] *= cube, pair.inertia[i] *= cube * ratio * ratio;
  }
  pair.normal.mass = 1 / (1 / pair.mass[0] + 1 / pair.mass[1]);
  pair.normal.radius = pair.wall ? radius1 : radius1 * radius2 / (radius1 + radius2);
  return pair;
}

std::optional<RollingKey> SizeTables::rolling_key_of(const CollidingPair& pair) const {
  const double ease = 1 / pair.inertia[0] + 1 / pair.inertia[1];
  SurfacePair surfaces = surfaces_;
  surfaces.rolling_inertia = rolling_over_own_inertia / ease;
  return rolling_key(pair.kind, pair.surface, pair.normal, surfaces, ease, tolerance_.oblique, adhesive_rolling_).key;
}

double SizeTables::rolling_place(const RollingKey& key) const {
  return std::log(rolling_groups(key).strength / first_strength_) / std::log(rolling_step);
}

RollingKey SizeTables::rolling_key_at(double strength) const {
  // Of numbers of the laws and materials alone, so that every flow of them asks for the same tables.
  RollingKey key = *rolling_key_of(pair_);
  key.inertia = pair_.wall ? wall_inertia : like_inertia;
  if (key.model == RollingModel::ar) {
    key.stiffness = strength / key.inertia;
    key.limit = adhesive_rolling_ * surfaces_.rolling_angle_max / key.stiffness;
    return key;
  }
  key.inertia *= strength / rolling_groups(key).strength;
  if (key.model == RollingModel::epsd) key.dashpot = surfaces_.rolling_damping * std::sqrt(rolling_over_own_inertia / key.inertia);
  return key;
}

void SizeTables::obtain_rolling_tables(const RadiusRange& first, const RadiusRange& second, const TableStore& store) {
  RollingKey like = *rolling_key_of(pair_);
  like.inertia = pair_.wall ? wall_inertia : like_inertia;
  // Of `ar` it depends on the size itself: its tables lie where those of any other flow do.
  first_strength_ = like.model == RollingModel::ar ? 1.0 : rolling_groups(like).strength;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double radius1 : radii_of(first)) {
    for (const double radius2 : pair_.wall ? std::vector{0.0} : radii_of(second)) {
      const double place = rolling_place(*rolling_key_of(resized(radius1, radius2)));
      low = std::min(low, place), high = std::max(high, place);
    }
  }
  constexpr double rounding = 1e-6;
  first_table_ = static_cast<int>(std::floor(low + rounding));
  const int last = std::max(first_table_, static_cast<int>(std::ceil(high - rounding)));
  for (int table = first_table_; table <= last; ++table)
    rolling_.push_back(obtain_rolling_table(rolling_key_at(first_strength_ * std::pow(rolling_step, table)), store).table);
}

RollingLookup SizeTables::rolling_of(const CollidingPair& pair) const {
  if (rolling_.empty()) return {};
  const RollingKey key = *rolling_key_of(pair);
  const auto last = static_cast<int>(rolling_.size()) - 1;
  const int below = std::clamp(static_cast<int>(std::floor(rolling_place(key))) - first_table_, 0, std::max(0, last - 1));
  return {rolling_[static_cast<std::size_t>(below)], rolling_[static_cast<std::size_t>(std::min(below + 1, last))], key};
}

PairOutcome SizeTables::look_up(double radius1, double radius2, const PairImpact& impact) const {
  if (refusal_ != Refusal::none) return {.refusal = refusal_};
  const CollidingPair pair = resized(radius1, radius2);
  return PairLookup(pair, &*row_, oblique_ ? &*oblique_ : nullptr, rolling_of(pair)).resolve(impact, tolerance_.turning);
}

PairOutcome SizeTables::integrate(double radius1, double radius2, const PairImpact& impact) const {
  Input input = input_;
  input.radius = {radius1 / size_};
  if (!pair_.wall) input.radius.push_back(radius2 / size_);
  return integrate_impact(moving_scene(input), colliding_pair(input), impact, tolerance_.exact);
}

}  // namespace scalebreak
