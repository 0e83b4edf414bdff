#pragma once

#include <cmath>
#include <numbers>

#include <scalebreak/contact/contact_point.hpp>
#include <scalebreak/contact/slider.hpp>
#include <scalebreak/contact/surface_kind.hpp>
#include <scalebreak/material/pair.hpp>

namespace scalebreak {

/// Rolling resistance, on the rolling part of the relative spin; twist is free. With y = (R*δ)^{1/4}, or √a for `ar`:
///
///     cdt:   M = μ_r R* F_N against the rolling                            (Washino et al. 2024, eqs 37–41; Hu 2024, eq. 2.51)
///     epsd:  dM = k_r dθ with k_r = 2.25 k_n μ_r² R*², k_n = 4/3 E* y² or the linear contact's, and a dashpot
///            2η_r √(I_r k_r) while |M| is below its limit μ_r R* F_N       (Washino et al. 2024, eqs 42–47)
///     epsd2: dM = k_r dθ with k_r = 8G* y² R*² (linear contact: k_t R*²), limited to μ_r R* F_N   (Hu 2024, eqs 2.47–2.50)
///     sds:   M = k_r R*² θ + γ_r R*² θ̇, spring and dashpot limited to μ_r R* F_N (LAMMPS' `rolling sds`, after Luding 2008)
///     ar:    M = 4F_po R* (a/a_0)^{3/2} θ = 4√(πγE*) R* y³ θ, limited by |θ| ≤ θ_max      (Washino et al. 2024, eqs 48–53)
template <class T>
struct RollingOf {
  RollingModel model = RollingModel::none;
  bool linear = false;  ///< k_r does not depend on the contact
  T stiffness = 0;      ///< k_r, or what multiplies y² (y³ for `ar`) in it
  T dashpot = 0;        ///< what multiplies √k_r; γ_r R*² of `sds`
  T limit = 0;          ///< μ_r R*, or θ_max

  /// `adhesive_rolling` multiplies the torque of `ar`: a scaling law may ask for it.
  [[nodiscard]] static RollingOf make(const SurfaceKind& kind, const ContactKind& contact, const NormalPair& pair,
                                      const SurfacePair& surfaces, double adhesive_rolling) {
    const double square = pair.radius * pair.radius, mu = surfaces.rolling_friction;
    RollingOf law{.model = kind.rolling, .linear = contact.traits().constant_spring, .limit = mu * pair.radius};
    switch (kind.rolling) {
      case RollingModel::none:
      case RollingModel::cdt: break;
      case RollingModel::epsd:
        law.stiffness = 2.25 * mu * mu * square * (law.linear ? pair.spring_constant : 4.0 / 3 * pair.young);
        law.dashpot = 2 * surfaces.rolling_damping * std::sqrt(surfaces.rolling_inertia);
        break;
      case RollingModel::epsd2: law.stiffness = square * (law.linear ? surfaces.spring_constant_tangential : 8 * surfaces.shear); break;
      case RollingModel::ar:
        law.stiffness = adhesive_rolling * 4 * std::sqrt(std::numbers::pi * surfaces.surface_energy * pair.young) * pair.radius;
        law.limit = surfaces.rolling_angle_max;
        break;
      case RollingModel::sds:
        law.stiffness = surfaces.rolling_spring_constant * square;
        law.dashpot = surfaces.rolling_dashpot * square;
        break;
    }
    return law;
  }

  [[nodiscard]] bool acts() const { return model != RollingModel::none && limit > 0; }
  /// Without a spring the torque at zero spin is whatever balances the rest, up to the limit.
  [[nodiscard]] bool rigid() const { return model == RollingModel::cdt; }
  /// Does its spring vanish with the overlap?
  [[nodiscard]] bool on_overlap() const { return !linear && (model == RollingModel::epsd || model == RollingModel::epsd2); }

  /// Spring, dashpot and limit at a point of the contact.
  [[nodiscard]] SliderLawOf<T> at(const ContactPointOf<T>& point) const {
    using std::sqrt;
    if (model == RollingModel::ar) {
      const T y = point.root, k = stiffness * y * y * y;
      return {.stiffness = k, .limit = k * limit};
    }
    SliderLawOf<T> law{.stiffness = stiffness, .damping = dashpot, .limit = limit * point.load};
    law.dashpot_is_limited = model == RollingModel::sds;
    if (model == RollingModel::sds) return law;
    law.incremental = true;
    if (rigid()) return law;
    const T y = linear ? T(1) : point.overlap_root;
    law.stiffness = stiffness * y * y;
    law.damping = dashpot * sqrt(stiffness) * y;
    return law;
  }
  /// The same with the rates of change that the exact engines ask for; `rate` holds the point's.
  [[nodiscard]] SliderLawOf<T> at(const ContactPointOf<T>& point, const ContactPointOf<T>& rate) const {
    SliderLawOf<T> law = at(point);
    if (model == RollingModel::ar) {
      law.stiffness_rate = 3 * stiffness * point.root * point.root * rate.root;
      law.limit_rate = law.stiffness_rate * limit;
    } else {
      law.limit_rate = limit * rate.load;
    }
    return law;
  }

  /// The same law of another scalar, its numbers given by `value`, a function of a pointer to member of Rolling.
  template <class Value>
  [[nodiscard]] static RollingOf from(const RollingOf<double>& form, Value value) {
    using Source = RollingOf<double>;
    return {form.model, form.linear, value(&Source::stiffness), value(&Source::dashpot), value(&Source::limit)};
  }
};
using Rolling = RollingOf<double>;

}  // namespace scalebreak
