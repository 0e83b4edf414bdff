#include <scalebreak/output/csv_read.hpp>

#include <cstdlib>
#include <sstream>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/output/atomic_file.hpp>

namespace scalebreak {
namespace {

/// The cells of a line; a quoted one may hold commas, and quotes twice.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"') {
      const bool twice = quoted && i + 1 < line.size() && line[i + 1] == '"';
      twice ? void(cells.back() += line[++i]) : void(quoted = !quoted);
    } else if (c == ',' && !quoted) {
      cells.emplace_back();
    } else if (c != '\r') {
      cells.back() += c;
    }
  }
  return cells;
}

}  // namespace

CsvTable::CsvTable(const std::string& text, std::string name) : name_(std::move(name)) {
  std::istringstream lines(text);
  std::string line;
  while (std::getline(lines, line)) {
    const std::vector<std::string> cells = cells_of(line);
    if (columns_.empty()) {
      for (std::size_t i = 0; i < cells.size(); ++i) columns_[cells[i]] = i;
      continue;
    }
    rows_.push_back(cells);
    if (cells.size() != columns_.size())
      throw InputError(
          fmt::format("{}: found {} cells; allowed: {}, as many as headers", place(rows_.size() - 1), cells.size(), columns_.size()));
  }
  if (columns_.empty()) throw InputError(fmt::format("{} is empty; allowed: a CSV file with a header", name_));
}

const std::string& CsvTable::word(std::size_t row, const std::string& header) const {
  const auto at = columns_.find(header);
  if (at == columns_.end())
    throw InputError(fmt::format("{}, line 1: there is no column \"{}\"; allowed: a file that has it", name_, header));
  return rows_[row][at->second];
}

std::optional<double> CsvTable::number(std::size_t row, const std::string& header) const {
  const std::string& cell = word(row, header);
  if (cell.empty()) return {};
  char* end = nullptr;
  const double value = std::strtod(cell.c_str(), &end);
  if (end != cell.c_str() + cell.size())
    throw InputError(fmt::format("{}: {}: found \"{}\"; allowed: a number, or nothing", place(row), header, cell));
  return value;
}

std::string CsvTable::place(std::size_t row) const { return fmt::format("{}, line {}", name_, row + 2); }

CsvTable read_csv(const std::filesystem::path& path) {
  const auto text = read_file(path);
  if (!text) throw InputError(fmt::format("{} cannot be read; allowed: a CSV file", path.string()));
  return {*text, path.string()};
}

}  // namespace scalebreak
