#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <scalebreak/ensembles/run/engine_choice.hpp>
#include <scalebreak/scene/input.hpp>
#include <scalebreak/scene/value.hpp>

namespace scalebreak {

/// A point of the scene's parameters: what original and scaled systems have in common.
struct StudyPoint {
  std::optional<double> volume_fraction;  ///< none: the scene's
  std::optional<double> value;            ///< of study.parameter; none: there is none
  bool operator==(const StudyPoint&) const = default;
  /// "volume fraction 0.4, material.surface_energy 0.02"; empty where nothing is varied.
  [[nodiscard]] std::string name(const std::string& parameter) const;
};

/// One cell of a study: a law at a factor, at a point, by an engine. The original is law "none" at 1.
struct StudyCell {
  std::string law;
  double factor = 1;
  StudyPoint point;
  std::string asked;    ///< engine of study.engines
  EngineChoice choice;  ///< and what that is
  Input input;          ///< of the cell alone: without a study
  /// Of the input and the engine: the same cell in another grid has the same, so that it need not be run again. Its random numbers follow
  /// from it, so that cells are independent of each other.
  std::uint64_t key = 0;

  [[nodiscard]] bool original() const { return law == "none" && factor == 1; }
  /// "rps_0.01_phi_0.4_hybrid_5f3a…": readable, and different for cells that differ.
  [[nodiscard]] std::string folder() const;
};

struct StudyGrid {
  std::vector<StudyCell> cells;  ///< by point, then by engine the original and the laws with their factors
  int skipped = 0;               ///< pairs of law and factor that do not go together, and cells that their engine cannot run

  /// Whom a cell is compared with: the original at its point, by the first engine that runs it.
  [[nodiscard]] std::size_t original_of(std::size_t cell) const;
};

/// The cell of an input's [study] at a point: a law at a factor by an engine, or by that which "auto" chooses. `more` is set beside that and goes
/// before it. Throws InputError where it is no scene.
[[nodiscard]] StudyCell study_cell(const Input& study, const StudyPoint& point, const std::string& engine, const std::string& law,
                                   double factor, const std::vector<Assignment>& more = {});

/// Why the cell's engine cannot run it, in a sentence: a hybrid without tables would be soft spheres in patches.
[[nodiscard]] std::optional<std::string> why_unsuited(const StudyCell& cell);

/// The grid of an input's [study]: volume fractions × values of the parameter × engines × (the original, laws × factors). A value of a key of
/// [material] is put into [second] and [wall] too where they have the same as [material]. Throws InputError where a cell is no scene.
[[nodiscard]] StudyGrid study_grid(const Input& input);

}  // namespace scalebreak
