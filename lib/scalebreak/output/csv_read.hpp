#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace scalebreak {

/// A CSV file of the program's own kind, as it is written by Csv: a header, then rows of as many cells.
class CsvTable {
 public:
  /// Throws InputError, with the line, where a row has more or fewer cells than the header.
  CsvTable(const std::string& text, std::string name);

  [[nodiscard]] std::size_t rows() const { return rows_.size(); }
  /// The cell of a row under a header, "deviation [-]". Throws InputError where there is no such header.
  [[nodiscard]] const std::string& word(std::size_t row, const std::string& header) const;
  /// The same as a number; none where the cell is empty. Throws InputError, with the line, where it is another word.
  [[nodiscard]] std::optional<double> number(std::size_t row, const std::string& header) const;
  /// "out/study.csv, line 7".
  [[nodiscard]] std::string place(std::size_t row) const;

 private:
  std::string name_;
  std::map<std::string, std::size_t> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// Throws InputError where the file cannot be read too.
[[nodiscard]] CsvTable read_csv(const std::filesystem::path& path);

}  // namespace scalebreak
