#include <scalebreak/ensembles/event/near/reference_bins.hpp>

namespace scalebreak {

ReferenceBins::ReferenceBins(const Cell& cell, double edge, std::size_t spheres) : cell_(cell), place_(spheres) {
  const double most = std::cbrt(8.0 * static_cast<double>(spheres)) + 1;  // along an axis, of a cell that is nearly empty
  for (int axis = 0; axis < 3; ++axis) {
    const int bins = static_cast<int>(std::clamp(cell.size[axis] / edge, 1.0, std::max(1.0, most)));
    bins_[static_cast<std::size_t>(axis)] = bins;
    edge_[axis] = cell.size[axis] / bins;
  }
  first_.assign(static_cast<std::size_t>(bins_[0]) * static_cast<std::size_t>(bins_[1]) * static_cast<std::size_t>(bins_[2]), none);
}

std::uint32_t ReferenceBins::bin_of(const Eigen::Vector3d& reference) const {
  std::array<int, 3> at{};
  for (int axis = 0; axis < 3; ++axis) {
    at[static_cast<std::size_t>(axis)] = inside(axis, static_cast<int>(std::floor(reference[axis] / edge_[axis])));
  }
  return static_cast<std::uint32_t>((at[2] * bins_[1] + at[1]) * bins_[0] + at[0]);
}

void ReferenceBins::link(std::uint32_t sphere, std::uint32_t bin) {
  place_[sphere] = {bin, first_[bin], none};
  if (first_[bin] != none) place_[first_[bin]].previous = sphere;
  first_[bin] = sphere;
}

void ReferenceBins::move(std::uint32_t sphere, const Eigen::Vector3d& reference) {
  const std::uint32_t bin = bin_of(reference);
  const Place place = place_[sphere];
  if (place.bin == bin) return;
  (place.previous == none ? first_[place.bin] : place_[place.previous].next) = place.next;
  if (place.next != none) place_[place.next].previous = place.previous;
  link(sphere, bin);
}

}  // namespace scalebreak
