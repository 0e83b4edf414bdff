#include <scalebreak/ensembles/breakdown/study_result.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <scalebreak/ensembles/breakdown/study_quantities.hpp>
#include <scalebreak/scene/flow_scene.hpp>
#include <scalebreak/statistics/pooled_mean.hpp>

namespace scalebreak {
namespace {

const Quantity* find(const std::vector<Quantity>& quantities, const std::string& name) {
  const auto at = std::find_if(quantities.begin(), quantities.end(), [&](const Quantity& each) { return each.name == name; });
  return at == quantities.end() ? nullptr : &*at;
}

/// Means over the runs of each quantity that one of them has.
std::vector<Quantity> mean_quantities(const std::vector<const CellReplica*>& runs) {
  std::vector<Quantity> means;
  for (const StudyQuantity& wanted : study_quantities()) {
    std::vector<Measured> values;
    for (const CellReplica* run : runs) {
      if (const Quantity* quantity = find(run->quantities, wanted.name)) values.push_back(quantity->measured);
    }
    if (!values.empty()) means.push_back({wanted.name, wanted.unit, pooled_mean(values)});
  }
  return means;
}

}  // namespace

const Quantity* CellResult::quantity(const std::string& name) const { return find(quantities, name); }

const Comparison* CellResult::deviation(const std::string& name) const {
  const auto at = std::find_if(deviations.begin(), deviations.end(), [&](const Comparison& each) { return each.name == name; });
  return at == deviations.end() ? nullptr : &*at;
}

CellResult cell_result(std::size_t cell, const std::vector<CellReplica>& replicas) {
  CellResult result{.cell = cell};
  std::vector<const CellReplica*> runs;
  for (const CellReplica& replica : replicas) {
    if (replica.failure.empty()) runs.push_back(&replica);
    if (result.failure.empty()) result.failure = replica.failure;
    if (result.version.find(replica.version) == std::string::npos) result.version += (result.version.empty() ? "" : " ") + replica.version;
  }
  result.replicas = runs.size();
  if (runs.empty()) return result;
  result.quantities = mean_quantities(runs);
  const auto n = static_cast<double>(runs.size());
  double patched = 0;
  for (const CellReplica* run : runs) {
    result.particles += run->particles / n, result.measured_time += run->measured_time / n;
    result.steps += run->steps / n, result.events += run->events / n, result.wall_seconds += run->wall_seconds / n;
    result.processor_seconds += run->processor_seconds / n, result.work.evaluations += run->work.evaluations / n;
    result.work.lookups += run->work.lookups / n, result.work.sphere_steps += run->work.sphere_steps / n;
    patched += run->patch_fraction.value_or(0) / n;
  }
  result.contact_time = runs.front()->contact_time;
  if (runs.front()->patch_fraction) result.patch_fraction = patched;
  return result;
}

double relative_error(const CellResult& result) {
  double largest = 0;
  for (const char* name : {"temperature", "collision_rate", "pressure", "rotational_energy", "stress_xz"}) {
    const Quantity* quantity = result.quantity(name);
    if (!quantity || quantity->measured.value == 0) continue;
    const double error = std::abs(quantity->measured.error / quantity->measured.value);
    if (!std::isfinite(error)) return std::numeric_limits<double>::infinity();
    if (std::string_view(name) == "stress_xz" && error > 0.5) continue;  // of a flow that is not sheared: noise about zero
    largest = std::max(largest, error);
  }
  return largest;
}

void compare_with_originals(StudyResult& study) {
  for (std::size_t i = 0; i < study.cells.size(); ++i) {
    CellResult& cell = study.cells[i];
    cell.deviations.clear();
    const StudyCell& of = study.grid.cells[i];
    const CellResult& original = study.original_of(i);
    if (&original == &cell) continue;
    const double size = size_factor(*find_scaling_law(of.law), of.factor);
    for (const Quantity& quantity : cell.quantities) {
      const Quantity* first = original.quantity(quantity.name);
      if (!first) continue;
      if (quantity.name == "stress_xz" && mean_shear_rate(of.input.cell, 1) == 0) continue;  // noise about zero
      const double claim = std::pow(size, study_quantity(quantity.name).size_power);
      cell.deviations.push_back(
          compare({first->name, first->unit, {claim * first->measured.value, claim * first->measured.error}}, quantity));
    }
  }
}

}  // namespace scalebreak
