#pragma once

#include <array>
#include <concepts>
#include <cstdint>

#include <Eigen/Core>

namespace scalebreak {

/// A sphere, or a wall as the second, at the instant it meets another, SI. A wall has no radius and an infinite mass.
struct Meeting {
  struct Body {
    double mass = 0, radius = 0;
    std::uint8_t material = 0;
    Eigen::Vector3d velocity{0, 0, 0}, spin{0, 0, 0};
  };
  Eigen::Vector3d normal;  ///< unit vector from the first to the second
  Body first, second;
  double distance =
      0;  ///< of the centres, or of a centre and the wall; less than the radii where an earlier collision has shifted them [m]
  bool wall = false;

  /// Of the first relative to the second.
  [[nodiscard]] Eigen::Vector3d velocity() const { return first.velocity - second.velocity; }
};

/// How they go on. A collision that took time is put as an instantaneous one from displaced places: `shift` is such that position + shift,
/// and from there on a straight line, is where the sphere will be once it has parted.
struct Parting {
  std::array<Eigen::Vector3d, 2> velocity, spin{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  std::array<Eigen::Vector3d, 2> shift{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};  ///< [m]
  double contact_time = 0;                                                                 ///< [s]
  bool unresolved = false;  ///< the rule does not say, and the two are as they were
};

/// A collision as a rule of the event-driven engine. `spins`: it looks at spins and changes them; `displaces`: it uses `shift`;
/// `lasts`: contacts have a time.
template <class Rule>
concept CollisionRule = requires(Rule rule, const Meeting& meeting) {
  { Rule::spins } -> std::convertible_to<bool>;
  { Rule::displaces } -> std::convertible_to<bool>;
  { Rule::lasts } -> std::convertible_to<bool>;
  { rule.collide(meeting) } -> std::same_as<Parting>;
};

}  // namespace scalebreak
