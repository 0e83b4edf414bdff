#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <scalebreak/ensembles/run/run_flow.hpp>

#include <lib/resolving.hpp>
#include "dem/flows.hpp"

// Flows in a cell whose height follows the normal stress, beside theory, beside the same flows at constant volume, and beside published ones.

namespace scalebreak {
namespace {

Measured of(const FlowResult& result, const std::string& name) {
  for (const Quantity& quantity : result.quantities) {
    if (quantity.name == name) return quantity.measured;
  }
  ADD_FAILURE() << "no " << name;
  return {};
}

Measured stress(const FlowResult& result, int i, int j) { return {result.stress.value(i, j), result.stress.error(i, j)}; }

/// The mean of what is kept: within three of its errors, where neighbours do not cancel so that there is none, and a fluctuation of the
/// volume by which it is weighted.
void expect_pressure(const Measured& normal, double wanted) {
  EXPECT_LT(std::abs(normal.value - wanted), (std::isfinite(normal.error) ? 3 * normal.error : 0.0) + 1e-3 * wanted);
  EXPECT_NEAR(normal.value, wanted, 0.01 * wanted);
}

/// Elastic spheres that are not sheared come to the pressure and the volume fraction of hard spheres, P = n m T Z(φ) with Carnahan and
/// Starling's Z.
TEST(ConfinedGas, ObeysTheEquationOfState) {
  const System start = test::filled(1000, 0.35, {0.5e-3}, 0.1);
  DemSetup setup = test::smooth(1e9, 1, 0.2, 0.5e-3);
  setup.pressure = 60;  // of the start it is about 15: the gas is compressed, and becomes hotter
  Dem dem(start, setup);
  dem.advance(60'000);
  double pressure = 0, expected = 0, fraction = 0;
  const int looks = 400;
  const double before = dem.totals().contact_moment(2, 2), began = dem.time();
  double kinetic = 0, volume = 0;
  for (int look = 0; look < looks; ++look) {
    dem.advance(500);
    const System system = dem.system();
    double squares = 0, along = 0;
    for (std::size_t i = 0; i < system.count(); ++i)
      squares += system.mass[i] * system.velocity[i].squaredNorm(), along += system.mass[i] * std::pow(system.velocity[i].z(), 2);
    const double v = system.cell.volume(), phi = 1000 * sphere_mass(0.5e-3, 1) / v;
    const double z = (1 + phi + phi * phi - phi * phi * phi) / std::pow(1 - phi, 3);
    expected += squares / 3 / v * z / looks, fraction += phi / looks, kinetic += along / looks, volume += v / looks;
  }
  pressure = ((dem.totals().contact_moment(2, 2) - before) / (dem.time() - began) + kinetic) / volume;
  EXPECT_GT(fraction, 0.4);
  EXPECT_NEAR(pressure / setup.pressure, 1, 0.01);
  EXPECT_NEAR(expected / setup.pressure, 1, 0.015);  // soft spheres are smaller by their overlap, and N is finite
}

const std::string inelastic = R"(
[material]
young = 1e8
density = 2500
restitution = 0.7
surface_energy = 0
[contact]
normal = "hertz"
[particles]
count = 500
[cell]
shear_rate = 200
[run]
warmup_strain = 20
strain = 130
[output]
formats = []
)";

/// The same flow whether its volume or its pressure is kept: inertial, I = 0.32.
TEST(ConfinedShear, IsTheFlowAtConstantVolume) {
  const FlowResult confined =
      run_flow(tests::resolved(inelastic, {"cell.kind=confined_shear", "cell.pressure=1000", "particles.volume_fraction=0.4"}), {})
          .measured;
  const Measured fraction = of(confined, "volume_fraction");
  expect_pressure(stress(confined, 2, 2), 1000);
  ASSERT_LT(fraction.error, 2e-3);

  const auto at = [&](double volume_fraction) {
    return run_flow(tests::resolved(inelastic, {"cell.kind=shear", fmt::format("particles.volume_fraction={:.17g}", volume_fraction)}), {})
        .measured;
  };
  const FlowResult kept = at(fraction.value), denser = at(fraction.value + 0.01);
  for (const auto& [i, j] : {std::pair(2, 2), std::pair(0, 2), std::pair(0, 0)}) {
    const Measured one = stress(confined, i, j), other = stress(kept, i, j);
    const double slope = (stress(denser, i, j).value - other.value) / 0.01;  // by which an error of the volume fraction counts
    const double own = std::isfinite(one.error) ? one.error : 0;             // of what is kept there may be none
    const double error = std::hypot(own, other.error, slope * fraction.error);
    EXPECT_LT(std::abs(one.value - other.value), 3 * error) << i << j;
    EXPECT_LT(error, 0.03 * std::abs(one.value)) << i << j;
  }
  const Measured one = of(confined, "temperature"), other = of(kept, "temperature");
  const double slope = (of(denser, "temperature").value - other.value) / 0.01;
  EXPECT_LT(std::abs(one.value - other.value), 3 * std::hypot(one.error, other.error, slope * fraction.error));
}

/// Slow shear, I = 0.01, of spheres with a friction of 0.5, beside the same cell at constant volume and beside published flows: glass beads yield at tan 20.9° =
/// 0.38 (Jop, Forterre & Pouliquen, Nature 441, 727 (2006)), and such spheres are said to yield at 0.382 and to jam at φ = 0.587 (quoted second hand of Chialvo,
/// Sun & Sundaresan, Phys. Rev. E 85, 021305 (2012)), from which I = 0.01 is 0.002 away. The bars are for 400 spheres, and for overlaps of 0.2 % of the diameter,
/// which raise φ by about 0.003.
TEST(ConfinedShear, YieldsWithTheFrictionOfTheFlowAtConstantVolume) {
  const Input input = tests::resolved(R"(
[material]
young = 1e7
density = 2500
restitution = 0.7
sliding_friction = 0.5
surface_energy = 0
[contact]
normal = "hertz"
tangential = "mindlin"
[particles]
count = 400
radius = 0.5e-3
volume_fraction = 0.5
speed = 0.05
[cell]
kind = "confined_shear"
shear_rate = 6.32
pressure = 1000
[run]
warmup_strain = 2
strain = 8
[output]
formats = []
)");
  const FlowResult result = run_flow(input, {}).measured;
  expect_pressure(stress(result, 2, 2), 1000);
  const double fraction = of(result, "volume_fraction").value;
  const auto friction = [](const FlowResult& flow) { return -stress(flow, 0, 2).value / of(flow, "pressure").value; };
  EXPECT_NEAR(friction(result), 0.384, 0.02);
  EXPECT_NEAR(fraction, 0.587, 0.01);
  Input kept = input;
  kept.cell.kind = CellKind::shear, kept.cell.pressure = 0, kept.particles.volume_fraction = fraction;
  EXPECT_NEAR(friction(run_flow(kept, {}).measured), friction(result), 0.02);
}

}  // namespace
}  // namespace scalebreak
