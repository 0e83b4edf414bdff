#pragma once

#include <functional>
#include <string>
#include <vector>

#include <scalebreak/ensembles/engine/shortest_contact.hpp>
#include <scalebreak/ensembles/stability/criteria.hpp>
#include <scalebreak/ensembles/stability/largest_step.hpp>
#include <scalebreak/statistics/standard_error.hpp>

namespace scalebreak {

/// Collisions of each sphere, on the mean, in a trial of a step.
inline constexpr double collisions_of_a_trial = 20;

/// The largest stable step of a law at a factor with an integrator, by one criterion, from several seeds.
struct StabilityRecord {
  std::string law;
  double factor = 1;
  std::string integrator, criterion;
  double rayleigh = 0;      ///< step, of the scaled system (Washino et al. 2024, eq. 55) [s]
  double oscillation = 0;   ///< of linear contacts (Washino et al. 2024, eq. 54); 0: of another law [s]
  ShortestContact contact;  ///< at the speed of the start
  std::vector<LargestStep> seeds;

  /// Seeds whose bracket was not found, as all steps that were tried were stable, or none was.
  [[nodiscard]] std::size_t without_bracket() const;
  /// Of the Rayleigh time: the mean over the seeds that were found. Its error is the larger of half a bracket and the standard error over
  /// seeds. NaN where none was found.
  [[nodiscard]] Measured fraction() const;
  [[nodiscard]] Measured step() const;  ///< the same in s
  /// The criterion's number at the largest stable and at the smallest unstable step, means over seeds; NaN where there is none.
  [[nodiscard]] double value_below() const;
  [[nodiscard]] double value_above() const;  ///< of the seeds that went on to their end
  /// How it fails just beyond: "energy grows", or what stopped the first seed that was stopped.
  [[nodiscard]] std::string failure() const;
};

struct StabilityStudy {
  bool flow = true;                               ///< false: of a collision
  std::vector<StabilityCriterion> criteria = {};  ///< by which steps were sought
  std::vector<StabilityRecord> records;           ///< for each criterion and integrator first the original's, law "none" at 1
  std::size_t spheres = 0;                        ///< of the original
  double speed = 0;  ///< root of the mean squared speed at the start; of a collision its largest relative speed [m/s]
  int skipped = 0;   ///< pairs of law and factor that do not go together

  /// Of the original, by the same criterion and integrator.
  [[nodiscard]] const StabilityRecord& original_of(const StabilityRecord& record) const;
};

/// The pairs of law and factor of [study] that go together, after the original, as a scaled input each; a flow made elastic.
[[nodiscard]] std::vector<Input> stability_inputs(const Input& input, int* skipped = nullptr);

/// Bisects the largest stable step for each criterion, integrator of [study], law and factor: of the input's flow made elastic (elastic_scene),
/// for as many seeds as run.replicas; or of its collision as it is, at study.phases points of a step. The same bits for any number of threads
/// (0: all). Throws InputError where the spheres do not move at the start, and what `collision_scene` throws.
[[nodiscard]] StabilityStudy run_stability(const Input& input, int threads, const std::function<void(double)>& progress = {});

}  // namespace scalebreak
