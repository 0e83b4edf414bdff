#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <scalebreak/measure/contact_force.hpp>
#include <scalebreak/scene/system.hpp>

namespace scalebreak {

/// What a hybrid engine left to be integrated in patches of spheres; while soft spheres are all of the flow, it is one patch.
struct PatchTotals {
  long begun = 0;             ///< patches
  long taken_back = 0;        ///< collisions of two that a third sphere disturbed after they had been put as instants
  long unresolved = 0;        ///< collisions that no table answered
  long sphere_steps = 0;      ///< steps of single spheres
  double contact_starts = 0;  ///< in patches, at a wall ½
  double sphere_time = 0;     ///< that spheres spent in patches [s]

  /// `number` is called with each of a and the same of b.
  template <class A, class B, class Number>
  static void pair_up(A& a, B& b, Number&& number) {
    number(a.begun, b.begun), number(a.taken_back, b.taken_back), number(a.unresolved, b.unresolved),
        number(a.sphere_steps, b.sphere_steps);
    number(a.contact_starts, b.contact_starts), number(a.sphere_time, b.sphere_time);
  }
};

/// Running totals of an engine since its start, as Sample wants them; what an engine does not keep is left out.
struct EngineTotals {
  double contact_starts = 0;  ///< of a sphere at a wall ½
  double wall_work = 0;       ///< done by moving walls on the spheres [J]
  std::optional<double> shear_work, dissipated, contact_time;
  std::optional<Eigen::Matrix3d> contact_moment;
  long steps = 0;  ///< of time
  /// Of contact forces of what touches, at a wall ½; of soft spheres while sums are kept.
  double evaluations = 0;
  std::optional<long> events;      ///< of an event-driven engine
  std::optional<long> integrated;  ///< of these, collisions that no table answered
  std::optional<long> delayed;     ///< and those put behind, TableRule::delayed
  std::optional<PatchTotals> patches;
  long handovers = 0;  ///< of the whole flow, between engines
};

/// What a run needs of an engine that moves a flow on.
class FlowEngine {
 public:
  FlowEngine() = default;
  virtual ~FlowEngine() = default;
  FlowEngine(const FlowEngine&) = delete;
  FlowEngine& operator=(const FlowEngine&) = delete;

  /// To a time [s]; an engine with a step to the whole step that is nearest. Throws WorkError where the run failed.
  virtual void advance_to(double time) = 0;
  /// Whether what only a measurement asks for is kept; true at the start.
  virtual void keep_sums(bool keep) = 0;

  [[nodiscard]] virtual double time() const = 0;  ///< [s]
  /// The state at this time, in the order of identity.
  [[nodiscard]] virtual System system() const = 0;
  [[nodiscard]] virtual std::vector<ContactForce> contact_forces() const = 0;
  /// Are the forces of these contacts theirs? Else only what touches is told.
  [[nodiscard]] virtual bool tells_forces() const { return true; }
  [[nodiscard]] virtual EngineTotals totals() const = 0;
  [[nodiscard]] virtual double elastic_energy() const = 0;  ///< of all contacts [J]
  /// What the same engine goes on from, bit for bit.
  [[nodiscard]] virtual std::string save() const = 0;
};

}  // namespace scalebreak
