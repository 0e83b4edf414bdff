#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <scalebreak/contact/damping.hpp>
#include <scalebreak/contact/reduced.hpp>

// The laws against their textbook forms, written here once more from the papers, and against each other.

namespace scalebreak {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double radius = 0.25e-3, young = 5.3e9, surface_energy = 0.02, mass = 6.5e-7, beta = 0.07;

constexpr NormalPair pair{
    .mass = mass, .radius = radius, .young = young, .surface_energy = surface_energy, .spring_constant = 8.1e4, .damping_ratio = beta};

Jkr<double> jkr(AdhesionRange range = AdhesionRange::full) { return Jkr<double>::make(pair, range); }

TEST(JkrLaw, IsTheTextbookForceAndOverlapOfTheContactRadius) {
  for (const double a : {1e-7, 3e-6, 2e-5}) {
    const double x = std::sqrt(a);
    const double force = 4 * young * a * a * a / (3 * radius) - 4 * std::sqrt(pi * surface_energy * young * a * a * a);
    EXPECT_NEAR(jkr().force(x), force, 1e-12 * std::abs(force));
    const double overlap = a * a / radius - std::sqrt(4 * pi * surface_energy * a / young);
    EXPECT_NEAR(jkr().overlap(x), overlap, 1e-12 * std::abs(overlap));
    EXPECT_NEAR(jkr().damping(x), 2 * std::sqrt(5.0 / 3) * beta * std::sqrt(mass * young * a), 1e-12 * jkr().damping(x));
  }
}

TEST(JkrLaw, DampingOnTheOverlapIsTsujisAndStopsAtZeroOverlap) {
  const auto law = JkrOnOverlap<double>::make(pair, AdhesionRange::full);
  const double overlap = 3e-7;
  const double tsuji = 2 * std::sqrt(5.0 / 3) * beta * std::sqrt(mass * young) * std::pow(radius * overlap, 0.25);
  EXPECT_NEAR(law.damping(law.coordinate(overlap)), tsuji, 1e-9 * tsuji);
  EXPECT_NEAR(law.damping_of_root(std::pow(overlap, 0.25)), tsuji, 1e-12 * tsuji);
  EXPECT_EQ(law.damping(law.fold()), 0);
}

/// F/F_po, δ/(π²γ²R/E²)^{1/3}, a³E/(πγR²) of a point.
void expect_point(double x, double force, double overlap, double cube) {
  const double unit = std::cbrt(pi * pi * surface_energy * surface_energy * radius / (young * young));
  EXPECT_NEAR(jkr().force(x) / (3 * pi * surface_energy * radius), force, 1e-12);
  EXPECT_NEAR(jkr().overlap(x) / unit, overlap, 1e-12);
  EXPECT_NEAR(std::pow(x, 6) * young / (pi * surface_energy * radius * radius), cube, 1e-12);
}

TEST(JkrLaw, PassesThroughThePointsOfChenAndElliottsTable2) {
  expect_point(jkr().pull_off(), -1, -std::cbrt(3.0 / 16), 9.0 / 4);
  expect_point(jkr().fold(), -5.0 / 9, -std::cbrt(27.0 / 16), 1.0 / 4);
  expect_point(jkr().touch(), -8.0 / 9, 0, 4);
  const double equilibrium = std::pow(9 * pi * surface_energy * radius * radius / young, 1.0 / 6);
  expect_point(equilibrium, 0, std::cbrt(3.0), 9);
}

TEST(JkrLaw, EndsWhereItsRangeSays) {
  EXPECT_EQ(jkr(AdhesionRange::full).separation(), jkr().fold());
  EXPECT_EQ(jkr(AdhesionRange::pull_off).separation(), jkr().pull_off());
  EXPECT_EQ(jkr(AdhesionRange::touch).separation(), jkr().touch());
  EXPECT_NEAR(jkr().overlap_slope(jkr().fold()), 0, 1e-12 * jkr().overlap_slope(jkr().touch()));
}

TEST(JkrLaw, PeelingWorkIsThatOfThePapers) {
  const double peeling = 22.5163187 * std::cbrt(std::pow(surface_energy, 5) * std::pow(radius, 4) / (young * young));
  EXPECT_NEAR(jkr().energy(jkr().fold()) / peeling, 1, 1e-8);
  EXPECT_NEAR(jkr().energy(jkr().fold()) / (3 * pi * surface_energy * radius * -jkr().overlap(jkr().fold())), 0.9355028, 1e-7);
  EXPECT_NEAR(jkr().energy(jkr().pull_off()) / jkr().energy(jkr().fold()), 0.4939, 5e-5);
}

/// The root against long double: Newton's iteration on the quartic from the double's answer.
TEST(JkrLaw, ContactRadiusOfAnOverlapIsExactFromTheFoldToAMillionEquilibria) {
  const auto law = reduced_law<JkrOnRadius>(0.0, AdhesionRange::full);
  const auto exact = reduced_law<JkrOnRadius>(0.0L, AdhesionRange::full);
  const long double fold = exact.overlap(exact.fold()), equilibrium = exact.overlap(1.0L);
  const auto expect_root = [&](long double overlap) {
    const double x = law.coordinate(static_cast<double>(overlap));
    long double better = std::max<long double>(x, exact.fold() * (1 + 1e-9L));
    for (int i = 0; i < 60; ++i) better -= (exact.overlap(better) - static_cast<double>(overlap)) / exact.overlap_slope(better);
    EXPECT_NEAR(x * x / static_cast<double>(better * better), 1, 1e-10) << "at overlap " << static_cast<double>(overlap);
  };
  for (long double gap = 1e-8L; gap < 0.99L; gap *= 1.7L) expect_root(fold * (1 - gap));
  expect_root(0);
  for (long double ratio = 1e-9L; ratio <= 1e6L; ratio *= 1.9L) expect_root(ratio * equilibrium);
  expect_root(1e6L * equilibrium);
}

TEST(JkrLaw, EnergyIsTheIntegralOfTheForce) {
  const double low = jkr().fold(), high = 4 * jkr().touch();
  const int count = 20000;
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    const double x = low + (high - low) * (i + 0.5) / count;
    sum += jkr().force(x) * jkr().overlap_slope(x) * (high - low) / count;
  }
  EXPECT_NEAR(sum / (jkr().energy(high) - jkr().energy(low)), 1, 1e-7);
}

TEST(HertzLaw, IsTheTextbookForceDampingAndEnergyOfTheOverlap) {
  const auto law = Hertz<double>::make(pair, AdhesionRange::touch);
  const double overlap = 2.3e-7, x = law.coordinate(overlap);
  EXPECT_NEAR(law.overlap(x) / overlap, 1, 1e-14);
  EXPECT_NEAR(law.force(x) / (4.0 / 3 * young * std::sqrt(radius) * std::pow(overlap, 1.5)), 1, 1e-13);
  EXPECT_NEAR(law.damping(x) / (2 * std::sqrt(5.0 / 3) * beta * std::sqrt(mass * young) * std::pow(radius * overlap, 0.25)), 1, 1e-13);
  EXPECT_NEAR(law.energy(x) / (8.0 / 15 * young * std::sqrt(radius) * std::pow(overlap, 2.5)), 1, 1e-13);
}

TEST(LinearLaw, DampingIsWashinosEquation8) {
  const double e = 0.7;
  NormalPair damped = pair;
  damped.damping_ratio = damping_ratio(e);
  const auto law = Linear<double>::make(damped, AdhesionRange::touch);
  EXPECT_NEAR(law.damping(0) / std::sqrt(4 * mass * pair.spring_constant / (1 + std::pow(pi / std::log(e), 2))), 1, 1e-14);
}

TEST(DampingRatio, IsInvertedByItsInverse) {
  for (const double e : {0.05, 0.3, 0.81, 0.999, 1.0}) EXPECT_NEAR(restitution_of_damping_ratio(damping_ratio(e)), e, 1e-14);
}

TEST(ReducedVariables, TurnAPairIntoTheReducedLaw) {
  const auto scales = Jkr<double>::scales(pair, 1.0);
  const auto reduced = reduced_law<JkrOnRadius>(beta, AdhesionRange::full);
  for (const double x : {0.6, 1.0, 2.5}) {
    const double physical = x * scales.coordinate;
    EXPECT_NEAR(jkr().overlap(physical) / scales.overlap, reduced.overlap(x), 1e-12);
    EXPECT_NEAR(jkr().force(physical) / scales.force, reduced.force(x), 1e-11);
    EXPECT_NEAR(jkr().damping(physical) * scales.speed() / scales.force, reduced.damping(x), 1e-12);
    // The equation itself: δ̂ = â² − (2/3)√â, force 4(â³ − â^{3/2}), D = 2√5 β √â.
    const double a = x * x;
    EXPECT_NEAR(reduced.overlap(x), a * a - 2.0 / 3 * std::sqrt(a), 1e-13);
    EXPECT_NEAR(reduced.force(x), 4 * (a * a * a - std::pow(a, 1.5)), 1e-11);
    EXPECT_NEAR(reduced.damping(x), 2 * std::sqrt(5.0) * beta * std::sqrt(a), 1e-13);
  }
}

TEST(ReducedVariables, UnitImpactHasTheReducedSpeedItIsAskedFor) {
  for (const double speed : {0.5, 3.0, 1e4}) {
    const NormalPair fast = Jkr<double>::pair_of_unit_impact(beta, speed);
    EXPECT_NEAR(1 / Jkr<double>::scales(fast, 1.0).speed() / speed, 1, 1e-13);
  }
}

TEST(ContactKind, IsOneNameForOnePhysics) {
  const ContactKind jkr_kind{NormalModel::jkr, AdhesionRange::pull_off, DampingOn::overlap};
  EXPECT_EQ(canonical(jkr_kind), jkr_kind);
  EXPECT_EQ(canonical({NormalModel::hertz, AdhesionRange::full, DampingOn::contact_radius}),
            canonical({NormalModel::hertz, AdhesionRange::touch, DampingOn::overlap}));
  EXPECT_EQ(effective_kind(jkr_kind, 0).normal, NormalModel::hertz);
  EXPECT_EQ(effective_kind(jkr_kind, 0.02), jkr_kind);
  EXPECT_EQ(to_string(jkr_kind), "jkr, pull_off, overlap");
}

}  // namespace
}  // namespace scalebreak
