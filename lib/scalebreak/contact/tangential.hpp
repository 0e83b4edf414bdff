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
template <class T>
struct TangentialOf {
  TangentialModel model = TangentialModel::none;
  bool on_overlap = false;  ///< y = (R*δ)^{1/4} rather than √a
  T stiffness = 0;          ///< k_t, or 8G*
  T dashpot = 0;            ///< η_t, or what multiplies y in it
  T friction = 0;           ///< μ_s

  [[nodiscard]] static TangentialOf make(const SurfaceKind& kind, const NormalPair& pair, const SurfacePair& surfaces) {
    const bool linear = kind.tangential == TangentialModel::linear;
    TangentialOf law{.model = kind.tangential,
                     .on_overlap = kind.tangential_radius == DampingOn::overlap,
                     .stiffness = linear ? surfaces.spring_constant_tangential : 8 * surfaces.shear,
                     .friction = surfaces.sliding_friction};
    law.dashpot = linear ? 2 * pair.damping_ratio * std::sqrt(pair.mass * law.stiffness)
                         : 4 * std::sqrt(5.0 / 3) * pair.damping_ratio * std::sqrt(pair.mass * surfaces.shear);
    return law;
  }

  [[nodiscard]] bool acts() const { return model != TangentialModel::none && friction > 0; }

  /// Spring, dashpot and limit at a point of the contact.
  [[nodiscard]] SliderLawOf<T> at(const ContactPointOf<T>& point) const {
    SliderLawOf<T> law{.stiffness = stiffness, .damping = dashpot, .limit = friction * point.load, .dashpot_is_limited = true};
    if (model == TangentialModel::linear) return law;
    const T y = on_overlap ? point.overlap_root : point.root;
    law.stiffness *= y * y;
    law.damping *= y;
    return law;
  }
  /// The same with their rates of change; `rate` holds the point's.
  [[nodiscard]] SliderLawOf<T> at(const ContactPointOf<T>& point, const ContactPointOf<T>& rate) const {
    SliderLawOf<T> law = at(point);
    law.limit_rate = friction * rate.load;
    if (model == TangentialModel::linear) return law;
    const T y = on_overlap ? point.overlap_root : point.root, y_rate = on_overlap ? rate.overlap_root : rate.root;
    law.stiffness_rate = 2 * stiffness * y * y_rate;
    law.damping_rate = dashpot * y_rate;
    return law;
  }

  /// The same law of another scalar, its numbers given by `value`, a function of a pointer to member of Tangential.
  template <class Value>
  [[nodiscard]] static TangentialOf from(const TangentialOf<double>& form, Value value) {
    using Source = TangentialOf<double>;
    return {form.model, form.on_overlap, value(&Source::stiffness), value(&Source::dashpot), value(&Source::friction)};
  }
};
using Tangential = TangentialOf<double>;

}  // namespace scalebreak
