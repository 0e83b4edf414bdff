#include <scalebreak/particle_files/extended_xyz.hpp>

#include <lib/particle_systems.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/particle_files/read_particles.hpp>

namespace scalebreak {
namespace {

System read(const std::string& content) { return tests::read_back(read_particles, "a.xyz", content); }
std::string sentence(const std::string& content) { return tests::refusal(read_extended_xyz, "a.xyz", content); }
std::string with_remark(const std::string& remark) { return sentence("1\n" + remark + "\n1 2 3 1\n"); }

TEST(ExtendedXyz, ReadsBackWhatItWrites) {
  System system = tests::three_spheres();
  for (const double offset : {0.0, 0.3}) {
    system.cell.shear_offset = offset;
    const System back = read(extended_xyz(system));
    tests::expect_same_spheres(back, system);
    EXPECT_EQ(back.cell, system.cell);
    EXPECT_EQ(back.time, system.time);
  }
}

TEST(ExtendedXyz, ReadsTheLastOfAppendedFrames) {
  const tests::TemporaryFolder folder;
  System system = tests::three_spheres();
  append_file(folder / "a.xyz", extended_xyz(system));
  system.time = 7;
  system.position[1].x() = 0.25;
  append_file(folder / "a.xyz", extended_xyz(system));
  const System back = read_particles((folder / "a.xyz").string());
  EXPECT_EQ(back.time, 7);
  tests::expect_same_spheres(back, system);
}

TEST(ExtendedXyz, ReadsAFileAsOvitoWritesIt) {
  const System back = read(
      "2\nLattice=\"2.0 0.0 0.0 0.0 3.0 0.0 0.0 0.0 4.0\" Properties=species:S:1:pos:R:3:Velo:R:3:radius:R:1 Origin=\"-1 -1.5 -2\" "
      "pbc=\"T F T\"\nA 0 0 0 1 2 3 0.5\nB -1 -1.5 -2 4 5 6 0.25\n");
  ASSERT_EQ(back.count(), 2u);
  EXPECT_EQ(back.cell.size, Eigen::Vector3d(2, 3, 4));
  EXPECT_EQ(back.cell.boundary, (std::array{Boundary::periodic, Boundary::open, Boundary::periodic}));
  EXPECT_EQ(back.position[0], Eigen::Vector3d(1, 1.5, 2));
  EXPECT_EQ(back.position[1], Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(back.velocity[1], Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(back.radius[1], 0.25);
  EXPECT_TRUE(back.mass.empty());
}

TEST(ExtendedXyz, NamesWhatIsWrongWithTheFrame) {
  const std::string good = "Properties=pos:R:3:radius:R:1";
  EXPECT_EQ(sentence(""), "a.xyz: found no sphere; allowed: one at least");
  EXPECT_EQ(sentence("two\n"), "a.xyz, line 1: number of particles: found two; allowed: a whole number that is not negative");
  EXPECT_EQ(sentence("-1\n"), "a.xyz, line 1: number of particles: found -1; allowed: a whole number that is not negative");
  EXPECT_EQ(sentence("2\n" + good + "\n1 2 3 1\n"), "a.xyz, line 1: found 2 lines after it; allowed: a remark and 2, one a particle");
  EXPECT_EQ(sentence("1\n" + good + "\n1 2 3 1\n1 2 3 1\n"),
            "a.xyz, line 4: found 0 lines after it; allowed: a remark and 1, one a particle");
  EXPECT_EQ(sentence("18446744073709551615\n\n"),
            "a.xyz, line 1: found 1 lines after it; allowed: a remark and 18446744073709551615, one a particle")
      << "or the sum ran over";
  EXPECT_EQ(sentence("1\n" + good + "\n1 2 3 0\n"), "a.xyz, line 3: radius: found 0; allowed: above 0");
  EXPECT_EQ(sentence("1\n" + good + "\n1 2 nan 1\n"), "a.xyz, line 3: pos 3: found nan; allowed: a finite number");
  EXPECT_EQ(sentence("1\n" + good + "\n1 2 3\n"), "a.xyz, line 3: found 3 values; allowed: 4, one a column");
}

TEST(ExtendedXyz, NamesWhatIsWrongWithTheRemark) {
  const std::string good = "Properties=pos:R:3:radius:R:1 ";
  EXPECT_EQ(with_remark("a plain file"),
            "a.xyz, line 2: Properties is missing; allowed: an extended XYZ file, with Properties=pos:R:3:radius:R:1 at least");
  EXPECT_EQ(with_remark("Properties=pos:R:3"), "a.xyz, line 2: a column for the radius is missing");
  EXPECT_EQ(with_remark("Properties=pos:R:2:radius:R:1"), "a.xyz, line 2: Properties: found 2 columns of pos; allowed: 3");
  EXPECT_EQ(with_remark("Properties=pos:R"), "a.xyz, line 2: Properties: found pos:R; allowed: name:type:columns:…");
  EXPECT_EQ(with_remark(good + "Lattice=\"1 0 0 0 1 0 0 0\""), "a.xyz, line 2: lattice: found 8 numbers; allowed: 9");
  EXPECT_EQ(with_remark(good + "Lattice=\"1 0 0 0 1 0 0 0 -1\""),
            "a.xyz, line 2: lattice: found a length that is not positive; allowed: above 0");
  EXPECT_EQ(with_remark(good + "Lattice=\"1 0 0 0 1 0 0 0.5 1\""),
            "a.xyz, line 2: lattice: found a skew cell; allowed: a box, or one that is periodic and sheared along x across z");
  EXPECT_EQ(with_remark(good + "Lattice=\"1 0 0 0 1 0 0 0 1"), "a.xyz, line 2: lattice: found a quote that does not end");
  EXPECT_EQ(with_remark(good + "Lattice=\"1 0 0 0 1 0 0 0 1\" pbc=\"T T\""), "a.xyz, line 2: pbc: found T T; allowed: three of T and F");
}

}  // namespace
}  // namespace scalebreak
