#include <scalebreak/measure/flow_csv.hpp>

#include <cmath>

#include <fmt/format.h>

#include <scalebreak/measure/sums/block_ratios.hpp>
#include <scalebreak/measure/sums/flow_state.hpp>

namespace scalebreak {
namespace {

CsvCell cell(double value) { return std::isfinite(value) ? CsvCell(value) : CsvCell(); }

double ratio_or_nothing(double numerator, double denominator) { return ratio_of_sums({numerator}, {denominator}).value; }

}  // namespace

Csv profile_csv(const FlowProfile& profile) {
  std::vector<std::string> header = {"z [m]"};
  for (const ProfileColumn& column : profile.columns) {
    header.push_back(fmt::format("{} [{}]", column.name, column.unit));
    header.push_back(fmt::format("{}_error [{}]", column.name, column.unit));
  }
  Csv csv(header);
  for (std::size_t k = 0; k < profile.height.size(); ++k) {
    std::vector<CsvCell> row = {profile.height[k]};
    for (const ProfileColumn& column : profile.columns) {
      row.push_back(cell(column.slabs[k].value));
      row.push_back(cell(column.slabs[k].error));
    }
    csv.add(row);
  }
  return csv;
}

std::vector<std::string> series_header() {
  std::vector<std::string> header = {"time [s]",           "temperature [m2/s2]", "rotational_energy [J]",      "kinetic_energy [J]",
                                     "elastic_energy [J]", "coordination [-]",    "multi_contact_fraction [-]", "pressure [Pa]"};
  for (const Eigen::Index i : {0, 1, 2}) {
    for (const Eigen::Index j : {0, 1, 2}) header.push_back(fmt::format("stress_{} [Pa]", tensor_entry_name(i, j)));
  }
  header.insert(header.end(), {"contact_starts [-]", "work [J]"});
  return header;
}

std::vector<CsvCell> series_row(const Sample& sample, int slabs) {
  const FlowState state = flow_state(sample, slabs);
  const Eigen::ArrayXd& s = state.sums;
  const VelocityProfile profile = velocity_profile(profile_kind(sample.system.cell), s);
  const double spheres = s[flow_entry::spheres], inside = spheres - s[flow_entry::outside];
  const double free = std::max(0.0, inside - static_cast<double>(profile.fitted_parameters));
  const Eigen::Matrix3d moment =
      fluctuation(s, slab_entry::mass, profile) + s.segment<9>(flow_entry::contact_stress).matrix().reshaped(3, 3);
  const Eigen::Matrix3d stress = moment / s[flow_entry::volume];

  std::vector<CsvCell> row = {state.time,
                              cell(ratio_or_nothing(fluctuation(s, slab_entry::number, profile).trace(), 3 * free)),
                              cell(ratio_or_nothing(s[flow_entry::rotational_energy], spheres)),
                              s[flow_entry::kinetic_energy],
                              sample.elastic_energy,
                              cell(ratio_or_nothing(s[flow_entry::contact_ends], spheres)),
                              cell(ratio_or_nothing(s[flow_entry::crowded], s[flow_entry::in_contact])),
                              stress.trace() / 3};
  for (const Eigen::Index i : {0, 1, 2}) {
    for (const Eigen::Index j : {0, 1, 2}) row.emplace_back(stress(i, j));
  }
  row.insert(row.end(), {sample.contact_starts, sample.work});
  return row;
}

}  // namespace scalebreak
