#include <scalebreak/ensembles/run/run_record.hpp>

#include <scalebreak/base/bytes.hpp>

namespace scalebreak {
namespace {

/// The same list for both ways.
template <class Record, class Number, class Text>
void go_through(Record& r, Number&& number, Text&& text) {
  text(r.engine), number(r.replica), number(r.particles);
  for (auto& edge : r.cell) number(edge);
  number(r.volume_fraction);
  number(r.step.step), number(r.step.asked), text(r.step.limit), text(r.step.bound), number(r.step.bound_step);
  number(r.step.contact.meeting.speed), text(r.step.contact.meeting.of), number(r.step.contact.time), text(r.step.contact.of);
  number(r.step.contact.tabulated), text(r.step.contact.resolved), text(r.step.warning);
  number(r.schedule.step), number(r.schedule.steps_per_sample), number(r.schedule.samples_per_row);
  number(r.schedule.warmup_samples), number(r.schedule.samples);
  number(r.gravity_energy), number(r.time), number(r.steps), number(r.handovers), number(r.contact_starts);
  number(r.events), number(r.integrated), number(r.delayed);
  for (auto* work : {&r.warmup, &r.work}) number(work->evaluations), number(work->lookups), number(work->sphere_steps);
}

}  // namespace

RunWork RunWork::of(const EngineTotals& totals, double particles) {
  RunWork work{.evaluations = totals.evaluations,
               .lookups = static_cast<double>(totals.events.value_or(0)),
               .sphere_steps = particles * static_cast<double>(totals.steps)};
  if (!totals.patches) return work;
  work.lookups += static_cast<double>(totals.patches->taken_back + totals.patches->unresolved);
  work.sphere_steps += static_cast<double>(totals.patches->sphere_steps);
  return work;
}

void RunRecord::save(std::string& bytes) const {
  go_through(
      *this, [&](const auto& value) { put_bytes(bytes, value); }, [&](const std::string& text) { put_text(bytes, text); });
  put_bytes(bytes, patches.has_value());
  if (patches) PatchTotals::pair_up(*patches, *patches, [&](const auto& value, const auto&) { put_bytes(bytes, value); });
  put_bytes(bytes, static_cast<std::uint64_t>(warnings.size()));
  for (const std::string& warning : warnings) put_text(bytes, warning);
}

void RunRecord::load(std::string_view& bytes) {
  go_through(
      *this, [&](auto& value) { take_bytes(bytes, value); }, [&](std::string& text) { text = take_text(bytes); });
  bool patched = false;
  take_bytes(bytes, patched);
  patches.reset();
  if (patched) PatchTotals::pair_up(patches.emplace(), *patches, [&](auto& value, const auto&) { take_bytes(bytes, value); });
  std::uint64_t sentences = 0;
  take_bytes(bytes, sentences);
  warnings.clear();
  for (std::uint64_t k = 0; k < sentences; ++k) warnings.push_back(take_text(bytes));
}

}  // namespace scalebreak
