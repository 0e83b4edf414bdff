#include "command.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <mutex>
#include <thread>

#include <fmt/format.h>
#include <unistd.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/base/version.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/scene/input_file.hpp>
#include <scalebreak/scene/toml_reader.hpp>

namespace scalebreak::apps {

Input Options::input(const std::optional<std::string>& file) const {
  std::vector<Assignment> given;
  if (flows && !file) given.push_back({"cell.kind", std::string(cell_kind_words[0]), {"default"}});
  if (file) given = read_toml_file(*file);
  for (const std::string& setting : settings) given.push_back(read_setting(setting));
  Input input = resolve_input(given);
  if (either) return input;
  if (input.flow && !flows)
    throw InputError(fmt::format("{}: [particles] or [cell] make a flow, which this command does not take; allowed: a pair or bodies",
                                 file.value_or("--set")));
  if (!input.flow && flows)
    throw InputError(
        fmt::format("{}: [particles] and [cell] are missing, and this command runs flows; allowed: one of the two, or the "
                    "command collide for a pair or bodies",
                    file.value_or("--set")));
  return input;
}

TableStore Options::store() const {
  return {.folder = tables.empty() ? default_table_folder() : std::filesystem::path(tables),
          .threads = threads,
          .say = [this](const std::string& sentence) { say(sentence); },
          .progress = progress("building a collision table")};
}

std::string Options::title() const { return files.empty() ? "defaults" : std::filesystem::path(files.front()).stem().string(); }

int Options::cores() const { return threads > 0 ? threads : static_cast<int>(std::max(1u, std::thread::hardware_concurrency())); }

void Options::say(const std::string& sentence) const {
  if (!quiet) fmt::print(stderr, "scalebreak: {}\n", sentence);
}

std::function<void(double)> Options::progress(const std::string& what, double begun, std::function<std::string()> remark) const {
  if (quiet) return {};
  struct State {
    std::mutex mutex;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    int shown = -1;
  };
  const auto state = std::make_shared<State>();
  const bool terminal = isatty(STDERR_FILENO) != 0;
  return [=](double done) {
    const std::lock_guard lock(state->mutex);
    const int percent = static_cast<int>(100 * done);
    if (percent <= state->shown || (!terminal && percent < 100 && percent / 25 == state->shown / 25)) return;
    state->shown = percent;
    const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - state->start).count();
    const std::string bar(static_cast<std::size_t>(percent / 4), '#');
    fmt::print(stderr, "{}{}: [{:<25}] {:3d} %, {}{:.0f} s left{}", terminal ? "\r" : "", what, bar, percent, remark ? remark() + ", " : "",
               done > begun ? spent * (1 - done) / (done - begun) : 0.0, terminal && percent < 100 ? "" : "\n");
    std::fflush(stderr);
  };
}

void add_options(CLI::App& command, Options& options, int most_files) {
  command.add_option("file", options.files, "input, TOML; without one the defaults hold")->expected(0, most_files)->type_name("FILE.toml");
  command.add_option("--set", options.settings, "dotted.key=value, over the file; repeatable")
      ->take_all()
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
  command.add_option("--out", options.out, "folder for the results")->type_name("DIR");
  command.add_option("--tables", options.tables, "folder of the collision tables (default: the user's cache)")->type_name("DIR");
  command.add_option("--threads", options.threads, "cores to use (default: all)")->check(CLI::Range(0, 4096))->type_name("N");
  command.add_flag("--json", options.json, "print one JSON object on standard output, and nothing else there");
  command.add_flag("--check", options.check, "check and print the resolved input with an estimate, then stop");
  command.add_flag("--print-defaults", options.print_defaults, "print every key with default, unit and meaning, then stop");
  command.add_flag("--quiet", options.quiet, "no progress and no remarks on standard error");
}

bool answered_early(const Options& options, const std::function<std::string(const Input&)>& estimate) {
  if (options.print_defaults) {
    fmt::print("{}", options.json ? nlohmann::json{{"keys", describe_keys()}}.dump() + "\n" : describe_keys());
    return true;
  }
  if (!options.check) return false;
  std::vector<std::optional<std::string>> files(options.files.begin(), options.files.end());
  if (files.empty()) files.emplace_back();
  nlohmann::json checked = nlohmann::json::array();
  std::string text;
  for (const auto& file : files) {
    const Input input = options.input(file);
    const std::string name = file.value_or("defaults");
    checked.push_back({{"file", name}, {"estimate", estimate(input)}, {"input", write_input(input)}});
    text += fmt::format("# {}\n# estimate: {}\n{}", name, estimate(input), write_input(input));
  }
  fmt::print("{}", options.json ? nlohmann::json{{"checked", checked}}.dump() + "\n" : text);
  return true;
}

std::string input_file_text(const Input& input, const std::string& command) {
  return fmt::format("# scalebreak {}: resolved input; run it again with: scalebreak {} input.toml\n{}", version(), command,
                     write_input(input));
}

void deliver(const Options& options, const Input& input, const std::string& command, const nlohmann::json& result) {
  if (!options.out.empty()) {
    const std::filesystem::path out = options.out;
    write_file(out / "input.toml", input_file_text(input, command));
    write_file(out / "result.json", result.dump(2) + "\n");
  }
  if (options.json) fmt::print("{}\n", result.dump());
}

}  // namespace scalebreak::apps
