#include <scalebreak/ensembles/run/engine_choice.hpp>

#include <fmt/format.h>

#include <scalebreak/ensembles/event/rules/table_rule.hpp>
#include <scalebreak/ensembles/run/run_estimate.hpp>

namespace scalebreak {

EngineChoice choose_engine(const std::string& engine, const Input& input, int threads, double worth) {
  if (engine != "auto") return {engine, "as --engine says"};
  if (input.cell.kind == CellKind::confined_shear) return {"dem", "the height of the cell follows the stress of every step"};
  if (find_scaling_law(input.scaling_law)->direct_force) return {"dem", "no collision table describes a law that maps forces"};
  if (input.surface.attraction != Attraction::none) return {"dem", "no collision table describes liquids, which act at a distance"};
  if (const std::string reason = why_no_tables(input); !reason.empty()) return {"dem", "no collision table serves: " + reason};
  const RunEstimate e = estimate_run(input, threads);
  const std::string numbers =
      fmt::format("contact time x collision rate is about {:.2g}; about {:.2g} s by the hybrid, {:.2g} s by soft spheres on {} threads",
                  e.contact_time * e.collision_rate, e.hybrid_seconds, e.seconds, threads);
  if (e.contact_time > 0 && e.seconds > e.hybrid_seconds + worth) return {"hybrid", numbers};
  return {"dem", numbers + (worth > 0 ? fmt::format(", which may be {:g} s later for its tables", worth) : "")};
}

}  // namespace scalebreak
