#include <fmt/format.h>

#include <lib/particle_systems.hpp>
#include <scalebreak/particle_files/lammps_data.hpp>
#include <scalebreak/particle_files/lammps_dump.hpp>
#include <scalebreak/particle_files/read_particles.hpp>

namespace scalebreak {
namespace {

System read(const std::string& content) { return tests::read_back(read_particles, "a.data", content); }
std::string sentence(const std::string& content) { return tests::refusal(read_lammps_data, "a.data", content); }

const std::string head = "remark\n\n2 atoms\n2 atom types\n\n-1 1 xlo xhi\n0 2 ylo yhi\n0 3 zlo zhi\n";

TEST(LammpsData, ReadsBackWhatItWrites) {
  System system = tests::three_spheres();
  const System back = read(lammps_data(system));
  EXPECT_EQ(back.cell.size, system.cell.size);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(back.mass[i], system.mass[i], 1e-15 * system.mass[i]);  // through the density
  system.mass = back.mass;
  tests::expect_same_spheres(back, system);
}

TEST(LammpsData, SortsByIdAndTakesImagesRemarksAndOtherSections) {
  const System back = read(head +
                           "0 0 0 xy xz yz\n\nMasses\n\n1 1.0\n2 1.0\n\nAtoms # sphere\n\n9 2 2 3 0 1 1.5 0 0 -1\n4 1 1 3 -1 0 0 # here\n\n"
                           "Velocities\n\n4 1 2 3 4 5 6\n9 0 0 0 0 0 7\n");
  ASSERT_EQ(back.count(), 2u);
  EXPECT_EQ(back.cell.size, Eigen::Vector3d(2, 2, 3));
  EXPECT_EQ(back.position[0], Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(back.position[1], Eigen::Vector3d(1, 1, 1.5));
  EXPECT_EQ(back.radius, (std::vector<double>{0.5, 1}));
  EXPECT_EQ(back.material, (std::vector<std::uint8_t>{0, 1}));
  EXPECT_NEAR(back.mass[1], 4 * std::numbers::pi, 1e-14);
  EXPECT_EQ(back.velocity[0], Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(back.spin[1], Eigen::Vector3d(0, 0, 7));
}

TEST(LammpsData, RefusesATiltedBox) {
  System system = tests::three_spheres();
  system.cell.shear_offset = 0.3;
  EXPECT_EQ(sentence(lammps_data(system)),
            fmt::format("a.data, line 9: xz: found {:.17g}; allowed: 0, as a tilted box cannot be read", 0.3 - 1.0 / 3));
}

TEST(LammpsData, NamesWhatIsWrong) {
  const std::string atoms = head + "\nAtoms # sphere\n\n";
  EXPECT_EQ(sentence(""), "a.data: \"N atoms\" is missing; allowed: a LAMMPS data file of atom_style sphere");
  EXPECT_EQ(sentence("remark\n2 atoms\n"), "a.data: the bounds of the box along x are missing");
  EXPECT_EQ(sentence(head), "a.data: the section Atoms is missing");
  EXPECT_EQ(sentence("remark\n2 atoms\n1 1 xlo xhi\n"), "a.data, line 3: found 1 to 1; allowed: the upper bound above the lower one");
  EXPECT_EQ(sentence(head + "\nAtoms # bond\n"), "a.data, line 10: Atoms: found atom_style bond; allowed: sphere");
  EXPECT_EQ(sentence(atoms + "1 1 1 1 0 0 0\n"), "a.data: the section Atoms ends early; allowed: 2 lines, one an atom");
  EXPECT_EQ(sentence(atoms + "1 1 1 0 0 0\n"), "a.data, line 12: Atoms: found 6 values; allowed: id type diameter density x y z");
  EXPECT_EQ(sentence(atoms + "1 3 1 1 0 0 0\n"), "a.data, line 12: type: found 3; allowed: 1 for [material] or 2 for [second]");
  EXPECT_EQ(sentence(atoms + "1 1 -1 1 0 0 0\n"), "a.data, line 12: diameter: found -1; allowed: above 0");
  EXPECT_EQ(sentence(atoms + "1 1 1 1 0 nan 0\n"), "a.data, line 12: y: found nan; allowed: a finite number");
  EXPECT_EQ(sentence(atoms + "1 1 1 1 0 0 0\n1 1 1 1 0 0 0\n"), "a.data, line 13: id: found 1 twice; allowed: once");
  EXPECT_EQ(sentence(atoms + "1 1 1 1 0 0 0\n2 1 1 1 0 0 0\n\nVelocities\n\n3 0 0 0 0 0 0\n"),
            "a.data, line 17: id: found 3; allowed: an id of the section Atoms");
}

TEST(LammpsDump, HasTheBoxAndAllNumbers) {
  System system = tests::three_spheres();
  system.time = 0.5;
  system.cell.size = {2, 3, 4};
  system.position.resize(1);
  system.position[0] = {0.1, 0.2, 0.3};
  system.velocity[0] = {1, 2, 3};
  system.spin[0] = {4, 5, 6};
  system.radius[0] = 0.25;
  system.mass[0] = 0.125;
  const std::string start = "ITEM: TIME\n0.5\nITEM: TIMESTEP\n70\nITEM: NUMBER OF ATOMS\n1\n";
  const std::string end =
      "ITEM: ATOMS id x y z diameter vx vy vz omegax omegay omegaz mass type\n"
      "1 0.10000000000000001 0.20000000000000001 0.29999999999999999 0.5 1 2 3 4 5 6 0.125 1\n";
  EXPECT_EQ(lammps_dump(system, 70), start + "ITEM: BOX BOUNDS pp ff pp\n0 2\n0 3\n0 4\n" + end);
  system.cell.shear_offset = 0.5;
  EXPECT_EQ(lammps_dump(system, 70), start + "ITEM: BOX BOUNDS xy xz yz pp ff pp\n0 2.5 0\n0 3 0.5\n0 4 0\n" + end);
  system.cell.shear_offset = 1.5;  // the nearer way is back
  EXPECT_EQ(lammps_dump(system, 70), start + "ITEM: BOX BOUNDS xy xz yz pp ff pp\n-0.5 2 0\n0 3 -0.5\n0 4 0\n" + end);
}

}  // namespace
}  // namespace scalebreak
