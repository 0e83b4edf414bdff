#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <scalebreak/collisions/invariance.hpp>
#include <scalebreak/collisions/table_store.hpp>
#include <scalebreak/output/html.hpp>

namespace scalebreak {

/// One scene of an invariance report.
struct InvarianceChapter {
  std::string title;
  Input input;
  InvarianceStudy study;
  StoredTable table;
};

/// Writes invariance.csv, summary.csv, restitution.csv, loops.csv and the plots into `folder`, and adds the chapter to the
/// report, with in words which law keeps what. False if a plot could not be drawn.
bool write_chapter(const InvarianceChapter& chapter, const std::filesystem::path& folder, HtmlReport& report);

/// What a law keeps and moves, in one sentence.
[[nodiscard]] std::string in_words(const LawSummary& summary);

}  // namespace scalebreak
