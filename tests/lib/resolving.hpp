#pragma once

#include <string>
#include <vector>

#include <scalebreak/base/error.hpp>
#include <scalebreak/scene/input_file.hpp>
#include <scalebreak/scene/toml_reader.hpp>

namespace scalebreak::tests {

/// The input of a text called scene.toml, with settings over it.
inline Input resolved(const std::string& toml, const std::vector<std::string>& settings = {}) {
  std::vector<Assignment> given = read_toml(toml, "scene.toml");
  for (const std::string& setting : settings) given.push_back(read_setting(setting));
  return resolve_input(given);
}

/// The sentence with which that input is refused.
inline std::string sentence_for(const std::string& toml, const std::vector<std::string>& settings = {}) {
  try {
    (void)resolved(toml, settings);
  } catch (const InputError& error) {
    return error.what();
  }
  return "(it was accepted)";
}

}  // namespace scalebreak::tests
