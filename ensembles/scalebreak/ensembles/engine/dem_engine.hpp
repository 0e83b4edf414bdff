#pragma once

#include <string_view>

#include <scalebreak/dem/dem.hpp>
#include <scalebreak/ensembles/engine/flow_engine.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// What the soft-sphere engine is told of an input beside the spheres. `step` in s; `threads` at least 1.
[[nodiscard]] DemSetup dem_setup(const Input& input, double step, int threads);

/// The soft-sphere engine in a run.
class DemEngine final : public FlowEngine {
 public:
  /// `dissipates`: do the laws take energy, of which the engine does not say how much?
  DemEngine(const System& start, const DemSetup& setup, bool dissipates)
      : dem_(start, setup), step_(setup.step), start_(start.time), dissipates_(dissipates) {}
  /// Goes on with the same setup. Throws WorkError where this processor has another instruction set than the one that was left.
  DemEngine(std::string_view saved, const DemSetup& setup, bool dissipates);

  void advance_to(double time) override;
  void keep_sums(bool keep) override { dem_.keep_sums(keep); }
  [[nodiscard]] double time() const override { return dem_.time(); }
  [[nodiscard]] System system() const override { return dem_.system(); }
  [[nodiscard]] std::vector<ContactForce> contact_forces() const override { return dem_.contact_forces(); }
  [[nodiscard]] EngineTotals totals() const override;
  [[nodiscard]] double elastic_energy() const override { return dem_.elastic_energy(); }
  [[nodiscard]] std::string save() const override;

 private:
  Dem dem_;
  double step_, start_;  ///< the latter a time [s]
  bool dissipates_;
};

}  // namespace scalebreak
