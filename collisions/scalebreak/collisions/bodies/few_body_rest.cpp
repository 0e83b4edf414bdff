#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <scalebreak/collisions/bodies/few_body_system.hpp>
#include <scalebreak/collisions/bodies/normal_well.hpp>

// When nothing can part or meet any more.

namespace scalebreak {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Bodies that hold together, or one that flies alone.
struct Cluster {
  std::vector<std::size_t> members;
  bool fixed = false, plane = false;
  Vector3d centre{0, 0, 0}, drift{0, 0, 0};
  double radius = 0;   ///< of a sphere about the centre that holds it
  double turning = 0;  ///< kinetic energy of its rotation as a whole
  double moving = 0;   ///< all other kinetic energy about its centre
  double stored = 0;   ///< in its contacts, above their wells
};

Cluster cluster_of(const std::vector<MovingBody>& bodies, std::vector<std::size_t> members) {
  Cluster cluster{.members = std::move(members)};
  double mass = 0;
  for (const std::size_t b : cluster.members) {
    const MovingBody& body = bodies[b];
    cluster.plane |= body.plane;
    if (!std::isfinite(body.mass)) {
      cluster.fixed = true;
      cluster.centre = body.position;
      cluster.drift = body.velocity;
      break;
    }
    mass += body.mass;
    cluster.centre += (body.position - cluster.centre) * (body.mass / mass);
    cluster.drift += (body.velocity - cluster.drift) * (body.mass / mass);
  }
  Vector3d angular = Vector3d::Zero();
  Matrix3d inertia = Matrix3d::Zero();
  for (const std::size_t b : cluster.members) {
    const MovingBody& body = bodies[b];
    const Vector3d at = body.position - cluster.centre, velocity = body.velocity - cluster.drift;
    cluster.radius = std::max(cluster.radius, at.norm() + body.radius);
    if (!std::isfinite(body.mass)) continue;
    cluster.moving += body.mass * velocity.squaredNorm() / 2 + body.inertia * body.spin.squaredNorm() / 2;
    angular += body.mass * at.cross(velocity) + body.inertia * body.spin;
    inertia += (body.inertia + body.mass * at.squaredNorm()) * Matrix3d::Identity() - body.mass * at * at.transpose();
  }
  if (cluster.fixed) return cluster;
  cluster.turning = angular.dot(inertia.inverse() * angular) / 2;
  cluster.moving = std::max(0.0, cluster.moving - cluster.turning);
  if (cluster.members.size() != 2) return cluster;
  // No law acts on the twist of two bodies about the line between them.
  const MovingBody &a = bodies[cluster.members[0]], &b = bodies[cluster.members[1]];
  const double twist = (a.spin - b.spin).dot((b.position - a.position).normalized());
  cluster.moving = std::max(0.0, cluster.moving - twist * twist / (1 / a.inertia + 1 / b.inertia) / 2);
  return cluster;
}

/// Do two clusters pass through each other's neighbourhood on their straight ways?
bool may_meet(const Cluster& a, const Cluster& b) {
  if (a.fixed && b.fixed) return false;
  if (a.plane || b.plane) return (a.plane ? b.drift - a.drift : a.drift - b.drift)[2] < 0;
  const Vector3d between = b.centre - a.centre, velocity = a.drift - b.drift;
  const double closing = velocity.dot(between), reach = a.radius + b.radius;
  if (!(closing > 0)) return between.norm() < reach;
  return between.squaredNorm() - closing * closing / velocity.squaredNorm() < reach * reach;
}

}  // namespace

bool FewBodySystem::rests(const State& y) const {
  if (links_.empty()) return false;
  // Each body's cluster is named by one of its members.
  std::vector<std::size_t> name(bodies_.size());
  std::iota(name.begin(), name.end(), std::size_t{0});
  for (const Link& link : links_) {
    if (!link.touching || link.turn_backs == 0) return false;
    const std::size_t from = name[static_cast<std::size_t>(link.first)], to = name[static_cast<std::size_t>(link.second)];
    std::replace(name.begin(), name.end(), from, to);
  }
  const std::vector<MovingBody> now = bodies(y);
  std::vector<Cluster> clusters;
  for (std::size_t c = 0; c < name.size(); ++c) {
    std::vector<std::size_t> members;
    for (std::size_t b = 0; b < name.size(); ++b) {
      if (name[b] == c) members.push_back(b);
    }
    if (!members.empty()) clusters.push_back(cluster_of(now, std::move(members)));
  }
  for (std::size_t a = 0; a < clusters.size(); ++a) {
    for (std::size_t b = a + 1; b < clusters.size(); ++b) {
      if (may_meet(clusters[a], clusters[b])) return false;
    }
  }
  const auto home = [&](const Link& link) -> Cluster& {
    return *std::find_if(clusters.begin(), clusters.end(), [&](const Cluster& cluster) {
      return std::find(cluster.members.begin(), cluster.members.end(), static_cast<std::size_t>(link.first)) != cluster.members.end();
    });
  };
  // What a contact holds above its well it may give to another one.
  const auto spare = [&](std::size_t c) {
    const MappedLaws& mapped = laws_[links_[c].pair];
    const double pull = mapped.laws.liquid.capillary_force(mapped.laws.liquid.separation_min);
    return mapped.force / mapped.length *
           std::visit(
               [&](const auto& law) {
                 return well_energy(law, y[link_at(c) + coordinate], pull) - well_energy(law, well_bottom(law, pull), pull);
               },
               mapped.laws.normal);
  };
  for (std::size_t c = 0; c < links_.size(); ++c) home(links_[c]).stored += spare(c);
  for (std::size_t c = 0; c < links_.size(); ++c) {
    const Link& link = links_[c];
    const MappedLaws& mapped = laws_[link.pair];
    const auto [parted, overlap, energy] = std::visit(
        [&](const auto& law) {
          const double x = y[link_at(c) + coordinate];
          return std::array{law.separation(), law.overlap(x), law.energy(law.separation()) - law.energy(x)};
        },
        mapped.laws.normal);
    const Liquid& liquid = mapped.laws.liquid;
    const double reach = link.bridged ? liquid.rupture : 0.0;
    const double needed = mapped.force / mapped.length * (energy + liquid.capillary_energy(reach) - liquid.capillary_energy(-overlap));
    const double end = std::visit([p = parted](const auto& law) { return law.overlap(p); }, mapped.laws.normal);
    // As bodies part, turning as a whole slows, by about twice the share that their distance grows.
    const double growth =
        2 * (overlap - std::min(end, -reach)) / mapped.length /
        std::max(bodies_[static_cast<std::size_t>(link.first)].radius, bodies_[static_cast<std::size_t>(link.second)].radius);
    const Cluster& whole = home(link);
    if (whole.moving + growth * whole.turning + whole.stored - spare(c) >= needed) return false;
  }
  return true;
}

}  // namespace scalebreak
