#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/collisions/normal/normal_collision.hpp>
#include <scalebreak/collisions/normal/reference_collision.hpp>
#include <scalebreak/contact/damping.hpp>

#include "collisions/kinds.hpp"

namespace scalebreak {
namespace {

class EveryKind : public testing::TestWithParam<ContactKind> {};

/// The second method shares neither stepper, nor event location, nor (undamped) the equation of motion.
TEST_P(EveryKind, AgreesWithTheSecondMethod) {
  const ContactKind kind = GetParam();
  const std::vector<double> speeds = kind.adhesive() ? std::vector{0.3, 1.6, 4.0, 60.0} : std::vector{1.0};
  for (const double e : {1.0, 0.9, 0.5, 0.1}) {
    const double beta = damping_ratio(e);
    for (const double speed : speeds) {
      SCOPED_TRACE(testing::Message() << to_string(kind) << ", e " << e << ", speed " << speed);
      const auto exact = resolve_normal_collision<double>(kind, beta, speed, {.tolerance = 1e-13});
      const auto second = resolve_by_second_method(kind, beta, speed);
      EXPECT_EQ(exact.stuck, second.stuck);
      EXPECT_NEAR(exact.restitution, second.restitution, 1e-10);
      EXPECT_NEAR(exact.max_overlap, second.max_overlap, 1e-10 * second.max_overlap);
      if (!second.stuck) {
        EXPECT_NEAR(exact.contact_time, second.contact_time, 1e-10 * second.contact_time);
      }
    }
  }
}

/// Error over tolerance, from 1e-6 to 1e-12, against long double: the slope of the logarithms is about one.
TEST_P(EveryKind, ErrorTracksTheTolerance) {
  const ContactKind kind = GetParam();
  const double beta = damping_ratio(0.81), speed = kind.adhesive() ? 3.0 : 1.0;
  const auto reference = resolve_normal_collision<long double>(kind, beta, speed, {.tolerance = 1e-17L});
  std::vector<double> x, y;
  for (int i = 12; i <= 24; ++i) {
    const double tolerance = std::pow(10.0, -i / 2.0);
    const auto outcome = resolve_normal_collision<double>(kind, beta, speed, {.tolerance = tolerance});
    const double error = std::max({std::abs(static_cast<double>(outcome.restitution - reference.restitution)),
                                   std::abs(static_cast<double>(outcome.contact_time / reference.contact_time - 1))});
    EXPECT_LT(error, tolerance) << to_string(kind) << " at " << tolerance;
    x.push_back(std::log10(tolerance));
    y.push_back(std::log10(std::max(error, 1e-16)));
  }
  double mx = 0, my = 0, sxy = 0, sxx = 0;
  for (std::size_t i = 0; i < x.size(); ++i) mx += x[i] / static_cast<double>(x.size()), my += y[i] / static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) sxy += (x[i] - mx) * (y[i] - my), sxx += (x[i] - mx) * (x[i] - mx);
  EXPECT_GT(sxy / sxx, 0.8) << to_string(kind);
  EXPECT_LT(sxy / sxx, 1.2) << to_string(kind);
}

/// What is lost between touch and separation is the work of spring, adhesion and dashpot, by the trapezium rule along the path.
TEST_P(EveryKind, ClosesItsEnergyAccount) {
  const ContactKind kind = GetParam();
  const double beta = damping_ratio(0.7), speed = kind.adhesive() ? 2.5 : 1.0;
  std::vector<ContactSample<double>> path;
  CollisionOptions<double> options{.tolerance = 1e-12, .max_step = 1e-3};
  options.observer = [&](const ContactSample<double>& sample) { path.push_back(sample); };
  const auto outcome = resolve_normal_collision<double>(kind, beta, speed, options);
  ASSERT_FALSE(outcome.stuck);
  double work = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double before = path[i - 1].elastic_force + path[i - 1].damping_force, after = path[i].elastic_force + path[i].damping_force;
    work += (before + after) / 2 * (path[i].overlap - path[i - 1].overlap);
  }
  const double kinetic = speed * speed / 2;
  EXPECT_NEAR(kinetic - work, outcome.restitution * outcome.restitution * kinetic, 1e-5 * kinetic) << to_string(kind);
}

/// Slow collisions leave the small difference of large energies: what comes out still tracks the tolerance, and never exceeds
/// what went in.
TEST_P(EveryKind, IsAsExactForSlowImpacts) {
  const ContactKind kind = GetParam();
  if (!kind.adhesive() || kind.range != AdhesionRange::touch) return;  // the others stick
  for (const double speed : {0.3, 0.03, 3e-3}) {
    const auto undamped = resolve_normal_collision<double>(kind, 0.0, speed, {.tolerance = 1e-8});
    EXPECT_NEAR(undamped.restitution, 1, 1e-14);
    const double beta = 0.05 * speed * speed;
    const auto reference = resolve_normal_collision<long double>(kind, beta, speed, {.tolerance = 1e-16L});
    ASSERT_FALSE(reference.stuck);
    for (const double tolerance : {1e-6, 1e-7, 1e-8}) {
      const auto outcome = resolve_normal_collision<double>(kind, beta, speed, {.tolerance = tolerance});
      EXPECT_NEAR(outcome.restitution, static_cast<double>(reference.restitution), tolerance) << to_string(kind) << speed;
      EXPECT_LT(outcome.restitution, 1);
    }
  }
  EXPECT_EQ(resolve_normal_collision<double>(kind, 0.0, 1e-6).restitution, 1);
  EXPECT_THROW((void)resolve_normal_collision<double>(kind, 1e-14, 1e-6), WorkError);
}

TEST_P(EveryKind, SticksAsTheRootOfTheDampingAtTouch) {
  const ContactKind kind = GetParam();
  if (!kind.adhesive() || kind.range != AdhesionRange::touch) return;
  const double share = reduced_sticking_speed<double>(kind, 1e-6) / 1e-3;
  for (const double beta : {1e-8, 1e-12, 1e-16}) EXPECT_NEAR(reduced_sticking_speed<double>(kind, beta) / std::sqrt(beta) / share, 1, 1e-5);
}

/// On both sides of the sticking speed, down to a part in 1e10: where two crossings fall into one step.
TEST_P(EveryKind, TellsStickingFromPartingNextToTheStickingSpeed) {
  const ContactKind kind = GetParam();
  if (!kind.adhesive()) return;
  for (const double e : {0.9, 0.5, 0.1}) {
    const double beta = damping_ratio(e), stick = reduced_sticking_speed(kind, beta);
    for (const double gap : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
      for (const double tolerance : {1e-6, 1e-9, 1e-13}) {
        if (gap < 20 * tolerance) continue;
        SCOPED_TRACE(testing::Message() << to_string(kind) << ", e " << e << ", gap " << gap << ", tolerance " << tolerance);
        EXPECT_TRUE(resolve_normal_collision<double>(kind, beta, stick * (1 - gap), {.tolerance = tolerance}).stuck);
        EXPECT_FALSE(resolve_normal_collision<double>(kind, beta, stick * (1 + gap), {.tolerance = tolerance}).stuck);
      }
    }
  }
}

TEST_P(EveryKind, EndsAtTheEndOfItsContact) {
  const ContactKind kind = GetParam();
  ContactSample<double> last{};
  CollisionOptions<double> options{.tolerance = 1e-10};
  options.observer = [&](const ContactSample<double>& sample) { last = sample; };
  const double speed = kind.adhesive() ? 5.0 : 1.0;
  const auto outcome = resolve_normal_collision<double>(kind, damping_ratio(0.8), speed, options);
  const double end = !kind.adhesive() || kind.range == AdhesionRange::touch ? 0.0
                     : kind.range == AdhesionRange::full                    ? -std::cbrt(1.0 / 48)
                                                                            : -std::cbrt(1.0 / 432);
  EXPECT_NEAR(last.overlap, end, 1e-9);
  EXPECT_NEAR(last.time, outcome.contact_time, 1e-15);
  EXPECT_NEAR(-last.speed / speed, outcome.restitution, 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryKind, testing::ValuesIn(all_contact_kinds()),
                         [](const auto& test) { return tests::kind_name(test.param); });

TEST(NormalCollision, OfAnOverdampedContactOnlyCreepsApart) {
  for (const NormalModel model : {NormalModel::linear, NormalModel::hertz}) {
    EXPECT_TRUE(resolve_normal_collision<double>(canonical({.normal = model}), 1.5, 1.0).stuck);
    EXPECT_TRUE(resolve_normal_collision<double>(canonical({.normal = model}), 1.0, 1.0).stuck);
  }
  EXPECT_TRUE(resolve_normal_collision<double>(ContactKind{}, 2.0, 1.0).stuck);
}

TEST(NormalCollision, RefusesNumbersThatAreNoCollision) {
  EXPECT_THROW((void)resolve_normal_collision<double>(ContactKind{}, 0.1, 0.0), WorkError);
  EXPECT_THROW((void)resolve_normal_collision<double>(ContactKind{}, 0.1, std::nan("")), WorkError);
  EXPECT_THROW((void)resolve_normal_collision<double>(ContactKind{}, -0.1, 1.0), WorkError);
}

TEST(NormalCollision, LargestForceIsThatOfTheWholeContact) {
  // A linear dashpot starts at its force: η v = 2β in reduced units, above k δ_max for strong damping.
  const auto strong =
      resolve_normal_collision<double>(canonical({.normal = NormalModel::linear}), 0.9, 1.0, {.tolerance = 1e-10, .find_max_force = true});
  EXPECT_NEAR(strong.max_force, 1.8, 1e-12);
  // Undamped it is k δ_max.
  const auto elastic =
      resolve_normal_collision<double>(canonical({.normal = NormalModel::linear}), 0.0, 1.0, {.tolerance = 1e-10, .find_max_force = true});
  EXPECT_NEAR(elastic.max_force, 1.0, 1e-9);
  // Lightly damped: kx + ηẋ = e^{−βt}(sin form), its largest value by calculus at tan(ωt) = ω(1 − 4β²)/(β(3 − 4β²)).
  const double beta = 0.1, omega = std::sqrt(1 - beta * beta);
  const double t = std::atan2(omega * (1 - 4 * beta * beta), beta * (3 - 4 * beta * beta)) / omega;
  const double x = std::exp(-beta * t) * std::sin(omega * t) / omega,
               v = std::exp(-beta * t) * (std::cos(omega * t) - beta * std::sin(omega * t) / omega);
  const auto light =
      resolve_normal_collision<double>(canonical({.normal = NormalModel::linear}), beta, 1.0, {.tolerance = 1e-10, .find_max_force = true});
  EXPECT_NEAR(light.max_force, x + 2 * beta * v, 1e-9);
}

}  // namespace
}  // namespace scalebreak
