#include <scalebreak/scene/study_keys.hpp>

#include <algorithm>

#include <scalebreak/scene/key_makers.hpp>

namespace scalebreak {
namespace {

/// Any number of words out of a list, kept as words.
Key words_of_list(const std::string& name, const std::string& meaning, const std::vector<std::string>& words, std::size_t least,
                  Member<std::vector<std::string>> member) {
  return choices(
      "study", name, meaning, words, least, 1000,
      [words, member](Input& input, const std::vector<std::size_t>& chosen) {
        member(input).clear();
        for (const std::size_t i : chosen) member(input).push_back(words[i]);
      },
      [words, member](const Input& input) {
        std::vector<std::size_t> chosen;
        for (const std::string& word : member(const_cast<Input&>(input)))
          chosen.push_back(static_cast<std::size_t>(std::find(words.begin(), words.end(), word) - words.begin()));
        return chosen;
      });
}

/// The grid of a study of flows, and how well each of its cells is to be known.
void add_grid(std::vector<Key>& list) {
  list.push_back(words_of_list("engines", "what moves the spheres, each in cells of its own; of tradeoff, \"auto\" alone: all of them",
                               words_of(study_engine_words), 1,
                               [](Input& input) -> std::vector<std::string>& { return input.study.engines; }));
  list.push_back(numbers("study", "volume_fractions", "-", "of breakdown: solids over the cell; empty: the scene's", 0, 1000,
                         [](Input& input) -> std::vector<double>& { return input.study.volume_fractions; }));
  list.push_back({"study", "parameter", "-", "of breakdown: a key of the scene that is varied, as \"material.surface_energy\"; \"\": none",
                  "the dotted key of a number, as a string",
                  [](Input& input, const Value& value) { input.study.parameter = expect<std::string>(value); },
                  [](const Input& input) { return Value(input.study.parameter); }});
  list.push_back(numbers("study", "values", "-", "of breakdown: the values of the parameter, in its unit", 0, 1000,
                         [](Input& input) -> std::vector<double>& { return input.study.values; }));
  list.push_back(number("study", "target_error", "-",
                        "relative standard error up to which replicas are added to a cell; 0: run.replicas are enough",
                        [](Input& input) -> double& { return input.study.target_error; }));
  list.push_back(whole_number("study", "most_replicas", "replicas of a cell to reach it",
                              [](Input& input) -> std::uint64_t& { return input.study.most_replicas; }));
  list.push_back(number("study", "budget_seconds", "s",
                        "wall time after which no more are added; 0: none, and results do not depend on the machine",
                        [](Input& input) -> double& { return input.study.budget_seconds; }));
}

}  // namespace

std::vector<std::string> scaling_law_names() {
  std::vector<std::string> names;
  for (const ScalingLaw& law : scaling_laws()) names.emplace_back(law.name);
  return names;
}

void add_study(std::vector<Key>& list) {
  list.push_back(words_of_list("laws", "scaling laws to compare; empty: all that suit the contact", scaling_law_names(), 0,
                               [](Input& input) -> std::vector<std::string>& { return input.study_laws; }));
  list.push_back(numbers("study", "factors", "-", "factors to compare; each law takes those on its side of 1", 1, 1000,
                         [](Input& input) -> std::vector<double>& { return input.study_factors; }));
  list.push_back(numbers("study", "speeds", "m/s", "impact speeds; empty: about the sticking speed", 0, 1000,
                         [](Input& input) -> std::vector<double>& { return input.study_speeds; }));
  list.push_back(choices(
      "study", "integrators", "integrators to compare (stability)", words_of(integrator_words), 1, std::size(integrator_words),
      [](Input& input, const std::vector<std::size_t>& chosen) {
        input.study_integrators.clear();
        for (const std::size_t i : chosen) input.study_integrators.push_back(static_cast<Integrator>(i));
      },
      [](const Input& input) {
        std::vector<std::size_t> chosen;
        for (const Integrator integrator : input.study_integrators) chosen.push_back(static_cast<std::size_t>(integrator));
        return chosen;
      }));
  list.push_back(number("study", "energy_growth", "-",
                        "relative growth of energy per collision of each sphere up to which a step counts as stable",
                        [](Input& input) -> double& { return input.study_energy_growth; }));
  list.push_back(
      number("study", "motion_error", "-",
             "largest error of a body's velocity or surface speed, over the speed of a collision, up to which a step counts as stable",
             [](Input& input) -> double& { return input.study_motion_error; }));
  list.push_back(choices(
      "study", "methods",
      "of tradeoff: ways to resolve a collision, of which verlet and synchronized follow flows; empty: all that suit a collision, all engines "
      "and laws of a flow",
      words_of(method_words), 0, std::size(method_words),
      [](Input& input, const std::vector<std::size_t>& chosen) {
        input.tradeoff.methods.clear();
        for (const std::size_t i : chosen) input.tradeoff.methods.push_back(static_cast<Method>(i));
      },
      [](const Input& input) {
        std::vector<std::size_t> chosen;
        for (const Method method : input.tradeoff.methods) chosen.push_back(static_cast<std::size_t>(method));
        return chosen;
      }));
  list.push_back(numbers("study", "step_fractions", "-", "of tradeoff: steps of the soft-sphere engine over the Rayleigh time", 1, 100,
                         [](Input& input) -> std::vector<double>& { return input.tradeoff.step_fractions; }));
  list.push_back(numbers("study", "tolerances", "-", "of tradeoff: tolerances of the exact engine and of collision tables", 1, 100,
                         [](Input& input) -> std::vector<double>& { return input.tradeoff.tolerances; }));
  list.push_back(whole_number("study", "phases", "of tradeoff: points of a step at which a collision begins",
                              [](Input& input) -> std::uint64_t& { return input.tradeoff.phases; }));
  add_grid(list);
}

}  // namespace scalebreak
