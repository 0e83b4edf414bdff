#pragma once

namespace scalebreak::dem {

/// How far beyond touch pairs are kept: as neighbours, and of those as near pairs that are tested at every step [m].
struct Skins {
  double neighbours = 0, near = 0;
};

/// The skins that cost least, by the number of neighbours a layer holds (12 φ χ pairs per sphere and diameter of skin) and how fast a gap
/// can close: `travel` [m] per step. Costs in cycles, measured: a test 8, a sphere's neighbours anew 300.
[[nodiscard]] Skins best_skins(double diameter, double volume_fraction, double travel);

}  // namespace scalebreak::dem
