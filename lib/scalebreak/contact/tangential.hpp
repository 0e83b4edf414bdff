#pragma once

#include <cmath>

#include <scalebreak/contact/contact_point.hpp>
#include <scalebreak/contact/slider.hpp>
#include <scalebreak/contact/surface_kind.hpp>
#include <scalebreak/material/pair.hpp>

namespace scalebreak {

/// Sliding friction: a spring k_t ξ and a dashpot η_t v_s whose sum is limited to μ_s F_N.
///
///     linear:  k_t = const,  η_t = 2β√(m* k_t)                                (Washino et al. 2024, eqs 6 and 70)
///     Mindlin: k_t = 8G* y²,  η_t = 4√(5/3) β √(m*G*) y,  y = √a or (R*δ)^{1/4}  (eqs 11 and 16; Chen & Elliott, eq. 19)
struct Tangential {
  TangentialModel model = TangentialModel::none;
  bool on_overlap = false;  ///< y = (R*δ)^{1/4} rather than √a
  double stiffness = 0;     ///< k_t, or 8G*
  double dashpot = 0;       ///< η_t, or what multiplies y in it
  double friction = 0;      ///< μ_s

  [[nodiscard]] static Tangential make(const SurfaceKind& kind, const NormalPair& pair, const SurfacePair& surfaces) {
    const bool linear = kind.tangential == TangentialModel::linear;
    Tangential law{.model = kind.tangential,
                   .on_overlap = kind.tangential_radius == DampingOn::overlap,
                   .stiffness = linear ? surfaces.spring_constant_tangential : 8 * surfaces.shear,
                   .friction = surfaces.sliding_friction};
    law.dashpot = linear ? 2 * pair.damping_ratio * std::sqrt(pair.mass * law.stiffness)
                         : 4 * std::sqrt(5.0 / 3) * pair.damping_ratio * std::sqrt(pair.mass * surfaces.shear);
    return law;
  }

  [[nodiscard]] bool acts() const { return model != TangentialModel::none && friction > 0; }

  /// Spring, dashpot and limit at a point of the contact; `rate` holds the point's rates of change.
  [[nodiscard]] SliderLaw at(const ContactPoint& point, const ContactPoint& rate) const {
    SliderLaw law{.limit = friction * point.load, .limit_rate = friction * rate.load, .dashpot_is_limited = true};
    if (model == TangentialModel::linear) {
      law.stiffness = stiffness;
      law.damping = dashpot;
    } else {
      const double y = on_overlap ? point.overlap_root : point.root;
      law.stiffness = stiffness * y * y;
      law.damping = dashpot * y;
      law.stiffness_rate = 2 * stiffness * y * (on_overlap ? rate.overlap_root : rate.root);
      law.damping_rate = dashpot * (on_overlap ? rate.overlap_root : rate.root);
    }
    return law;
  }
};

}  // namespace scalebreak
