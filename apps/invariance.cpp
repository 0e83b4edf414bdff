#include <set>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/collisions/invariance/invariance_files.hpp>
#include <scalebreak/collisions/invariance/invariance_report.hpp>
#include <scalebreak/collisions/invariance/invariance_words.hpp>
#include <scalebreak/output/atomic_file.hpp>

#include "command.hpp"

namespace scalebreak::apps {
namespace {

using nlohmann::json;

json study_json(const InvarianceStudy& study) {
  json records = json::array();
  for (const InvarianceRecord& r : study.records) {
    json record = {{"law", r.law},
                   {"factor", r.factor},
                   {"normal_speed", r.normal_speed},
                   {"stuck", r.stuck},
                   {"restitution_normal", r.restitution},
                   {"sticking_speed", or_null(r.sticking_speed)},
                   {"contact_time_ratio", or_null(r.contact_time_ratio)},
                   {"contact_time_ratio_predicted", or_null(r.contact_time_ratio_predicted)},
                   {"max_overlap_ratio", or_null(r.max_overlap_ratio)},
                   {"sticking_speed_ratio", or_null(r.sticking_speed_ratio)}};
    for (const MotionMember& member : motion_members()) record[member.key] = or_null(member.of(r));
    records.push_back(std::move(record));
  }
  return {{"records", records}};
}

/// What each scene is called: its file's name, made to differ.
std::vector<std::string> chapter_names(const std::vector<std::string>& files) {
  std::vector<std::string> names;
  std::set<std::string> used;
  for (const std::string& file : files) {
    const std::string stem = std::filesystem::path(file).stem().string();
    std::string name = stem;
    for (int i = 2; !used.insert(name).second; ++i) name = fmt::format("{}_{}", stem, i);
    names.push_back(name);
  }
  return names;
}

std::string estimate(const Input& input) {
  const std::size_t speeds = input.study_speeds.empty() ? default_speeds({}).size() : input.study_speeds.size();
  const std::size_t cells = study_laws(input).size() * input.study_factors.size();
  const double collisions = static_cast<double>(cells * (speeds + 12));
  const std::string normal =
      fmt::format("{:.0f} exact collisions, about {:.1f} s and 1 s for the table, below 20 MB", collisions, 1e-4 * collisions);
  if (!moves_beyond_normal(input)) return normal;
  // Each at three overlaps, and the charts' own.
  const double motions = static_cast<double>(3 * cells * speeds + 1200);
  return fmt::format("{}; {:.0f} exact motions, about {:.1f} s", normal, motions, 5e-4 * motions);
}

/// Each file's scene, or the defaults. All are read before any work is done.
std::vector<Input> read_inputs(const Options& options) {
  std::vector<std::optional<std::string>> files(options.files.begin(), options.files.end());
  if (files.empty()) files.emplace_back();
  std::vector<Input> inputs;
  for (const auto& file : files) {
    inputs.push_back(options.input(file));
    if (inputs.back().bodies.empty()) continue;
    throw InputError(
        fmt::format("{}: invariance compares pairs; allowed: [pair] and [impact] in place of [[body]]", file.value_or("--set")));
  }
  return inputs;
}

void run(const Options& options, const std::vector<Input>& inputs) {
  const auto names = options.files.empty() ? std::vector<std::string>{"defaults"} : chapter_names(options.files);
  HtmlReport report("What scaling laws keep in a collision",
                    "Each scaling law is applied to one pair at several factors, and every collision is resolved exactly. "
                    "A law is exact for the pair if the scaled pair has the original's reduced impact speed and damping; then all that "
                    "follows is the same but for the units of length and time.");
  json results = json::array();
  bool drawn = true;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const Input& input = inputs[i];
    const ContactKind kind = effective_kind(input.contact, input.colliding().pair().surface_energy);
    const InvarianceStudy study = run_invariance(input, options.threads, options.progress("comparing laws, " + names[i]));
    if (study.skipped > 0) {
      options.say(fmt::format("{}: {} pairs of law and factor were left out: each law takes the factors on its side of 1", names[i],
                              study.skipped));
    }
    if (study.deep > 0) options.say(fmt::format("{}: in {} collisions {}", names[i], study.deep, too_deep));
    results.push_back(study_json(study));
    if (!options.json) {
      fmt::print("{}\n", names[i]);
      for (const LawSummary& summary : study.summaries) fmt::print("  {}\n", in_words(summary));
    }
    if (options.out.empty()) continue;
    InvarianceChapter chapter{.title = names[i], .input = input, .study = study, .table = {}, .threads = options.threads};
    if (!study.wet) chapter.table = obtain_table({kind, input.table_tolerance}, options.store());
    const std::filesystem::path folder =
        inputs.size() == 1 ? std::filesystem::path(options.out) : std::filesystem::path(options.out) / names[i];
    write_file(folder / "input.toml", input_file_text(input, "invariance"));
    write_file(folder / "result.json", results.back().dump(2) + "\n");
    drawn = write_chapter(chapter, folder, report) && drawn;
  }
  if (!options.out.empty()) write_file(std::filesystem::path(options.out) / "index.html", report.text());
  if (!drawn) options.say("some plots were not drawn: gnuplot is missing or failed; their scripts are kept in " + options.out);
  if (options.json) fmt::print("{}\n", (results.size() == 1 ? results.front() : json{{"scenes", results}}).dump());
}

}  // namespace

void add_invariance(CLI::App& app, Options& options, std::function<void()>& job) {
  CLI::App* command = app.add_subcommand("invariance", "what each scaling law keeps and breaks in a pair, over factors and speeds");
  add_options(*command, options, 100);
  command->callback([&] {
    job = [&options] {
      const auto inputs = options.print_defaults ? std::vector<Input>{} : read_inputs(options);
      if (!answered_early(options, estimate)) run(options, inputs);
    };
  });
}

}  // namespace scalebreak::apps
