#include <scalebreak/dem/law_rows.hpp>

#include <algorithm>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>

namespace scalebreak::dem {

double hold_of(const MappedLaws& laws) {
  const double stretched = std::visit([](const auto& law) { return -law.overlap(law.separation()); }, laws.laws.normal);
  return std::max(stretched, 0.0) / laws.length;
}

double bridge_of(const MappedLaws& laws) { return laws.laws.liquid.bridges() ? laws.laws.liquid.rupture / laws.length : 0.0; }

LawRows::LawRows(const DemSetup& setup, const std::vector<Kind>& kinds, bool walls, bool each)
    : setup_(setup), walls_(walls), each_(each), kinds_(static_cast<std::uint32_t>(kinds.size())) {
  radius_share_ = setup.law.direct_force ? 1 / size_factor(setup.law, setup.factor) : 1.0;
  mapped_ = laws_of(kinds.front(), kinds.front());
  bridges_ = mapped_.laws.liquid.bridges();
  std::vector<MappedLaws> all;
  for (const Kind& first : kinds) {
    if (walls) {
      all.push_back(laws_of(first, first));
    } else {
      for (const Kind& second : kinds) all.push_back(laws_of(first, second));
    }
  }
  for (const MappedLaws& laws : all) {
    largest_reach_ = std::max({largest_reach_, hold_of(laws), bridge_of(laws)});
    if (laws.laws.normal.index() != mapped_.laws.normal.index())
      throw InputError(
          "[material] and [second] differ in that one pair of them adheres and another does not; allowed: surface_energy of both "
          "above 0, or of both 0");
  }
  if (each) all.resize(1);  // its form is that of every row
  rows_.resize(all.size());
  hold_.resize(all.size());
  bridge_.resize(all.size());
  for (std::uint32_t row = 0; row < all.size(); ++row) put(row, all[row]);
}

MappedLaws LawRows::laws_of(const Kind& first, const Kind& second) const {
  const double size = size_factor(setup_.law, setup_.factor);
  const auto material = [&](const Kind& kind) { return kind.material == 0 ? setup_.material : setup_.second; };
  Bodies bodies{material(first), material(second), setup_.wall, {first.radius / size}};
  if (!walls_) bodies.radius.push_back(second.radius / size);
  return mapped_laws(setup_.contact, setup_.surface, bodies, setup_.law, setup_.factor);
}

void LawRows::put(std::uint32_t row, const MappedLaws& laws) {
  rows_[row] = laws.laws;
  hold_[row] = hold_of(laws);
  bridge_[row] = bridge_of(laws);
}

std::uint32_t LawRows::open(const Kind& first, const Kind& second) {
  std::uint32_t row = static_cast<std::uint32_t>(rows_.size());
  if (!free_.empty()) {
    row = free_.back();
    free_.pop_back();
  } else {
    rows_.emplace_back();
    hold_.emplace_back();
    bridge_.emplace_back();
  }
  put(row, laws_of(first, second));
  return row;
}

void LawRows::close_all() {
  rows_.resize(1);
  hold_.resize(1);
  bridge_.resize(1);
  free_.clear();
}

}  // namespace scalebreak::dem
