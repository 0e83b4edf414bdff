#include <scalebreak/collisions/invariance/invariance_words.hpp>

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace scalebreak {
namespace {

/// An exponent whose error is this small is a power law; one that the scatter over speeds leaves open is none.
constexpr double power_law_error = 1e-6, no_power_error = 0.05;

bool has_power(const Trend& trend) { return trend.exists && trend.exponent_error < no_power_error; }

std::string moved(const std::string& what, const Trend& trend) {
  if (!trend.exists) return "";
  if (trend.kept) return fmt::format("keeps the {}", what);
  if (trend.exponent_error < power_law_error) return fmt::format("moves the {} as factor^{:.3f}", what, trend.exponent);
  if (trend.exponent_error < no_power_error)
    return fmt::format("moves the {} about as factor^({:.3f} ± {:.1g})", what, trend.exponent, trend.exponent_error);
  return fmt::format("moves the {} by up to {:.3g} times itself, not by one power of the factor", what, trend.largest);
}

std::string power_in_words(const Trend& trend) {
  return trend.exponent_error < power_law_error ? fmt::format("factor^{:.3f}", trend.exponent)
                                                : fmt::format("about factor^({:.3f} ± {:.1g})", trend.exponent, trend.exponent_error);
}

/// "keeps A, B; keeps in the limit … C (0.002, p = 1.00 ± 0.01); moves D as factor^-1.000, E by up to 0.3"
std::string motion_in_words(const std::vector<MotionTrend>& trends) {
  std::vector<std::string> kept, first_order, moved, parts;
  for (const MotionTrend& t : trends) {
    const std::string name(t.quantity->name);
    switch (t.verdict) {
      case TrendVerdict::kept: kept.push_back(name); break;
      case TrendVerdict::kept_to_first_order:
        first_order.push_back(
            fmt::format("{} ({:.2g}{})", name, t.largest,
                        t.overlap_power ? fmt::format(", p = {:.2f} ± {:.1g}", t.overlap_exponent, t.overlap_exponent_error) : ""));
        break;
      case TrendVerdict::moved:
        moved.push_back(t.quantity->by_ratio && has_power(t.power) ? name + " as " + power_in_words(t.power)
                                                                   : fmt::format("{} by up to {:.3g}", name, t.largest));
        break;
    }
  }
  if (!kept.empty()) parts.push_back(fmt::format("keeps {}", fmt::join(kept, ", ")));
  if (!first_order.empty()) {
    parts.push_back(
        fmt::format("keeps in the limit of small overlaps, with deviations here that go as overlap over radius to the power p, {}",
                    fmt::join(first_order, ", ")));
  }
  if (!moved.empty()) parts.push_back(fmt::format("moves {}", fmt::join(moved, ", ")));
  return fmt::format("{}", fmt::join(parts, "; "));
}

}  // namespace

std::string verdict(const Trend& trend) {
  if (!trend.exists) return "–";
  if (trend.kept) return "kept";
  if (!has_power(trend)) return fmt::format("moves by up to {:.3g}", trend.largest);
  return fmt::format("{}factor^{:.3f}", trend.exponent_error < power_law_error ? "" : "about ", trend.exponent);
}

std::string full_name(const LawSummary& s) {
  const ScalingLaw* law = find_scaling_law(s.law);
  return law->factor_of == FactorOf::stiffness_or_size ? fmt::format("{} ({})", s.law, s.softer ? "softer" : "larger") : s.law;
}

std::string verdict(const MotionTrend& t) {
  if (t.verdict == TrendVerdict::kept) return "kept";
  if (t.verdict == TrendVerdict::kept_to_first_order) return fmt::format("kept to first order: {:.2g}", t.largest);
  return t.quantity->by_ratio && has_power(t.power) ? power_in_words(t.power) : fmt::format("moves by up to {:.3g}", t.largest);
}

std::string in_words(const LawSummary& s) {
  std::string text =
      full_name(s) + (s.motion.empty() || s.wet ? "" : " in the normal motion by itself") +
      (s.restitution_change < kept_tolerance ? std::string(" keeps the restitution at every speed")
                                             : fmt::format(" changes the restitution by up to {:.3g}", s.restitution_change));
  if (s.verdict_changes > 0)
    text += fmt::format(" ({} of its collisions stick where the original's do not, or the reverse)", s.verdict_changes);
  for (const auto& [what, trend] :
       {std::pair{"sticking speed", &s.sticking_speed}, {"contact time", &s.contact_time}, {"largest overlap", &s.max_overlap}}) {
    if (const std::string part = moved(what, *trend); !part.empty()) text += "; it " + part;
  }
  if (s.motion.empty()) return text + ".";
  return text + ". In the whole motion it " + motion_in_words(s.motion) + ".";
}

}  // namespace scalebreak
