#include <scalebreak/ensembles/breakdown/study_files.hpp>

#include <cmath>

#include <scalebreak/ensembles/breakdown/engine_agreement.hpp>
#include <scalebreak/ensembles/breakdown/verdicts.hpp>
#include <scalebreak/output/known.hpp>

namespace scalebreak {
namespace {

using nlohmann::json;

CsvCell filled(double value) { return known_cell(value); }
CsvCell filled(const std::optional<double>& value) { return value ? CsvCell(*value) : CsvCell(); }
json number(double value) { return known_number(value); }
json number(const std::optional<double>& value) { return value ? json(*value) : json(); }

constexpr const char* verdict_words[] = {"no_difference", "difference", "unknown"};  ///< in the order of Verdict

double coordination_of(const CellResult& cell) {
  const Quantity* contacts = cell.quantity("coordination");
  return contacts ? contacts->measured.value : std::nan("");
}

json quantities_json(const CellResult& cell) {
  json quantities = json::object();
  for (const Quantity& q : cell.quantities) {
    json& entry = quantities[q.name] = {{"value", number(q.measured.value)}, {"error", number(q.measured.error)}};
    const Comparison* c = cell.deviation(q.name);
    if (!c) continue;
    entry["claim"] = number(c->first.value), entry["claim_error"] = number(c->first.error);
    entry["deviation"] = number(c->relative.value), entry["deviation_error"] = number(c->relative.error);
    entry["verdict"] = verdict_words[static_cast<std::size_t>(c->verdict)];
  }
  return quantities;
}

json cell_json(const StudyCell& of, const CellResult& cell) {
  const CellVerdict verdict = cell_verdict(cell);
  return {{"law", of.law},
          {"factor", of.factor},
          {"engine", of.choice.engine},
          {"engine_reason", of.choice.reason},
          {"volume_fraction", number(of.point.volume_fraction)},
          {"parameter_value", number(of.point.value)},
          {"standing", standing_words[static_cast<std::size_t>(verdict.standing)]},
          {"worst", verdict.worst ? json(verdict.worst->name) : json()},
          {"failure", cell.failure.empty() ? json() : json(cell.failure)},
          {"replicas", cell.replicas},
          {"particles", cell.particles},
          {"measured_time", cell.measured_time},
          {"steps", cell.steps},
          {"events", cell.events},
          {"wall_seconds", cell.wall_seconds},
          {"contact_time", cell.contact_time > 0 ? json(cell.contact_time) : json()},
          {"patch_fraction", number(cell.patch_fraction)},
          {"version", cell.version},
          {"quantities", quantities_json(cell)}};
}

json agreement_json(const QuantityAgreement& q) {
  return {{"flows", q.flows}, {"squares", number(q.squares)}, {"probability", number(q.chance)}};
}

json agreement_json(const EngineAgreement& agreement) {
  json quantities = json::object();
  for (const QuantityAgreement& q : agreement.quantities) quantities[q.name] = agreement_json(q);
  return {{"first", agreement.first},
          {"second", agreement.second},
          {"quantities", quantities},
          {"all", agreement_json(agreement.all)},
          {"sentence", sentence(agreement)}};
}

}  // namespace

Csv study_csv(const StudyResult& study, const std::string& parameter) {
  Csv csv({"law",           "factor [-]",           "engine",           "volume_fraction [-]",
           "parameter",     "parameter_value [SI]", "quantity",         "unit",
           "value [unit]",  "error [unit]",         "claim [unit]",     "claim_error [unit]",
           "deviation [-]", "deviation_error [-]",  "verdict",          "replicas [-]",
           "particles [-]", "measured_time [s]",    "steps [-]",        "events [-]",
           "wall_time [s]", "contact_time [s]",     "coordination [-]", "patch_fraction [-]",
           "version"});
  for (std::size_t i = 0; i < study.cells.size(); ++i) {
    const StudyCell& of = study.grid.cells[i];
    const CellResult& cell = study.cells[i];
    for (const Quantity& q : cell.quantities) {
      const Comparison* c = cell.deviation(q.name);
      const double nothing = std::nan("");
      csv.add({of.law,
               of.factor,
               of.choice.engine,
               filled(of.point.volume_fraction),
               parameter,
               filled(of.point.value),
               q.name,
               q.unit,
               filled(q.measured.value),
               filled(q.measured.error),
               filled(c ? c->first.value : nothing),
               filled(c ? c->first.error : nothing),
               filled(c ? c->relative.value : nothing),
               filled(c ? c->relative.error : nothing),
               c ? CsvCell(std::string(verdict_words[static_cast<std::size_t>(c->verdict)])) : CsvCell(),
               static_cast<double>(cell.replicas),
               cell.particles,
               cell.measured_time,
               cell.steps,
               cell.events,
               cell.wall_seconds,
               cell.contact_time > 0 ? CsvCell(cell.contact_time) : CsvCell(),
               filled(coordination_of(cell)),
               filled(cell.patch_fraction),
               cell.version});
    }
  }
  return csv;
}

json study_json(const StudyResult& study, const std::string& parameter) {
  json cells = json::array(), reaches = json::array(), agreements = json::array();
  for (std::size_t i = 0; i < study.cells.size(); ++i) cells.push_back(cell_json(study.grid.cells[i], study.cells[i]));
  for (const LawReach& reach : law_reaches(study))
    reaches.push_back({{"law", reach.law},
                       {"engine", reach.engine},
                       {"volume_fraction", number(reach.point.volume_fraction)},
                       {"parameter_value", number(reach.point.value)},
                       {"holds_to", number(reach.holds_to)},
                       {"next", number(reach.next)},
                       {"standing", reach.there ? json(standing_words[static_cast<std::size_t>(reach.there->standing)]) : json()},
                       {"sentence", sentence(reach, parameter)}});
  for (const EngineAgreement& each : engine_agreements(study)) agreements.push_back(agreement_json(each));
  return {{"complete", study.complete},
          {"parameter", parameter.empty() ? json() : json(parameter)},
          {"broken_beyond", broken_beyond},
          {"cells", cells},
          {"reaches", reaches},
          {"digest", law_digest(study, parameter)},
          {"engines", agreements},
          {"skipped", study.grid.skipped}};
}

}  // namespace scalebreak
