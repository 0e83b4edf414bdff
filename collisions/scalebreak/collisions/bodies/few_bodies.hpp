#pragma once

#include <functional>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include <scalebreak/collisions/steps/stepper.hpp>
#include <scalebreak/scaling/mapped_laws.hpp>

namespace scalebreak {

/// A body of a few-body motion, SI, as it moves (under a scaling law: the scaled one).
struct MovingBody {
  Eigen::Vector3d position{0, 0, 0}, velocity{0, 0, 0}, spin{0, 0, 0};
  double radius = 0;
  double mass = std::numeric_limits<double>::infinity();     ///< infinite: moves on as it started
  double inertia = std::numeric_limits<double>::infinity();  ///< about its centre [kg m²]
  bool plane = false;                                        ///< a wall through `position`, above which the others are (+z)
};

/// Where the energy of a motion is and where it went [J]. The sum stays what it was at the start.
struct EnergyAccount {
  double kinetic = 0;   ///< translation and rotation
  double elastic = 0;   ///< in the contacts: the normal force's potential, zero at first touch, and tangential springs
  double damping = 0;   ///< taken by the normal dashpots
  double friction = 0;  ///< taken by the tangential forces beyond what their springs hold
  double rolling = 0;   ///< taken by the rolling torques, their springs included
  double adhesion = 0;  ///< lost where adhesive contacts tore
  double liquid = 0;    ///< taken by capillary and viscous forces; a bridge may still give some of it back

  [[nodiscard]] double total() const { return kinetic + elastic + damping + friction + rolling + adhesion + liquid; }
};

/// What acts between two bodies at one instant, SI. Forces are those on the first body.
struct ContactState {
  int first = 0, second = 0;
  bool touching = false;                      ///< else only a liquid bridge holds them
  double overlap = 0;                         ///< negative beyond first touch: of a stretched neck, of a bridge [m]
  double normal_force = 0;                    ///< spring and dashpot, repulsion positive [N]
  double liquid_force = 0;                    ///< along the line of centres, repulsion positive [N]
  Eigen::Vector3d tangential_force{0, 0, 0};  ///< of friction [N]
  Eigen::Vector3d surface_velocity{0, 0, 0};  ///< of the first surface past the second, in the contact plane [m/s]
  bool slides = false, rolls = false;         ///< beyond what the springs hold
  double contact_radius = 0;                  ///< of the pair in which the force is evaluated [m]; 0 of a linear contact
  double tangential_stiffness = 0;            ///< [N/m]
};

/// One instant of a motion.
struct MotionSample {
  double time;
  const std::vector<MovingBody>& bodies;
  EnergyAccount energy;
  double largest_overlap;                   ///< [m]
  std::vector<ContactState> contacts = {};  ///< if MotionOptions::sample_contacts asks for them
};

/// What of a contact has changed.
enum class ContactChange { touch, separation, slide, stick, roll, roll_stop, bridge, rupture };
[[nodiscard]] const char* to_string(ContactChange change);

/// What is asked of a motion.
struct MotionOptions {
  double tolerance = 1e-8;                                 ///< of the outcome, relative to what moves
  Stepper stepper = Stepper::fehlberg78;                   ///< docs/tradeoff.md says why
  double duration = 0;                                     ///< [s]; 0: until nothing can meet again, or all that touches rests
  std::function<void(const MotionSample&)> observer = {};  ///< at the start, every step, every event and the end
  double sample_interval = 0;                              ///< [s]; bounds the steps for the observer's sake; 0: none
  bool sample_contacts = false;                            ///< fill MotionSample::contacts
  bool find_max_force = false;                             ///< follow the largest force inside the steps too
  std::function<void(double time, int first, int second, ContactChange)> on_change = {};
};

/// How a motion ended.
struct MotionOutcome {
  std::vector<MovingBody> bodies;
  double time = 0;
  double first_touch = -1;      ///< [s]; negative if nothing touched
  double last_separation = -1;  ///< [s]
  int touches = 0, ruptures = 0;
  int slides = 0, rolls = 0;  ///< times that a contact began to slide, to roll, the first instant included
  bool resting = false;       ///< ended with contacts that cannot part
  int open_contacts = 0;      ///< that touch at the end
  double max_overlap = 0;     ///< [m]
  double max_depth = 0;       ///< largest overlap over R* of its pair
  double max_force = 0;       ///< largest normal force of a contact; at the steps' ends only, unless find_max_force [N]
  double turned = 0;          ///< largest angle by which a line of centres turned during one contact [rad]
  EnergyAccount before, after;
  int steps = 0;
  long force_evaluations = 0;  ///< of contacts and bridges, each once at every state looked at
};

/// Moves a few bodies that interact by `laws(i, j)` (i < j) to the end, exactly: adaptive steps, of eighth order unless asked for another, every touch,
/// separation, slip, stick, bridge and rupture located as an event. The bodies must not overlap at the start. Throws
/// WorkError where the motion cannot be followed.
[[nodiscard]] MotionOutcome move_bodies(std::vector<MovingBody> bodies, const std::function<MappedLaws(int, int)>& laws,
                                        const MotionOptions& options);

/// Linear and angular momentum (about the origin) of the bodies of finite mass.
[[nodiscard]] Eigen::Vector3d momentum(const std::vector<MovingBody>& bodies);
[[nodiscard]] Eigen::Vector3d angular_momentum(const std::vector<MovingBody>& bodies);
[[nodiscard]] double kinetic_energy(const std::vector<MovingBody>& bodies);

}  // namespace scalebreak
