#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <scalebreak/dem/group/group_laws.hpp>
#include <scalebreak/dem/lists/pairs.hpp>
#include <scalebreak/dem/spheres.hpp>
#include <scalebreak/scene/system.hpp>

namespace scalebreak {

namespace dem {
[[nodiscard]] inline Quad quad(const Eigen::Vector3d& v, double w) { return {v.x(), v.y(), v.z(), w}; }
[[nodiscard]] inline Eigen::Vector3d vector(const Quad& quad) { return {quad.x, quad.y, quad.z}; }
}  // namespace dem

/// A sphere that comes into a group, or leaves it, SI.
struct GroupSphere {
  Eigen::Vector3d position{0, 0, 0}, velocity{0, 0, 0}, spin{0, 0, 0};
  double radius = 0, mass = 0;
  std::uint8_t material = 0;
};

/// What a group's contacts did since it was last asked.
struct GroupTotals {
  double contact_starts = 0;                                 ///< of a sphere at a wall ½
  double contact_time = 0;                                   ///< [s]; of a sphere at a wall ½
  double evaluations = 0;                                    ///< of forces of what touches; of a sphere at a wall ½
  double wall_work = 0;                                      ///< done by moving walls on the spheres [J]
  Eigen::Matrix3d contact_moment = Eigen::Matrix3d::Zero();  ///< −∫Σ force branchᵀ dt [N m s]
  long steps = 0;                                            ///< of all spheres together
};

/// A few spheres, of which all may touch each other and the walls, in open space: the laws and the loops of Dem without its lists. Between two
/// calls the state is one of an instant: velocities, spins and histories too. Integrated by velocity Verlet with velocities of the
/// forces' instant, histories half before and half after each force.
class DemGroup {
 public:
  /// Keeps a pointer to the laws.
  DemGroup(const GroupLaws& laws, double time);

  /// Returns its number. Numbers are those of the order in which spheres came.
  std::uint32_t add(const GroupSphere& sphere);
  /// A contact that goes on: `first` and `second` (or the wall) are numbers in this group.
  void add(const ContactMemory& contact);
  /// Puts another group's spheres behind the own, moved by a vector and a velocity. Both must be of one time.
  void absorb(const DemGroup& other, const Eigen::Vector3d& shift, const Eigen::Vector3d& drift);
  /// Some of the spheres and the contacts among them, as a group.
  [[nodiscard]] DemGroup part(std::span<const std::uint32_t> which) const;

  /// To a time, by equal steps of at most laws.step(). What lies further apart than `margin` now is taken not to touch on the way [m].
  void advance_to(double time, double margin);
  /// Makes this instant another one of the clock.
  void begin_at(double time);

  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] const GroupLaws& laws() const { return *laws_; }
  [[nodiscard]] std::uint32_t count() const { return spheres_.count(); }
  [[nodiscard]] GroupSphere sphere(std::uint32_t k) const;
  [[nodiscard]] Eigen::Vector3d position(std::uint32_t k) const;
  [[nodiscard]] Eigen::Vector3d velocity(std::uint32_t k) const;
  [[nodiscard]] double radius(std::uint32_t k) const { return spheres_.position[k].w; }
  /// Contacts in which something acts; numbers of this group.
  [[nodiscard]] std::vector<ContactMemory> contacts() const;
  [[nodiscard]] double kinetic_energy() const;  ///< with rotation [J]
  [[nodiscard]] double elastic_energy() const;  ///< of all springs [J]
  /// Since they were last taken.
  [[nodiscard]] GroupTotals take_totals();

 private:
  class Keeper;

  void find_near(double margin);
  struct Work;
  void find_contacts(Work& work);
  void add_forces(Work& work, double before, double after, double step);
  [[nodiscard]] dem::MoveTask move_task(double step);
  void kick(double time);
  [[nodiscard]] dem::ForceTask task(dem::Pairs& pairs, const dem::WallView* wall);
  /// The pairs of spheres (without a wall), and those with each wall.
  template <class Visit>
  void each_list(Visit&& visit) {
    visit(pairs_, static_cast<const dem::WallView*>(nullptr));
    for (std::size_t w = 0; w < walls_.size(); ++w) visit(walls_[w], &laws_->walls()[w]);
  }

  [[nodiscard]] const dem::LawRows& rows(bool wall) const { return own_rows_.empty() ? laws_->rows(wall) : own_rows_[wall ? 1 : 0]; }
  /// Rows move as more are opened, also those of another wall's contacts.
  void show_rows(dem::ForceTask& task, bool wall) const;
  /// The row of a contact that begins; `second` is not used for a wall.
  [[nodiscard]] std::uint32_t open_row(bool wall, std::uint32_t first, std::uint32_t second);

  const GroupLaws* laws_;
  double time_;
  std::vector<dem::LawRows> own_rows_;  ///< between spheres and at walls, where each contact has laws of its own; else none
  dem::Spheres spheres_;
  std::vector<std::uint8_t> material_;
  std::vector<double> mass_;             ///< as given: the inverse of an inverse is not
  std::vector<std::uint32_t> everyone_;  ///< 0 … count − 1
  dem::Pairs pairs_;
  std::vector<dem::Pairs> walls_;
  GroupTotals totals_;
};

}  // namespace scalebreak
