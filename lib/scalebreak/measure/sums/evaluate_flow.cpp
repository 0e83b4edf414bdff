#include <scalebreak/measure/sums/evaluate_flow.hpp>

#include <scalebreak/measure/sums/block_ratios.hpp>
#include <scalebreak/measure/sums/evaluate_profile.hpp>

namespace scalebreak {
namespace {

struct Definition {
  const char *name, *unit;
  double (*numerator)(const Eigen::ArrayXd&);
  double (*denominator)(const Eigen::ArrayXd&);
};

double spheres(const Eigen::ArrayXd& s) { return s[flow_entry::spheres]; }
double volume(const Eigen::ArrayXd& s) { return s[flow_entry::volume]; }

constexpr Definition definitions[] = {
    {"rotational_energy", "J", [](const auto& s) { return s[flow_entry::rotational_energy]; }, spheres},
    {"collision_rate", "1/s", [](const auto& s) { return 2 * s[flow_entry::contact_starts]; }, spheres},
    {"coordination", "-", [](const auto& s) { return s[flow_entry::contact_ends]; }, spheres},
    {"multi_contact_fraction", "-", [](const auto& s) { return s[flow_entry::crowded]; },
     [](const auto& s) { return s[flow_entry::in_contact]; }},
    {"volume_fraction", "-", [](const auto& s) { return s[flow_entry::solid]; }, volume},
    {"dissipation", "W/m3", [](const auto& s) { return s[flow_entry::work] - s[flow_entry::energy_gain]; }, volume},
};

MeasuredTensor tensor(const Blocks& blocks, const std::vector<Eigen::Matrix3d>& moments) {
  MeasuredTensor result;
  std::vector<double> volumes;
  for (const Eigen::ArrayXd& block : blocks) volumes.push_back(volume(block));
  for (const Eigen::Index i : {0, 1, 2}) {
    for (const Eigen::Index j : {0, 1, 2}) {
      std::vector<double> entries;
      for (const Eigen::Matrix3d& moment : moments) entries.push_back(moment(i, j));
      const Measured entry = ratio_of_sums(entries, volumes);
      result.value(i, j) = entry.value;
      result.error(i, j) = entry.error;
    }
  }
  return result;
}

/// What the account of energy leaves over, of the mean kinetic energy, per collision.
Measured energy_drift(const Blocks& blocks, const Eigen::ArrayXd& run) {
  const double kinetic = run[flow_entry::kinetic_energy] / run[flow_entry::duration];
  return ratio(
      blocks, [](const auto& s) { return s[flow_entry::energy_gain] + s[flow_entry::dissipated] - s[flow_entry::work]; },
      [&](const auto& s) { return kinetic * s[flow_entry::contact_starts]; });
}

}  // namespace

FlowResult evaluate_flow(const Blocks& blocks, ProfileKind kind, double shear_rate) {
  FlowResult result;
  Eigen::ArrayXd run;
  for (const Eigen::ArrayXd& block : blocks) run = run.size() == 0 ? block : Eigen::ArrayXd(run + block);
  VelocityProfile profile;
  if (!blocks.empty()) {
    profile = velocity_profile(kind, run);
    result.duration = run[flow_entry::duration];
    result.outside = run[flow_entry::outside] / result.duration;
    result.profile = evaluate_profile(blocks, run, profile, shear_rate);
  }

  const auto in_slabs = [](const auto& s) { return 3 * (s[flow_entry::spheres] - s[flow_entry::outside]); };
  const auto squares = [&](const auto& s) { return fluctuation(s, slab_entry::number, profile).trace(); };
  result.quantities.push_back({"temperature", "m2/s2", ratio(blocks, squares, in_slabs)});
  for (const Definition& d : definitions) result.quantities.push_back({d.name, d.unit, ratio(blocks, d.numerator, d.denominator)});

  std::vector<Eigen::Matrix3d> contact, total;
  for (const Eigen::ArrayXd& block : blocks) {
    contact.emplace_back(block.segment<9>(flow_entry::contact_stress).reshaped(3, 3));
    total.emplace_back(contact.back() + fluctuation(block, slab_entry::mass, profile));
  }
  result.stress = tensor(blocks, total);
  result.stress_contact = tensor(blocks, contact);
  std::size_t k = 0;
  result.quantities.push_back({"pressure", "Pa",
                               ratio(
                                   blocks, [&](const auto&) { return total[k++].trace() / 3; }, volume)});
  result.quantities.push_back({"energy_drift", "-", blocks.empty() ? ratio_of_sums({}, {}) : energy_drift(blocks, run)});
  return result;
}

}  // namespace scalebreak
