#pragma once

#include <functional>
#include <string>
#include <vector>

#include <scalebreak/measure/comparison.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// A flow by one method at one step.
struct FlowPoint {
  Method method = Method::synchronized;
  double step_fraction = 0, step = 0;  ///< of the Rayleigh time; [s]
  double force_evaluations = 0;        ///< of contacts over the measured time: touching ones, summed over steps
  double particle_steps = 0, seconds = 0;
  std::vector<Comparison> deviations;  ///< from the reference, in the order of `tradeoff_quantities`
  double largest = 0,
         largest_error = 0;  ///< of the relative deviations from what the reference knows to 10 %, and its standard error; NaN: none
  bool on_front = false;     ///< of force evaluations and the largest deviation
};

/// What is compared: temperature, collision rate, coordination, dissipation pressure and shear stress.
[[nodiscard]] const std::vector<std::string>& tradeoff_quantities();

/// Accuracy against cost of the methods on one flow.
struct FlowTradeoff {
  std::vector<FlowPoint> points;  ///< by method, then in the order of the step fractions; the reference is one of them
  std::size_t reference = 0;      ///< the point at the smallest step, of the best method
};

/// The input's flow run at each step fraction of [study] by each method, from the same start, whatever the bounds on the step. Runs that differ
/// in their step alone part ways soon, so that their errors are taken to be independent. Throws what `run_flow` throws.
[[nodiscard]] FlowTradeoff flow_tradeoff(const Input& input, int threads, const std::function<void(double)>& progress = {});

}  // namespace scalebreak
