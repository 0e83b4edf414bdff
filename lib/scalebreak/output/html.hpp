#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scalebreak {

/// Text made safe for HTML.
[[nodiscard]] std::string html_escaped(const std::string& text);

/// A report as one file that can be mailed: drawings are put into it.
class HtmlReport {
 public:
  HtmlReport(std::string title, std::string introduction);

  void heading(const std::string& text);
  void paragraph(const std::string& text);
  void table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows);
  /// Puts the SVG in, with a caption; says so if there is no such drawing.
  void figure(const std::filesystem::path& svg, const std::string& caption);

  /// The whole page.
  [[nodiscard]] std::string text() const;

 private:
  std::string title_, body_;
  int figures_ = 0;
};

}  // namespace scalebreak
