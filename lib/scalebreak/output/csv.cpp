#include <scalebreak/output/csv.hpp>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>

namespace scalebreak {
namespace {

std::string cell_text(const CsvCell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return fmt::format("{:.17g}", *number);
  if (const auto* word = std::get_if<std::string>(&cell)) {
    if (word->find_first_of(",\"\n") == std::string::npos) return *word;
    std::string quoted = "\"";
    for (const char c : *word) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
  }
  return "";
}

}  // namespace

Csv::Csv(std::vector<std::string> header) : columns_(header.size()), text_(fmt::format("{}\n", fmt::join(header, ","))) {}

void Csv::add(const std::vector<CsvCell>& row) {
  if (row.size() != columns_) throw WorkError(fmt::format("a CSV row has {} cells under {} headers", row.size(), columns_));
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (i > 0) text_ += ',';
    text_ += cell_text(row[i]);
  }
  text_ += '\n';
}

}  // namespace scalebreak
