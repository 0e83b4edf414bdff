#include <scalebreak/ensembles/event/near/reference_bins.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

#include <scalebreak/ensembles/event/saved_list.hpp>

namespace scalebreak {

/// Around which point, as a bin sees it, and what has been found.
struct ReferenceBins::Search {
  std::vector<std::uint32_t>& found;
  std::array<float, 3> middle{};
  float strain = 0, square = 0;
  std::size_t count = 0;
};

ReferenceBins::ReferenceBins(const Cell& cell, std::size_t spheres) : cell_(cell), bin_of_sphere_(spheres, none) {
  constexpr double spheres_a_bin = 0.7;  // few, so that bins fill the sphere that is searched, and more than three are rare
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

int ReferenceBins::inside(int axis, int bin) const {
  const int bins = bins_[static_cast<std::size_t>(axis)];
  if (bin >= 0 && bin < bins) return bin;
  if (!cell_.periodic(axis)) return bin < 0 ? 0 : bins - 1;
  return (bin % bins + bins) % bins;
}

ReferenceBins::Range ReferenceBins::range(int axis, double low, double high) const {
  const int bins = bins_[static_cast<std::size_t>(axis)];
  const auto below = [](double x) { return static_cast<int>(x) - (x < static_cast<int>(x) ? 1 : 0); };
  int from = below(low / edge_[axis]), to = below(high / edge_[axis]);
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

void ReferenceBins::search_bin(const Bin& bin, Search& search) {
  std::array<float, lanes> distance;
  for (std::size_t k = 0; k < lanes; ++k) {
    const float z = bin.z[k] - search.middle[2], y = bin.y[k] - search.middle[1], x = bin.x[k] - search.middle[0] + search.strain * z;
    distance[k] = x * x + y * y + z * z;
  }
  // Written wherever it is, and kept where it is near: no branch has to be guessed.
  if (search.found.size() < search.count + entries) search.found.resize(2 * search.count + entries);
  std::uint32_t* const found = search.found.data();
  for (std::size_t k = 0; k < entries; ++k) {
    found[search.count] = bin.sphere[k];
    search.count += distance[k] < search.square ? 1 : 0;
  }
}

void ReferenceBins::search_row(std::size_t line, const Range& xs, double middle, Search& search) const {
  for (int i = xs.first; i < xs.first + xs.count; ++i) {
    const int x = inside(0, i);
    search.middle[0] = static_cast<float>(middle - (i - x) / bins_[0] * cell_.size.x());
    for (std::size_t bin = line + static_cast<std::size_t>(x); bin != none; bin = bin_[bin].more) search_bin(bin_[bin], search);
  }
}

std::span<const std::uint32_t> ReferenceBins::find_near(const Eigen::Vector3d& point, double reach, double strain,
                                                       std::vector<std::uint32_t>& space) const {
  const double single_precision = 1e-6 * cell_.size.maxCoeff();  // points have been rounded to it
  reach += single_precision;
  const Range ys = range(1, point.y() - reach, point.y() + reach), zs = range(2, point.z() - reach, point.z() + reach);
  // Where an axis is looked at as a whole, images are left to the caller.
  const bool whole_rows = zs.all && cell_.shear_rate != 0;
  Search search{.found = space, .strain = static_cast<float>(strain)};
  for (int row = zs.first; row < zs.first + zs.count; ++row) {
    const int z = inside(2, row), crossings = (row - z) / bins_[2];
    const auto [low, high] = above(2, row, point.z(), reach);
    const double off_z = zs.all ? 0 : std::max({0.0, low, -high}), middle = point.x() - crossings * cell_.shear_offset;
    search.middle[2] = static_cast<float>(point.z() - crossings * cell_.size.z());
    for (int j = ys.first; j < ys.first + ys.count; ++j) {
      const int y = inside(1, j);
      const auto [right, left] = above(1, j, point.y(), reach);
      const double off_y = ys.all ? 0 : std::max({0.0, right, -left}), square = reach * reach - off_y * off_y - off_z * off_z;
      if (square < 0) continue;
      // By so much more as the references of this row are higher the flow has carried them on.
      const double half = std::sqrt(square), least = std::min(strain * low, strain * high), most = std::max(strain * low, strain * high);
      const Range xs = whole_rows ? Range{0, bins_[0], true} : range(0, middle - half - most, middle + half - least);
      search.square = xs.all || ys.all || zs.all ? nowhere : static_cast<float>(reach * reach);
      search.middle[1] = static_cast<float>(point.y() - (j - y) / bins_[1] * cell_.size.y());
      search_row((static_cast<std::size_t>(z) * static_cast<std::size_t>(bins_[1]) + static_cast<std::size_t>(y)) * static_cast<std::size_t>(bins_[0]), xs,
                 middle, search);
    }
  }
  return {space.data(), search.count};
}

}  // namespace scalebreak
