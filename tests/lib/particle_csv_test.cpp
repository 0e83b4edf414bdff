#include <scalebreak/particle_files/particle_csv.hpp>

#include <lib/particle_systems.hpp>
#include <scalebreak/particle_files/read_particles.hpp>

namespace scalebreak {
namespace {

std::string sentence(const std::string& content) { return tests::refusal(read_particles_csv, "a.csv", content); }

TEST(ParticleCsv, ReadsBackWhatItWrites) {
  const System system = tests::three_spheres();
  tests::expect_same_spheres(tests::read_back(read_particles, "a.csv", particles_csv(system)), system);
}

TEST(ParticleCsv, HasHeadersWithUnits) {
  EXPECT_EQ(particles_csv({}),
            "x [m],y [m],z [m],radius [m],velocity_x [m/s],velocity_y [m/s],velocity_z [m/s],spin_x [rad/s],spin_y [rad/s],spin_z [rad/s],"
            "mass [kg],material [-]\n");
}

TEST(ParticleCsv, TakesColumnsInAnyOrderAndSkipsOthers) {
  const System read =
      tests::read_back(read_particles_csv, "a.csv", "id [-],\"radius [m]\", z [m],y [m],x [m]\r\nseven,1e-3,3,+2,1\r\n\r\n");
  ASSERT_EQ(read.count(), 1u);
  EXPECT_EQ(read.position[0], Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(read.radius[0], 1e-3);
  EXPECT_EQ(read.velocity[0].norm() + read.spin[0].norm(), 0);
  EXPECT_EQ(read.material[0], 0);
  EXPECT_TRUE(read.mass.empty());
  EXPECT_EQ(read.cell.size.norm(), 0);
}

TEST(ParticleCsv, NamesLineColumnFoundAndAllowed) {
  const std::string head = "x [m],y [m],z [m],radius [m]\n0,0,0,1\n";
  EXPECT_EQ(sentence(head + "1,2,nan,1\n"), "a.csv, line 3: z [m]: found nan; allowed: a finite number");
  EXPECT_EQ(sentence(head + "1,inf,3,1\n"), "a.csv, line 3: y [m]: found inf; allowed: a finite number");
  EXPECT_EQ(sentence(head + "1,,3,1\n"), "a.csv, line 3: y [m]: found nothing; allowed: a finite number");
  EXPECT_EQ(sentence(head + "1,2m,3,1\n"), "a.csv, line 3: y [m]: found 2m; allowed: a finite number");
  EXPECT_EQ(sentence(head + "1,2,3,-1\n"), "a.csv, line 3: radius [m]: found -1; allowed: above 0");
  EXPECT_EQ(sentence(head + "1,2,3\n"), "a.csv, line 3: found 3 values; allowed: 4, one a column");
  EXPECT_EQ(sentence("x [m],y [m],z [m],radius [m],mass [kg]\n1,2,3,1,0\n"), "a.csv, line 2: mass [kg]: found 0; allowed: above 0");
  EXPECT_EQ(sentence("x [m],y [m],z [m],radius [m],material [-]\n1,2,3,1,2\n"),
            "a.csv, line 2: material [-]: found 2; allowed: 0 for [material] or 1 for [second]");
}

TEST(ParticleCsv, NamesWhatIsWrongWithTheHeaders) {
  EXPECT_EQ(sentence("x [m],y [m],z [m]\n"), "a.csv, line 1: a column for the radius is missing");
  EXPECT_EQ(sentence("x [mm],y [m],z [m],radius [m]\n"), "a.csv, line 1: found the column x [mm]; allowed: x [m]");
  EXPECT_EQ(sentence("x [m],x [m],y [m],z [m],radius [m]\n"), "a.csv, line 1: x [m]: found twice; allowed: one column for the x");
  EXPECT_EQ(sentence("x [m],y [m],z [m],radius [m],velocity_x [m/s]\n"),
            "a.csv, line 1: a column for the velocity along y is missing; allowed: all three components, or none");
  EXPECT_EQ(sentence(""), "a.csv: found nothing; allowed: a line of headers and a line for each sphere");
  EXPECT_EQ(sentence("x [m],y [m],z [m],radius [m]\n"), "a.csv: found no sphere; allowed: one at least");
}

TEST(ReadParticles, NamesFilesItCannotRead) {
  EXPECT_EQ(tests::refusal(read_particles, "a.stl", ""), "a.stl: found an unknown ending; allowed: .csv, .xyz, .extxyz, .data, .lmp");
  EXPECT_EQ(tests::refusal([](const std::string& file) { return read_particles(file + ".csv"); }, "a", ""),
            "a.csv: there is no such file, or it cannot be read");
}

}  // namespace
}  // namespace scalebreak
