#include <scalebreak/collisions/invariance/invariance.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>

#include <scalebreak/collisions/normal/normal_collision.hpp>
#include <scalebreak/collisions/normal/pair_collision.hpp>
#include <scalebreak/collisions/parallel.hpp>

namespace scalebreak {
namespace {

struct Cell {
  const ScalingLaw* law;
  double factor;
};

Trend trend_of(const std::vector<InvarianceRecord>& records, std::optional<double> InvarianceRecord::*ratio) {
  std::vector<TrendPoint> points;
  for (const InvarianceRecord& record : records) {
    const auto& value = record.*ratio;
    if (value && *value > 0) points.push_back({record.factor, *value});
  }
  return trend_of(points);
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

/// What "kept" means is decided more finely than a single collision needs.
double motion_tolerance(const Input& input) { return std::min(input.tolerance, 1e-10); }

/// Overlaps over radius at which nothing of first order is left above the tolerance.
constexpr double limit_shrink = 1e-8;

/// The motion of a pair, at the three overlaps at which it is compared.
struct Motions {
  PairMotion own;
  std::optional<PairMotion> tenth, limit;
};

Motions motions_of(const Input& input, const ScalingLaw& law, double factor) {
  const double tolerance = motion_tolerance(input);
  Motions motions{resolve_motion(input, law, factor, tolerance), {}, {}};
  if (!has_small_overlap_limit(input)) return motions;
  motions.tenth = resolve_motion(input, law, factor, tolerance, 0.1);
  motions.limit = resolve_motion(input, law, factor, tolerance, limit_shrink);
  return motions;
}

void set_motion(InvarianceRecord& record, const Motions& scaled, const Motions& original, double size) {
  record.motions = ComparedMotions{scaled.own, original.own, scaled.tenth, original.tenth, scaled.limit, original.limit, size};
  record.stuck = scaled.own.stuck;
  record.restitution = scaled.own.restitution_normal;
  record.restitution_original = original.own.restitution_normal;
  record.contact_time_ratio.reset();
  if (scaled.own.contact_time && original.own.contact_time)
    record.contact_time_ratio = *scaled.own.contact_time / *original.own.contact_time;
  record.max_overlap_ratio = scaled.own.max_overlap / original.own.max_overlap;
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
  study.motion = moves_beyond_normal(input);
  study.wet = input.surface.attraction != Attraction::none;
  const ScalingLaw& unscaled = *find_scaling_law("none");
  const ScaledContact original(input.contact, input.colliding(), unscaled, 1);
  const auto dry_sticking_speed = original.sticking_speed(input.tolerance);
  if (!study.wet) study.sticking_speed = dry_sticking_speed;
  study.speeds = input.study_speeds.empty() ? default_speeds(dry_sticking_speed) : input.study_speeds;
  std::vector<PairCollision> reference(study.speeds.size());
  std::vector<Motions> reference_motions(study.motion ? study.speeds.size() : 0);
  parallel_for(reference.size(), threads, [&](std::size_t i) {
    if (!study.wet) reference[i] = original.collide(study.speeds[i], input.tolerance);
    if (study.motion) reference_motions[i] = motions_of(at_normal_speed(input, study.speeds[i]), unscaled, 1);
  });

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
    std::vector<Motions> motions;
    double size = 1;
    double reduced_change = 0;
    bool exact = false;
    int deep = 0;
  };
  std::vector<Result> results(cells.size());
  std::atomic<std::size_t> done = 0;
  parallel_for(cells.size(), threads, [&](std::size_t c) {
    const ScaledContact scaled(input.contact, input.colliding(), *cells[c].law, cells[c].factor);
    const auto stick = study.wet ? std::nullopt : scaled.sticking_speed(input.tolerance);
    const double radius = scaled_bodies(*cells[c].law, cells[c].factor, input.colliding(), input.contact.normal).pair().radius;
    Result& result = results[c];
    result.size = size_factor(*cells[c].law, cells[c].factor);
    result.exact = same_reduced_numbers(original, scaled);
    if (study.sticking_speed && *study.sticking_speed > 0 && stick && *stick > 0) {
      result.reduced_change = change_at_equal_reduced_speed(original, scaled, *study.sticking_speed, *stick, input.tolerance);
    }
    for (std::size_t i = 0; i < study.speeds.size(); ++i) {
      const double speed = study.speeds[i];
      InvarianceRecord record{.law = std::string(cells[c].law->name), .factor = cells[c].factor, .normal_speed = speed};
      if (study.motion) result.motions.push_back(motions_of(at_normal_speed(input, speed), *cells[c].law, cells[c].factor));
      if (study.wet) {
        set_motion(record, result.motions[i], reference_motions[i], result.size);
        result.deep += result.motions[i].own.max_overlap > deep_overlap * radius;
        result.records.push_back(std::move(record));
        continue;
      }
      const PairCollision collision = scaled.collide(speed, input.tolerance);
      record.stuck = collision.stuck;
      record.restitution = collision.restitution;
      record.restitution_original = reference[i].restitution;
      record.sticking_speed = stick;
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
    LawSummary summary{.law = std::string(cells[c].law->name), .softer = cells[c].factor < 1, .exact = !study.wet};
    std::vector<InvarianceRecord> records;
    const std::size_t first = c;
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
    summary.wet = study.wet;
    if (study.motion) {
      std::vector<MotionPoint> points;
      for (std::size_t i = 0; i < records.size(); ++i) {
        const Result& result = results[first + i / study.speeds.size()];
        const std::size_t speed = i % study.speeds.size();
        set_motion(records[i], result.motions[speed], reference_motions[speed], result.size);
        points.push_back({records[i].factor, &*records[i].motions});
      }
      summary.motion = motion_trends(points);
    }
    study.summaries.push_back(std::move(summary));
    study.records.insert(study.records.end(), std::make_move_iterator(records.begin()), std::make_move_iterator(records.end()));
  }
  return study;
}

}  // namespace scalebreak
