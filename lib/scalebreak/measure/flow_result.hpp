#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include <scalebreak/statistics/standard_error.hpp>

namespace scalebreak {

struct Quantity {
  std::string name, unit;
  Measured measured;
};

struct MeasuredTensor {
  Eigen::Matrix3d value, error;
};

/// A quantity over the slabs of the gap, from below.
struct ProfileColumn {
  std::string name, unit;
  std::vector<Measured> slabs;
};

struct FlowProfile {
  std::vector<double> height;  ///< of the slabs' middles [m]
  std::vector<ProfileColumn> columns;
};

/// What a run measured: means over time with standard errors; NaN where there is nothing to tell.
struct FlowResult {
  double duration = 0;  ///< [s]
  double outside = 0;   ///< spheres beyond open ends along z, in no slab and no temperature, mean
  std::vector<Quantity> quantities;
  MeasuredTensor stress, stress_contact;  ///< [Pa], rows: the force's component, columns: the plane's
  FlowProfile profile;
};

/// The 3 × 3 entries in words, "xx" to "zz", as rows go.
[[nodiscard]] inline std::string tensor_entry_name(Eigen::Index row, Eigen::Index column) { return {"xyz"[row], "xyz"[column]}; }

}  // namespace scalebreak
