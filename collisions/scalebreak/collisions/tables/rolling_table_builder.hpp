#pragma once

#include <functional>
#include <optional>
#include <string>

#include <scalebreak/collisions/oblique/oblique_collision.hpp>
#include <scalebreak/scene/input.hpp>
#include <scalebreak/table/rolling_table.hpp>

namespace scalebreak {

/// The key of a pair's rolling under its laws, or why no table serves it: a sentence. `inertia` is 1/I₁ + 1/I₂ [1/(kg m²)];
/// `adhesive_rolling` multiplies the torque of `ar`, as in contact_laws.
struct RollingKeyOrReason {
  std::optional<RollingKey> key;
  std::string reason;
};
[[nodiscard]] RollingKeyOrReason rolling_key(const ContactKind& kind, const SurfaceKind& surface, const NormalPair& pair,
                                             const SurfacePair& surfaces, double inertia, double tolerance, double adhesive_rolling = 1);

/// Of an input's pair, original system.
[[nodiscard]] RollingKeyOrReason rolling_key(const Input& input, double tolerance);

/// What a table says, resolved exactly: at v̂ (1 without adhesion) and χ > 0.
[[nodiscard]] double exact_rolling_entry(const RollingKey& key, double speed, double ratio, double tolerance);

/// Builds and measures a table. The same for any number of threads. Throws WorkError where it would grow beyond its bounds.
[[nodiscard]] RollingTable build_rolling_table(const RollingKey& key, int threads, const std::function<void(double)>& progress = {});

}  // namespace scalebreak
