#include <scalebreak/ensembles/breakdown/verdicts.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scalebreak/ensembles/breakdown/study_quantities.hpp>

namespace scalebreak {
namespace {

constexpr double standard_errors = 2;

double size_of(const Comparison& c) { return std::abs(c.relative.value); }
bool beyond(const Comparison& c) { return size_of(c) - standard_errors * c.relative.error > broken_beyond; }
bool within(const Comparison& c) { return size_of(c) + standard_errors * c.relative.error <= broken_beyond; }

/// Cells of one law, point and engine on one side of 1, nearest to 1 first.
std::vector<std::vector<std::size_t>> chains(const StudyResult& study) {
  std::vector<std::vector<std::size_t>> all;
  const auto& cells = study.grid.cells;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].original() || cells[i].factor == 1) continue;
    const auto alike = [&](const std::vector<std::size_t>& chain) {
      const StudyCell& other = cells[chain.front()];
      return other.law == cells[i].law && other.point == cells[i].point && other.asked == cells[i].asked &&
             (other.factor < 1) == (cells[i].factor < 1);
    };
    const auto at = std::find_if(all.begin(), all.end(), alike);
    at == all.end() ? all.push_back({i}) : at->push_back(i);
  }
  for (auto& chain : all)
    std::sort(chain.begin(), chain.end(),
              [&](std::size_t a, std::size_t b) { return std::abs(std::log(cells[a].factor)) < std::abs(std::log(cells[b].factor)); });
  return all;
}

}  // namespace

const std::vector<std::string>& judged_quantities() {
  static const std::vector<std::string> names = {"temperature", "rotational_energy", "collision_rate", "pressure", "stress_xz"};
  return names;
}

CellVerdict cell_verdict(const CellResult& cell) {
  if (cell.failed()) return {Standing::failed, {}};
  if (cell.deviations.empty()) return {};
  CellVerdict verdict{Standing::holds, {}};
  bool broken = false;
  for (const std::string& name : judged_quantities()) {
    const Comparison* c = cell.deviation(name);
    if (!c || !std::isfinite(c->relative.value)) continue;
    const bool known = std::isfinite(c->relative.error), here = known && beyond(*c);
    if (!known || !within(*c)) verdict.standing = Standing::undecided;
    if (broken && !here) continue;
    if (!verdict.worst || (here && !broken) || size_of(*c) > size_of(*verdict.worst)) verdict.worst = *c;
    broken = broken || here;
  }
  if (broken) verdict.standing = Standing::broken;
  return verdict;
}

std::vector<LawReach> law_reaches(const StudyResult& study) {
  std::vector<LawReach> reaches;
  for (const auto& chain : chains(study)) {
    const StudyCell& first = study.grid.cells[chain.front()];
    LawReach reach{.law = first.law, .engine = first.choice.engine, .point = first.point, .softer = first.factor < 1};
    for (const std::size_t i : chain) {
      CellVerdict verdict = cell_verdict(study.cells[i]);
      if (verdict.standing == Standing::holds) {
        reach.holds_to = study.grid.cells[i].factor;
        continue;
      }
      reach.next = study.grid.cells[i].factor, reach.there = std::move(verdict);
      break;
    }
    reaches.push_back(std::move(reach));
  }
  return reaches;
}

std::string sentence(const LawReach& reach, const std::string& parameter) {
  std::string text = reach.law;
  if (const std::string name = reach.point.name(parameter); !name.empty()) text += ", " + name;
  text += reach.holds_to ? fmt::format(": holds to {:g}", *reach.holds_to) : std::string(": holds at none of the factors");
  if (!reach.next) return text + ", the last that was tried";
  text += fmt::format("; at {:g} ", *reach.next);
  const CellVerdict& there = *reach.there;
  if (there.standing == Standing::failed) return text + "it could not be run to its end";
  if (!there.worst) return text + "nothing is known";
  const Measured& off = there.worst->relative;
  return text + fmt::format("{} is off by {:+.1f} % ± {:.1f} %{}", study_quantity(there.worst->name).what, 100 * off.value, 100 * off.error,
                            there.standing == Standing::undecided ? ", which is too uncertain to tell" : "");
}

}  // namespace scalebreak
