#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <scalebreak/measure/flow_result.hpp>

namespace scalebreak {

/// What a finished run left in its folder.
struct FinishedRun {
  std::filesystem::path folder;
  nlohmann::json result;
  std::vector<Quantity> quantities;
  std::string profiles;  ///< profiles.csv; empty: there is none
};

/// Throws InputError where the folder holds no finished run of a flow.
[[nodiscard]] FinishedRun read_finished_run(const std::filesystem::path& folder);

/// Keys in which the inputs of two finished runs differ, as "material.sliding_friction: 0.3, 0.5"; nothing where one has no input.toml.
[[nodiscard]] std::vector<std::string> input_differences(const FinishedRun& first, const FinishedRun& second);

}  // namespace scalebreak
