#include <scalebreak/table/pair_lookup.hpp>

#include <cmath>

#include <Eigen/Geometry>

namespace scalebreak {
namespace {

using Eigen::Vector3d;

Vector3d in_plane(const Vector3d& v, const Vector3d& normal) { return v - normal * normal.dot(v); }

/// A vector of the plane across `from`, carried to that across `to` by the shortest turn.
Vector3d carried(const Vector3d& v, const Vector3d& from, const Vector3d& to) { return v - (from + to) * (to.dot(v) / (1 + from.dot(to))); }

}  // namespace

bool rolls_apart(const SurfaceKind& surface, const std::array<double, 2>& radius, const std::array<double, 2>& inertia) {
  if (surface.tangential == TangentialModel::none || surface.rolling == RollingModel::none) return true;
  const double first = radius[0] / inertia[0], second = radius[1] / inertia[1];
  const bool same_arm = surface.torque_arm == TorqueArm::radius || radius[0] == radius[1];
  return same_arm && std::abs(first - second) <= 1e-12 * (first + second);
}

const char* to_string(Refusal refusal) {
  switch (refusal) {
    case Refusal::none: return "none";
    case Refusal::sticks: return "sticks";
    case Refusal::outside_table: return "outside the table";
    case Refusal::turns_too_far: return "turns too far";
    case Refusal::coupled: return "sliding and rolling change each other";
    case Refusal::liquid: return "a liquid acts at a distance";
    case Refusal::no_table:
    case Refusal::count: break;
  }
  return "no table";
}

PairLookup::PairLookup(const CollidingPair& pair, const TableRow* normal, const ObliqueTable* oblique, const RollingLookup& rolling)
    : pair_(pair), normal_(normal), oblique_(oblique), rolling_(rolling) {
  const bool slides = pair.surface.tangential != TangentialModel::none, rolls = pair.surface.rolling != RollingModel::none;
  if (!normal || (slides && !oblique) || (rolls && !rolling)) refusal_ = Refusal::no_table;
  if (pair.surface.attraction != Attraction::none) refusal_ = Refusal::liquid;
  mass_ = 1 / (1 / pair.mass[0] + 1 / pair.mass[1]);
  distance_ = pair.radius[0] + pair.radius[1];
  if (!rolls_apart(pair.surface, pair.radius, pair.inertia))
    coupling_ = pair.radius[0] / pair.inertia[0] - pair.radius[1] / pair.inertia[1];
  if (!pair.kind.adhesive()) return;
  scales_ = reduce(pair.kind, pair.normal, 1.0).scales;
  end_gap_ = reduced_end_gap(pair.kind) * scales_.overlap;
}

PairOutcome PairLookup::resolve(const PairImpact& impact, double tolerance) const {
  PairOutcome outcome{.refusal = refusal_};
  if (refusal_ != Refusal::none) return outcome;
  const auto refused = [&](Refusal reason) { return outcome.refusal = reason, outcome; };

  const Vector3d& n = impact.normal;
  const Vector3d velocity = impact.velocity[0] - impact.velocity[1];
  const double normal_speed = velocity.dot(n);
  const bool adhesive = pair_.kind.adhesive();
  const auto scales = adhesive ? scales_ : reduce(pair_.kind, pair_.normal, normal_speed).scales;
  const double reduced_speed = adhesive ? normal_speed / scales.speed() : 1.0;
  const auto head_on = normal_->find(reduced_speed);
  if (!head_on) return refused(Refusal::outside_table);
  if (head_on->stuck) return refused(Refusal::sticks);
  const double contact_time = head_on->contact_time * scales.time, depth = head_on->max_overlap * scales.overlap / distance_;
  double separation_speed = head_on->restitution * normal_speed;

  // What slides, and how far it gets.
  const Vector3d centres = velocity - n * normal_speed;
  const Vector3d arms = pair_.radius[0] * impact.spin[0] + pair_.radius[1] * impact.spin[1],
                 relative_spin = impact.spin[0] - impact.spin[1];
  Exchange exchanged;
  if (coupling_ != 0) {
    const auto found = exchange(n, normal_speed, reduced_speed, centres + arms.cross(n), in_plane(relative_spin, n));
    if (!found) return refused(Refusal::outside_table);
    exchanged = *found;
    outcome.coupling_error = exchanged.error;
    if (exchanged.error > tolerance) return refused(Refusal::coupled);
  }
  const Vector3d sliding = centres + arms.cross(n) + exchanged.sliding;
  const double slide = sliding.norm(), ratio = slide / normal_speed;
  const Vector3d along = slide > 0 ? Vector3d(sliding / slide) : in_plane(centres, n).stableNormalized();
  Vector3d displacement = contact_time * centres, centres_change = Vector3d::Zero(), surfaces_change = Vector3d::Zero();
  std::optional<ObliqueEntry> entry;
  if (oblique_) {
    entry = oblique_->find(reduced_speed, ratio);
    if (!entry) return refused(Refusal::outside_table);
    displacement -= contact_time * entry->lag * sliding;
    centres_change = -(1 - entry->surface_restitution) / (1 + oblique_->key().inertia) * sliding;
    surfaces_change = oblique_->key().inertia * centres_change;
  }
  const Vector3d turned_normal = pair_.wall ? n : Vector3d((n - displacement / distance_).normalized());
  const Vector3d middle = pair_.wall ? n : Vector3d((n + turned_normal).normalized());

  // The first order of the turning, and what it leaves out.
  const double across = in_plane(centres - along * along.dot(centres), n).norm() / normal_speed, tau = centres.dot(along) / normal_speed;
  const double square = tau * tau + across * across, twist = arms.dot(n) / normal_speed;
  if (pair_.wall ? pair_.surface.torque_arm == TorqueArm::contact && oblique_ : oblique_ != nullptr) {
    const auto turning = oblique_->turning(reduced_speed, ratio);
    if (!turning) return refused(depth * square > 0 ? Refusal::turns_too_far : Refusal::outside_table);
    const auto at = [&](const Eigen::Array3d& c) { return depth * normal_speed * (c[0] + c[1] * tau + c[2] * square); };
    separation_speed += at(turning->normal);
    const double centres_more = at(turning->tangential), sliding_more = at(turning->sliding);
    // Across the sliding, friction follows what has turned half-way into it.
    const Vector3d half_way = carried(in_plane(velocity, middle) + arms.cross(middle), middle, n) + exchanged.sliding;
    const Vector3d aside = slide > 0 ? Vector3d((half_way - along * along.dot(half_way)) / slide) : Vector3d::Zero();
    centres_change += along * centres_more + aside * centres_change.dot(along);
    surfaces_change += along * (sliding_more - centres_more) + aside * surfaces_change.dot(along);
  }
  const double size = 1 + ratio + std::sqrt(square);
  double error = pair_.wall ? 0.0 : second_order * depth * depth * size * size;
  if (oblique_) error += oblique_->quality().turning_error_median * depth * size * size;
  if (!pair_.wall) error += first_order * depth * (oblique_ ? across + std::abs(twist) * std::sqrt(square) : square);
  const Vector3d rolling = in_plane(relative_spin + exchanged.rolling, middle);
  const double roll = pair_.normal.radius * rolling.norm() / normal_speed;
  if (rolling_ && !pair_.wall) {
    const double relative_twist = pair_.normal.radius * std::abs(relative_spin.dot(n)) / normal_speed;
    error += first_order * depth * (square + relative_twist * std::sqrt(square));
  }
  outcome.turning_error = error;
  if (error > tolerance) return refused(Refusal::turns_too_far);

  const Vector3d relative = carried(centres + centres_change, n, turned_normal) - turned_normal * separation_speed;
  const Vector3d drift = impact.velocity[0] - mass_ / pair_.mass[0] * velocity;
  outcome.velocity = {drift + mass_ / pair_.mass[0] * relative, drift - (1 - mass_ / pair_.mass[0]) * relative};
  outcome.contact_time = contact_time;
  outcome.displacement =
      pair_.wall ? Vector3d(displacement - n * end_gap_) : Vector3d(n * distance_ - turned_normal * (distance_ + end_gap_));
  outcome.spin = impact.spin;
  if (oblique_) {
    const double ease = pair_.radius[0] * pair_.radius[0] / pair_.inertia[0] + pair_.radius[1] * pair_.radius[1] / pair_.inertia[1];
    Vector3d torque = middle.cross(carried(surfaces_change, n, middle)) * (distance_ / ease);  // on both together
    if (pair_.surface.torque_arm == TorqueArm::contact && !pair_.wall)
      torque = mass_ * ((distance_ + end_gap_) * turned_normal.cross(relative) - distance_ * n.cross(velocity));
    for (std::size_t i = 0; i < 2; ++i) outcome.spin[i] += pair_.radius[i] / (distance_ * pair_.inertia[i]) * torque;
  }
  if (rolling_) {
    const auto left = rolling_.find(reduced_speed, roll);
    if (!left) return refused(Refusal::outside_table);
    const double ease = 1 / pair_.inertia[0] + 1 / pair_.inertia[1];
    for (std::size_t i = 0; i < 2; ++i) outcome.spin[i] += (i == 0 ? -1 : 1) * (1 - *left) / (pair_.inertia[i] * ease) * rolling;
  }
  return outcome;
}

}  // namespace scalebreak
