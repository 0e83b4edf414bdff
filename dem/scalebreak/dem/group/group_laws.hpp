#pragma once

#include <vector>

#include <scalebreak/cell/cell.hpp>
#include <scalebreak/dem/dem.hpp>
#include <scalebreak/dem/kernel/kernel.hpp>
#include <scalebreak/dem/law_rows.hpp>
#include <scalebreak/dem/lists/images.hpp>

namespace scalebreak {

/// What all small groups of a flow have in common: the laws between its kinds of spheres, its walls, and the loops that work on them.
class GroupLaws {
 public:
  /// Up to so many radii and materials, unless each contact has laws of its own.
  static constexpr std::size_t most_kinds = 16;

  /// `kinds`: of the spheres that will be in groups, scaled radii; with `each`, where each contact has laws of its own, the smallest and the
  /// largest of each material. Throws InputError where there are none, or too many.
  GroupLaws(const DemSetup& setup, const Cell& cell, std::vector<dem::LawRows::Kind> kinds, bool each = false);

  [[nodiscard]] double step() const { return step_; }  ///< at most [s]
  [[nodiscard]] bool turns() const { return turns_; }
  /// How far beyond touch anything acts [m].
  [[nodiscard]] double largest_reach() const { return largest_reach_; }
  [[nodiscard]] const Eigen::Vector3d& gravity() const { return gravity_; }
  [[nodiscard]] const std::vector<dem::WallView>& walls() const { return walls_; }

 private:
  friend class DemGroup;
  [[nodiscard]] bool each() const { return rows_.each(); }
  /// 0 where each contact has laws of its own.
  [[nodiscard]] std::uint32_t kind_number(const dem::LawRows::Kind& kind) const;
  [[nodiscard]] const dem::LawRows& rows(bool wall) const { return wall ? wall_rows_ : rows_; }

  const dem::Kernel* kernel_;
  std::vector<dem::LawRows::Kind> kinds_;
  dem::LawRows rows_, wall_rows_;
  std::vector<dem::WallView> walls_;
  dem::Images images_;  ///< none but the spheres themselves
  Eigen::Vector3d gravity_{0, 0, 0};
  double step_ = 0, largest_reach_ = 0;
  bool turns_ = false, slides_ = false, rolls_ = false;
};

}  // namespace scalebreak
