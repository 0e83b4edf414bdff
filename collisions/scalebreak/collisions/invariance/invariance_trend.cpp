#include <scalebreak/collisions/invariance/invariance_trend.hpp>

#include <algorithm>
#include <cmath>

#include <gsl/gsl_fit.h>
#include <gsl/gsl_statistics_double.h>

namespace scalebreak {
namespace {

using Pair = MotionQuantity::Pair;
using Compared = std::optional<Pair>;

/// Of a member that both motions must have.
template <auto Member>
Compared both(const PairMotion& scaled, const PairMotion& original, double) {
  const std::optional<double> a = scaled.*Member, b = original.*Member;
  if (!a || !b) return {};
  return Pair{*a, *b};
}

Compared normal(const PairMotion& scaled, const PairMotion& original, double) {
  return Pair{scaled.restitution_normal, original.restitution_normal};
}

/// Along what the original gains: size factor × spin of the scaled pair.
Compared spin(const PairMotion& scaled, const PairMotion& original, double size) {
  double along = 0, square = 0;
  for (const std::size_t i : {0, 1}) {
    along += scaled.spin_gained[i].dot(original.spin_gained[i]);
    square += original.spin_gained[i].squaredNorm();
  }
  if (square == 0) return {};
  return Pair{size * along / std::sqrt(square), std::sqrt(square)};
}

Compared impulse(const PairMotion& scaled, const PairMotion& original, double) {
  const double norm = original.tangential_gained.norm();
  if (norm == 0) return {};
  return Pair{scaled.tangential_gained.dot(original.tangential_gained) / norm, norm};
}

Compared slides(const PairMotion& scaled, const PairMotion& original, double) {
  return Pair{static_cast<double>(scaled.slides), static_cast<double>(original.slides)};
}

/// The deviation's power of overlap over radius, from the overlaps of the input to a tenth of them.
void fit_overlap_power(const std::vector<MotionPoint>& points, MotionTrend& trend) {
  std::vector<double> powers;
  for (const MotionPoint& point : points) {
    const ComparedMotions& m = *point.motions;
    if (!m.scaled_tenth || m.scaled_tenth->stuck || m.original_tenth->stuck) continue;
    const auto all = trend.quantity->deviation(m.scaled, m.original, m.size);
    const auto tenth = trend.quantity->deviation(*m.scaled_tenth, *m.original_tenth, m.size);
    // Below a tenth of the tolerance a deviation is the integration's own.
    if (!all || !tenth || std::abs(*all) < kept_tolerance || std::abs(*tenth) < kept_tolerance / 10) continue;
    powers.push_back(std::log10(std::abs(*all / *tenth)));
  }
  if (powers.size() < 2) return;
  trend.overlap_power = true;
  trend.overlap_exponent = gsl_stats_mean(powers.data(), 1, powers.size());
  trend.overlap_exponent_error = gsl_stats_sd(powers.data(), 1, powers.size()) / std::sqrt(static_cast<double>(powers.size()));
}

std::optional<MotionTrend> motion_trend(const MotionQuantity& quantity, const std::vector<MotionPoint>& points) {
  MotionTrend trend{.quantity = &quantity};
  bool exists = false;
  std::vector<TrendPoint> ratios;
  for (const MotionPoint& point : points) {
    const ComparedMotions& m = *point.motions;
    if (m.stuck()) continue;
    const auto deviation = quantity.deviation(m.scaled, m.original, m.size);
    if (!deviation) continue;
    const bool limit = m.scaled_limit && !m.scaled_limit->stuck && !m.original_limit->stuck;
    if (m.scaled_limit && !limit) continue;
    // What only the overlap gives the original is nothing that a law could keep.
    if (limit && !quantity.deviation(*m.scaled_limit, *m.original_limit, m.size)) continue;
    exists = true;
    trend.largest = std::max(trend.largest, std::abs(*deviation));
    const PairMotion &scaled = limit ? *m.scaled_limit : m.scaled, &original = limit ? *m.original_limit : m.original;
    if (limit) {
      trend.limit = true;
      if (const auto d = quantity.deviation(scaled, original, m.size)) trend.largest_limit = std::max(trend.largest_limit, std::abs(*d));
    }
    if (const auto ratio = quantity.ratio(scaled, original, m.size)) ratios.push_back({point.factor, *ratio});
  }
  if (!exists) return {};
  trend.power = trend_of(ratios);
  trend.verdict = trend.largest < kept_tolerance                        ? TrendVerdict::kept
                  : trend.limit && trend.largest_limit < kept_tolerance ? TrendVerdict::kept_to_first_order
                                                                        : TrendVerdict::moved;
  if (trend.verdict == TrendVerdict::kept_to_first_order) fit_overlap_power(points, trend);
  return trend;
}

}  // namespace

Trend trend_of(const std::vector<TrendPoint>& points) {
  std::vector<double> x, y;
  Trend trend;
  bool positive = true;
  for (const TrendPoint& point : points) {
    trend.exists = true;
    trend.largest = std::max(trend.largest, std::abs(point.ratio - 1));
    positive = positive && point.ratio > 0;
    if (point.factor == 1 || !(point.ratio > 0)) continue;
    x.push_back(std::log(point.factor));
    y.push_back(std::log(point.ratio));
  }
  trend.kept = trend.exists && trend.largest < kept_tolerance;
  // One point has no power with an error, nor has what changes its sign.
  if (!positive || x.size() < 2) {
    trend.exponent = trend.exponent_error = std::nan("");
    return trend;
  }
  double variance = 0, residue = 0;
  gsl_fit_mul(x.data(), 1, y.data(), 1, x.size(), &trend.exponent, &variance, &residue);
  trend.exponent_error = std::sqrt(variance);
  return trend;
}

std::optional<double> MotionQuantity::ratio(const PairMotion& scaled, const PairMotion& original, double size) const {
  const Compared pair = of(scaled, original, size);
  if (!pair || pair->original == 0 || (!by_ratio && std::abs(pair->original) < kept_tolerance)) return {};
  return pair->scaled / pair->original;
}

std::optional<double> MotionQuantity::deviation(const PairMotion& scaled, const PairMotion& original, double size) const {
  if (by_ratio) {
    const auto r = ratio(scaled, original, size);
    return r ? std::optional(*r - 1) : std::nullopt;
  }
  const Compared pair = of(scaled, original, size);
  return pair ? std::optional(pair->scaled - pair->original) : std::nullopt;
}

const std::vector<MotionQuantity>& motion_quantities() {
  static const std::vector<MotionQuantity> all = {
      {"restitution_normal", "normal restitution", false, normal},
      {"restitution_tangential", "tangential restitution of the centres", false, both<&PairMotion::restitution_tangential>},
      {"restitution_surface", "tangential restitution of the surfaces", false, both<&PairMotion::restitution_surface>},
      {"restitution_rolling", "rolling speed after over before", false, both<&PairMotion::restitution_rolling>},
      {"spin_ratio", "spin gained × size", true, spin},
      {"tangential_impulse_ratio", "tangential impulse over mass", true, impulse},
      {"angular_momentum_share", "share of the orbit's loss of angular momentum that the spins gain", true,
       both<&PairMotion::angular_momentum_share>},
      {"slides", "number of slides", false, slides},
  };
  return all;
}

const MotionQuantity& motion_quantity(std::string_view key) {
  return *std::find_if(motion_quantities().begin(), motion_quantities().end(), [&](const auto& q) { return q.key == key; });
}

std::vector<MotionTrend> motion_trends(const std::vector<MotionPoint>& points) {
  std::vector<MotionTrend> trends;
  for (const MotionQuantity& quantity : motion_quantities()) {
    if (const auto trend = motion_trend(quantity, points)) trends.push_back(*trend);
  }
  return trends;
}

}  // namespace scalebreak
