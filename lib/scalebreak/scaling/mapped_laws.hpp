#pragma once

#include <array>

#include <scalebreak/contact/contact_laws.hpp>
#include <scalebreak/scaling/scaled_pair.hpp>

namespace scalebreak {

/// All laws between two bodies, evaluated at the variables of the ORIGINAL pair, and what turns the answer into the
/// scaled pair's. Without a direct-force law all factors are 1.
struct MappedLaws {
  ContactLaws laws;
  double length = 1;                      ///< original over scaled overlap, gap and time
  double spin = 1;                        ///< original over scaled spin
  double force = 1, torque = 1;           ///< scaled over original
  std::array<double, 2> radius = {0, 0};  ///< of the original spheres [m]
};

/// The laws of one pair of bodies under a scaling law; a fixed one counts as infinitely heavy.
[[nodiscard]] MappedLaws mapped_laws(const ContactKind& contact, const SurfaceKind& surface, const Bodies& original, const ScalingLaw& law,
                                     double factor, std::array<bool, 2> fixed = {false, false});

}  // namespace scalebreak
