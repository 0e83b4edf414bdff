#include <gmock/gmock.h>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/ensembles/engine/flow_start.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/particle_files/extended_xyz.hpp>
#include <scalebreak/particle_files/particle_csv.hpp>

#include <ensembles/flows.hpp>

namespace scalebreak::tests {
namespace {

struct FlowStartTest : testing::Test {
  TemporaryFolder folder;
  System two;

  FlowStartTest() {
    two.cell.size = {0.01, 0.01, 0.01};
    two.radius = {0.5e-3, 0.6e-3};
    two.material = {0, 1};
    two.mass = {sphere_mass(0.5e-3, 2500), sphere_mass(0.6e-3, 2500)};
    two.position = {{1e-3, 2e-3, 3e-3}, {4e-3, 5e-3, 6e-3}};
    two.velocity = {{0.1, 0, 0}, {0, 0.2, 0}};
    two.spin = {{8, 0, 0}, {0, 0, -4}};
  }

  /// The scene that starts from these spheres.
  [[nodiscard]] Input from_file(const std::string& more = "") const {
    write_file(folder / "start.xyz", extended_xyz(two));
    return resolved(fmt::format("[particles]\nfile = \"{}\"\n[cell]\nkind = \"cooling\"\n{}", (folder / "start.xyz").string(), more));
  }
};

TEST_F(FlowStartTest, AFileIsTakenAsItIs) {
  const FlowStart start = flow_start(from_file());
  EXPECT_EQ(start.system.position, two.position);
  EXPECT_EQ(start.system.velocity, two.velocity);
  EXPECT_EQ(start.system.spin, two.spin);
  EXPECT_EQ(start.system.cell.size, two.cell.size);
  EXPECT_THAT(start.warnings, testing::IsEmpty());
  EXPECT_NEAR(start.speed, std::sqrt((0.01 + 0.04) / 2), 1e-15);
}

TEST_F(FlowStartTest, ALawThatEnlargesTakesItsPlacesAndSpinsWithIt) {
  const FlowStart start = flow_start(from_file("[scaling]\nlaw = \"sup\"\nfactor = 2\n"));
  EXPECT_EQ(start.system.radius, (std::vector{1e-3, 1.2e-3}));
  EXPECT_EQ(start.system.position[1], 2 * two.position[1]);
  EXPECT_EQ(start.system.velocity, two.velocity);
  EXPECT_EQ(start.system.spin[0], two.spin[0] / 2);
  EXPECT_EQ(start.system.cell.size, 2 * two.cell.size);
  EXPECT_NEAR(start.system.mass[0], 8 * two.mass[0], 1e-12 * two.mass[0]);
}

TEST_F(FlowStartTest, MassesAreTheMaterialsAndWhereAFileDiffersThatIsSaid) {
  two.mass[1] *= 1.01;
  const FlowStart start = flow_start(from_file());
  EXPECT_NEAR(start.system.mass[1], sphere_mass(0.6e-3, 2500), 1e-20);
  EXPECT_THAT(start.warnings,
              testing::ElementsAre((folder / "start.xyz").string() + " gives 1 of 2 spheres another mass than their material "
                                                                     "has: the material's are used"));
}

TEST_F(FlowStartTest, SpheresThatOverlapAreRefusedWithTheFile) {
  two.position[1] = two.position[0] + Eigen::Vector3d(0, 1e-3, 0);
  EXPECT_THAT(message_of<InputError>([&] { (void)flow_start(from_file()); }),
              testing::StartsWith((folder / "start.xyz").string() + ": spheres 1 and 2 overlap by 0.0001 m at the start"));
}

TEST_F(FlowStartTest, AFileWithoutACellIsRefused) {
  const std::string csv = folder / "start.csv";
  write_file(csv, particles_csv(two));
  const Input input = resolved(fmt::format("[particles]\nfile = \"{}\"\n[cell]\nkind = \"cooling\"\n", csv));
  EXPECT_EQ(message_of<InputError>([&] { (void)flow_start(input); }),
            "particles.file: " + csv + " says nothing of the cell; allowed: extended XYZ with a Lattice, or LAMMPS data");
}

TEST_F(FlowStartTest, BetweenWallsThatMoveTheSpheresStartAboutTheLinearProfile) {
  const Input input = resolved("[particles]\ncount = 400\nvolume_fraction = 0.2\nspeed = 0\n[cell]\nkind = \"couette\"\nwall_speed = 2\n");
  const FlowStart start = flow_start(input);
  for (std::size_t i = 0; i < start.system.count(); ++i) {
    const double z = start.system.position[i].z() / start.system.cell.size.z();
    EXPECT_NEAR(start.system.velocity[i].x(), -2 + 4 * z, 1e-12);
  }
}

}  // namespace
}  // namespace scalebreak::tests
