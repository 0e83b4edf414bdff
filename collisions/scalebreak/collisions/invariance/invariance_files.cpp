#include <scalebreak/collisions/invariance/invariance_files.hpp>

#include <cmath>
#include <string>

#include <scalebreak/output/csv.hpp>

namespace scalebreak {
namespace {

CsvCell cell(const std::optional<double>& value) { return value ? CsvCell(*value) : CsvCell(); }

template <auto Member>
std::optional<double> scaled(const InvarianceRecord& r) {
  return r.motions ? r.motions->scaled.*Member : std::optional<double>();
}
template <auto Member>
std::optional<double> original(const InvarianceRecord& r) {
  return r.motions ? r.motions->original.*Member : std::optional<double>();
}

std::optional<double> ratio(const InvarianceRecord& r, std::string_view key) {
  if (!r.motions || r.motions->stuck()) return {};
  return motion_quantity(key).ratio(r.motions->scaled, r.motions->original, r.motions->size);
}
std::optional<double> spin_ratio(const InvarianceRecord& r) { return ratio(r, "spin_ratio"); }
std::optional<double> impulse_ratio(const InvarianceRecord& r) { return ratio(r, "tangential_impulse_ratio"); }

std::optional<double> spin_ratio_limit(const InvarianceRecord& r) {
  if (!r.motions || !r.motions->scaled_limit || r.motions->scaled_limit->stuck || r.motions->original_limit->stuck) return {};
  return motion_quantity("spin_ratio").ratio(*r.motions->scaled_limit, *r.motions->original_limit, r.motions->size);
}

std::optional<double> slides(const InvarianceRecord& r) {
  return r.motions ? std::optional<double>(r.motions->scaled.slides) : std::nullopt;
}
std::optional<double> slides_original(const InvarianceRecord& r) {
  return r.motions ? std::optional<double>(r.motions->original.slides) : std::nullopt;
}
std::optional<double> turned(const InvarianceRecord& r) {
  return r.motions ? std::optional<double>(r.motions->scaled.turned) : std::nullopt;
}

CsvCell exponent(const Trend& trend) { return trend.exists && std::isfinite(trend.exponent) ? CsvCell(trend.exponent) : CsvCell(); }
CsvCell exponent_error(const Trend& trend) {
  return trend.exists && std::isfinite(trend.exponent) ? CsvCell(trend.exponent_error) : CsvCell();
}

const char* to_string(TrendVerdict verdict) {
  switch (verdict) {
    case TrendVerdict::kept: return "kept";
    case TrendVerdict::kept_to_first_order: return "kept_to_first_order";
    case TrendVerdict::moved: return "moved";
  }
  return "?";
}

}  // namespace

const std::vector<MotionMember>& motion_members() {
  static const std::vector<MotionMember> members = {
      {"spin_ratio", "-", spin_ratio},
      {"spin_ratio_limit", "-", spin_ratio_limit},
      {"restitution_tangential", "-", scaled<&PairMotion::restitution_tangential>},
      {"restitution_tangential_original", "-", original<&PairMotion::restitution_tangential>},
      {"restitution_surface", "-", scaled<&PairMotion::restitution_surface>},
      {"restitution_surface_original", "-", original<&PairMotion::restitution_surface>},
      {"restitution_rolling", "-", scaled<&PairMotion::restitution_rolling>},
      {"restitution_rolling_original", "-", original<&PairMotion::restitution_rolling>},
      {"tangential_impulse_ratio", "-", impulse_ratio},
      {"angular_momentum_share", "-", scaled<&PairMotion::angular_momentum_share>},
      {"angular_momentum_change", "-", scaled<&PairMotion::angular_momentum_change>},
      {"slides", "-", slides},
      {"slides_original", "-", slides_original},
      {"turned", "rad", turned},
  };
  return members;
}

std::string records_csv(const InvarianceStudy& study) {
  std::vector<std::string> header = {"law",
                                     "factor [-]",
                                     "normal_speed [m/s]",
                                     "stuck",
                                     "restitution_normal [-]",
                                     "restitution_original [-]",
                                     "sticking_speed [m/s]",
                                     "contact_time_ratio [-]",
                                     "contact_time_ratio_predicted [-]",
                                     "max_overlap_ratio [-]",
                                     "sticking_speed_ratio [-]"};
  for (const MotionMember& member : motion_members()) header.push_back(std::string(member.key) + " [" + member.unit + "]");
  Csv csv(header);
  for (const InvarianceRecord& r : study.records) {
    std::vector<CsvCell> row = {r.law,
                                r.factor,
                                r.normal_speed,
                                std::string(r.stuck ? "true" : "false"),
                                r.restitution,
                                r.restitution_original,
                                cell(r.sticking_speed),
                                cell(r.contact_time_ratio),
                                cell(r.contact_time_ratio_predicted),
                                cell(r.max_overlap_ratio),
                                cell(r.sticking_speed_ratio)};
    for (const MotionMember& member : motion_members()) row.push_back(cell(member.of(r)));
    csv.add(row);
  }
  return csv.text();
}

std::string summary_csv(const InvarianceStudy& study) {
  Csv csv({"law", "factors", "exact", "restitution_change_max [-]", "verdict_changes", "restitution_change_at_equal_v_over_v_stick [-]",
           "sticking_speed_exponent [-]", "sticking_speed_exponent_error [-]", "contact_time_exponent [-]",
           "contact_time_exponent_error [-]", "max_overlap_exponent [-]", "max_overlap_exponent_error [-]"});
  for (const LawSummary& s : study.summaries) {
    csv.add({s.law, std::string(s.softer ? "below 1" : "1 and above"), std::string(s.exact ? "true" : "false"), s.restitution_change,
             static_cast<double>(s.verdict_changes), s.reduced_restitution_change, exponent(s.sticking_speed),
             exponent_error(s.sticking_speed), exponent(s.contact_time), exponent_error(s.contact_time), exponent(s.max_overlap),
             exponent_error(s.max_overlap)});
  }
  return csv.text();
}

std::string motion_csv(const InvarianceStudy& study) {
  Csv csv({"law", "factors", "quantity", "verdict", "deviation_max [-]", "deviation_max_limit [-]", "exponent [-]", "exponent_error [-]",
           "overlap_exponent [-]", "overlap_exponent_error [-]"});
  for (const LawSummary& s : study.summaries) {
    for (const MotionTrend& t : s.motion) {
      const bool power = t.power.exists && std::isfinite(t.power.exponent);
      csv.add({s.law, std::string(s.softer ? "below 1" : "1 and above"), std::string(t.quantity->key), std::string(to_string(t.verdict)),
               t.largest, t.limit ? CsvCell(t.largest_limit) : CsvCell(), power ? CsvCell(t.power.exponent) : CsvCell(),
               power ? CsvCell(t.power.exponent_error) : CsvCell(), t.overlap_power ? CsvCell(t.overlap_exponent) : CsvCell(),
               t.overlap_power ? CsvCell(t.overlap_exponent_error) : CsvCell()});
    }
  }
  return csv.text();
}

}  // namespace scalebreak
