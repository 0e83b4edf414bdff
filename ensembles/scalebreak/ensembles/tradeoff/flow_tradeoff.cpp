#include <scalebreak/ensembles/tradeoff/flow_tradeoff.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/ensembles/run/run_flow.hpp>
#include <scalebreak/ensembles/tradeoff/front.hpp>
#include <scalebreak/measure/flow_json.hpp>

namespace scalebreak {
namespace {

/// How a method makes a run of an input; the last is the best, whose finest run the others are compared with.
struct FlowMethod {
  Method method;
  Integrator integrator;
};
constexpr FlowMethod flow_methods[] = {{Method::verlet, Integrator::verlet}, {Method::synchronized, Integrator::synchronized}};

/// Relative to a value that is not known to this share, a deviation says nothing: a shear stress without shear, a temperature at rest.
constexpr double well_known = 0.1;

std::vector<FlowMethod> methods_of(const Input& input) {
  std::vector<FlowMethod> chosen;
  const auto& asked = input.tradeoff.methods;
  for (const FlowMethod& method : flow_methods) {
    if (asked.empty() || std::find(asked.begin(), asked.end(), method.method) != asked.end()) chosen.push_back(method);
  }
  for (const Method method : asked) {
    const bool follows = std::any_of(chosen.begin(), chosen.end(), [&](const FlowMethod& each) { return each.method == method; });
    if (!follows)
      throw InputError(fmt::format("study.methods: found \"{}\", which follows no flow; allowed: \"verlet\", \"synchronized\"",
                                   method_words[static_cast<std::size_t>(method)]));
  }
  return chosen;
}

std::vector<Quantity> compared(const FlowResult& result) {
  const std::vector<Quantity> all = all_quantities(result);
  std::vector<Quantity> quantities;
  for (const std::string& name : tradeoff_quantities()) {
    const auto at = std::find_if(all.begin(), all.end(), [&](const Quantity& quantity) { return quantity.name == name; });
    if (at == all.end()) throw WorkError(fmt::format("nothing is measured under the name of {}", name));
    quantities.push_back(*at);
  }
  return quantities;
}

/// Touching contacts at an instant, in the mean; one at a wall counts half.
double contacts_of(const RunOutcome& outcome) {
  for (const Quantity& quantity : outcome.measured.quantities) {
    if (quantity.name == "coordination") return quantity.measured.value * static_cast<double>(outcome.replicas.front().particles) / 2;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

struct FinishedPoint {
  FlowPoint point;
  std::vector<Quantity> quantities;
};

FinishedPoint run_at(Input input, const FlowMethod& method, double fraction, int threads, const std::function<void(double)>& progress) {
  input.run.step_fraction = fraction, input.run.step_bounds = false, input.run.integrator = method.integrator;
  RunOptions options{.out = {}, .threads = threads};
  if (progress) options.progress = [&](const RunProgress& at) { progress(at.share); };
  const RunOutcome outcome = run_flow(input, options);
  const double step = outcome.replicas.front().schedule.step;
  FlowPoint point{.method = method.method, .step_fraction = fraction, .step = step};
  const auto replicas = static_cast<double>(outcome.replicas.size());
  point.force_evaluations = replicas * contacts_of(outcome) * outcome.measured.duration / step;
  point.particle_steps = outcome.particle_steps(), point.seconds = outcome.wall_seconds;
  return {point, compared(outcome.measured)};
}

void compare_with(FinishedPoint& finished, const FinishedPoint& reference) {
  FlowPoint& point = finished.point;
  point.deviations = compare(reference.quantities, finished.quantities);
  point.largest = point.largest_error = std::numeric_limits<double>::quiet_NaN();
  for (const Comparison& c : point.deviations) {
    const double size = std::abs(c.relative.value);
    if (!(c.first.error <= well_known * std::abs(c.first.value)) || !std::isfinite(c.relative.error) || size < point.largest) continue;
    point.largest = size, point.largest_error = c.relative.error;
  }
}

}  // namespace

const std::vector<std::string>& tradeoff_quantities() {
  static const std::vector<std::string> names = {"temperature", "collision_rate", "coordination", "dissipation", "pressure", "stress_xz"};
  return names;
}

FlowTradeoff flow_tradeoff(const Input& input, int threads, const std::function<void(double)>& progress) {
  const auto methods = methods_of(input);
  std::vector<FinishedPoint> finished;
  double cost = 0, done = 0;  // of a run: as the number of its steps
  for (const double fraction : input.tradeoff.step_fractions) cost += static_cast<double>(methods.size()) / fraction;
  FlowTradeoff study;
  for (const FlowMethod& method : methods) {
    for (const double fraction : input.tradeoff.step_fractions) {
      const auto show = [&](double share) { progress((done + share / fraction) / cost); };
      finished.push_back(run_at(input, method, fraction, threads, progress ? show : std::function<void(double)>{}));
      done += 1 / fraction;
      if (method.method == methods.back().method &&
          (finished[study.reference].point.method != method.method || fraction < finished[study.reference].point.step_fraction))
        study.reference = finished.size() - 1;
    }
  }
  const FinishedPoint reference = finished[study.reference];
  std::vector<double> costs, errors;
  for (FinishedPoint& each : finished) {
    compare_with(each, reference);
    study.points.push_back(each.point);
    costs.push_back(each.point.force_evaluations), errors.push_back(each.point.largest);
  }
  const std::vector<bool> front = on_front(costs, errors);
  for (std::size_t i = 0; i < front.size(); ++i) study.points[i].on_front = front[i] && i != study.reference;
  return study;
}

}  // namespace scalebreak
