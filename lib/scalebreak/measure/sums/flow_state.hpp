#pragma once

#include <string>
#include <string_view>

#include <Eigen/Core>

#include <scalebreak/measure/sample.hpp>

namespace scalebreak {

/// A sample as it is added up.
struct FlowState {
  double time = 0;
  double shear_rate = 0;  ///< of homogeneous shear, else 0
  Eigen::ArrayXd sums;    ///< flow_sums.hpp
  Eigen::ArrayXd totals;  ///< running_total; NaN where not handed over
};

namespace running_total {
enum Entry : Eigen::Index {
  contact_starts,
  work,
  energy,
  dissipated,
  shear_work,
  contact_time,
  contact_moment,
  count = contact_moment + 9
};
}  // namespace running_total

/// Homogeneous shear: Lees–Edwards images across z.
[[nodiscard]] inline bool homogeneous_shear(const Cell& cell) { return cell.periodic(2) && cell.shear_rate != 0; }

/// Sums over spheres and contacts, with the gap cut into slabs of equal height. WorkError for a contact that names no sphere.
[[nodiscard]] FlowState flow_state(const Sample& sample, int slabs);

/// The sums of the time between two states: by the trapezoidal rule, running totals by their difference. The work of homogeneous
/// shear follows from the stress, −γ̇ ∫P_xz dt V, unless it is handed over.
[[nodiscard]] Eigen::ArrayXd interval_sums(const FlowState& begin, const FlowState& end);

void save(std::string& bytes, const FlowState& state);
void load(std::string_view& bytes, FlowState& state);

}  // namespace scalebreak
