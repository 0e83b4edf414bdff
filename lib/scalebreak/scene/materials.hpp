#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <scalebreak/scene/value.hpp>

namespace scalebreak {

/// The folder with materials, papers' cases and scenes: $SCALEBREAK_DATA, or share/scalebreak beside the program's
/// bin, or the data folder of the source tree. Empty if there is none.
[[nodiscard]] std::filesystem::path data_folder();

/// The keys of a named material, without its section. Throws InputError, which says `where`, what was found and which
/// materials there are.
[[nodiscard]] std::vector<Assignment> named_material(const std::string& name, const Where& where, const std::string& key);

}  // namespace scalebreak
