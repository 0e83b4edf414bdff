#pragma once

#include <functional>
#include <optional>
#include <string>

#include <scalebreak/collisions/oblique/oblique_collision.hpp>
#include <scalebreak/scene/input.hpp>
#include <scalebreak/table/oblique_table.hpp>

namespace scalebreak {

/// The key of a pair under its laws, or why no table serves it: a sentence. `inertia` is m*(r₁²/I₁ + r₂²/I₂).
struct ObliqueKeyOrReason {
  std::optional<ObliqueKey> key;
  std::string reason;
};
[[nodiscard]] ObliqueKeyOrReason oblique_key(const ContactKind& kind, const SurfaceKind& surface, const NormalPair& pair,
                                             const SurfacePair& surfaces, double inertia, double share, double tolerance);

/// Of an input's pair, original system.
[[nodiscard]] ObliqueKeyOrReason oblique_key(const Input& input, double tolerance);
/// m*(r₁²/I₁ + r₂²/I₂) of solid spheres of any sizes.
inline constexpr double solid_sphere_inertia = 2.5;

/// A pair with the numbers of a key in reduced units (see contact/reduced.hpp; R* = m* = 1). `depth` is the overlap unit over the distance of the
/// centres; 0: the normal never turns.
[[nodiscard]] ObliquePair reduced_oblique_pair(const ObliqueKey& key, double depth);

/// What a table says, resolved exactly: at v̂ (1 without adhesion) and ψ > 0.
[[nodiscard]] ObliqueEntry exact_oblique_entry(const ObliqueKey& key, double speed, double ratio, double tolerance);
[[nodiscard]] TurningEntry exact_turning_entry(const ObliqueKey& key, double speed, double ratio);

/// Builds and measures a table. The same for any number of threads. Throws WorkError where it would grow beyond its bounds.
[[nodiscard]] ObliqueTable build_oblique_table(const ObliqueKey& key, int threads, const std::function<void(double)>& progress = {});

}  // namespace scalebreak
