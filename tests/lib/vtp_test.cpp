#include <scalebreak/particle_files/vtp.hpp>

#include <cstdlib>
#include <map>
#include <sstream>

#include <lib/particle_systems.hpp>

namespace scalebreak {
namespace {

using Arrays = std::map<std::string, std::vector<double>>;

/// The arrays of a .vtp, "section name" to numbers, as Python reads them.
Arrays decoded(const std::string& vtp) {
  const tests::TemporaryFolder folder;
  tests::put_file(folder / "a.vtp", vtp);
  const std::string command =
      "python3 " SCALEBREAK_SOURCE "/tests/lib/vtk_reads_back.py " + (folder / "a.vtp").string() + " > " + (folder / "out").string();
  EXPECT_EQ(std::system(command.c_str()), 0);
  Arrays arrays;
  std::istringstream lines(tests::content_of(folder / "out"));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string section, name, number;
    words >> section >> name;
    auto& numbers = arrays[section + " " + name];
    while (words >> number) numbers.push_back(std::stod(number));
  }
  return arrays;
}

std::vector<double> flat(const std::vector<Eigen::Vector3d>& vectors) {
  std::vector<double> numbers;
  for (const Eigen::Vector3d& v : vectors) numbers.insert(numbers.end(), v.begin(), v.end());
  return numbers;
}

std::string base64_of(const std::string& text) {
  const std::vector<unsigned char> bytes(text.begin(), text.end());
  return base64(bytes);
}

TEST(Base64, IsThatOfRfc4648) {
  EXPECT_EQ(base64_of(""), "");
  EXPECT_EQ(base64_of("f"), "Zg==");
  EXPECT_EQ(base64_of("fo"), "Zm8=");
  EXPECT_EQ(base64_of("foo"), "Zm9v");
  EXPECT_EQ(base64_of("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64_of("\xff\xef\xbf"), "/++/");
}

TEST(Vtp, HoldsTheSpheres) {
  const System system = tests::three_spheres();
  const Arrays arrays = decoded(spheres_vtp(system));
  EXPECT_EQ(arrays.at("Points position"), flat(system.position));
  EXPECT_EQ(arrays.at("PointData velocity"), flat(system.velocity));
  EXPECT_EQ(arrays.at("PointData spin"), flat(system.spin));
  EXPECT_EQ(arrays.at("PointData radius"), system.radius);
  EXPECT_EQ(arrays.at("PointData mass"), system.mass);
  EXPECT_EQ(arrays.at("PointData material"), (std::vector<double>{0, 1, 0}));
  EXPECT_EQ(arrays.at("PointData id"), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(arrays.at("Verts connectivity"), (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(arrays.at("Verts offsets"), (std::vector<double>{1, 2, 3}));
}

TEST(Vtp, HoldsContactsAsLines) {
  const System system = tests::three_spheres();
  const std::vector<ContactForce> contacts = {{0, 1, true, {0.1, 0, 0}, {3, 4, 0}}, {2, -1, false, {0, 0, -0.5}, {0, 0, 1}}};
  const Arrays arrays = decoded(contacts_vtp(system, contacts));
  EXPECT_EQ(arrays.at("Points position"), flat({system.position[0], system.position[0] + Eigen::Vector3d(0.1, 0, 0), system.position[2],
                                                system.position[2] - Eigen::Vector3d(0, 0, 0.5)}));
  EXPECT_EQ(arrays.at("Lines connectivity"), (std::vector<double>{0, 1, 2, 3}));
  EXPECT_EQ(arrays.at("Lines offsets"), (std::vector<double>{2, 4}));
  EXPECT_EQ(arrays.at("CellData force"), (std::vector<double>{3, 4, 0, 0, 0, 1}));
  EXPECT_EQ(arrays.at("CellData force_magnitude"), (std::vector<double>{5, 1}));
  EXPECT_EQ(arrays.at("CellData touching"), (std::vector<double>{1, 0}));
  EXPECT_TRUE(decoded(contacts_vtp(system, {})).at("Lines offsets").empty());
}

TEST(Pvd, NamesTimesAndFiles) {
  const std::vector<std::pair<double, std::string>> frames = {{0, "a_0.vtp"}, {0.5, "a_1.vtp"}};
  EXPECT_EQ(pvd(frames),
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n<Collection>\n"
            "<DataSet timestep=\"0\" group=\"\" part=\"0\" file=\"a_0.vtp\"/>\n<DataSet timestep=\"0.5\" group=\"\" part=\"0\" "
            "file=\"a_1.vtp\"/>\n</Collection>\n</VTKFile>\n");
}

}  // namespace
}  // namespace scalebreak
