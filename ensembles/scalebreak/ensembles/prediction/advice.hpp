#pragma once

#include <optional>
#include <string>
#include <vector>

#include <scalebreak/ensembles/prediction/flow_knowledge.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// How far one law may be taken in a scene, on one side of 1.
struct LawAdvice {
  std::string law;
  double factor = 1;  ///< the farthest from 1 up to which all predictions stay within the tolerance
  std::string engine, engine_reason;
  std::vector<Expectation> predictions;   ///< at that factor
  std::string keeps;                      ///< which numbers of the flow it keeps there, and how it changes the others
  std::string worst;                      ///< the one that is off most, its uncertainty included
  double speedup = 1;                     ///< sphere steps of the original over those of the scaled flow, by soft spheres
  std::string limiting_mechanism, limit;  ///< what ends the law's reach in a word, and in a sentence
  std::vector<std::string> warnings;
  ScaleGroups groups;  ///< at that factor

  /// Deviation of `worst` and its standard error.
  [[nodiscard]] Measured expected_error() const;
};

struct Advice {
  std::vector<LawAdvice> laws;  ///< in the order of the laws; those that soften first
  std::size_t recommended = 0;  ///< of them: the fastest
  ScaleGroups original;
};

/// The scene with what [advise] says in place of its own. Throws InputError where that does not go together.
[[nodiscard]] Input advised_scene(const Input& input);

/// How far each law of the study's, or each that suits the contact, may be taken within advise.tolerance. `threads` are those that the runs would have.
/// Throws InputError.
[[nodiscard]] Advice advise(const Input& input, const DeviationModel& model, int threads);

}  // namespace scalebreak
