#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <scalebreak/ensembles/prediction/advice.hpp>

namespace scalebreak {

/// A factor a little beyond one, on the way to `end`: there, what ends a law's reach is seen.
[[nodiscard]] double beyond(double factor, double end);

/// Puts in what ends the reach of a law, from the groups a little beyond it.
void describe_limit(LawAdvice& advice, const FlowKnowledge& knowledge, const ScaleGroups& original, const ScaleGroups& there,
                    double tolerance, double end);

/// Where the scene is beyond what is known, in sentences.
[[nodiscard]] std::vector<std::string> warnings_of(const Input& scene, const FlowKnowledge& knowledge, const ScaleGroups& original,
                                                   const ScaleGroups& scaled);

/// The object of `scalebreak advise --json`: the recommended law's, with all of them in `laws`.
[[nodiscard]] nlohmann::json advice_json(const Advice& advice, const DeviationModel& model, double tolerance);

/// "rps to 0.0021: 12 times faster by dem; temperature off by 4 % ± 1 %; limited by contact time".
[[nodiscard]] std::string sentence(const LawAdvice& advice);

}  // namespace scalebreak
