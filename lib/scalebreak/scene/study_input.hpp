#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace scalebreak {

/// What may move the spheres of a flow; "auto" chooses.
inline constexpr const char* study_engine_words[] = {"auto", "event", "hybrid", "dem"};

/// Of a study of flows, beside its laws and factors: what is varied, and how well each cell is to be known.
struct StudyInput {
  std::vector<std::string> engines = {"auto"};  ///< words of study_engine_words
  std::vector<double> volume_fractions;         ///< empty: the scene's
  std::string parameter;                        ///< "dotted.key" of a number of the scene; empty: none
  std::vector<double> values;                   ///< of it
  double target_error = 0;                      ///< relative standard error wanted; 0: run.replicas are enough
  std::uint64_t most_replicas = 16;             ///< of a cell, to reach it
  double budget_seconds = 0;                    ///< of wall time, after which no more replicas are added; 0: none

  bool operator==(const StudyInput&) const = default;
};

}  // namespace scalebreak
