#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <scalebreak/ensembles/run/flow_run.hpp>
#include <scalebreak/scene/flow_input.hpp>

namespace scalebreak {

/// The files that grow while a run goes on: series.csv, and frames of the spheres in the formats of [output], particles_000000.csv and .vtp
/// with particles.pvd, particles.xyz, particles.dump.
class RunFiles {
 public:
  /// Begins them anew in a folder.
  RunFiles(std::filesystem::path folder, const OutputInput& output);
  /// Goes on with files as they were when `saved` was made: what has been appended since is cut off. Throws WorkError where one is gone
  /// or shorter.
  RunFiles(std::filesystem::path folder, const OutputInput& output, std::string_view saved);

  /// A row and a frame.
  void add(const FlowInstant& instant);
  [[nodiscard]] std::string save() const;

 private:
  void append(const std::string& name, const std::string& text);
  void add_frame(const FlowInstant& instant, ParticleFormat format);

  std::filesystem::path folder_;
  OutputInput output_;
  std::map<std::string, std::uint64_t> lengths_;  ///< of what is appended to [bytes]
  std::vector<double> frames_;                    ///< their times [s]
};

}  // namespace scalebreak
