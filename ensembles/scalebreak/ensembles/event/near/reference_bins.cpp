#include <scalebreak/ensembles/event/near/reference_bins.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include <scalebreak/ensembles/event/saved_list.hpp>

namespace scalebreak {

ReferenceBins::ReferenceBins(const Cell& cell, std::size_t spheres) : cell_(cell), bin_of_sphere_(spheres, none) {
  constexpr double spheres_a_bin = 3.5;  // more than there is room for are rare, and bins are about as long as lists reach
  const double edge = std::cbrt(spheres_a_bin * cell.volume() / static_cast<double>(spheres));
  std::size_t bins = 1;
  for (const int axis : {0, 1, 2}) {
    const int along = std::max(1, static_cast<int>(cell.size[axis] / edge));
    bins_[static_cast<std::size_t>(axis)] = along;
    edge_[axis] = cell.size[axis] / along;
    bins_per_length_[axis] = along / cell.size[axis];
    bins *= static_cast<std::size_t>(along);
  }
  bin_.assign(bins, {});
}

ReferenceBins::Place ReferenceBins::place_of(const Eigen::Vector3d& reference) const {
  Place place{};
  for (const int axis : {0, 1, 2}) {
    const auto k = static_cast<std::size_t>(axis);
    double x = reference[axis];
    if (cell_.periodic(axis) && (x < 0 || x >= cell_.size[axis])) x -= cell_.size[axis] * std::floor(x / cell_.size[axis]);
    const double bins = x * bins_per_length_[axis];
    place.bin[k] = std::clamp(static_cast<int>(bins), 0, bins_[k] - 1);
    const double steps = (bins - place.bin[k]) * Bin::steps;
    assert(std::abs(steps) < std::numeric_limits<std::int16_t>::max());
    place.steps[k] = static_cast<std::int16_t>(steps);
  }
  return place;
}

std::uint32_t ReferenceBins::number_of(const std::array<int, 3>& bin) const {
  return static_cast<std::uint32_t>((bin[2] * bins_[1] + bin[1]) * bins_[0] + bin[0]);
}

void ReferenceBins::put(std::uint32_t bin, std::uint32_t sphere, const Place& place) {
  bin_of_sphere_[sphere] = bin;
  while (bin_[bin].count == Bin::room) {
    if (bin_[bin].more == Bin::none) {
      bin_[bin].more = static_cast<std::uint32_t>(bin_.size()) & Bin::none;
      bin_.emplace_back();
    }
    bin = bin_[bin].more;
  }
  Bin& b = bin_[bin];
  b.x[b.count] = place.steps[0], b.y[b.count] = place.steps[1], b.z[b.count] = place.steps[2];
  b.sphere[b.count] = sphere;
  b.count = (b.count + 1u) & 7u;
}

void ReferenceBins::take(std::uint32_t bin, std::uint32_t sphere) {
  for (; bin != Bin::none; bin = bin_[bin].more) {
    Bin& b = bin_[bin];
    for (std::size_t k = 0; k < b.count; ++k) {
      if (b.sphere[k] != sphere) continue;
      b.count = (b.count - 1u) & 7u;
      b.x[k] = b.x[b.count], b.y[k] = b.y[b.count], b.z[k] = b.z[b.count];
      b.sphere[k] = b.sphere[b.count];
      return;
    }
  }
  assert(false);
}

void ReferenceBins::insert(std::uint32_t sphere, const Eigen::Vector3d& reference) {
  const Place place = place_of(reference);
  put(number_of(place.bin), sphere, place);
}

void ReferenceBins::move(std::uint32_t sphere, const Eigen::Vector3d& reference) {
  take(bin_of_sphere_[sphere], sphere);
  insert(sphere, reference);
}

void ReferenceBins::save(std::string& bytes) const { put_list(bytes, bin_), put_list(bytes, bin_of_sphere_); }

void ReferenceBins::load(std::string_view& bytes) { take_list(bytes, bin_), take_list(bytes, bin_of_sphere_); }

int ReferenceBins::inside(int axis, int bin) const {
  const int bins = bins_[static_cast<std::size_t>(axis)];
  if (!cell_.periodic(axis)) return std::clamp(bin, 0, bins - 1);
  while (bin < 0) bin += bins;
  while (bin >= bins) bin -= bins;
  return bin;
}

ReferenceBins::Range ReferenceBins::range(int axis, double low, double high) const {
  const int bins = bins_[static_cast<std::size_t>(axis)];
  const auto below = [](double x) { return static_cast<int>(x) - (x < static_cast<int>(x) ? 1 : 0); };
  int from = below(low * bins_per_length_[axis]), to = below(high * bins_per_length_[axis]);
  if (!cell_.periodic(axis)) {
    from = inside(axis, from), to = inside(axis, to);
  } else if (to - from + 1 >= bins) {
    return {from, bins, true};
  }
  return {from, to - from + 1, false};
}

/// How much higher than `middle` references of a row lie, from and to, as far as they are within reach.
std::array<double, 2> ReferenceBins::above(int axis, int row, double middle, double reach) const {
  const bool first = !cell_.periodic(axis) && row == 0, last = !cell_.periodic(axis) && row == bins_[static_cast<std::size_t>(axis)] - 1;
  return {first ? -reach : std::max(-reach, row * edge_[axis] - middle), last ? reach : std::min(reach, (row + 1) * edge_[axis] - middle)};
}

ReferenceBins::Near ReferenceBins::find_near(const Eigen::Vector3d& reference, double reach, double strain, Space& space) const {
  const Place place = place_of(reference);
  const Eigen::Array3d step = edge_.array() / Bin::steps;
  Eigen::Vector3d point;  // in the cell, and in whole steps: what is near is then near also from the other's side
  for (const int axis : {0, 1, 2})
    point[axis] =
        (place.bin[static_cast<std::size_t>(axis)] + place.steps[static_cast<std::size_t>(axis)] / static_cast<double>(Bin::steps)) *
        edge_[axis];
  reach += 2 * (1 + std::abs(strain)) * step.maxCoeff();  // as far as points may be from their steps
  const Range ys = range(1, point.y() - reach, point.y() + reach), zs = range(2, point.z() - reach, point.z() + reach);
  // Where an axis is looked at as a whole, images are left to the caller.
  const bool whole_rows = zs.all && cell_.shear_rate != 0;
  bool all = ys.all || zs.all;
  space.visits.clear();
  const auto steps_beyond = [&](int axis, int bin) {
    const auto k = static_cast<std::size_t>(axis);
    return static_cast<float>((bin - place.bin[k]) * static_cast<double>(Bin::steps) - place.steps[k]);
  };
  for (int row = zs.first; row < zs.first + zs.count; ++row) {
    const int z = inside(2, row), crossings = (row - z) / bins_[2];
    const auto [low, high] = above(2, row, point.z(), reach);
    const double off_z = zs.all ? 0 : std::max({0.0, low, -high}), moved = crossings * cell_.shear_offset, middle = point.x() - moved;
    for (int j = ys.first; j < ys.first + ys.count; ++j) {
      const int y = inside(1, j), across = (j - y) / bins_[1];
      const auto [right, left] = above(1, j, point.y(), reach);
      const double off_y = ys.all ? 0 : std::max({0.0, right, -left}), square = reach * reach - off_y * off_y - off_z * off_z;
      if (square < 0) continue;
      // By so much more as the references of this row are higher the flow has carried them on.
      const double half = std::sqrt(square), least = std::min(strain * low, strain * high), most = std::max(strain * low, strain * high);
      const Range xs = whole_rows ? Range{0, bins_[0], true} : range(0, middle - half - most, middle + half - least);
      all |= xs.all;
      const std::uint32_t line = number_of({0, y, z});
      for (int i = xs.first; i < xs.first + xs.count; ++i) {
        const int x = inside(0, i);
        const std::uint32_t bin = line + static_cast<std::uint32_t>(x);
        __builtin_prefetch(&bin_[bin]);
        space.visits.push_back({bin, Images::code(cell_.shear_rate == 0 ? (i - x) / bins_[0] : 0, across, crossings),
                                steps_beyond(0, i) + static_cast<float>(moved / step.x()), steps_beyond(1, j), steps_beyond(2, row)});
      }
    }
  }
  const BinSearch search{static_cast<float>(step.x()), static_cast<float>(step.y()), static_cast<float>(step.z()),
                         static_cast<float>(strain), all ? std::numeric_limits<float>::infinity() : static_cast<float>(reach * reach)};
  space.found.clear();
  static const bool whole_bins = can_look_into_whole_bins();
  (whole_bins ? look_into_whole_bins : look_into_bins)(bin_, space.visits, search, space.found);
  return {space.found, !all && cell_.shear_rate == 0};
}

}  // namespace scalebreak
