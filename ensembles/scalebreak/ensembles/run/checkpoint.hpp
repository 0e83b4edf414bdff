#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace scalebreak {

/// An unfinished run in a file.
struct Checkpoint {
  std::string version;                ///< of the program, with its commit
  std::string input;                  ///< resolved, as TOML
  std::string engine;                 ///< "dem", "event" or "hybrid"
  int threads = 1;                    ///< on which it goes on bit for bit
  double wall_seconds = 0;            ///< so far
  double time = 0;                    ///< of the replica that runs [s]
  std::vector<std::string> finished;  ///< what earlier replicas came to
  std::string run, files;             ///< of the replica that runs: FlowRun, and RunFiles
};

/// Where the checkpoint of a run lies.
[[nodiscard]] std::filesystem::path checkpoint_path(const std::filesystem::path& folder);

/// Writes it whole, or leaves the one before.
void write_checkpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint);

/// The checkpoint of a folder. Throws InputError where there is none, or another version's, or what is no checkpoint.
[[nodiscard]] Checkpoint read_checkpoint(const std::filesystem::path& folder);

/// Takes the checkpoint of a run away that is finished.
void remove_checkpoint(const std::filesystem::path& folder);

}  // namespace scalebreak
