#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <scalebreak/ensembles/breakdown/study_result.hpp>
#include <scalebreak/scene/input.hpp>

namespace scalebreak {

/// Writes study.csv, maps, plots and index.html into `out`; `title` names the scene. Returns the plots that could not be drawn.
std::vector<std::string> write_study(const Input& input, const StudyResult& study, const std::string& title,
                                     const std::filesystem::path& out);

}  // namespace scalebreak
