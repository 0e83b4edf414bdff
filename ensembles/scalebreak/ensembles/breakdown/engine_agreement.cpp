#include <scalebreak/ensembles/breakdown/engine_agreement.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <scalebreak/ensembles/breakdown/study_quantities.hpp>
#include <scalebreak/ensembles/breakdown/verdicts.hpp>
#include <scalebreak/statistics/pooled_mean.hpp>

namespace scalebreak {
namespace {

double chance_of(double squares, double count) {
  if (count == 0) return 1;
  return boost::math::cdf(complement(boost::math::chi_squared(count), squares));
}

/// The squared variance of a mean over its degrees of freedom, where it is from the scatter of runs.
double spread(double variance, std::size_t runs) {
  return from_scatter_alone(runs) ? variance * variance / static_cast<double>(runs - 1) : 0.0;
}

/// The square of a normal number that is as seldom as this difference.
double normal_square(const Comparison& c, std::size_t first_runs, std::size_t second_runs) {
  const double first = std::pow(c.first.error / scatter_factor(first_runs), 2),
               second = std::pow(c.second.error / scatter_factor(second_runs), 2);
  const double t = std::abs(c.difference.value) / std::sqrt(first + second);
  const double uncertain = spread(first, first_runs) + spread(second, second_runs);
  if (uncertain == 0) return t * t;
  const boost::math::students_t few((first + second) * (first + second) / uncertain);
  const double seldom = 2 * boost::math::cdf(complement(few, t));
  return seldom > 0 ? boost::math::quantile(complement(boost::math::chi_squared(1), seldom)) : t * t;
}

/// A number of the scene, as the volume fraction of a closed cell, and no result?
bool is_given(const Comparison& c) { return std::abs(c.relative.value) < 1e-9 && c.difference.error < 1e-9 * std::abs(c.first.value); }

void add(EngineAgreement& agreement, const CellResult& first, const CellResult& second) {
  for (const std::string& name : judged_quantities()) {
    const Quantity *one = first.quantity(name), *other = second.quantity(name);
    if (!one || !other) continue;
    const Comparison c = compare(*one, *other);
    if (!std::isfinite(c.difference.value) || !std::isfinite(c.difference.error) || c.difference.error == 0 || is_given(c)) continue;
    auto& list = agreement.quantities;
    auto at = std::find_if(list.begin(), list.end(), [&](const QuantityAgreement& q) { return q.name == name; });
    if (at == list.end()) at = list.insert(list.end(), {.name = name});
    const double square = normal_square(c, first.replicas, second.replicas);
    ++at->flows, at->squares += square;
    ++agreement.all.flows, agreement.all.squares += square;
    if (agreement.farthest && square <= agreement.farthest_squares) continue;
    agreement.farthest = c, agreement.farthest_squares = square;
  }
}

}  // namespace

std::vector<EngineAgreement> engine_agreements(const StudyResult& study) {
  std::vector<EngineAgreement> agreements;
  const auto& cells = study.grid.cells;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (std::size_t k = i + 1; k < cells.size(); ++k) {
      const bool same_flow = cells[k].law == cells[i].law && cells[k].factor == cells[i].factor && cells[k].point == cells[i].point;
      if (!same_flow || cells[i].choice.engine == cells[k].choice.engine || study.cells[i].failed() || study.cells[k].failed()) continue;
      if (cells[i].asked != cells.front().asked) continue;
      const std::string &first = cells[i].choice.engine, &second = cells[k].choice.engine;
      auto at = std::find_if(agreements.begin(), agreements.end(),
                             [&](const EngineAgreement& each) { return each.first == first && each.second == second; });
      if (at == agreements.end())
        at = agreements.insert(agreements.end(), {.first = first, .second = second, .all = {.name = "all"}, .farthest = {}});
      add(*at, study.cells[i], study.cells[k]);
    }
  }
  for (EngineAgreement& agreement : agreements) {
    for (QuantityAgreement& q : agreement.quantities) q.chance = chance_of(q.squares, q.flows);
    agreement.all.chance = chance_of(agreement.all.squares, agreement.all.flows);
  }
  return agreements;
}

std::string sentence(const EngineAgreement& agreement) {
  int flows = 0;
  std::string text;
  for (const QuantityAgreement& q : agreement.quantities) {
    flows = std::max(flows, q.flows);
    text += fmt::format(" {} {:.1f} over {} (probability {:.2g}),", study_quantity(q.name).what, q.squares, q.flows, q.chance);
  }
  text = fmt::format("{} and {} on {} flows, squared differences over their errors:{} all {:.1f} over {} ({:.2g})", agreement.first,
                     agreement.second, flows, text, agreement.all.squares, agreement.all.flows, agreement.all.chance);
  if (!agreement.farthest) return text;
  const Comparison& c = *agreement.farthest;
  return text + fmt::format("; least likely is {} by {:+.1f} % ± {:.1f} %", study_quantity(c.name).what, 100 * c.relative.value,
                            100 * c.relative.error);
}

}  // namespace scalebreak
