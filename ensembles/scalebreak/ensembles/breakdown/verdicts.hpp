#pragma once

#include <optional>
#include <string>
#include <vector>

#include <scalebreak/ensembles/breakdown/study_result.hpp>

namespace scalebreak {

/// How far a law may be off before it counts as broken, relative.
inline constexpr double broken_beyond = 0.05;

/// What a law claims to keep, by which it is judged: temperature, rotational energy, collision rate, pressure, shear stress, and the volume
/// fraction where the flow finds it. Not coordination, which grows with the contact time under every law that softens.
[[nodiscard]] const std::vector<std::string>& judged_quantities();

enum class Standing {
  original,   ///< nothing to compare
  holds,      ///< all that is judged is within `broken_beyond`, two standard errors included
  undecided,  ///< the errors are too large to tell
  broken,     ///< something is beyond it by two standard errors
  failed,     ///< it could not be run to its end
};
inline constexpr const char* standing_words[] = {"original", "holds", "undecided", "broken", "failed"};

/// How a cell stands, and the judged quantity that is off most.
struct CellVerdict {
  Standing standing = Standing::original;
  std::optional<Comparison> worst;  ///< of a broken cell, among those that are beyond
};
[[nodiscard]] CellVerdict cell_verdict(const CellResult& cell);

/// How far a law goes at one point with one engine, on one side of 1: its factors in order of their distance from 1.
struct LawReach {
  std::string law, engine;
  StudyPoint point;
  bool softer = false;               ///< factors below 1
  std::optional<double> holds_to;    ///< the last factor before the first that does not hold; none: the first does not
  std::optional<double> next;        ///< the first that does not hold
  std::optional<CellVerdict> there;  ///< how it stands
};
[[nodiscard]] std::vector<LawReach> law_reaches(const StudyResult& study);

/// "rps (dem), volume fraction 0.4: holds to 0.01; at 0.0001 granular temperature is off by +12 % ± 1 %"; parameter is study.parameter.
[[nodiscard]] std::string sentence(const LawReach& reach, const std::string& parameter);

/// A sentence for each law and factor: in how many cells it holds and is broken, and where it is off most.
[[nodiscard]] std::vector<std::string> law_digest(const StudyResult& study, const std::string& parameter);

}  // namespace scalebreak
