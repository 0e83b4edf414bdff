#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <scalebreak/contact/contact_kind.hpp>
#include <scalebreak/contact/surface_kind.hpp>
#include <scalebreak/table/impact_plane.hpp>
#include <scalebreak/table/patch_table.hpp>

namespace scalebreak {

/// What rolling resistance does to a pair whose rolling nothing else changes, beside the reduced impact speed v̂ and the ratio
/// χ = R*u/v_n of the rolling u = |(ω₁ − ω₂) × n| to it: numbers without a unit (docs/tables.md). What a law does not have is 0.
struct RollingKey {
  ContactKind kind;
  RollingModel model = RollingModel::cdt;
  double damping_ratio = 0;
  double limit = 0;  ///< μ_r; θ_max R*/δ₀ of `ar`
  double stiffness =
      0;  ///< `epsd2`: G*/E*, or k_t/k_n beside a linear contact; `ar`: δ₀/R*, times what a scaling law multiplies its torque by
  double dashpot = 0;      ///< `epsd`: η_r √(I_r/(m*R*²))
  double inertia = 0.625;  ///< m*R*² (1/I₁ + 1/I₂): 5/8 of equal spheres, 5/2 against a wall
  double tolerance = 1e-4;

  bool operator==(const RollingKey&) const = default;
};

/// How well a table does at points between its nodes.
struct RollingQuality {
  double error_max = 0, error_rms = 0;
  int samples = 0;

  bool operator==(const RollingQuality&) const = default;
};

/// The rolling after a collision over the rolling before, over ξ of v̂ and η = χ/(χ + χ₀(v̂)), χ₀ what rolling throughout takes away:
/// where `cdt` just stops the rolling is η = 1/2, an edge of cells. Kinks elsewhere lie in cells of their own.
class RollingTable {
 public:
  using Entries = PatchTable<1>;

  RollingTable() = default;
  /// `half_way` is χ₀ at even places of x from 0 to 1, six of them at least.
  RollingTable(RollingKey key, double sticking_squared, std::vector<double> half_way, Entries entries, RollingQuality quality)
      : key_(key),
        plane_{key.kind.adhesive(), sticking_squared},
        half_way_(std::move(half_way)),
        entries_(std::move(entries)),
        quality_(quality) {}

  /// u after over u before at v̂ (1 without adhesion) and χ ≥ 0; nothing where CollisionTable has nothing, or the pair sticks.
  [[nodiscard]] std::optional<double> find(double speed, double ratio) const {
    const auto x = plane_.column(speed);
    if (!x) return std::nullopt;
    return entries_.at(*x, plane_.row(ratio / half_way_at(half_way_, *x)))[0];
  }

  [[nodiscard]] const RollingKey& key() const { return key_; }
  [[nodiscard]] const RollingQuality& quality() const { return quality_; }
  [[nodiscard]] const ImpactPlane& plane() const { return plane_; }
  [[nodiscard]] const std::vector<double>& half_way() const { return half_way_; }
  [[nodiscard]] const Entries& entries() const { return entries_; }
  [[nodiscard]] std::size_t bytes() const { return entries_.bytes(); }

  /// χ₀ at x by the polynomial through the six places about it.
  [[nodiscard]] static double half_way_at(const std::vector<double>& half_way, double x) {
    return Stencil(Axis::span(0, 1, static_cast<int>(half_way.size())), x).of(half_way.data());
  }

 private:
  RollingKey key_;
  ImpactPlane plane_;
  std::vector<double> half_way_;
  Entries entries_;
  RollingQuality quality_;
};

}  // namespace scalebreak
