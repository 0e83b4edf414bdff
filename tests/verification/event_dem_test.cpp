#include <cmath>

#include <gtest/gtest.h>

#include <ensembles/flows.hpp>

// The event-driven engine beside the soft-sphere engine: the same laws, stiffness and flow, so dilute that hardly ever a third sphere is near.

namespace scalebreak::tests {
namespace {

TEST(EventDrivenShear, AgreesWithSoftSpheres) {
  TemporaryFolder folder;
  const Input input = resolved(R"(
[material]
young = 2e7
restitution = 0.85
[contact]
normal = "hertz"
tangential = "mindlin"
[particles]
count = 600
volume_fraction = 0.1
[cell]
kind = "shear"
[run]
warmup_strain = 6
strain = 12
[output]
formats = []
)");
  const RunOutcome soft = run_flow(input, {}), hard = run_flow(input, {.engine = "event", .tables = TableStore{.folder = folder / "tables"}});
  std::size_t compared = 0;
  const auto check = [&](const std::string& name, const Measured& a, const Measured& b) {
    const double error = std::hypot(a.error, b.error);
    EXPECT_LT(std::abs(a.value - b.value), 3.5 * error) << name << ": " << a.value << " and " << b.value << " ± " << error;
    EXPECT_LT(error, 0.15 * std::abs(a.value)) << name;  // else nothing could be told
    ++compared;
  };
  const auto quantity = [](const RunOutcome& outcome, const std::string& name) {
    for (const Quantity& q : outcome.measured.quantities)
      if (q.name == name) return q.measured;
    return Measured{};
  };
  for (const char* name : {"temperature", "rotational_energy", "collision_rate", "coordination", "dissipation", "pressure"})
    check(name, quantity(soft, name), quantity(hard, name));
  const auto stress = [](const RunOutcome& outcome, Eigen::Index i, Eigen::Index j) {
    return Measured{outcome.measured.stress.value(i, j), outcome.measured.stress.error(i, j)};
  };
  check("stress xz", stress(soft, 0, 2), stress(hard, 0, 2));
  check("stress zz", stress(soft, 2, 2), stress(hard, 2, 2));
  EXPECT_EQ(compared, 8u);
}

}  // namespace
}  // namespace scalebreak::tests
