#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <boost/numeric/odeint.hpp>

#include <scalebreak/collisions/normal/pair_collision.hpp>
#include <scalebreak/contact/reduced.hpp>

// Scaling laws on one pair: those that are exact leave e(v/v_stick) alone, and a direct-force law does what its equation of
// motion, integrated as it is written, does.

namespace scalebreak {
namespace {

Bodies glass() { return {{}, {}, {}, {0.5e-3, 0.7e-3}}; }

ScaledContact contact(const char* law, double factor, const ContactKind& kind = {}) {
  return {kind, glass(), *find_scaling_law(law), factor};
}

struct Exact {
  const char* law;
  double factor, length, time;
};

class ExactLaw : public testing::TestWithParam<Exact> {};

TEST_P(ExactLaw, KeepsTheCollisionAndScalesLengthAndTime) {
  const Exact& p = GetParam();
  for (const auto range : {AdhesionRange::full, AdhesionRange::pull_off, AdhesionRange::touch}) {
    for (const auto damping : {DampingOn::contact_radius, DampingOn::overlap}) {
      const ContactKind kind{NormalModel::jkr, range, damping};
      const ScaledContact original = contact("none", 1, kind), scaled = contact(p.law, p.factor, kind);
      const double stick = *original.sticking_speed(1e-12);
      EXPECT_NEAR(*scaled.sticking_speed(1e-12) / stick, 1, 1e-9);
      for (const double ratio : {1.1, 2.0, 20.0, 300.0}) {
        const PairCollision a = original.collide(ratio * stick, 1e-11), b = scaled.collide(ratio * stick, 1e-11);
        EXPECT_NEAR(b.restitution, a.restitution, 1e-9);
        EXPECT_NEAR(*b.contact_time / *a.contact_time / p.time, 1, 1e-9);
        EXPECT_NEAR(b.max_overlap / a.max_overlap / p.length, 1, 1e-9);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, ExactLaw,
                         testing::Values(Exact{"rps", 1e-2, std::pow(1e-2, -0.4), std::pow(1e-2, -0.4)},
                                         Exact{"rps", 1e-6, std::pow(1e-6, -0.4), std::pow(1e-6, -0.4)}, Exact{"sup", 2, 2, 2},
                                         Exact{"sup", 16, 16, 16}, Exact{"torque_cubed", 4, 4, 4}, Exact{"sakai", 8, 1, 1},
                                         Exact{"chen_elliott", 2, 1, 1}, Exact{"chen_elliott", 8, 1, 1}, Exact{"thakur", 4, 4, 4}),
                         [](const auto& test) { return fmt::format("{}_{}", test.param.law, test.index); });

/// Any law that changes only the material leaves e(v/v_stick) alone, even where it moves v_stick.
TEST(ParameterLaw, KeepsRestitutionAtEqualSpeedOverStickingSpeed) {
  const ScaledContact original = contact("none", 1);
  const double stick = *original.sticking_speed(1e-12);
  for (const auto& [law, factor, power] :
       {std::tuple{"none", 1e-4, -1.0 / 3}, {"none", 8.0, -5.0 / 6}, {"bond", 4.0, 5.0 / 6}, {"cohesion", 4.0, 0.5}}) {
    const ScaledContact scaled = contact(law, factor);
    const double scaled_stick = *scaled.sticking_speed(1e-12);
    EXPECT_NEAR(scaled_stick / stick / std::pow(factor, power), 1, 1e-9) << law;
    for (const double ratio : {1.05, 3.0, 100.0})
      EXPECT_NEAR(scaled.collide(ratio * scaled_stick, 1e-11).restitution, original.collide(ratio * stick, 1e-11).restitution, 1e-9) << law;
  }
}

/// m_S dv/dt = −l^p F_O(δ_S/l^q, v) stepped in time and overlap, as a soft-sphere program would, with the ORIGINAL's dashpot.
PairCollision by_brute_force(double l, double q, double p, double speed, double restitution) {
  Bodies bodies = glass();
  bodies.first.restitution = bodies.second.restitution = restitution;
  const NormalPair original = bodies.pair();
  for (double& r : bodies.radius) r *= l;
  const double scaled_mass = bodies.pair().mass;
  const auto law = Hertz<double>::make(original, AdhesionRange::touch);
  using State = std::array<double, 2>;
  const auto motion = [&](const State& y, State& rate, double) {
    const double overlap = std::max(y[0], 0.0) / std::pow(l, q), x = law.coordinate(overlap);
    rate = {y[1], -std::pow(l, p) * (law.force(x) + law.damping(x) * y[1]) / scaled_mass};
  };
  State y{0, speed};
  PairCollision result;
  boost::numeric::odeint::runge_kutta_fehlberg78<State> stepper;
  const double h = Hertz<double>::scales(original, speed).time * std::pow(l, q) / 4000;
  for (double t = 0;; t += h) {
    const State before = y;
    stepper.do_step(motion, y, t, h);
    result.max_overlap = std::max(result.max_overlap, y[0]);
    if (y[0] > 0) continue;
    const double share = before[0] / (before[0] - y[0]);
    result.contact_time = t + share * h;
    result.restitution = -(before[1] + share * (y[1] - before[1])) / speed;
    return result;
  }
}

TEST(DirectForceLaw, DoesWhatItsEquationOfMotionDoes) {
  for (const auto& [law, q, p] : {std::tuple{"sup", 1.0, 2.0},
                                  {"overlap_kept", 0.0, 2.0},
                                  {"force_cubed", 1.0, 3.0},
                                  {"sakai", 0.0, 3.0},
                                  {"torque_cubed", 1.0, 2.0}}) {
    Bodies bodies = glass();
    bodies.first.restitution = bodies.second.restitution = 0.7;
    const ScaledContact contact(canonical({.normal = NormalModel::hertz}), bodies, *find_scaling_law(law), 3);
    const PairCollision reduced = contact.collide(0.4, 1e-11), brute = by_brute_force(3, q, p, 0.4, 0.7);
    EXPECT_NEAR(reduced.restitution, brute.restitution, 1e-5) << law;
    EXPECT_NEAR(*reduced.contact_time / *brute.contact_time, 1, 1e-5) << law;
    EXPECT_NEAR(reduced.max_overlap / brute.max_overlap, 1, 1e-5) << law;
  }
}

/// Force and momentum: the impulse of the scaled pair is its mass times its change of speed.
TEST(DirectForceLaw, ImpulseIsMassTimesChangeOfSpeed) {
  for (const char* law : {"sup", "overlap_kept", "force_cubed", "sakai", "chen_elliott", "rps"}) {
    const double factor = std::string(law) == "rps" ? 0.01 : 4;
    const ScaledContact scaled = contact(law, factor);
    const double speed = 0.05;
    const auto path = scaled.trajectory(speed, 1e-11, 4000);
    double impulse = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
      impulse += (path[i].elastic_force + path[i].damping_force + path[i - 1].elastic_force + path[i - 1].damping_force) / 2 *
                 (path[i].time - path[i - 1].time);
    }
    const double mass = scaled_bodies(*find_scaling_law(law), factor, glass(), NormalModel::jkr).pair().mass;
    EXPECT_NEAR(impulse / (mass * speed * (1 + scaled.collide(speed, 1e-11).restitution)), 1, 1e-5) << law;
  }
}

}  // namespace
}  // namespace scalebreak
