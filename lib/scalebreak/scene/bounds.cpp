#include <scalebreak/scene/bounds.hpp>

#include <cstdlib>
#include <map>
#include <numbers>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>

namespace scalebreak {
namespace {

/// The bounds by section and name; materials share theirs.
const std::map<std::string, Bounds, std::less<>>& all_bounds() {
  static const std::map<std::string, Bounds, std::less<>> map = {
      {"young", {1e2, 1e14}},
      {"poisson", {0, 0.5}},
      {"density", {1e-2, 1e6}},
      {"restitution", {0, 1, false}},
      {"sliding_friction", {0, 1e3}},
      {"surface_energy", {0, 1e3}},
      {"spring_constant", {1e-6, 1e12}},
      {"spring_constant_tangential", {1e-6, 1e12}},
      {"rolling_friction", {0, 1e3}},
      {"rolling_damping", {0, 1e3}},
      {"rolling_angle_max", {1e-9, 10}},
      {"rolling_spring_constant", {1e-6, 1e12}},
      {"rolling_dashpot", {0, 1e6}},
      {"surface_tension", {0, 1e3}},
      {"contact_angle", {0, std::numbers::pi / 2}},
      {"viscosity", {0, 1e6}},
      {"liquid_volume", {0, 1e6}},
      {"liquid_fraction", {0, 0.1}},
      {"separation_min", {0, 1}},
      {"separation_min_ratio", {1e-9, 1}},
      {"pair.radius", {1e-9, 1e2}},
      {"impact.normal_speed", {1e-9, 1e4}},
      {"impact.tangential_speed", {0, 1e4}},
      {"impact.spin1", {-1e9, 1e9}},
      {"impact.spin2", {-1e9, 1e9}},
      {"body.position", {-1e3, 1e3}},
      {"body.velocity", {-1e4, 1e4}},
      {"body.spin", {-1e9, 1e9}},
      {"body.radius", {1e-9, 1e2}},
      {"particles.count", {0, 1e8}},
      {"particles.radius", {1e-9, 1e2}},
      {"particles.volume_fraction", {0, 0.6}},
      {"particles.size_spread", {0, 2}},
      {"particles.large_radius", {0, 1e2}},
      {"particles.large_mass_fraction", {0, 1}},
      {"particles.speed", {0, 1e4}},
      {"cell.size", {0, 1e3}},
      {"cell.shear_rate", {0, 1e9}},
      {"cell.wall_speed", {0, 1e4}},
      {"cell.pressure", {0, 1e12}},
      {"cell.gravity", {-1e4, 1e4}},
      {"run.duration", {0, 1e6}},
      {"run.strain", {0, 1e6}},
      {"run.warmup_duration", {0, 1e6}},
      {"run.warmup_strain", {0, 1e6}},
      {"run.seed", {0, 0x1p53 - 1}},
      {"run.step_fraction", {0, 1, false}},
      {"run.replicas", {1, 1000}},
      {"output.interval", {0, 1e6}},
      {"output.checkpoint_interval", {0, 1e6}},
      {"scaling.factor", {1e-8, 1e3}},
      {"study.factors", {1e-8, 1e3}},
      {"study.speeds", {1e-9, 1e4}},
      {"study.energy_growth", {1e-9, 1}},
      {"study.motion_error", {1e-9, 1}},
      {"study.step_fractions", {1e-4, 1}},
      {"study.tolerances", {1e-11, 1e-2}},
      {"study.phases", {1, 10000}},
      {"study.volume_fractions", {0, 0.6, false}},
      {"study.values", {-1e14, 1e14}},
      {"study.target_error", {0, 1}},
      {"study.most_replicas", {1, 1000}},
      {"study.budget_seconds", {0, 1e8}},
      {"advise.tolerance", {0, 1, false}},
      {"advise.speed", {0, 1e4}},
      {"advise.shear_rate", {0, 1e9}},
      {"advise.volume_fraction", {0, 0.6}},
      {"advise.pressure", {0, 1e12}},
      {"advise.size", {0, 1e2}},
      {"numerics.tolerance", {1e-13, 1e-6}},
      {"numerics.table_tolerance", {1e-7, 1e-2}},
  };
  return map;
}

/// Six digits where they say all of it, else as many as it takes: what is printed as allowed is allowed.
std::string exact(double number) {
  const std::string six = fmt::format("{:g}", number);
  return std::strtod(six.c_str(), nullptr) == number ? six : fmt::format("{}", number);
}

}  // namespace

std::string Bounds::text() const {
  return fmt::format("{} {} and at most {}", low_allowed ? "of at least" : "above", exact(low), exact(high));
}

Bounds bounds_of(std::string_view dotted) {
  const auto& map = all_bounds();
  if (const auto at = map.find(dotted); at != map.end()) return at->second;
  if (const std::size_t dot = dotted.find('.'); dot != std::string_view::npos) {
    if (const auto at = map.find(dotted.substr(dot + 1)); at != map.end()) return at->second;
  }
  throw WorkError(fmt::format("{} has no bounds", dotted));
}

}  // namespace scalebreak
