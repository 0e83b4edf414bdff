#pragma once

#include <array>
#include <string>
#include <vector>

#include <scalebreak/ensembles/prediction/scale_groups.hpp>
#include <scalebreak/measure/flow_result.hpp>

namespace scalebreak {

// How far a law is off what it claims to keep, from the dimensionless groups of the original (o) and the scaled flow (s) alone. Of each quantity,
// with x contact time × collision rate, w impact speed over sticking speed, l the size factor:
//
//     ln(value / claim) = n c ln l + a₁ ln((1 + x_s)/(1 + x_o)) + a₂ (k_s − k_o) + a₃ q ln l + a₄ ln((1 + w_s⁻²)/(1 + w_o⁻²))
//
// The first term has no coefficient to fit: at constant volume all speeds of a sheared flow of hard spheres are γ̇d times numbers, so that
// temperature and stress grow as l², and a collision rate that was to fall as 1/l stays; c is the share of the pressure that collisions carry.

/// A term with a fitted coefficient.
struct DeviationTerm {
  const char *name, *mechanism, *what;
};
inline constexpr DeviationTerm deviation_terms[] = {
    {"contact_time", "contact time", "ln of 1 + contact time x collision rate, over the original's"},
    {"crowding", "contact time", "contact time x collision rate x solids beyond a fluid's, beside the original's"},
    {"torque", "torque of a direct-force law", "powers of the size by which the torque falls short, x ln of the size"},
    {"sticking", "adhesion", "ln of 1 + sticking speed / impact speed, over the original's"},
};
inline constexpr std::size_t term_count = std::size(deviation_terms);
using Terms = std::array<double, term_count>;
[[nodiscard]] Terms terms_of(const ScaleGroups& original, const ScaleGroups& scaled);

/// ln(value / claim) of a flow of hard spheres that are l times larger: n c ln l.
[[nodiscard]] double size_term(double size_excess, const ScaleGroups& scaled);
/// Beyond this share of the impact speed that sticks, a flow gathers into lumps, of which no term knows.
inline constexpr double lumps_beyond = 0.1;
/// Above 0 where a flow is beyond what contact laws (overlaps of deep_overlap) or the prediction (lumps_beyond) are meant for, by how much of it. A gas that cools
/// is held to lumps_beyond where it sticks more than its original.
[[nodiscard]] double beyond_model(const ScaleGroups& original, const ScaleGroups& scaled);

/// What is predicted: temperature, rotational energy, collision rate, pressure and shear stress. The volume fraction that a pressure leads to is
/// judged by studies and not predicted.
[[nodiscard]] const std::vector<std::string>& predicted_quantities();

/// n of such a quantity: 2, of the collision rate 1.
[[nodiscard]] double size_excess(const std::string& quantity);

/// The model of one quantity, fitted.
struct QuantityModel {
  std::string quantity;
  Terms coefficients{};
  std::array<bool, term_count> fitted{};  ///< false: no cell told, and the coefficient is 0
  std::array<std::array<double, term_count>, term_count> covariance{};
  double scatter = 0;  ///< by how much of itself each part of the logarithm is off, beside the errors of what it was fitted to
};

/// What a model says: the deviation (value / claim − 1), its standard error, and each part of ln(value / claim).
struct Prediction {
  Measured deviation;
  double size = 0;  ///< its part
  Terms parts{};    ///< those of the terms
};
[[nodiscard]] Prediction predict(const QuantityModel& model, const ScaleGroups& original, const ScaleGroups& scaled);

}  // namespace scalebreak
