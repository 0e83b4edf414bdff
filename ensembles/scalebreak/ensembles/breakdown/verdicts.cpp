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
/// Is it a number of the scene, as the volume fraction of a closed cell, and no result?
bool is_given(const Comparison& c) { return size_of(c) < 1e-9; }
bool within(const Comparison& c) { return size_of(c) + standard_errors * c.relative.error <= broken_beyond; }

/// "granular temperature is off by +8.1 % ± 0.9 %"
std::string off_by(const Comparison& c) {
  return fmt::format("{} is off by {:+.1f} % ± {:.1f} %", study_quantity(c.name).what, 100 * c.relative.value, 100 * c.relative.error);
}

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
  static const std::vector<std::string> names = {"temperature", "rotational_energy", "collision_rate",
                                                 "pressure",    "stress_xz",         "volume_fraction"};
  return names;
}

CellVerdict cell_verdict(const CellResult& cell) {
  if (cell.failed()) return {Standing::failed, {}};
  if (cell.deviations.empty()) return {};
  CellVerdict verdict{Standing::holds, {}};
  bool broken = false;
  for (const std::string& name : judged_quantities()) {
    const Comparison* c = cell.deviation(name);
    if (!c || !std::isfinite(c->relative.value) || is_given(*c)) continue;
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
  std::string text = fmt::format("{} ({})", reach.law, reach.engine);
  if (const std::string name = reach.point.name(parameter); !name.empty()) text += ", " + name;
  text += ": ";
  if (reach.holds_to) text += fmt::format("holds to {:g}", *reach.holds_to);
  if (!reach.next) return text + ", the last that was tried";
  text += fmt::format("{}at {:g} ", reach.holds_to ? "; " : "", *reach.next);
  const CellVerdict& there = *reach.there;
  if (there.standing == Standing::failed) return text + "it could not be run to its end";
  if (!there.worst) return text + "nothing is known";
  return text + off_by(*there.worst) + (there.standing == Standing::undecided ? ", which is too uncertain to tell" : "");
}

std::vector<std::string> law_digest(const StudyResult& study, const std::string& parameter) {
  struct Tally {
    std::string law;
    double factor;
    int cells = 0, count[std::size(standing_words)] = {};
    std::optional<Comparison> worst;
    StudyPoint where;
  };
  std::vector<Tally> tallies;
  for (std::size_t i = 0; i < study.cells.size(); ++i) {
    const StudyCell& of = study.grid.cells[i];
    if (of.original()) continue;
    const CellVerdict verdict = cell_verdict(study.cells[i]);
    auto at = std::find_if(tallies.begin(), tallies.end(), [&](const Tally& t) { return t.law == of.law && t.factor == of.factor; });
    if (at == tallies.end()) at = tallies.insert(tallies.end(), {.law = of.law, .factor = of.factor});
    ++at->cells, ++at->count[static_cast<std::size_t>(verdict.standing)];
    if (verdict.standing != Standing::broken || (at->worst && size_of(*at->worst) >= size_of(*verdict.worst))) continue;
    at->worst = verdict.worst, at->where = of.point;
  }
  std::vector<std::string> sentences;
  for (const Tally& t : tallies) {
    std::string text = fmt::format("{} at {:g}:", t.law, t.factor);
    for (const Standing standing : {Standing::holds, Standing::undecided, Standing::broken, Standing::failed}) {
      const auto k = static_cast<std::size_t>(standing);
      if (t.count[k] > 0) text += fmt::format("{} {} in {} of {}", text.back() == ':' ? "" : ",", standing_words[k], t.count[k], t.cells);
    }
    if (t.worst) {
      const std::string where = t.where.name(parameter);
      text += fmt::format("; most{}{}, where {}", where.empty() ? "" : " at ", where, off_by(*t.worst));
    }
    sentences.push_back(text);
  }
  return sentences;
}

}  // namespace scalebreak
