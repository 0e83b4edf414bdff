#include <scalebreak/particle_files/vtp.hpp>

#include <algorithm>
#include <bit>
#include <cstring>
#include <iterator>

#include <fmt/format.h>

namespace scalebreak {
namespace {

static_assert(std::endian::native == std::endian::little, "the files say LittleEndian");

template <class Number>
constexpr const char* vtk_type() {
  if constexpr (std::is_same_v<Number, double>) return "Float64";
  if constexpr (std::is_same_v<Number, std::int64_t>) return "Int64";
  if constexpr (std::is_same_v<Number, std::uint8_t>) return "UInt8";
}

/// The length in bytes and the numbers behind it, as one base64 text.
template <class Number>
std::string array(const std::string& name, const std::vector<Number>& numbers, int components = 1) {
  const std::uint64_t length = numbers.size() * sizeof(Number);
  std::vector<unsigned char> bytes(sizeof length + length);
  std::memcpy(bytes.data(), &length, sizeof length);
  if (length > 0) std::memcpy(bytes.data() + sizeof length, numbers.data(), length);
  return fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">{}</DataArray>\n", vtk_type<Number>(),
                     name, components, base64(bytes));
}

std::string array(const std::string& name, const std::vector<Eigen::Vector3d>& vectors) {
  std::vector<double> numbers;
  numbers.reserve(3 * vectors.size());
  for (const Eigen::Vector3d& v : vectors) numbers.insert(numbers.end(), v.begin(), v.end());
  return array(name, numbers, 3);
}

std::vector<std::int64_t> counted(std::size_t count, std::int64_t first, std::int64_t step) {
  std::vector<std::int64_t> numbers(count);
  for (std::size_t i = 0; i < count; ++i) numbers[i] = first + static_cast<std::int64_t>(i) * step;
  return numbers;
}

std::string poly_data(double time, std::size_t points, std::size_t vertices, std::size_t lines, const std::string& content) {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n"
      "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{:.17g}</DataArray>\n</FieldData>\n"
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n{}"
      "</Piece>\n</PolyData>\n</VTKFile>\n",
      time, points, vertices, lines, content);
}

std::string section(const std::string& name, const std::string& arrays) { return fmt::format("<{0}>\n{1}</{0}>\n", name, arrays); }

std::string cells(const std::string& name, std::size_t count, std::int64_t points_each) {
  return section(name, array("connectivity", counted(count * static_cast<std::size_t>(points_each), 0, 1)) +
                           array("offsets", counted(count, points_each, points_each)));
}

}  // namespace

std::string spheres_vtp(const System& system, const ParticleFields& fields) {
  const std::size_t count = system.count();
  std::string point_data;
  const auto add = [&](ParticleField field, const auto& values) {
    if (std::find(fields.begin(), fields.end(), field) != fields.end())
      point_data += array(particle_field_words[static_cast<std::size_t>(field)], values);
  };
  add(ParticleField::velocity, system.velocity);
  add(ParticleField::spin, system.spin);
  add(ParticleField::radius, system.radius);
  add(ParticleField::mass, system.mass);
  add(ParticleField::material, system.material);
  return poly_data(system.time, count, count, 0,
                   section("PointData", point_data + array("id", counted(count, 1, 1))) +
                       section("Points", array("position", system.position)) + cells("Verts", count, 1));
}

std::string contacts_vtp(const System& system, std::span<const ContactForce> contacts) {
  std::vector<Eigen::Vector3d> ends, force;
  std::vector<double> magnitude;
  std::vector<std::uint8_t> touching;
  for (const ContactForce& contact : contacts) {
    const Eigen::Vector3d& centre = system.position[static_cast<std::size_t>(contact.first)];
    ends.push_back(centre);
    ends.emplace_back(centre + contact.branch);
    force.push_back(contact.force);
    magnitude.push_back(contact.force.norm());
    touching.push_back(contact.touching ? 1 : 0);
  }
  return poly_data(system.time, ends.size(), 0, contacts.size(),
                   section("CellData", array("force", force) + array("force_magnitude", magnitude) + array("touching", touching)) +
                       section("Points", array("position", ends)) + cells("Lines", contacts.size(), 2));
}

std::string pvd(std::span<const std::pair<double, std::string>> frames) {
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n<Collection>\n";
  for (const auto& [time, file] : frames)
    fmt::format_to(std::back_inserter(text), "<DataSet timestep=\"{:.17g}\" group=\"\" part=\"0\" file=\"{}\"/>\n", time, file);
  return text + "</Collection>\n</VTKFile>\n";
}

std::string base64(std::span<const unsigned char> bytes) {
  constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::size_t given = std::min<std::size_t>(3, bytes.size() - at);
    unsigned word = 0;
    for (std::size_t k = 0; k < 3; ++k) word = word << 8 | (k < given ? bytes[at + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += k <= given ? letters[word >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

}  // namespace scalebreak
