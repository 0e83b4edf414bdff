#include <cmath>

#include <gmock/gmock.h>
#include <boost/math/distributions/chi_squared.hpp>

#include <scalebreak/ensembles/breakdown/run_study.hpp>
#include <scalebreak/ensembles/breakdown/verdicts.hpp>

#include <ensembles/flows.hpp>

namespace scalebreak::tests {
namespace {

/// Rough cohesionless glass, a hundredth as stiff, in shear.
const std::string scene = R"(
[material]
young = 1e8
poisson = 0.25
density = 2500
restitution = 0.81
sliding_friction = 0.3
surface_energy = 0
[contact]
normal = "hertz"
tangential = "mindlin"
[particles]
count = 300
radius = 0.5e-3
speed = 0.04
[cell]
kind = "shear"
shear_rate = 40
[run]
warmup_strain = 6
strain = 15
replicas = 4
)";

StudyResult study_of(const std::string& study, const TemporaryFolder& folder) {
  const Input input = resolved(scene + study);
  return run_study(input, study_grid(input), {.out = {}, .threads = 2, .tables = {.folder = folder / "tables"}});
}

/// Of so many deviations that are noise, how seldom their squares over those of their errors add up to as much.
double chance_of(double squares, int count) {
  return boost::math::cdf(complement(boost::math::chi_squared_distribution<double>(count), squares));
}

TEST(Breakdown, TheSameSystemByAnotherNameAndByAnotherEngineDoesNotDeviate) {
  const TemporaryFolder folder;
  // RPS at 1 is the original with other random numbers; the hybrid another method for both.
  const StudyResult study =
      study_of("[study]\nlaws = [\"rps\"]\nfactors = [1]\nvolume_fractions = [0.2, 0.45]\nengines = [\"dem\", \"hybrid\"]\n", folder);
  ASSERT_EQ(study.cells.size(), 8u);
  double squares = 0;
  int count = 0;
  for (const CellResult& cell : study.cells) {
    for (const std::string& name : judged_quantities()) {
      const Comparison* c = cell.deviation(name);
      if (!c || name == "volume_fraction" || !std::isfinite(c->relative.error)) continue;
      const double size = c->relative.value / c->relative.error;
      EXPECT_LT(std::abs(size), 4) << name << " of " << study.grid.cells[cell.cell].folder();
      squares += size * size, ++count;
    }
  }
  EXPECT_GE(count, 24);
  // Quantities of one flow hang together, so that the sum scatters more than it would: this bounds gross errors alone.
  EXPECT_GT(chance_of(squares / 2, count), 1e-3) << squares << " of " << count;
}

TEST(Breakdown, ASteadyFlowOfCollisionsGrowsAsTheSquareOfTheSize) {
  const TemporaryFolder folder;
  const StudyResult study = study_of("[study]\nlaws = [\"sup\"]\nfactors = [2]\nvolume_fractions = [0.3]\nengines = [\"dem\"]\n", folder);
  // Speeds go as shear rate times size; forces between contacts of no duration have no say. SUP keeps overlap over size, so that contact times do not
  // change what is relative to them but for v^(-1/5).
  for (const char* name : {"temperature", "pressure", "stress_xz"}) {
    const Comparison* c = study.cells[1].deviation(name);
    ASSERT_NE(c, nullptr);
    EXPECT_NEAR(1 + c->relative.value, 4, 4 * c->relative.error + 0.1) << name;
    EXPECT_LT(c->relative.error, 0.3) << name;
  }
  EXPECT_EQ(cell_verdict(study.cells[1]).standing, Standing::broken);
}

}  // namespace
}  // namespace scalebreak::tests
