#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <scalebreak/collisions/bodies/collision_report.hpp>
#include <scalebreak/collisions/bodies/motion_record.hpp>
#include <scalebreak/output/csv.hpp>
#include <scalebreak/output/plot.hpp>

// What the files of a pair and of a scene of bodies have in common. Internal to write_collision_files.

namespace scalebreak::report {

using Row = std::vector<CsvCell>;

void append(Row& row, const Eigen::Vector3d& v);
void append(std::vector<std::string>& header, const std::string& name, const std::string& unit);
void append_terms(std::vector<std::string>& header);
void append_terms(Row& row, const EnergyAccount& account);

/// A time axis in a unit that suits its length.
struct TimeAxis {
  std::string column, label;
};
[[nodiscard]] TimeAxis time_axis(double duration);

[[nodiscard]] std::string events_csv(const std::vector<MotionRecord::Change>& changes);
/// ", rps at 0.01"; nothing of the original.
[[nodiscard]] std::string under(const Input& input);
/// The terms that are not zero throughout, from the columns of `file` that begin at `first_column`.
[[nodiscard]] Plot energy_plot(const std::string& file, int first_column, const std::vector<MotionRecord::Instant>& instants,
                               const std::string& title);

/// The files of a scene of [[body]]; its plots.
[[nodiscard]] std::vector<Plot> write_bodies(const Input& input, const SceneCollision& result, const std::filesystem::path& folder);

}  // namespace scalebreak::report
