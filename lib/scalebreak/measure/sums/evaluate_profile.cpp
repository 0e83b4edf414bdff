#include <scalebreak/measure/sums/evaluate_profile.hpp>

#include <functional>

#include <fmt/format.h>

namespace scalebreak {
namespace {

/// Of the sums of a block and a slab.
using Sum = std::function<double(const Eigen::ArrayXd&, Eigen::Index)>;

Sum entry(Eigen::Index which) {
  return [which](const Eigen::ArrayXd& s, Eigen::Index slab) { return s[slab_index(slab, which)]; };
}

ProfileColumn column(const Blocks& blocks, std::string name, std::string unit, const Sum& numerator, const Sum& denominator) {
  ProfileColumn result{std::move(name), std::move(unit), {}};
  for (Eigen::Index k = 0; k < slab_count(blocks.front()); ++k) {
    result.slabs.push_back(ratio(
        blocks, [&](const auto& s) { return numerator(s, k); }, [&](const auto& s) { return denominator(s, k); }));
  }
  return result;
}

}  // namespace

FlowProfile evaluate_profile(const Blocks& blocks, const Eigen::ArrayXd& run, const VelocityProfile& profile, double shear_rate) {
  FlowProfile result;
  const auto slabs = static_cast<double>(slab_count(run));
  const double gap = run[flow_entry::gap] / run[flow_entry::duration], thickness = gap / slabs;
  for (double k = 0.5; k < slabs; ++k) result.height.push_back(k * thickness);

  const Sum spheres = entry(slab_entry::number);
  const Sum volume = [=](const auto& s, auto) { return s[flow_entry::volume] / slabs; };
  const auto add = [&](std::string name, std::string unit, const Sum& numerator, const Sum& denominator) {
    result.columns.push_back(column(blocks, std::move(name), std::move(unit), numerator, denominator));
  };
  constexpr std::string_view axes = "xyz";
  add("volume_fraction", "-", entry(slab_entry::solid), volume);
  add("number_density", "1/m3", spheres, volume);
  for (const Eigen::Index i : {0, 1, 2}) {
    const Sum velocity = [&, i](const auto& s, auto k) {
      const double count = spheres(s, k), place = static_cast<double>(k) * count + s[slab_index(k, slab_entry::number + 1)];
      const double imposed = i == 0 ? shear_rate * gap * (place / slabs - count / 2) : 0.0;
      return imposed + s[slab_index(k, slab_entry::number + 3 + i)];
    };
    add(fmt::format("velocity_{}", axes[static_cast<std::size_t>(i)]), "m/s", velocity, spheres);
  }
  add(
      "temperature", "m2/s2", [&](const auto& s, auto k) { return fluctuation(s, k, slab_entry::number, profile).trace(); },
      [&](const auto& s, auto k) { return 3 * spheres(s, k); });
  for (const Eigen::Index i : {0, 1, 2}) {
    add(fmt::format("spin_{}", axes[static_cast<std::size_t>(i)]), "rad/s", entry(slab_entry::spin + i), spheres);
  }
  add("rotational_energy", "J", entry(slab_entry::rotational_energy), spheres);
  for (const Eigen::Index i : {0, 1, 2}) {
    for (const Eigen::Index j : {0, 1, 2}) {
      const Sum flux = [&, i, j](const auto& s, auto k) {
        return s[slab_index(k, slab_entry::contact_stress + 3 * j + i)] + fluctuation(s, k, slab_entry::mass, profile)(i, j);
      };
      add("stress_" + tensor_entry_name(i, j), "Pa", flux, volume);
    }
  }
  return result;
}

}  // namespace scalebreak
