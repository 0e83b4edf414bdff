#include <scalebreak/ensembles/breakdown/study_quantities.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/measure/flow_json.hpp>

namespace scalebreak {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double middle_from = 0.2, middle_to = 0.8;  ///< of the height of a gap

const ProfileColumn* column(const FlowProfile& profile, const std::string& name) {
  const auto at = std::find_if(profile.columns.begin(), profile.columns.end(), [&](const auto& each) { return each.name == name; });
  return at == profile.columns.end() ? nullptr : &*at;
}

/// Mean over the middle of the gap of what is a mean over spheres, or, without `weights`, over volume. Slabs of one run hang together, so
/// that the error is left to how runs differ.
double middle(const FlowProfile& profile, const std::string& name, const ProfileColumn* weights) {
  const ProfileColumn* values = column(profile, name);
  if (!values || profile.height.empty()) return nothing;
  const double slab = profile.height.size() > 1 ? profile.height[1] - profile.height[0] : 2 * profile.height[0];
  const double low = profile.height.front() - slab / 2, height = profile.height.back() + slab / 2 - low;
  double sum = 0, weight = 0;
  for (std::size_t s = 0; s < profile.height.size(); ++s) {
    const double at = (profile.height[s] - low) / height, own = weights ? weights->slabs[s].value : 1;
    if (at < middle_from || at > middle_to || !std::isfinite(values->slabs[s].value)) continue;
    sum += own * values->slabs[s].value, weight += own;
  }
  return sum / weight;
}

void add_middle(std::vector<Quantity>& quantities, const FlowProfile& profile) {
  const ProfileColumn* number = column(profile, "number_density");
  for (const char* name : {"temperature", "rotational_energy"})
    quantities.push_back({fmt::format("{}_middle", name), "", {middle(profile, name, number), nothing}});
  quantities.push_back({"volume_fraction_middle", "", {middle(profile, "volume_fraction", nullptr), nothing}});
}

/// Of a bed of the same spheres with its centre of mass at the same height, and as dense everywhere. The height is the volume fraction's own mean.
double bed_volume_fraction(const FlowProfile& profile) {
  const ProfileColumn* solids = column(profile, "volume_fraction");
  if (!solids || profile.height.empty()) return nothing;
  double depth = 0, moment = 0;
  for (std::size_t s = 0; s < profile.height.size(); ++s) {
    const double thickness = 2 * profile.height.front(), solid = solids->slabs[s].value * thickness;
    depth += solid, moment += solid * profile.height[s];
  }
  return depth * depth / (2 * moment);
}

}  // namespace

bool is_bed(const Input& scene) {
  const CellInput& cell = scene.cell;
  return cell.gravity.z() < 0 && cell.boundary[2] == Boundary::wall && cell.shear_rate == 0 && cell.wall_speed == 0;
}

const std::vector<StudyQuantity>& study_quantities() {
  static const std::vector<StudyQuantity> list = {
      {"temperature", "m2/s2", 0, "granular temperature"},
      {"rotational_energy", "J", 3, "rotational energy"},
      {"collision_rate", "1/s", -1, "collision rate"},
      {"coordination", "-", 0, "coordination"},
      {"multi_contact_fraction", "-", 0, "multi-contact fraction"},
      {"pressure", "Pa", 0, "pressure"},
      {"stress_xz", "Pa", 0, "shear stress"},
      {"dissipation", "W/m3", 0, "dissipation"},
      {"volume_fraction", "-", 0, "volume fraction"},
      {"temperature_middle", "m2/s2", 0, "granular temperature in the middle"},
      {"rotational_energy_middle", "J", 3, "rotational energy in the middle"},
      {"volume_fraction_middle", "-", 0, "volume fraction in the middle"},
      {"bed_volume_fraction", "-", 0, "volume fraction of the bed"},
  };
  return list;
}

const StudyQuantity& study_quantity(const std::string& name) {
  for (const StudyQuantity& quantity : study_quantities()) {
    if (name == quantity.name) return quantity;
  }
  throw WorkError(fmt::format("a study has no quantity {}", name));
}

std::vector<Quantity> studied(const FlowResult& result, const Input& scene) {
  std::vector<Quantity> all = all_quantities(result);
  if (scene.cell.boundary[2] == Boundary::wall) add_middle(all, result.profile);
  if (is_bed(scene)) all.push_back({"bed_volume_fraction", "", {bed_volume_fraction(result.profile), nothing}});
  std::vector<Quantity> list;
  for (const StudyQuantity& wanted : study_quantities()) {
    const auto at = std::find_if(all.begin(), all.end(), [&](const Quantity& each) { return each.name == wanted.name; });
    if (at == all.end() || !std::isfinite(at->measured.value)) continue;
    list.push_back({wanted.name, wanted.unit, at->measured});
  }
  return list;
}

}  // namespace scalebreak
