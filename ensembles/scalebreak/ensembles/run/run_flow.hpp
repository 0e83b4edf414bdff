#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <scalebreak/base/error.hpp>
#include <scalebreak/collisions/tables/table_store.hpp>
#include <scalebreak/ensembles/run/run_record.hpp>
#include <scalebreak/measure/flow_result.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

struct RunProgress {
  double share = 0;  ///< of all replicas
  double rate = 0;   ///< particle steps, or events, per second, since this program began with them
  const char* of = "particle steps/s";
};

struct RunOptions {
  std::filesystem::path out;  ///< empty: no files, no checkpoints
  int threads = 1;
  bool resume = false;         ///< goes on from the checkpoint in `out`
  std::string engine = "dem";  ///< or "event", "hybrid"; a run that goes on must have the one that it had
  std::optional<TableStore> tables =
      {};  ///< where collision tables are kept; none: the step is bounded by exact collisions, and engines use the user's cache
  /// Asked after every sample; true: the run ends with a checkpoint and RunInterrupted.
  std::function<bool()> stop = {};
  std::function<void(const RunProgress&)> progress = {};
  std::function<void(const std::string&)> say = {};  ///< warnings, a sentence each, when they are known
};

/// The run was told to stop: a sentence with what is kept, and how to go on.
struct RunInterrupted : WorkError {
  using WorkError::WorkError;
};

/// What a flow came to.
struct RunOutcome {
  std::vector<RunRecord> replicas;
  FlowResult measured;  ///< mean over replicas
  double wall_seconds = 0;
  int threads = 1;

  /// Spheres times steps, and events, of all replicas.
  [[nodiscard]] double particle_steps() const;
  [[nodiscard]] long events() const;
};

/// Where the files of a replica of so many lie, from 0.
[[nodiscard]] std::filesystem::path replica_folder(const std::filesystem::path& out, std::uint64_t replica, std::uint64_t replicas);

/// Writes input.toml into the folder of a new run. Throws InputError where the folder holds an unfinished one.
void begin_run_folder(const std::filesystem::path& out, const std::string& input_file);

/// Runs a flow, replica after replica. Writes the files of RunFiles, checkpoints every
/// output.checkpoint_interval of wall time, and profiles.csv. Files of a run that was interrupted and
/// went on are those of one that was not, byte for byte, on the same number of threads. The threads of a run that goes on must be those that it had.
///
/// Throws InputError, RunInterrupted, and WorkError where the run became unstable: then it says which checkpoint is left.
[[nodiscard]] RunOutcome run_flow(const Input& input, const RunOptions& options);

}  // namespace scalebreak
