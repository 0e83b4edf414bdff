#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include <scalebreak/ensembles/engine/flow_engine.hpp>
#include <scalebreak/ensembles/event/event_spheres.hpp>
#include <scalebreak/ensembles/event/rules/table_rule.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// The event-driven engine in a run: spheres whose collisions are looked up, each as if it were alone; or, given how groups are stepped, the
/// hybrid, which integrates those that are not.
class EventEngine final : public FlowEngine {
 public:
  /// Throws InputError where the input's laws have no tables and there are no groups, or its spheres do not fit the cell.
  EventEngine(const System& start, const Input& input, const TableStore& store, const std::optional<DemSetup>& groups = {});
  /// Goes on with the same input and groups.
  EventEngine(std::string_view saved, const Input& input, const TableStore& store, const std::optional<DemSetup>& groups = {});

  void advance_to(double time) override { spheres_.advance_to(time); }
  void keep_sums(bool) override {}  // they cost nothing
  [[nodiscard]] double time() const override { return spheres_.time(); }
  [[nodiscard]] System system() const override { return spheres_.system(); }
  [[nodiscard]] std::vector<ContactForce> contact_forces() const override {
    return groups_ ? spheres_.touching() : std::vector<ContactForce>();
  }
  [[nodiscard]] bool tells_forces() const override { return false; }
  [[nodiscard]] EngineTotals totals() const override;
  [[nodiscard]] double elastic_energy() const override { return spheres_.elastic_energy(); }
  [[nodiscard]] std::string save() const override;
  /// With groups: the state with all contacts that last, for a soft-sphere engine to go on from.
  [[nodiscard]] System soft_system();

 private:
  std::unique_ptr<GroupLaws> groups_;  ///< null: there are none
  EventSpheres<CalendarQueue, TableRule> spheres_;
};

/// How often a sphere of a gas meets others, by Enskog's theory with Carnahan & Starling's contact value: `crowd` is Σd²/V [1/m], `speed` the root
/// mean square [m/s] → [1/s].
[[nodiscard]] double enskog_rate(double crowd, double volume_fraction, double speed);

/// How often the state of an event-driven flow is worth a look: a few times that its spheres fly between collisions, by Enskog's rate at a
/// root mean square speed [m/s]. Contacts need no look, they are summed as they happen [s].
[[nodiscard]] double event_sample_interval(const System& start, double speed);

}  // namespace scalebreak
