#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <ensembles/flows.hpp>

// The hybrid and the event-driven engine beside the soft-sphere engine: the same laws, stiffness and flow.

namespace scalebreak::tests {
namespace {

struct Flow {
  const char* name;
  const char* contact;
  double young, volume_fraction, shear_rate, strain;
  std::size_t least;   ///< quantities whose errors are known after that
  bool often_crowded;  ///< so that three in touch are common enough to be counted at samples
  const char* sizes = "";
  friend void PrintTo(const Flow& flow, std::ostream* out) { *out << flow.name; }
};

class ShearedFlow : public testing::TestWithParam<Flow> {};

TEST_P(ShearedFlow, OfTheHybridIsThatOfSoftSpheres) {
  TemporaryFolder folder;
  const Flow& flow = GetParam();
  const Input input = resolved(fmt::format(R"(
[material]
young = {}
restitution = 0.85
[contact]
{}
[particles]
count = 500
volume_fraction = {}
speed = {}
{}
[cell]
kind = "shear"
shear_rate = {}
[run]
warmup_strain = 6
strain = {}
[output]
formats = []
)",
                                           flow.young, flow.contact, flow.volume_fraction, flow.shear_rate / 400, flow.sizes,
                                           flow.shear_rate, flow.strain));
  const RunOutcome soft = run_flow(input, {}),
                   hybrid = run_flow(input, {.engine = "hybrid", .tables = TableStore{.folder = folder / "tables"}});
  EXPECT_GT(hybrid.replicas.front().patches.value().begun, 100);
  std::size_t compared = 0;
  const auto check = [&](const std::string& name, const Measured& a, const Measured& b) {
    if (!std::isfinite(a.error) || !std::isfinite(b.error)) return;
    const double error = std::hypot(a.error, b.error);
    EXPECT_LT(std::abs(a.value - b.value), 4 * error) << name << ": " << a.value << " and " << b.value << " ± " << error;
    EXPECT_LT(error, 0.15 * std::abs(a.value)) << name;  // else nothing could be told
    ++compared;
  };
  const auto quantity = [](const RunOutcome& outcome, const std::string& name) {
    for (const Quantity& q : outcome.measured.quantities)
      if (q.name == name) return q.measured;
    return Measured{};
  };
  for (const char* name : {"temperature", "rotational_energy", "collision_rate", "coordination", "dissipation", "pressure"})
    check(name, quantity(soft, name), quantity(hybrid, name));
  if (flow.often_crowded)
    check("multi_contact_fraction", quantity(soft, "multi_contact_fraction"), quantity(hybrid, "multi_contact_fraction"));
  const auto stress = [](const RunOutcome& outcome, Eigen::Index i, Eigen::Index j) {
    return Measured{outcome.measured.stress.value(i, j), outcome.measured.stress.error(i, j)};
  };
  check("stress xz", stress(soft, 0, 2), stress(hybrid, 0, 2));
  check("stress zz", stress(soft, 2, 2), stress(hybrid, 2, 2));
  EXPECT_GE(compared, flow.least);
}

INSTANTIATE_TEST_SUITE_P(Laws, ShearedFlow,
                         testing::Values(Flow{"hertz_thin", "normal = \"hertz\"\ntangential = \"mindlin\"", 2e7, 0.1, 40, 80, 5, false},
                                         Flow{"hertz_dense", "normal = \"hertz\"\ntangential = \"mindlin\"", 2e7, 0.4, 40, 25, 6, true},
                                         Flow{"jkr", "normal = \"jkr\"\ntangential = \"none\"", 2e7, 0.2, 400, 40, 2, false},
                                         Flow{"jkr_of_all_sizes", "normal = \"jkr\"\ntangential = \"mindlin\"\nrolling = \"ar\"", 2e7, 0.2,
                                              400, 40, 2, false, "size = \"gaussian\"\nsize_spread = 0.05"}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace scalebreak::tests
