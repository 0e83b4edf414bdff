#include <scalebreak/ensembles/engine/energy_account.hpp>

#include <algorithm>

#include <fmt/format.h>

namespace scalebreak {
namespace {

/// Of those that meet, the materials under their sections' names.
struct Named {
  const char* name;
  const Material* material;
};
std::vector<Named> materials_that_meet(const Input& input) {
  std::vector<Named> all = {{"material", &input.material}};
  if (input.particles.size == SizeKind::bidisperse || !input.particles.file.empty()) all.push_back({"second", &input.second});
  const auto& boundary = input.cell.boundary;
  if (std::count(boundary.begin(), boundary.end(), Boundary::wall) > 0) all.push_back({"wall", &input.wall.material});
  return all;
}

}  // namespace

std::optional<std::string> why_account_is_open(const Input& input) {
  if (input.surface.spins() || input.surface.attraction != Attraction::none)
    return "friction, rolling and liquids dissipate, and the engine does not add up how much";
  for (const Named& each : materials_that_meet(input)) {
    if (each.material->restitution < 1)
      return fmt::format("{}.restitution = {:g} dissipates, and the engine does not add up how much", each.name,
                         each.material->restitution);
    const ContactKind kind = effective_kind(input.contact, each.material->surface_energy);
    if (kind.adhesive() && kind.range != AdhesionRange::touch)
      return "adhesive contacts that tear dissipate, and the engine does not add up how much";
  }
  if (input.cell.shear_rate != 0) return "the work of homogeneous shear is taken from samples, whose noise hides a drift";
  return std::nullopt;
}

}  // namespace scalebreak
