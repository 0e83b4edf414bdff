#pragma once

#include <memory>
#include <string_view>

#include <scalebreak/ensembles/engine/dem_engine.hpp>
#include <scalebreak/ensembles/engine/event_engine.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// The hybrid in a run: collisions of two are looked up, patches of more are integrated, and where patches are most of the flow all of it is
/// handed over to the soft-sphere engine until it thins. What it does when follows from the flow alone.
class HybridEngine final : public FlowEngine {
 public:
  /// `setup`: of the soft spheres, on as many threads where they are all of it.
  HybridEngine(const System& start, const Input& input, const TableStore& store, const DemSetup& setup);
  HybridEngine(std::string_view saved, const Input& input, const TableStore& store, const DemSetup& setup);

  void advance_to(double time) override;
  void keep_sums(bool keep) override;
  [[nodiscard]] double time() const override;
  [[nodiscard]] System system() const override { return engine().system(); }
  [[nodiscard]] std::vector<ContactForce> contact_forces() const override { return engine().contact_forces(); }
  [[nodiscard]] bool tells_forces() const override { return false; }
  [[nodiscard]] EngineTotals totals() const override;
  [[nodiscard]] double elastic_energy() const override { return engine().elastic_energy(); }
  [[nodiscard]] std::string save() const override;

 private:
  [[nodiscard]] const FlowEngine& engine() const { return soft_ ? static_cast<const FlowEngine&>(*soft_) : *flying_; }
  [[nodiscard]] bool is_crowded(double since) const;
  [[nodiscard]] bool is_thin() const;
  /// Of what runs now. All that soft spheres do counts as one patch of the whole flow.
  [[nodiscard]] EngineTotals running_totals() const;
  void hand_over();
  void take_back();

  const Input& input_;
  TableStore store_;
  DemSetup setup_;
  std::size_t count_;
  bool keeps_sums_ = true;
  std::unique_ptr<EventEngine> flying_;  ///< one of the two
  std::unique_ptr<DemEngine> soft_;
  EngineTotals before_;    ///< of engines that have handed over
  double patch_time_ = 0;  ///< at the last look [s]
  double soft_since_ = 0;  ///< [s]
  /// Samples since the last handover, and how many soft spheres stay at least: twice as many after each flight that was crowded at once.
  long since_handover_ = 0, stay_ = 1;
};

}  // namespace scalebreak
