#include <scalebreak/ensembles/breakdown/cell_replica.hpp>

#include <chrono>
#include <cmath>
#include <limits>

#include <ctime>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/base/version.hpp>
#include <scalebreak/ensembles/breakdown/study_quantities.hpp>
#include <scalebreak/ensembles/run/flow_run.hpp>
#include <scalebreak/ensembles/run/run_flow.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/output/known.hpp>

namespace scalebreak {
namespace {

using nlohmann::json;

double number_of(const json& value) { return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>(); }

json to_json(const CellReplica& r) {
  json quantities = json::array();
  for (const Quantity& q : r.quantities) quantities.push_back({q.name, known_number(q.measured.value), known_number(q.measured.error)});
  return {{"failure", r.failure},
          {"quantities", quantities},
          {"particles", r.particles},
          {"measured_time", r.measured_time},
          {"steps", r.steps},
          {"events", r.events},
          {"wall_seconds", r.wall_seconds},
          {"processor_seconds", known_number(r.processor_seconds)},
          {"evaluations", known_number(r.work.evaluations)},
          {"lookups", known_number(r.work.lookups)},
          {"sphere_steps", known_number(r.work.sphere_steps)},
          {"contact_time", r.contact_time},
          {"patch_fraction", r.patch_fraction ? json(*r.patch_fraction) : json()},
          {"version", r.version}};
}

CellReplica from_json(const json& j) {
  CellReplica r{.failure = j.at("failure"),
                .quantities = {},
                .particles = j.at("particles"),
                .measured_time = j.at("measured_time"),
                .steps = j.at("steps"),
                .events = j.at("events"),
                .wall_seconds = j.at("wall_seconds"),
                .processor_seconds = number_of(j.value("processor_seconds", json())),
                .work = {number_of(j.value("evaluations", json())), number_of(j.value("lookups", json())),
                         number_of(j.value("sphere_steps", json()))},
                .contact_time = j.at("contact_time"),
                .patch_fraction = {},
                .version = j.at("version")};
  for (const json& q : j.at("quantities")) {
    const std::string name = q.at(0);
    r.quantities.push_back({name, study_quantity(name).unit, {number_of(q.at(1)), number_of(q.at(2))}});
  }
  if (!j.at("patch_fraction").is_null()) r.patch_fraction = j.at("patch_fraction").get<double>();
  return r;
}

/// Of this thread, since it began [s].
double processor_seconds() {
  timespec spent{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &spent);
  return static_cast<double>(spent.tv_sec) + 1e-9 * static_cast<double>(spent.tv_nsec);
}

/// Random numbers of a cell's runs lie apart from those of other cells.
std::uint64_t stream_of(const StudyCell& cell, std::uint64_t replica) { return cell.key + replica; }

}  // namespace

CellReplica run_replica(const StudyCell& cell, std::uint64_t replica, const TableStore& store, const std::function<bool()>& stop) {
  using Clock = std::chrono::steady_clock;
  CellReplica result;
  result.version = version();
  const auto began = Clock::now();
  const double spent_before = processor_seconds();
  try {
    FlowRun run(cell.input, stream_of(cell, replica), 1, &store, cell.choice.engine);
    while (!run.done()) {
      if (stop && stop()) throw RunInterrupted("the study was interrupted");
      run.advance();
    }
    const FlowResult measured = run.measurement().result();
    const RunRecord& record = run.record();
    result.quantities = studied(measured, cell.input);
    result.particles = static_cast<double>(record.particles), result.measured_time = measured.duration;
    result.steps = static_cast<double>(record.steps), result.events = static_cast<double>(record.events.value_or(0));
    result.contact_time = record.step.contact.time, result.work = record.work;
    if (record.patches) result.patch_fraction = record.patches->contact_starts / record.contact_starts;
  } catch (const RunInterrupted&) {
    throw;
  } catch (const std::runtime_error& error) {  // of the input or of the work: it is the cell's result
    result.failure = error.what();
  }
  result.wall_seconds = std::chrono::duration<double>(Clock::now() - began).count();
  result.processor_seconds = processor_seconds() - spent_before;
  return result;
}

std::filesystem::path CellFiles::path(const StudyCell& cell, std::uint64_t replica) const {
  return folder_ / cell.folder() / fmt::format("replica_{}.json", replica + 1);
}

std::optional<CellReplica> CellFiles::read(const StudyCell& cell, std::uint64_t replica) const {
  const std::filesystem::path file = path(cell, replica);
  const auto text = read_file(file);
  if (!text) return {};
  try {
    return from_json(json::parse(*text));
  } catch (const json::exception& error) {
    throw WorkError(
        fmt::format("{} is no result of a cell of a study ({}); remove it, and the cell is run again", file.string(), error.what()));
  }
}

void CellFiles::write(const StudyCell& cell, std::uint64_t replica, const CellReplica& result) const {
  write_file(path(cell, replica), to_json(result).dump(1) + "\n");
}

}  // namespace scalebreak
