#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <scalebreak/collisions/tables/table_store.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak::apps {

/// The options that every subcommand has.
struct Options {
  std::vector<std::string> files;
  std::vector<std::string> settings;
  std::string out, tables;
  int threads = 0;
  bool json = false, check = false, print_defaults = false, quiet = false;
  bool all_kinds = false, rebuild = false;  ///< of `table`
  bool list = false;                        ///< of `reproduce`
  bool flows = false;                       ///< takes flows, and not pairs and bodies alone
  bool either = false;                      ///< takes both; without a file, the default pair
  std::string engine = "auto";              ///< of `run`
  bool resume = false;                      ///< of `run`
  std::vector<std::string> studies;         ///< of `advise`, to fit to
  std::vector<std::string> tested;          ///< of `advise`, to test on
  bool forecast = false;                    ///< of `advise`
  std::string model;                        ///< of `advise`

  /// The input of one file, or of none. Throws InputError for a flow if the command takes none.
  [[nodiscard]] Input input(const std::optional<std::string>& file) const;
  [[nodiscard]] Input input() const { return input(files.empty() ? std::nullopt : std::optional(files.front())); }
  /// What a report calls the input: its file's name.
  [[nodiscard]] std::string title() const;
  [[nodiscard]] TableStore store() const;
  /// Those of --threads, or all that there are.
  [[nodiscard]] int cores() const;
  /// A sentence on standard error, unless quiet.
  void say(const std::string& sentence) const;
  /// A bar on standard error with the time left, unless quiet. `begun` is the share that was done earlier.
  [[nodiscard]] std::function<void(double)> progress(const std::string& what, double begun = 0,
                                                     std::function<std::string()> remark = {}) const;
};

/// Adds the common options; `most_files` input files are allowed.
void add_options(CLI::App& command, Options& options, int most_files = 1);

/// Does what --print-defaults and --check ask for: true if there is nothing more to do. `estimate` says how long the
/// work takes and what memory.
bool answered_early(const Options& options, const std::function<std::string(const Input&)>& estimate);

/// The resolved input with version and a line on how to run it again.
[[nodiscard]] std::string input_file_text(const Input& input, const std::string& command);

/// Prints the object if --json asks for it, and writes result.json and input.toml into --out if that is given.
void deliver(const Options& options, const Input& input, const std::string& command, const nlohmann::json& result);

/// A number, or null where there is none.
[[nodiscard]] inline nlohmann::json or_null(const std::optional<double>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json();
}

/// Said where contact laws of small overlaps are used beyond them.
inline constexpr const char* too_deep = "the largest overlap exceeds a tenth of R*, more than the contact laws are meant for";

void add_collide(CLI::App& app, Options& options, std::function<void()>& job);
void add_table(CLI::App& app, Options& options, std::function<void()>& job);
void add_invariance(CLI::App& app, Options& options, std::function<void()>& job);
void add_reproduce(CLI::App& app, Options& options, std::function<void()>& job);
void add_run(CLI::App& app, Options& options, std::function<void()>& job);
void add_tradeoff(CLI::App& app, Options& options, std::function<void()>& job);
void add_breakdown(CLI::App& app, Options& options, std::function<void()>& job);
void add_advise(CLI::App& app, Options& options, std::function<void()>& job);
void add_compare(CLI::App& app, Options& options, std::function<void()>& job);
void add_stability(CLI::App& app, Options& options, std::function<void()>& job);

}  // namespace scalebreak::apps
