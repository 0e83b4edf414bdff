#include <scalebreak/collisions/invariance.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>

#include <gsl/gsl_fit.h>

#include <scalebreak/collisions/normal_collision.hpp>
#include <scalebreak/collisions/pair_collision.hpp>
#include <scalebreak/collisions/parallel.hpp>

namespace scalebreak {
namespace {

struct Cell {
  const ScalingLaw* law;
  double factor;
};

/// log ratio = p log factor, through the point (1, 1): p and its standard error over all records.
Trend trend_of(const std::vector<InvarianceRecord>& records, std::optional<double> InvarianceRecord::*ratio) {
  std::vector<double> x, y;
  Trend trend;
  for (const InvarianceRecord& record : records) {
    const auto& value = record.*ratio;
    if (!value || !(*value > 0)) continue;
    trend.exists = true;
    trend.largest = std::max(trend.largest, std::abs(*value - 1));
    if (record.factor == 1) continue;
    x.push_back(std::log(record.factor));
    y.push_back(std::log(*value));
  }
  trend.kept = trend.exists && trend.largest < kept_tolerance;
  if (x.size() < 2) return trend;
  double variance = 0, residue = 0;
  gsl_fit_mul(x.data(), 1, y.data(), 1, x.size(), &trend.exponent, &variance, &residue);
  trend.exponent_error = std::sqrt(variance);
  return trend;
}

/// Does the scaled pair have the reduced numbers of the original, so that every collision is the same in them?
bool same_reduced_numbers(const ScaledContact& original, const ScaledContact& scaled) {
  const auto a = original.reduced(1.0), b = scaled.reduced(1.0);
  const auto close = [](double p, double q) { return std::abs(p - q) <= 1e-12 * std::abs(p); };
  return original.kind() == scaled.kind() && close(a.speed, b.speed) && close(a.damping_ratio, b.damping_ratio);
}

double time_scale(const ScaledContact& contact, double speed) { return contact.reduced(speed).scales.time * contact.scaled().time; }

/// Largest change of e at equal v/v_stick, where both exist.
double change_at_equal_reduced_speed(const ScaledContact& original, const ScaledContact& scaled, double v0, double v1, double tolerance) {
  double largest = 0;
  for (const double ratio : {1.05, 1.5, 3.0, 10.0, 50.0}) {
    largest = std::max(largest,
                       std::abs(original.collide(ratio * v0, tolerance).restitution - scaled.collide(ratio * v1, tolerance).restitution));
  }
  return largest;
}

}  // namespace

std::vector<double> default_speeds(std::optional<double> sticking_speed) {
  const bool sticks = sticking_speed && *sticking_speed > 0;
  const double low = sticks ? 0.5 * *sticking_speed : 1e-3, high = sticks ? 100 * *sticking_speed : 10.0;
  constexpr int count = 24;
  std::vector<double> speeds;
  for (int i = 0; i < count; ++i) speeds.push_back(low * std::pow(high / low, i / (count - 1.0)));
  return speeds;
}

std::vector<std::string> study_laws(const Input& input) {
  if (!input.study_laws.empty()) return input.study_laws;
  std::vector<std::string> names;
  for (const ScalingLaw& law : scaling_laws()) {
    const bool suits = std::any_of(input.study_factors.begin(), input.study_factors.end(),
                                   [&](double factor) { return !refusal(law, factor, input.contact.normal); });
    if (suits) names.emplace_back(law.name);
  }
  return names;
}

InvarianceStudy run_invariance(const Input& input, int threads, const std::function<void(double)>& progress) {
  InvarianceStudy study;
  const ScaledContact original(input.contact, input.colliding(), *find_scaling_law("none"), 1);
  study.sticking_speed = original.sticking_speed(input.tolerance);
  study.speeds = input.study_speeds.empty() ? default_speeds(study.sticking_speed) : input.study_speeds;
  std::vector<PairCollision> reference(study.speeds.size());
  parallel_for(reference.size(), threads, [&](std::size_t i) { reference[i] = original.collide(study.speeds[i], input.tolerance); });

  std::vector<Cell> cells;
  for (const std::string& name : study_laws(input)) {
    const ScalingLaw* law = find_scaling_law(name);
    for (const bool softer : {true, false}) {
      for (const double factor : input.study_factors) {
        if ((factor < 1) != softer) continue;
        refusal(*law, factor, input.contact.normal) ? void(++study.skipped) : cells.push_back({law, factor});
      }
    }
  }

  struct Result {
    std::vector<InvarianceRecord> records;
    double reduced_change = 0;
    bool exact = false;
    int deep = 0;
  };
  std::vector<Result> results(cells.size());
  std::atomic<std::size_t> done = 0;
  parallel_for(cells.size(), threads, [&](std::size_t c) {
    const ScaledContact scaled(input.contact, input.colliding(), *cells[c].law, cells[c].factor);
    const auto stick = scaled.sticking_speed(input.tolerance);
    const double radius = scaled_bodies(*cells[c].law, cells[c].factor, input.colliding(), input.contact.normal).pair().radius;
    Result& result = results[c];
    result.exact = same_reduced_numbers(original, scaled);
    if (study.sticking_speed && *study.sticking_speed > 0 && stick && *stick > 0) {
      result.reduced_change = change_at_equal_reduced_speed(original, scaled, *study.sticking_speed, *stick, input.tolerance);
    }
    for (std::size_t i = 0; i < study.speeds.size(); ++i) {
      const double speed = study.speeds[i];
      const PairCollision collision = scaled.collide(speed, input.tolerance);
      InvarianceRecord record{std::string(cells[c].law->name),
                              cells[c].factor,
                              speed,
                              collision.stuck,
                              collision.restitution,
                              reference[i].restitution,
                              stick,
                              {},
                              {},
                              {},
                              {}};
      if (collision.contact_time && reference[i].contact_time)
        record.contact_time_ratio = *collision.contact_time / *reference[i].contact_time;
      result.deep += collision.max_overlap > deep_overlap * radius;
      record.max_overlap_ratio = collision.max_overlap / reference[i].max_overlap;
      if (stick && *study.sticking_speed > 0) record.sticking_speed_ratio = *stick / *study.sticking_speed;
      if (result.exact) record.contact_time_ratio_predicted = time_scale(scaled, speed) / time_scale(original, speed);
      result.records.push_back(std::move(record));
    }
    const double share = static_cast<double>(++done) / static_cast<double>(cells.size());
    if (progress) progress(share);
  });

  for (std::size_t c = 0; c < cells.size();) {
    LawSummary summary{.law = std::string(cells[c].law->name), .softer = cells[c].factor < 1, .exact = true};
    std::vector<InvarianceRecord> records;
    for (; c < cells.size() && cells[c].law->name == summary.law && (cells[c].factor < 1) == summary.softer; ++c) {
      study.deep += results[c].deep;
      summary.exact = summary.exact && results[c].exact;
      summary.reduced_restitution_change = std::max(summary.reduced_restitution_change, results[c].reduced_change);
      records.insert(records.end(), results[c].records.begin(), results[c].records.end());
    }
    for (const InvarianceRecord& record : records) {
      summary.restitution_change = std::max(summary.restitution_change, std::abs(record.restitution - record.restitution_original));
      summary.verdict_changes += record.stuck != (record.restitution_original == 0);
    }
    summary.sticking_speed = trend_of(records, &InvarianceRecord::sticking_speed_ratio);
    summary.contact_time = trend_of(records, &InvarianceRecord::contact_time_ratio);
    summary.max_overlap = trend_of(records, &InvarianceRecord::max_overlap_ratio);
    study.summaries.push_back(summary);
    study.records.insert(study.records.end(), std::make_move_iterator(records.begin()), std::make_move_iterator(records.end()));
  }
  return study;
}

}  // namespace scalebreak
