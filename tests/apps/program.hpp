#pragma once

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <lib/surroundings.hpp>

namespace scalebreak::tests {

/// How a run of the program ended and what it wrote.
struct ProgramRun {
  int status = -1;  ///< of exit; -1 for a signal
  std::string out, err;

  /// Standard output as the one JSON value that it must be; throws otherwise.
  [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(out); }
};

/// Runs the program itself, with standard input closed and its two outputs kept apart; `meanwhile` is told its process.
inline ProgramRun run(const std::vector<std::string>& arguments, const std::function<void(pid_t)>& meanwhile = {}) {
  const TemporaryFolder folder;
  const std::string out = folder / "out", err = folder / "err";
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, out.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addopen(&actions, 2, err.c_str(), O_WRONLY | O_CREAT, 0600);
  std::vector<std::string> words = {SCALEBREAK_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t process = 0;
  const int failed = posix_spawn(&process, SCALEBREAK_PROGRAM, &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) throw std::runtime_error("cannot start " SCALEBREAK_PROGRAM);
  if (meanwhile) meanwhile(process);
  int status = 0;
  waitpid(process, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(out), content_of(err)};
}

inline std::set<std::string> keys_of(const nlohmann::json& object) {
  std::set<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.insert(key);
  return keys;
}

inline nlohmann::json json_file(const std::filesystem::path& path) { return nlohmann::json::parse(content_of(path)); }

/// Folders of one test: for results, and for tables, so that the user's cache stays out of it.
struct ProgramTest : testing::Test {
  TemporaryFolder folder;
  std::string out = folder / "out";
  std::string tables = folder / "tables";
  EnvironmentVariable cache{"XDG_CACHE_HOME", (folder / "cache").c_str()};

  /// Puts a scene into a file and gives its path.
  [[nodiscard]] std::string scene(const std::string& name, const std::string& text) const {
    put_file(folder / name, text);
    return folder / name;
  }
};

inline bool gnuplot_is_there() { return std::system("gnuplot --version >/dev/null 2>&1") == 0; }

}  // namespace scalebreak::tests
