#include <scalebreak/ensembles/prediction/training_rows.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/ensembles/breakdown/study_grid.hpp>
#include <scalebreak/ensembles/prediction/deviation_model.hpp>
#include <scalebreak/output/csv_read.hpp>
#include <scalebreak/scene/input_file.hpp>
#include <scalebreak/scene/toml_reader.hpp>

namespace scalebreak {
namespace {

bool same(double a, double b) { return std::abs(a - b) <= 1e-12 * std::max(std::abs(a), std::abs(b)); }
bool same(const std::optional<double>& a, const std::optional<double>& b) { return a.has_value() == b.has_value() && (!a || same(*a, *b)); }

/// The cell of a row: by its engine where that ran it, else by any, since "auto" may choose another today.
std::size_t cell_of(const StudyGrid& grid, const CsvTable& csv, std::size_t row) {
  const std::string& law = csv.word(row, "law");
  const std::string& engine = csv.word(row, "engine");
  const double factor = csv.number(row, "factor [-]").value_or(1);
  const auto fraction = csv.number(row, "volume_fraction [-]"), value = csv.number(row, "parameter_value [SI]");
  std::size_t found = grid.cells.size();
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    const StudyCell& cell = grid.cells[i];
    if (cell.law != law || !same(cell.factor, factor) || !same(cell.point.volume_fraction, fraction) || !same(cell.point.value, value))
      continue;
    if (cell.choice.engine == engine) return i;
    if (found == grid.cells.size()) found = i;
  }
  if (found == grid.cells.size())
    throw InputError(fmt::format("{}: {} at {:g} is no cell of the study of input.toml beside it; allowed: both files of one study",
                                 csv.place(row), law, factor));
  return found;
}

/// The groups of a study's cells, each found once.
class GroupsOf {
 public:
  explicit GroupsOf(const StudyGrid& grid) : grid_(grid) {}
  const ScaleGroups& operator()(std::size_t cell) {
    const auto at = known_.find(cell);
    return at != known_.end() ? at->second : known_.emplace(cell, scale_groups(grid_.cells[cell].input)).first->second;
  }

 private:
  const StudyGrid& grid_;
  std::map<std::size_t, ScaleGroups> known_;
};

/// Of a cell that is no original; what came of it is not in it yet.
TrainingRow row_of(const std::string& study, const StudyGrid& grid, std::size_t index, const Input& input, const std::string& quantity,
                   GroupsOf& groups) {
  const StudyCell& cell = grid.cells[index];
  constexpr double not_run = std::numeric_limits<double>::quiet_NaN();
  return {.study = study,
          .law = cell.law,
          .point = cell.point.name(input.study.parameter),
          .factor = cell.factor,
          .key = cell.key,
          .quantity = quantity,
          .original = groups(grid.original_of(index)),
          .scaled = groups(index),
          .deviation = {not_run, not_run},
          .version = ""};
}

}  // namespace

TrainingRows forecast_rows(const Input& input, const std::string& name) {
  const StudyGrid grid = study_grid(input);
  GroupsOf groups(grid);
  TrainingRows forecast;
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    if (grid.cells[i].original()) continue;
    for (const std::string& quantity : predicted_quantities()) {
      if (quantity != "stress_xz" || groups(i).sheared) forecast.rows.push_back(row_of(name, grid, i, input, quantity, groups));
    }
  }
  return forecast;
}

void add_study(TrainingRows& to, const std::filesystem::path& folder) {
  const std::filesystem::path input_path = folder / "input.toml", csv_path = folder / "study.csv";
  for (const auto& path : {input_path, csv_path}) {
    if (!std::filesystem::is_regular_file(path))
      throw InputError(fmt::format("{} holds no finished study: there is no {}; allowed: the --out folder of scalebreak breakdown",
                                   folder.string(), path.filename().string()));
  }
  const Input input = resolve_input(read_toml_file(input_path));
  const CsvTable csv = read_csv(csv_path);
  const StudyGrid grid = study_grid(input);
  const std::string name = std::filesystem::absolute(folder / ".").lexically_normal().parent_path().filename().string();
  GroupsOf groups(grid);
  for (std::size_t row = 0; row < csv.rows(); ++row) {
    const std::string& quantity = csv.word(row, "quantity");
    const auto& predicted = predicted_quantities();
    if (std::find(predicted.begin(), predicted.end(), quantity) == predicted.end()) continue;
    const auto deviation = csv.number(row, "deviation [-]"), error = csv.number(row, "deviation_error [-]");
    const std::size_t index = cell_of(grid, csv, row);
    if (!deviation || grid.cells[index].original()) continue;
    if (!error || *deviation <= -1) {
      ++to.without_error;
      continue;
    }
    TrainingRow found = row_of(name, grid, index, input, quantity, groups);
    found.deviation = {*deviation, *error}, found.version = csv.word(row, "version");
    to.rows.push_back(std::move(found));
  }
}

}  // namespace scalebreak
