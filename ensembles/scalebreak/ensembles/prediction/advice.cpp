#include <scalebreak/ensembles/prediction/advice.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <boost/math/tools/toms748_solve.hpp>

#include <scalebreak/base/error.hpp>
#include <scalebreak/collisions/invariance/invariance.hpp>
#include <scalebreak/collisions/normal/pair_collision.hpp>
#include <scalebreak/ensembles/breakdown/study_quantities.hpp>
#include <scalebreak/ensembles/prediction/advice_words.hpp>
#include <scalebreak/ensembles/run/engine_choice.hpp>
#include <scalebreak/ensembles/run/run_estimate.hpp>
#include <scalebreak/scene/flow_scene.hpp>

namespace scalebreak {
namespace {

constexpr double softest = 1e-7, largest = 100;  ///< factors that are asked for
constexpr int tried = 24;                        ///< factors on the way there

bool walled(const CellInput& cell) { return std::count(cell.boundary.begin(), cell.boundary.end(), Boundary::wall) > 0; }

Input under(const Input& scene, const ScalingLaw& law, double factor) {
  Input scaled = scene;
  scaled.scaling_law = law.name, scaled.scaling_factor = factor;
  scaled.keep = size_factor(law, factor) > 1 && walled(scene.cell) && scene.particles.file.empty() ? Keep::cell : Keep::count;
  return scaled;
}

/// One law on one side of 1.
class Search {
 public:
  Search(const Input& scene, const FlowKnowledge& knowledge, const ScaleGroups& original, const ScalingLaw& law)
      : scene_(scene), knowledge_(knowledge), original_(original), law_(law) {}

  [[nodiscard]] ScaleGroups groups(double factor) const { return scale_groups(under(scene_, law_, factor)); }

  /// Above 0 where something is beyond what is allowed: by how much of it, relative.
  [[nodiscard]] double excess(double factor) const {
    const ScaleGroups scaled = groups(factor);
    double most = knowledge_.beyond(original_, scaled, scene_.advise.tolerance);
    for (const Expectation& each : knowledge_.expected(original_, scaled))
      most = std::max(most, with_error(each) / scene_.advise.tolerance - 1);
    return most;
  }

  /// The farthest factor before the first that is beyond, or `end`.
  [[nodiscard]] double reach(double end) const {
    const double step = std::log(end) / tried;
    const auto at = [&](double logarithm) { return excess(std::exp(logarithm)); };
    double within = 0, value_within = at(0);
    if (value_within > 0) return 1;
    for (int i = 1; i <= tried; ++i) {
      const double next = i * step, value = at(next);
      if (value > 0) {
        const double low = std::min(within, next), high = std::max(within, next);
        std::uintmax_t iterations = 40;
        const auto close = [](double a, double b) { return std::abs(a - b) < 1e-3; };
        const auto [a, b] = boost::math::tools::toms748_solve(at, low, high, step > 0 ? value_within : value,
                                                              step > 0 ? value : value_within, close, iterations);
        return std::exp(step > 0 ? a : b);  // the end of the bracket that is nearer to 1
      }
      within = next, value_within = value;
    }
    return end;
  }

 private:
  const Input& scene_;
  const FlowKnowledge& knowledge_;
  const ScaleGroups& original_;
  const ScalingLaw& law_;
};

double work_of(const Input& input) {
  const RunEstimate estimate = estimate_run(input, 1);
  return estimate.particles * estimate.steps;
}

/// A cell must hold a sphere and its neighbours.
double largest_size(const Input& scene) {
  if (!scene.particles.file.empty() || !walled(scene.cell)) return largest;
  const FlowPlan plan = plan_flow(scene);
  return std::clamp(plan.size.minCoeff() / least_periodic_edge(plan.largest, plan.reach), 1.0, largest);
}

LawAdvice advise_law(const Input& scene, const FlowKnowledge& knowledge, const ScaleGroups& original, const ScalingLaw& law, double end,
                     int threads) {
  const Search search(scene, knowledge, original, law);
  LawAdvice advice{.law = std::string(law.name)};
  advice.factor = end == 1 ? 1 : search.reach(end);
  const Input scaled = under(scene, law, advice.factor);
  advice.groups = scale_groups(scaled);
  advice.predictions = knowledge.expected(original, advice.groups);
  advice.keeps = kept_groups(original, advice.groups);
  advice.worst = std::max_element(advice.predictions.begin(), advice.predictions.end(), [](const Expectation& a, const Expectation& b) {
                   return with_error(a) < with_error(b);
                 })->quantity;
  describe_limit(advice, knowledge, original, search.groups(beyond(advice.factor, end)), scene.advise.tolerance, end);
  advice.warnings = warnings_of(scene, knowledge, original, advice.groups);
  const EngineChoice engine = choose_engine("auto", scaled, threads);
  advice.engine = engine.engine, advice.engine_reason = engine.reason;
  advice.speedup = work_of(scene) / work_of(scaled);
  return advice;
}

}  // namespace

Measured LawAdvice::expected_error() const {
  for (const Expectation& each : predictions) {
    if (each.quantity == worst) return {std::abs(each.deviation.value), each.deviation.error};
  }
  return {};
}

Advice advise(const Input& input, const DeviationModel& model, int threads) {
  const Input scene = advised_scene(input);
  Advice advice{.laws = {}, .original = scale_groups(scene)};
  const FlowKnowledge knowledge = knowledge_of(advice.original, model);
  for (const bool softens : {true, false}) {
    for (const std::string& name : study_laws(scene)) {
      const ScalingLaw& law = *find_scaling_law(name);
      const double end = softens ? softest : largest_size(scene);
      if (refusal(law, softens ? 0.5 : 2, scene.contact.normal)) continue;
      advice.laws.push_back(advise_law(scene, knowledge, advice.original, law, end, threads));
    }
  }
  if (advice.laws.empty()) throw InputError("study.laws: none of these laws suits the contact; allowed: [] for all that do");
  const auto better = [](const LawAdvice& a, const LawAdvice& b) {
    constexpr double alike = 1.01;  // then what is made to keep the physics goes before what is not
    if (std::max(a.speedup, b.speedup) > alike * std::min(a.speedup, b.speedup)) return a.speedup < b.speedup;
    return a.law == "none" && b.law != "none";
  };
  advice.recommended = static_cast<std::size_t>(std::max_element(advice.laws.begin(), advice.laws.end(), better) - advice.laws.begin());
  return advice;
}

}  // namespace scalebreak
