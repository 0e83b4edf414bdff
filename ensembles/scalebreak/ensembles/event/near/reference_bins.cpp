#include <scalebreak/ensembles/event/near/reference_bins.hpp>

#include <cassert>

#include <scalebreak/ensembles/event/saved_list.hpp>

namespace scalebreak {

ReferenceBins::ReferenceBins(const Cell& cell, std::size_t spheres) : cell_(cell), bin_of_sphere_(spheres, none) {
  constexpr double spheres_a_bin = 2;
  const double edge = std::cbrt(spheres_a_bin * cell.volume() / static_cast<double>(spheres));
  std::size_t bins = 1;
  for (const int axis : {0, 1, 2}) {
    const int along = std::max(1, static_cast<int>(cell.size[axis] / edge));
    bins_[static_cast<std::size_t>(axis)] = along;
    edge_[axis] = cell.size[axis] / along;
    bins *= static_cast<std::size_t>(along);
  }
  Bin empty{};
  empty.x.fill(nowhere), empty.y.fill(nowhere), empty.z.fill(nowhere);
  empty.more = none;
  bin_.assign(bins, empty);
}

std::array<float, 3> ReferenceBins::point_in_cell(const Eigen::Vector3d& reference) const {
  std::array<float, 3> point{};
  for (const int axis : {0, 1, 2}) {
    double x = reference[axis];
    if (cell_.periodic(axis)) x -= cell_.size[axis] * std::floor(x / cell_.size[axis]);
    point[static_cast<std::size_t>(axis)] = static_cast<float>(x);
  }
  return point;
}

std::uint32_t ReferenceBins::bin_of(const std::array<float, 3>& point) const {
  std::array<int, 3> at{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double bin = std::floor(static_cast<double>(point[axis]) / edge_[static_cast<Eigen::Index>(axis)]);
    at[axis] = static_cast<int>(std::clamp(bin, 0.0, bins_[axis] - 1.0));
  }
  return static_cast<std::uint32_t>((at[2] * bins_[1] + at[1]) * bins_[0] + at[0]);
}

void ReferenceBins::put(std::uint32_t bin, std::uint32_t sphere, const std::array<float, 3>& point) {
  bin_of_sphere_[sphere] = bin;
  while (true) {
    Bin& b = bin_[bin];
    for (std::size_t k = 0; k < entries; ++k) {
      if (b.x[k] != nowhere) continue;
      b.x[k] = point[0], b.y[k] = point[1], b.z[k] = point[2];
      b.sphere[k] = sphere;
      return;
    }
    if (b.more == none) {
      Bin empty = b;
      empty.x.fill(nowhere);
      empty.more = none;
      b.more = static_cast<std::uint32_t>(bin_.size());
      bin = b.more;
      bin_.push_back(empty);
    } else {
      bin = b.more;
    }
  }
}

void ReferenceBins::take(std::uint32_t bin, std::uint32_t sphere) {
  while (true) {
    assert(bin != none);
    Bin& b = bin_[bin];
    for (std::size_t k = 0; k < entries; ++k) {
      if (b.sphere[k] != sphere || b.x[k] == nowhere) continue;
      b.x[k] = nowhere;
      return;
    }
    bin = b.more;
  }
}

void ReferenceBins::insert(std::uint32_t sphere, const Eigen::Vector3d& reference) {
  const auto point = point_in_cell(reference);
  put(bin_of(point), sphere, point);
}

void ReferenceBins::move(std::uint32_t sphere, const Eigen::Vector3d& reference) {
  take(bin_of_sphere_[sphere], sphere);
  insert(sphere, reference);
}

void ReferenceBins::save(std::string& bytes) const { put_list(bytes, bin_), put_list(bytes, bin_of_sphere_); }

void ReferenceBins::load(std::string_view& bytes) { take_list(bytes, bin_), take_list(bytes, bin_of_sphere_); }

}  // namespace scalebreak
