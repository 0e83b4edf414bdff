#include <scalebreak/ensembles/tradeoff/closed_form_collision.hpp>

#include <chrono>
#include <cmath>
#include <numbers>

#include <scalebreak/contact/contact_kind.hpp>
#include <scalebreak/scaling/scaled_pair.hpp>

namespace scalebreak {
namespace {

struct HeadOn {
  double restitution = 1, contact_time = 0;
};

HeadOn linear(const NormalPair& pair) {
  const double beta = pair.damping_ratio, slowing = std::sqrt(1 - beta * beta);
  return {.restitution = std::exp(-std::numbers::pi * beta / slowing),
          .contact_time = std::numbers::pi * std::sqrt(pair.mass / pair.spring_constant) / slowing};
}

/// From m v²/2 = (8/15) E* √R* δ_max^{5/2} and ∫ dx / √(1 − x^{5/2}) from 0 to 1 = (2/5) B(2/5, 1/2).
HeadOn elastic_hertz(const NormalPair& pair, double speed) {
  const double deepest = std::pow(15 * pair.mass * speed * speed / (16 * pair.young * std::sqrt(pair.radius)), 0.4);
  return {.contact_time = 0.8 * std::beta(0.4, 0.5) * deepest / speed};
}

bool head_on(const MovingScene& scene) {
  const Eigen::Vector3d velocity = scene.bodies[0].velocity - scene.bodies[1].velocity;
  return velocity.head<2>().isZero(0) && scene.bodies[0].spin.isZero(0) && scene.bodies[1].spin.isZero(0);
}

CollisionOutcome parted(const CollisionScene& scene, const ScaledPair& scaled, bool is_linear) {
  const auto began = std::chrono::steady_clock::now();
  CollisionOutcome outcome{.bodies = scene.moving.bodies, .force_evaluations = 1};
  MovingBody &first = outcome.bodies[0], &second = outcome.bodies[1];
  const Eigen::Vector3d velocity = first.velocity - second.velocity;
  const HeadOn found = is_linear ? linear(scaled.pair) : elastic_hertz(scaled.pair, velocity.norm());
  outcome.contact_time = scaled.time * found.contact_time;
  const Eigen::Vector3d impulse = -(1 + found.restitution) / (1 / first.mass + 1 / second.mass) * velocity;
  first.velocity += impulse / first.mass, second.velocity -= impulse / second.mass;
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return outcome;
}

}  // namespace

PreparedCollision closed_form_collision(const CollisionScene& scene) {
  if (!scene.is_pair() || !scene.has_parted() || !head_on(scene.moving))
    return {.refusal = "formulas are of pairs that meet head-on without spin, and part"};
  const Input& input = scene.input;
  const ScaledPair scaled =
      scaled_pair(*find_scaling_law(input.scaling_law), input.scaling_factor, input.colliding(), input.contact.normal);
  const NormalModel model = effective_kind(input.contact, scaled.pair.surface_energy).normal;
  const bool is_linear = model == NormalModel::linear, elastic = model == NormalModel::hertz && scaled.pair.damping_ratio == 0;
  if ((!is_linear && !elastic) || input.surface.attraction != Attraction::none)
    return {.refusal = "formulas are of linear contacts and of elastic Hertz contacts, without liquid"};
  return {.resolve = [&scene, scaled, is_linear](double, double) { return parted(scene, scaled, is_linear); }};
}

}  // namespace scalebreak
