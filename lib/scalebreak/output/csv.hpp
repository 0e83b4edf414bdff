#pragma once

#include <string>
#include <variant>
#include <vector>

namespace scalebreak {

/// A cell: a number (17 digits), a word, or nothing.
using CsvCell = std::variant<std::monostate, double, std::string>;

/// A table as text: headers are "name [unit]", cells without a value are left empty.
class Csv {
 public:
  explicit Csv(std::vector<std::string> header);
  /// As many cells as headers, or WorkError.
  void add(const std::vector<CsvCell>& row);
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::size_t columns_;
  std::string text_;
};

}  // namespace scalebreak
