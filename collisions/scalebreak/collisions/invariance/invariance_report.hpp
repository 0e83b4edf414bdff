#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <scalebreak/collisions/invariance/invariance.hpp>
#include <scalebreak/collisions/tables/table_store.hpp>
#include <scalebreak/output/html.hpp>

namespace scalebreak {

/// One scene of an invariance report.
struct InvarianceChapter {
  std::string title;
  Input input;
  InvarianceStudy study;
  std::optional<StoredTable> table;  ///< of its normal contact; none if a liquid has its say in the normal motion too
  int threads = 0;                   ///< 0: all
};

/// Writes invariance.csv, summary.csv, of a dry pair restitution.csv and loops.csv, where more than the normal motion happens
/// motion.csv and the files of its charts, and the plots into `folder`, and adds the chapter to the report, with in words which
/// law keeps what. False if a plot could not be drawn.
bool write_chapter(const InvarianceChapter& chapter, const std::filesystem::path& folder, HtmlReport& report);

}  // namespace scalebreak
