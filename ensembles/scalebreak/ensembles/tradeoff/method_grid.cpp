#include <scalebreak/ensembles/tradeoff/method_grid.hpp>

#include <algorithm>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/collisions/invariance/invariance.hpp>
#include <scalebreak/ensembles/breakdown/study_quantities.hpp>
#include <scalebreak/ensembles/engine/engine_names.hpp>
#include <scalebreak/scaling/scaling_law.hpp>

namespace scalebreak {
namespace {

const char* word(Keep keep) { return keep_words[static_cast<std::size_t>(keep)]; }

/// Puts ways into a grid, each cell once.
class Builder {
 public:
  explicit Builder(const Input& input) : input_(input) {}

  void add(FlowWay way, const std::vector<Assignment>& changes) {
    try {
      StudyCell cell = study_cell(input_, {}, way.automatic ? "auto" : way.engine, way.law, way.factor, changes);
      way.engine = cell.choice.engine;
      if (steps(way.engine)) way.step_fraction = cell.input.run.step_fraction;
      if (const auto refusal = why_unsuited(cell)) {
        way.refusal = *refusal;
      } else {
        way.cell = place_of(std::move(cell));
      }
    } catch (const InputError& error) {
      way.refusal = error.what();
    }
    const auto same =
        std::find_if(made_.ways.begin(), made_.ways.end(), [&](const FlowWay& other) { return way.cell && other.cell == way.cell; });
    if (same == made_.ways.end()) return made_.ways.push_back(std::move(way));
    same->automatic = same->automatic || way.automatic;
  }

  void add_soft_spheres() {
    std::vector<double> fractions = input_.tradeoff.step_fractions;
    fractions.push_back(input_.run.step_fraction);
    std::sort(fractions.begin(), fractions.end(), std::greater());
    fractions.erase(std::unique(fractions.begin(), fractions.end()), fractions.end());
    for (const double fraction : fractions) {
      std::vector<Assignment> changes = {{"run.step_fraction", fraction, {}}};
      if (fraction > input_.run.step_fraction) changes.push_back({"run.step_bounds", false, {}});
      add({.engine = "dem"}, changes);
    }
    for (const std::string& name : study_laws(input_)) {
      for (const double factor : input_.study_factors) {
        const ScalingLaw& law = *find_scaling_law(name);
        if (refusal(law, factor, input_.contact.normal)) {
          ++made_.skipped;
        } else if (size_factor(law, factor) > 1) {
          for (const Keep keep : {Keep::count, Keep::cell}) {
            if (keep == Keep::count && is_bed(input_)) continue;  // as many larger spheres are a deeper bed
            add({.engine = "dem", .law = name, .factor = factor, .keep = word(keep)}, {{"scaling.keep", std::string(word(keep)), {}}});
          }
        } else {
          add({.engine = "dem", .law = name, .factor = factor}, {});
        }
      }
    }
  }

  MethodGrid take() { return std::move(made_); }

 private:
  std::size_t place_of(StudyCell cell) {
    auto& cells = made_.grid.cells;
    const auto at = std::find_if(cells.begin(), cells.end(), [&](const StudyCell& other) { return other.key == cell.key; });
    const auto place = static_cast<std::size_t>(at - cells.begin());
    if (at == cells.end()) cells.push_back(std::move(cell));
    return place;
  }

  const Input& input_;
  MethodGrid made_;
};

}  // namespace

std::string FlowWay::series() const {
  if (original()) return engine == "dem" ? "dem over step" : engine;
  return fmt::format("{}{}{} ({})", law, keep.empty() ? "" : " keeping ", keep, engine);
}

std::string FlowWay::name() const {
  if (!original()) return fmt::format("{} {:g}{}{} ({})", law, factor, keep.empty() ? "" : " keeping ", keep, engine);
  return engine == "dem" ? fmt::format("dem at a step of {:g}", step_fraction) : engine;
}

MethodGrid method_grid(const Input& input) {
  Builder builder(input);
  std::vector<std::string> engines = input.study.engines;
  if (engines == std::vector<std::string>{"auto"}) engines = {"dem", "hybrid", "event", "auto"};
  for (const std::string& engine : engines) {
    if (engine == "dem") {
      builder.add_soft_spheres();
    } else {
      builder.add({.engine = engine, .automatic = engine == "auto"}, {});
    }
  }
  MethodGrid made = builder.take();
  made.bed = is_bed(input);
  const bool there = std::any_of(made.ways.begin(), made.ways.end(), [](const FlowWay& way) { return way.cell && way.original(); });
  if (!there) throw InputError("study.engines: none of them runs the original; allowed: one that does, as \"dem\"");
  return made;
}

}  // namespace scalebreak
