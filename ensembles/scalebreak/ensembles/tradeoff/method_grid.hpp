#pragma once

#include <optional>
#include <string>
#include <vector>

#include <scalebreak/ensembles/breakdown/study_grid.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// A way to come to a flow's answer.
struct FlowWay {
  std::string engine;               ///< "dem", "event" or "hybrid"
  std::string law = "none";         ///< of scaling
  double factor = 1;                ///< 1: the original
  std::string keep;                 ///< "count" or "cell" of a law that enlarges, else empty
  double step_fraction = 0;         ///< of the Rayleigh time; 0: the engine has no step
  bool automatic = false;           ///< "auto" takes it
  std::optional<std::size_t> cell;  ///< of the grid; none: it was refused
  std::string refusal;              ///< then why, in a sentence

  [[nodiscard]] bool original() const { return law == "none" && factor == 1; }
  /// What is drawn as one: "dem over step", "rps (dem)", "sup keeping cell (dem)", "hybrid".
  [[nodiscard]] std::string series() const;
  /// "rps 0.01 (dem)"; "dem at a step of 0.15"; "hybrid".
  [[nodiscard]] std::string name() const;
};

struct MethodGrid {
  StudyGrid grid;             ///< what is run, each cell once
  std::vector<FlowWay> ways;  ///< in the order of the engines; those that are refused too
  int skipped = 0;            ///< pairs of law and factor that do not go together
  bool bed = false;           ///< is_bed: other quantities tell the ways apart
};

/// The ways that an input's [study] asks for: soft spheres ("dem") at each of the step fractions and at the scene's own, and at that one under each law at
/// its factors, laws that enlarge both with as many spheres and in the same cell where there are any left, of a bed the latter alone; "hybrid" and "event" of the original;
/// "auto", which is one of them. "auto" alone: all. Throws InputError where no way is left that runs the original.
[[nodiscard]] MethodGrid method_grid(const Input& input);

}  // namespace scalebreak
