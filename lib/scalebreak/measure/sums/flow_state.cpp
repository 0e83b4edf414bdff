#include <scalebreak/measure/sums/flow_state.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include <scalebreak/base/bytes.hpp>
#include <scalebreak/base/error.hpp>
#include <scalebreak/measure/sums/flow_sums.hpp>
#include <scalebreak/measure/sums/slab_grid.hpp>
#include <scalebreak/measure/sums/sphere_slab.hpp>

namespace scalebreak {
namespace {

using Stress = Eigen::Array<double, 9, 1>;

void add_sphere(Eigen::ArrayXd& sums, const SlabGrid& grid, const System& system, std::size_t i) {
  const Cell& cell = system.cell;
  Eigen::Vector3d position = system.position[i], velocity = system.velocity[i];
  wrap(cell, position, velocity);
  const double radius = system.radius[i], mass = system.mass[i], height = position.z();
  const double spinning = system.inertia(i) * system.spin[i].squaredNorm() / 2;
  const Eigen::Vector3d own = homogeneous_shear(cell) ? Eigen::Vector3d(velocity - mean_flow(cell, height)) : velocity;

  sums[flow_entry::spheres] += 1;
  sums[flow_entry::solid] += 4 * std::numbers::pi / 3 * radius * radius * radius;
  sums[flow_entry::kinetic_energy] += mass * own.squaredNorm() / 2 + spinning;
  sums[flow_entry::rotational_energy] += spinning;
  if (homogeneous_shear(cell)) sums[flow_entry::work] -= cell.shear_rate * mass * own.x() * own.z();

  grid.cut(height - radius, height + radius, [&](Eigen::Index slab, double lower, double upper) {
    sums[slab_index(slab, slab_entry::solid)] += sphere_between_planes(radius, lower - height, upper - height);
  });

  const std::optional<Eigen::Index> found = grid.slab_at(height);
  if (!found) {
    sums[flow_entry::outside] += 1;
    return;
  }
  const Eigen::Index slab = *found;
  const double place = height / grid.height() - static_cast<double>(slab);
  constexpr Eigen::Index moments = VelocityMoments::SizeAtCompileTime;
  add_velocity(sums.segment<moments>(slab_index(slab, slab_entry::number)), 1, place, own);
  add_velocity(sums.segment<moments>(slab_index(slab, slab_entry::mass)), mass, place, own);
  sums[slab_index(slab, slab_entry::rotational_energy)] += spinning;
  sums.segment<3>(slab_index(slab, slab_entry::spin)) += system.spin[i].array();
}

void add_contact(Eigen::ArrayXd& sums, const SlabGrid& grid, const System& system, const ContactForce& contact) {
  const Eigen::Matrix3d moment = -contact.force * contact.branch.transpose();
  const Stress stress = moment.reshaped();
  sums.segment<9>(flow_entry::contact_stress) += stress;

  Eigen::Vector3d start = system.position[static_cast<std::size_t>(contact.first)], unused = start;
  wrap(system.cell, start, unused);
  const double rise = contact.branch.z(), from = std::min(start.z(), start.z() + rise), length = std::abs(rise);
  if (length < 1e-9 * grid.height()) {  // level: all of it where it lies
    if (const auto slab = grid.slab_at(start.z())) sums.segment<9>(slab_index(*slab, slab_entry::contact_stress)) += stress;
    return;
  }
  grid.cut(from, from + length, [&](Eigen::Index slab, double lower, double upper) {
    sums.segment<9>(slab_index(slab, slab_entry::contact_stress)) += stress * ((upper - lower) / length);
  });
}

void add_contacts(Eigen::ArrayXd& sums, const SlabGrid& grid, const Sample& sample) {
  const std::size_t spheres = sample.system.count();
  std::vector<int> contacts_of(spheres, 0);
  for (const ContactForce& contact : sample.contacts) {
    if (contact.first < 0 || static_cast<std::size_t>(contact.first) >= spheres ||
        (contact.second >= 0 && static_cast<std::size_t>(contact.second) >= spheres)) {
      throw WorkError(fmt::format("a contact of spheres {} and {} was measured among {} spheres", contact.first, contact.second, spheres));
    }
    if (sample.forces_known) add_contact(sums, grid, sample.system, contact);
    if (!contact.touching) continue;
    for (const std::int32_t end : {contact.first, contact.second}) {
      if (end < 0) continue;
      sums[flow_entry::contact_ends] += 1;
      ++contacts_of[static_cast<std::size_t>(end)];
    }
  }
  for (const int contacts : contacts_of) {
    sums[flow_entry::in_contact] += contacts > 0 ? 1 : 0;
    sums[flow_entry::crowded] += contacts > 1 ? 1 : 0;
  }
}

Eigen::ArrayXd totals_of(const Sample& sample, double kinetic_energy) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  Eigen::ArrayXd totals = Eigen::ArrayXd::Constant(running_total::count, nothing);
  totals[running_total::contact_starts] = sample.contact_starts;
  totals[running_total::work] = sample.work;
  totals[running_total::energy] = kinetic_energy + sample.elastic_energy;
  totals[running_total::dissipated] = sample.dissipated.value_or(nothing);
  totals[running_total::shear_work] = sample.shear_work.value_or(nothing);
  totals[running_total::contact_time] = sample.contact_time.value_or(nothing);
  if (sample.contact_moment) totals.segment<9>(running_total::contact_moment) = sample.contact_moment->reshaped().array();
  return totals;
}

}  // namespace

FlowState flow_state(const Sample& sample, int slabs) {
  const Cell& cell = sample.system.cell;
  const SlabGrid grid(cell, slabs);
  Eigen::ArrayXd sums = Eigen::ArrayXd::Zero(flow_entry::count + slabs * slab_entry::count);
  sums[flow_entry::duration] = 1;
  sums[flow_entry::volume] = cell.volume();
  sums[flow_entry::gap] = cell.size.z();
  for (std::size_t i = 0; i < sample.system.count(); ++i) add_sphere(sums, grid, sample.system, i);
  add_contacts(sums, grid, sample);
  if (!sample.forces_known) {
    for (Eigen::Index slab = 0; slab < slabs; ++slab)
      sums.segment<9>(slab_index(slab, slab_entry::contact_stress)).setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  return {sample.system.time, homogeneous_shear(cell) ? cell.shear_rate : 0, sums, totals_of(sample, sums[flow_entry::kinetic_energy])};
}

Eigen::ArrayXd interval_sums(const FlowState& begin, const FlowState& end) {
  Eigen::ArrayXd sums = (end.time - begin.time) / 2 * (begin.sums + end.sums);
  const Eigen::ArrayXd gain = end.totals - begin.totals;
  sums[flow_entry::contact_starts] = gain[running_total::contact_starts];
  sums[flow_entry::energy_gain] = gain[running_total::energy];
  sums[flow_entry::dissipated] = gain[running_total::dissipated];
  if (std::isfinite(gain[running_total::contact_time])) sums[flow_entry::contact_ends] = 2 * gain[running_total::contact_time];
  if (std::isfinite(gain[running_total::contact_moment])) {
    sums.segment<9>(flow_entry::contact_stress) = gain.segment<9>(running_total::contact_moment);
  }
  constexpr Eigen::Index stress_xz = flow_entry::contact_stress + 6;
  const double sampled_shear_work = sums[flow_entry::work] - begin.shear_rate * sums[stress_xz];
  const bool handed_over = std::isfinite(gain[running_total::shear_work]);
  sums[flow_entry::work] = gain[running_total::work] + (handed_over ? gain[running_total::shear_work] : sampled_shear_work);
  // A drift cannot be told from the noise of a sampled work.
  if (begin.shear_rate != 0 && !handed_over) sums[flow_entry::dissipated] = std::numeric_limits<double>::quiet_NaN();
  return sums;
}

void save(std::string& bytes, const FlowState& state) {
  put_bytes(bytes, state.time);
  put_bytes(bytes, state.shear_rate);
  put_bytes(bytes, state.sums);
  put_bytes(bytes, state.totals);
}

void load(std::string_view& bytes, FlowState& state) {
  take_bytes(bytes, state.time);
  take_bytes(bytes, state.shear_rate);
  take_bytes(bytes, state.sums);
  take_bytes(bytes, state.totals);
}

}  // namespace scalebreak
