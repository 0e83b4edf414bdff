#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include <scalebreak/ensembles/run/run_flow.hpp>

#include <lib/resolving.hpp>
#include <lib/surroundings.hpp>

namespace scalebreak::tests {

/// 200 soft spheres that are sheared over some hundred steps: a tenth of a second of work.
inline const std::string small_shear = R"(
[material]
young = 1e7
[contact]
tangential = "mindlin"
[particles]
count = 200
volume_fraction = 0.3
[cell]
kind = "shear"
[run]
warmup_strain = 0.1
strain = 0.3
[output]
interval = 1e-3
formats = ["csv", "vtp", "xyz", "dump"]
checkpoint_interval = 0
)";

/// What a short run is made of: soft spheres that do not stick, milliseconds of work.
inline const std::string soft_glass = R"([material]
young = 1e7
surface_energy = 0
[contact]
normal = "hertz"
tangential = "mindlin"
)";

/// Every file of a folder, by its path in it.
inline std::map<std::string, std::string> files_of(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files[entry.path().lexically_relative(folder).string()] = content_of(entry.path());
  }
  return files;
}

inline std::vector<std::string> names_of(const std::map<std::string, std::string>& files) {
  std::vector<std::string> names;
  for (const auto& [name, content] : files) names.push_back(name);
  return names;
}

/// A stop after so many samples.
inline std::function<bool()> stop_after(int samples) {
  return [left = samples]() mutable { return left-- <= 0; };
}

inline double value_of(const FlowResult& result, const std::string& name) {
  for (const Quantity& quantity : result.quantities) {
    if (quantity.name == name) return quantity.measured.value;
  }
  ADD_FAILURE() << "no " << name;
  return 0;
}

/// What a piece of work throws.
template <class Error, class Work>
std::string message_of(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return "";
}

}  // namespace scalebreak::tests
