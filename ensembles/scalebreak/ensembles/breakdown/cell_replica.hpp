#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <scalebreak/collisions/tables/table_store.hpp>
#include <scalebreak/ensembles/breakdown/study_grid.hpp>
#include <scalebreak/ensembles/run/run_record.hpp>
#include <scalebreak/measure/flow_result.hpp>

namespace scalebreak {

/// What one run of a cell came to.
struct CellReplica {
  std::string failure;  ///< a sentence; empty: it came to its end
  std::vector<Quantity> quantities;
  double particles = 0, measured_time = 0, steps = 0, events = 0, wall_seconds = 0;
  double processor_seconds = 0;          ///< of its core, as wall_seconds with start and warm-up: those where nothing else ran
  RunWork work;                          ///< while it measured; NaN where an earlier version ran it
  double contact_time = 0;               ///< of the shortest contact [s]; 0: not known
  std::optional<double> patch_fraction;  ///< of a hybrid
  std::string version;                   ///< of the program that ran it
};

/// Runs a replica of a cell, serially. Throws what `stop` makes it throw (RunInterrupted), where that is asked and says true; a run that
/// fails has a failure.
[[nodiscard]] CellReplica run_replica(const StudyCell& cell, std::uint64_t replica, const TableStore& store,
                                      const std::function<bool()>& stop);

/// Runs of cells as files, one a run, so that a study that is killed keeps what it had.
class CellFiles {
 public:
  explicit CellFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}
  [[nodiscard]] std::filesystem::path path(const StudyCell& cell, std::uint64_t replica) const;
  /// Nothing where there is none. Throws WorkError, naming the file, where it is damaged.
  [[nodiscard]] std::optional<CellReplica> read(const StudyCell& cell, std::uint64_t replica) const;
  void write(const StudyCell& cell, std::uint64_t replica, const CellReplica& result) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace scalebreak
