#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include <scalebreak/ensembles/breakdown/study_quantities.hpp>
#include <scalebreak/ensembles/run/flow_run.hpp>
#include <scalebreak/ensembles/tradeoff/method_tradeoff.hpp>
#include <scalebreak/ensembles/tradeoff/tradeoff_files.hpp>

#include <ensembles/flows.hpp>

namespace scalebreak::tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Soft, small and short: a run is milliseconds of work.
const std::string small_methods = soft_glass + R"([particles]
count = 100
volume_fraction = 0.2
[cell]
kind = "shear"
shear_rate = 100
[run]
warmup_strain = 0.2
strain = 2
[study]
laws = ["rps", "sup"]
factors = [0.1, 2]
step_fractions = [0.1]
)";

/// Tables are made once for all tests.
TableStore store() {
  static const TemporaryFolder folder;
  return {.folder = folder.path()};
}

StudyOptions options_of(const TemporaryFolder& folder) { return {.out = folder / "out", .threads = 1, .tables = store()}; }

MethodTradeoff study_of(const Input& input, const TemporaryFolder& folder) { return method_tradeoff(input, options_of(folder)); }

std::vector<std::string> names_of(const MethodGrid& grid) {
  std::vector<std::string> names;
  for (const FlowWay& way : grid.ways) names.push_back(way.name());
  return names;
}

TEST(MethodGrid, HoldsStepsLawsAndEngines) {
  const MethodGrid grid = method_grid(resolved(small_methods));
  EXPECT_THAT(names_of(grid), ElementsAre("dem at a step of 0.15", "dem at a step of 0.1", "rps 0.1 (dem)", "sup 2 keeping count (dem)",
                                          "sup 2 keeping cell (dem)", "hybrid", "event"));
  EXPECT_EQ(grid.skipped, 2);
  EXPECT_EQ(grid.grid.cells.size(), 7u);
  EXPECT_EQ(std::count_if(grid.ways.begin(), grid.ways.end(), [](const FlowWay& way) { return way.automatic; }), 1);
  const FlowWay& emptied = grid.ways[4];
  EXPECT_EQ(grid.grid.cells[*emptied.cell].input.keep, Keep::cell);
  EXPECT_EQ(emptied.series(), "sup keeping cell (dem)");
}

TEST(MethodGrid, SaysWhatAnEngineRefuses) {
  const MethodGrid grid = method_grid(resolved(small_methods, {"contact.attraction=\"capillary\""}));
  const auto event = std::find_if(grid.ways.begin(), grid.ways.end(), [](const FlowWay& way) { return way.engine == "event"; });
  ASSERT_NE(event, grid.ways.end());
  EXPECT_FALSE(event->cell);
  EXPECT_THAT(event->refusal, HasSubstr("which acts at a distance and has no collision tables; allowed in an event-driven run: \"none\""));
  EXPECT_THAT(message_of<InputError>([&] {
                (void)method_grid(resolved(small_methods, {"contact.attraction=\"capillary\"", "study.engines=[\"event\"]"}));
              }),
              HasSubstr("study.engines: none of them runs the original"));
}

/// Soft spheres: touching contacts summed over steps, which the coordination number tells too; the events are counted by the engine.
TEST(RunWork, IsWhatTheMeasuredTimeTook) {
  const Input input = resolved(small_methods, {"run.strain=4"});
  const TableStore tables = store();
  FlowRun soft(input, 0, 1, &tables, "dem");
  while (!soft.done()) soft.advance();
  const RunRecord& record = soft.record();
  const FlowResult result = soft.measurement().result();
  const double steps = result.duration / record.schedule.step;
  EXPECT_NEAR(record.work.evaluations, value_of(result, "coordination") * 100 / 2 * steps, 1e-6 * record.work.evaluations);
  EXPECT_NEAR(record.work.sphere_steps, 100 * steps, 1);
  EXPECT_EQ(record.work.lookups, 0);
  FlowRun flown(input, 0, 1, &tables, "event");
  while (!flown.done()) flown.advance();
  const double rate = value_of(flown.measurement().result(), "collision_rate");
  EXPECT_NEAR(flown.record().work.lookups, rate * 100 / 2 * flown.measurement().result().duration, 1e-6 * flown.record().work.lookups);
  EXPECT_EQ(flown.record().work.evaluations, 0);
  FlowRun mixed(input, 0, 1, &tables, "hybrid");
  while (!mixed.done()) mixed.advance();
  EXPECT_GT(mixed.record().work.evaluations, 0);
  EXPECT_GT(mixed.record().work.lookups, 0);
  EXPECT_LT(mixed.record().work.evaluations, record.work.evaluations);
}

TEST(MethodTradeoff, CountsTheSameWorkAndFrontAgain) {
  const TemporaryFolder one, two;
  const Input input = resolved(small_methods, {"run.replicas=2"});
  const MethodTradeoff first = study_of(input, one), second = study_of(input, two);
  ASSERT_EQ(first.points.size(), second.points.size());
  for (std::size_t i = 0; i < first.points.size(); ++i) {
    const WayPoint &a = first.points[i], &b = second.points[i];
    EXPECT_EQ(a.result.work.evaluations, b.result.work.evaluations) << a.way.name();
    EXPECT_EQ(a.result.work.lookups, b.result.work.lookups) << a.way.name();
    EXPECT_EQ(a.work, b.work) << a.way.name();
    EXPECT_EQ(a.error, b.error) << a.way.name();
    EXPECT_EQ(a.on_work_front, b.on_work_front) << a.way.name();
    EXPECT_GT(a.work, 0) << a.way.name();
  }
  EXPECT_TRUE(std::any_of(first.points.begin(), first.points.end(), [](const WayPoint& point) { return point.on_work_front; }));
}

/// Two spheres that stick are an end that an event cannot say: its failure is a point, and the rest goes on.
TEST(MethodTradeoff, KeepsTheReasonOfAMethodThatFails) {
  const TemporaryFolder folder;
  const MethodTradeoff study =
      study_of(resolved(small_methods, {"contact.normal=\"jkr\"", "contact.tangential=\"none\"", "material.surface_energy=0.5",
                                        "study.laws=[\"rps\"]", "study.engines=[\"dem\", \"event\"]"}),
               folder);
  const WayPoint& event = study.points.back();
  EXPECT_EQ(event.way.engine, "event");
  EXPECT_THAT(event.failure, HasSubstr("stick together, which an event cannot say"));
  EXPECT_TRUE(std::isnan(event.work));
  EXPECT_FALSE(event.on_work_front);
  EXPECT_THAT(sentences(study), testing::Contains(HasSubstr("event has no answer: ")));
  (void)write_tradeoff(study, 1, "sticking", folder / "files");
  EXPECT_THAT(content_of(folder / "files" / "tradeoff.csv"), HasSubstr("stick together"));
}

/// A cell's result with errors of 1 %, which `runs` runs of so much work each came to.
CellResult known(double temperature, double rate, double work) {
  CellResult result{.replicas = 1, .particles = 80};
  for (const char* name : {"temperature", "collision_rate", "pressure"}) result.quantities.push_back({name, "-", {1, 0.01}});
  result.quantities[0].measured = {temperature, 0.01 * temperature};
  result.quantities[1].measured = {rate, 0.01 * rate};
  result.work.evaluations = work, result.processor_seconds = work;
  return result;
}

TEST(MethodTradeoff, ComparesWithTheMostAccurateAndGivesCostsOfTheSameStatistics) {
  const MethodGrid grid = method_grid(resolved(small_methods));
  std::vector<CellResult> results;
  for (const FlowWay& way : grid.ways)
    results.push_back(known(way.law == "rps"     ? 1.2
                            : way.keep == "cell" ? 1.03
                                                 : 1,
                            way.law == "sup" ? 0.5 : 1,  // as SUP claims it
                            way.engine == "hybrid" ? 10
                            : way.law == "rps"     ? 5
                                                   : 100));
  results[4].particles = 10;  // in the same cell
  const MethodTradeoff study = method_tradeoff(grid, results);
  const WayPoint &coarse = study.points[0], &fine = study.points[1], &rps = study.points[2], &emptied = study.points[4],
                 &hybrid = study.points[5];
  EXPECT_TRUE(fine.in_reference && hybrid.in_reference);
  EXPECT_FALSE(coarse.in_reference);
  EXPECT_NEAR(rps.error, 0.2, 1e-12);
  EXPECT_TRUE(rps.told);
  EXPECT_NEAR(rps.error_error, 1.2 * std::sqrt(1e-4 + 0.5e-4), 1e-9);  // beside two parts of 1 % each
  EXPECT_NEAR(fine.error_error, std::sqrt(2e-4), 1e-9);                // beside the other part alone
  EXPECT_FALSE(emptied.told);
  EXPECT_EQ(hybrid.work, 10);
  EXPECT_EQ(emptied.work, 800);  // of an eighth of the spheres: eight runs for the same statistics
  EXPECT_TRUE(rps.on_work_front && hybrid.on_work_front);
  EXPECT_FALSE(coarse.on_work_front || fine.on_work_front || emptied.on_work_front);
  EXPECT_THAT(sentences(study), testing::Contains(HasSubstr("cheaper and less accurate: rps 0.1 (dem)")));
  EXPECT_EQ(sentences(study).back(),
            "What to choose, by processor time: where no error may be told, hybrid (10 s); where one of 30 % may be, rps 0.1 (dem) (5 s)");
}

const std::string small_bed = R"(
[material]
young = 1e7
surface_energy = 0
[contact]
normal = "hertz"
[particles]
count = 64
volume_fraction = 0
[cell]
kind = "box"
size = [0.004, 0.004, 0.008]
boundary = ["periodic", "periodic", "wall"]
gravity = [0, 0, -9.81]
[run]
duration = 0.01
[study]
laws = ["sup"]
factors = [2]
step_fractions = [0.15]
engines = ["dem"]
)";

TEST(MethodGrid, OfABedLeavesTheDepthOfTheBedAlone) {
  const MethodGrid bed = method_grid(resolved(small_bed));
  EXPECT_TRUE(bed.bed);
  EXPECT_THAT(names_of(bed), ElementsAre("dem at a step of 0.15", "sup 2 keeping cell (dem)"));
  EXPECT_FALSE(method_grid(resolved(small_methods)).bed);
  EXPECT_FALSE(method_grid(resolved(small_bed, {"cell.gravity=[0, 0, 0]"})).bed);
}

/// Spheres at rest have a temperature of rounding, and nothing that collides.
TEST(MethodTradeoff, TellsBedsApartByHowTheyArePacked) {
  const MethodGrid grid = method_grid(resolved(small_bed));
  std::vector<CellResult> results = {known(1e-12, 0, 100), known(5e-12, 0, 10)};
  for (CellResult& result : results) result.quantities.push_back({"bed_volume_fraction", "-", {0.6, 0.001}});
  results[1].quantities.back().measured.value = 0.57;
  const MethodTradeoff study = method_tradeoff(grid, results);
  EXPECT_EQ(study.points[1].worst, "bed_volume_fraction");
  EXPECT_NEAR(study.points[1].error, 0.05, 1e-12);
  for (const Comparison& c : study.points[1].deviations) EXPECT_NE(c.name, "temperature");
}

/// A small deviation that is known well is an error; a larger one that is not is none.
TEST(MethodTradeoff, TellsAWayByWhatIsBeyondItsError) {
  const MethodGrid grid = method_grid(resolved(small_bed));
  std::vector<CellResult> results = {known(1e-12, 0, 100), known(5e-12, 0, 10)};
  for (CellResult& result : results) result.quantities.push_back({"bed_volume_fraction", "-", {0.6, 0.0006}});
  results[1].quantities.back().measured.value = 0.588;
  results[1].quantities[2].measured = {1.03, 0.05};  // pressure
  const WayPoint way = method_tradeoff(grid, results).points[1];
  EXPECT_TRUE(way.told);
  EXPECT_EQ(way.worst, "bed_volume_fraction");
  EXPECT_NEAR(way.error, 0.02, 1e-12);
}

/// Layers of this volume fraction, from the floor of a box of 20 slabs.
double bed_of(const std::vector<double>& layers) {
  FlowResult result;
  ProfileColumn solids{"volume_fraction", "-", {}};
  for (std::size_t k = 0; k < 20; ++k) {
    result.profile.height.push_back((static_cast<double>(k) + 0.5) * 0.4e-3);
    solids.slabs.push_back({k < layers.size() ? layers[k] : 0, 0});
  }
  result.profile.columns = {solids};
  for (const Quantity& quantity : studied(result, resolved(small_bed))) {
    if (quantity.name == "bed_volume_fraction") return quantity.measured.value;
  }
  return std::nan("");
}

TEST(StudyQuantities, GiveTheVolumeFractionOfABedWhateverItsDepth) {
  EXPECT_NEAR(bed_of(std::vector<double>(10, 0.6)), 0.6, 1e-12);
  EXPECT_NEAR(bed_of(std::vector<double>(5, 0.6)), 0.6, 1e-12);
  EXPECT_NEAR(bed_of({0.6, 0.6, 0.6, 0.6, 0.6, 0.3, 0.3}), 3.6 * 3.6 / (2 * (0.6 * 12.5 + 0.3 * 12)),
              1e-12);  // of the height of the centre of mass alone
}

}  // namespace
}  // namespace scalebreak::tests
