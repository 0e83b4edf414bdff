#include <scalebreak/dem/group/dem_group.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <scalebreak/dem/spring_energy.hpp>

namespace scalebreak {

using namespace dem;

DemGroup::DemGroup(const GroupLaws& laws, double time) : laws_(&laws), time_(time), walls_(laws.walls().size()) {
  if (!laws.each()) return;
  own_rows_.push_back(laws.rows(false));
  if (!walls_.empty()) own_rows_.push_back(laws.rows(true));
}

std::uint32_t DemGroup::open_row(bool wall, std::uint32_t first, std::uint32_t second) {
  if (own_rows_.empty()) return laws_->rows(wall).row_of(spheres_.kind[first], wall ? 0 : spheres_.kind[second]);
  const auto kind = [this](std::uint32_t k) { return LawRows::Kind{radius(k), material_[k]}; };
  return own_rows_[wall ? 1 : 0].open(kind(first), kind(wall ? first : second));
}

std::uint32_t DemGroup::add(const GroupSphere& sphere) {
  const std::uint32_t k = count();
  everyone_.push_back(k);
  spheres_.id.push_back(k);
  spheres_.position.push_back(quad(sphere.position, sphere.radius));
  spheres_.velocity.push_back(quad(sphere.velocity, 1 / sphere.mass));
  spheres_.seen_velocity.push_back(spheres_.velocity.back());
  // Without laws that turn them spins are kept and left alone.
  const Quad spin = quad(sphere.spin, 1 / (0.4 * sphere.mass * sphere.radius * sphere.radius));
  spheres_.spin.push_back(spin), spheres_.seen_spin.push_back(spin);
  spheres_.force.emplace_back(), spheres_.torque.emplace_back();
  spheres_.kind.push_back(laws_->kind_number({sphere.radius, sphere.material}));
  material_.push_back(sphere.material), mass_.push_back(sphere.mass);
  return k;
}

void DemGroup::add(const ContactMemory& contact) {
  const bool wall = contact.second < 0;
  Contact added{.first = static_cast<std::uint32_t>(contact.first),
                .second = wall ? no_image : packed(static_cast<std::uint32_t>(contact.second), no_image),
                .state = contact.touching ? touching : bridged,
                .begun = contact.begun,
                .slide = quad(contact.sliding, 0),
                .roll = quad(contact.rolling, 0)};
  each_list([&](Pairs& pairs, const WallView* at) {
    if (wall ? !at || wall_number(at->axis, at->side > 0) != contact.second : at != nullptr) return;
    added.row = open_row(wall, added.first, sphere_of(added.second));
    pairs.contacts.slides = laws_->slides_, pairs.contacts.rolls = laws_->rolls_;
    pairs.contacts.add(added);
  });
}

void DemGroup::absorb(const DemGroup& other, const Eigen::Vector3d& shift, const Eigen::Vector3d& drift) {
  const auto before = static_cast<std::int32_t>(count());
  for (std::uint32_t k = 0; k < other.count(); ++k) {
    GroupSphere sphere = other.sphere(k);
    sphere.position += shift, sphere.velocity += drift;
    add(sphere);
  }
  for (ContactMemory contact : other.contacts()) {
    contact.first += before;
    if (contact.second >= 0) contact.second += before;
    add(contact);
  }
}

DemGroup DemGroup::part(std::span<const std::uint32_t> which) const {
  DemGroup group(*laws_, time_);
  std::vector<std::int32_t> number(count(), -1);
  for (const std::uint32_t k : which) number[k] = static_cast<std::int32_t>(group.add(sphere(k)));
  for (ContactMemory contact : contacts()) {
    const std::int32_t first = number[static_cast<std::size_t>(contact.first)];
    if (first < 0) continue;
    contact.first = first;
    if (contact.second >= 0) contact.second = number[static_cast<std::size_t>(contact.second)];
    group.add(contact);
  }
  return group;
}

GroupSphere DemGroup::sphere(std::uint32_t k) const {
  return {position(k), velocity(k), vector(spheres_.spin[k]), radius(k), mass_[k], material_[k]};
}
Eigen::Vector3d DemGroup::position(std::uint32_t k) const { return vector(spheres_.position[k]); }
Eigen::Vector3d DemGroup::velocity(std::uint32_t k) const { return vector(spheres_.velocity[k]); }

std::vector<ContactMemory> DemGroup::contacts() const {
  std::vector<ContactMemory> memories;
  const auto put = [&](const Contacts& contacts, std::int32_t wall) {
    for (std::uint32_t k = 0; k < contacts.count; ++k) {
      if (contacts.state[k] == apart) continue;
      const Contact contact = contacts.get(k);
      memories.push_back({.first = static_cast<std::int32_t>(contact.first),
                          .second = wall < 0 ? wall : static_cast<std::int32_t>(sphere_of(contact.second)),
                          .touching = contact.state == touching,
                          .begun = contact.begun,
                          .sliding = vector(contact.slide),
                          .rolling = vector(contact.roll)});
    }
  };
  put(pairs_.contacts, 0);
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    const WallView& wall = laws_->walls()[w];
    put(walls_[w].contacts, wall_number(wall.axis, wall.side > 0));
  }
  return memories;
}

void DemGroup::begin_at(double time) {
  each_list([&](Pairs& pairs, const WallView*) {
    for (std::uint32_t k = 0; k < pairs.contacts.count; ++k) pairs.contacts.begun[k] += time - time_;
  });
  time_ = time;
}

double DemGroup::kinetic_energy() const {
  double twice = 0;
  for (std::uint32_t k = 0; k < count(); ++k) {
    const Quad &v = spheres_.velocity[k], &w = spheres_.spin[k];
    twice += vector(v).squaredNorm() / v.w + vector(w).squaredNorm() / w.w;
  }
  return twice / 2;
}

double DemGroup::elastic_energy() const {
  double energy = spring_energy(pairs_.contacts, rows(false), [&](std::uint32_t k) {
    const Quad &here = spheres_.position[pairs_.contacts.first[k]], &there = spheres_.position[sphere_of(pairs_.contacts.second[k])];
    return (vector(there) - vector(here)).norm() - here.w - there.w;
  });
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    const WallView& wall = laws_->walls()[w];
    energy += spring_energy(walls_[w].contacts, rows(true), [&](std::uint32_t k) {
      const Quad& here = spheres_.position[walls_[w].contacts.first[k]];
      return wall.side * (wall.place - (&here.x)[wall.axis]) - here.w;
    });
  }
  return energy;
}

GroupTotals DemGroup::take_totals() { return std::exchange(totals_, {}); }

}  // namespace scalebreak
