#include <scalebreak/ensembles/engine/dem_engine.hpp>

#include <cmath>

#include <fmt/format.h>

#include <scalebreak/base/bytes.hpp>
#include <scalebreak/base/error.hpp>

namespace scalebreak {
namespace {

std::string_view without_kernel(std::string_view saved) {
  (void)take_text(saved);
  return saved;
}

}  // namespace

DemSetup dem_setup(const Input& input, double step, int threads) {
  return {.contact = input.contact,
          .surface = input.surface,
          .material = input.material,
          .second = input.second,
          .wall = input.wall,
          .law = *find_scaling_law(input.scaling_law),
          .factor = input.scaling_factor,
          .gravity = input.cell.gravity,
          .wall_no_slip = input.cell.wall_no_slip,
          .pressure = input.cell.pressure,
          .step = step,
          .integrator = input.run.integrator,
          .threads = threads};
}

DemEngine::DemEngine(std::string_view saved, const DemSetup& setup, bool dissipates)
    : dem_(without_kernel(saved), setup),
      step_(setup.step),
      start_(dem_.time() - setup.step * static_cast<double>(dem_.steps())),
      dissipates_(dissipates) {
  const std::string kernel = take_text(saved);
  if (kernel != dem_.kernel_name())
    throw WorkError(fmt::format("the run was left with the instruction set {}, and here it would go on with {}, so not bit for bit", kernel,
                                dem_.kernel_name()));
}

void DemEngine::advance_to(double time) { dem_.advance(std::lround((time - start_) / step_) - dem_.steps()); }

EngineTotals DemEngine::totals() const {
  const DemTotals& totals = dem_.totals();
  return {.contact_starts = totals.contact_starts,
          .wall_work = totals.wall_work,
          .shear_work = {},  // Dem does not add it up: it is taken from the stress at samples
          .dissipated = dissipates_ ? std::nullopt : std::optional(0.0),
          .contact_time = totals.contact_time,
          .contact_moment = totals.contact_moment,
          .steps = dem_.steps(),
          .evaluations = std::round(2 * totals.contact_time / step_) / 2,  // halves are of walls
          .events = {},
          .integrated = {},
          .delayed = {},
          .patches = {}};
}

std::string DemEngine::save() const {
  std::string bytes;
  put_text(bytes, dem_.kernel_name());
  return bytes + dem_.save();
}

}  // namespace scalebreak
