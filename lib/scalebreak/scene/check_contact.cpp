#include <scalebreak/scene/check_contact.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/material/pair.hpp>
#include <scalebreak/scene/check_bodies.hpp>
#include <scalebreak/scene/sphere_sizes.hpp>

namespace scalebreak {
namespace {

constexpr const char* other_rolling = "rolling = \"none\", \"cdt\", \"epsd\", \"epsd2\" or \"sds\"";

/// A word of [contact] that does not go with the rest: contact.KEY = "WORD" needs NEEDS, and BUT; allowed: ALLOWED.
struct Refusal {
  std::string key, word;
  std::string needs, but, allowed;
};

[[noreturn]] void refuse(const Given& given, const Refusal& refusal) {
  const auto& [key, word, needs, but, allowed] = refusal;
  throw InputError(fmt::format("{}contact.{} = \"{}\" needs {}, and {}; allowed: {}",
                               place(given, {"contact." + key, "contact.attraction", "contact.normal"}), key, word, needs, but, allowed));
}

void refuse_without_radius(const Input& input, const Given& given, const std::string& key, const std::string& word,
                           const std::string& allowed) {
  refuse(
      given,
      {key, word, "a contact radius", fmt::format("contact.normal = \"{}\" has none", to_string(input.contact.normal)),
       allowed + ", or normal = " + normal_names_where([](const NormalTraits& other) { return other.coordinate != Coordinate::overlap; })});
}

/// Without a contact radius no law can work on it.
void check_without_radius(const Input& input, const Given& given) {
  if (find_given(given, "contact.damping_on") && input.contact.damping_on == DampingOn::contact_radius)
    refuse_without_radius(input, given, "damping_on", "contact_radius", "\"overlap\"");
  if (find_given(given, "contact.tangential_radius") && input.surface.tangential == TangentialModel::mindlin &&
      input.surface.tangential_radius == DampingOn::contact_radius)
    refuse_without_radius(input, given, "tangential_radius", "contact_radius", "\"overlap\"");
  if (input.surface.rolling == RollingModel::ar) refuse_without_radius(input, given, "rolling", "ar", other_rolling);
}

/// Two bodies that meet, as far as their surfaces go.
struct Meeting {
  SurfacePair surfaces;
  double radius;  ///< the smaller
  std::string who;
};

/// Of a flow its smallest spheres, as far as they are known before a particle file is read.
std::vector<Meeting> flow_meetings(const Input& input) {
  const Particles& particles = input.particles;
  const bool two = particles.size == SizeKind::bidisperse;
  const double small = size_range(particles, {input.material.density, input.second.density}).least,
               large = two ? particles.large_radius : small;
  std::vector<Meeting> all = {
      {sphere_surfaces(input.material, small, input.material, small), small, two ? "two small spheres" : "two spheres"}};
  if (two) {
    all.push_back({sphere_surfaces(input.material, small, input.second, large), small, "a small sphere and a large one"});
    all.push_back({sphere_surfaces(input.second, large, input.second, large), large, "two large spheres"});
  }
  if (std::find(input.cell.boundary.begin(), input.cell.boundary.end(), Boundary::wall) != input.cell.boundary.end() &&
      input.wall.attraction) {
    all.push_back({wall_surfaces(input.material, small, input.wall), small, two ? "a small sphere and a wall" : "a sphere and a wall"});
    if (two) all.push_back({wall_surfaces(input.second, large, input.wall), large, "a large sphere and a wall"});
  }
  if (!particles.file.empty()) {
    for (Meeting& meeting : all) meeting.radius = std::numeric_limits<double>::infinity();
  }
  return all;
}

std::vector<Meeting> meetings(const Input& input) {
  if (input.flow) return flow_meetings(input);
  if (!input.bodies.empty()) {
    std::vector<Meeting> all;
    for (const auto& [i, j] : meeting_pairs(input)) {
      const Body &a = input.bodies[i], &b = input.bodies[j];
      all.push_back({sphere_surfaces(input.material_of(a), a.radius, input.material_of(b), b.radius), std::min(a.radius, b.radius),
                     fmt::format("body.{} and body.{}", i + 1, j + 1)});
    }
    return all;
  }
  const double radius = input.radius[0];
  if (input.against_wall)
    return {{wall_surfaces(input.material, radius, input.wall), radius,
             input.wall.attraction ? "the sphere and the wall" : "the sphere and a wall with attraction = false"}};
  return {{sphere_surfaces(input.material, radius, input.second, input.radius[1]), std::min(radius, input.radius[1]), "the two spheres"}};
}

void check_liquid(const SurfaceKind& kind, const Meeting& meeting, const Given& given) {
  const std::string word = to_string(kind.attraction);
  const bool bridge = kind.attraction_range == AttractionRange::bridge;
  const auto none_between = [&](const char* what) { return fmt::format("{} between {} is 0", what, meeting.who); };
  if (kind.capillary() && meeting.surfaces.surface_tension == 0)
    refuse(given, {"attraction", word, "surface tension", none_between("the surface_tension"), "above 0, or attraction = \"none\""});
  if (kind.viscous() && meeting.surfaces.viscosity == 0)
    refuse(given, {"attraction", word, "viscosity", none_between("the viscosity"), "above 0, or attraction = \"none\""});
  const double volume = meeting.surfaces.bridge_volume;
  const std::string more = "a liquid_volume or liquid_fraction above 0, or ";
  if (kind.capillary() && volume == 0)
    refuse(given, {"attraction", word, "liquid", none_between("its volume"), more + "attraction = \"none\""});
  if (bridge && volume == 0)
    refuse(given, {"attraction_range", "bridge", "liquid", none_between("its volume"), more + "attraction_range = \"contact\""});
  // The rupture distance of Lian et al. 1993, with the contact angle in radians.
  const double rupture = (1 + meeting.surfaces.contact_angle / 2) * std::cbrt(volume);
  if (bridge && rupture >= meeting.radius) {
    refuse(given, {"attraction_range", "bridge", "small bridges",
                   fmt::format("that of {:g} m3 between {} ruptures at {:g} m, which is not below the radius of {:g} m", volume,
                               meeting.who, rupture, meeting.radius),
                   "less liquid, or attraction_range = \"contact\""});
  }
}

}  // namespace

void check_contact(Input& input, const Given& given) {
  const NormalTraits& law = input.contact.traits();
  if (!law.adhesive() && find_given(given, "contact.adhesion_range") && input.contact.range != AdhesionRange::touch) {
    refuse(given, {"adhesion_range", to_string(input.contact.range), "adhesion", fmt::format("contact.normal = \"{}\" has none", law.name),
                   "\"touch\", or normal = " + normal_names_where([](const NormalTraits& other) { return other.adhesive(); })});
  }
  if (law.coordinate == Coordinate::overlap) check_without_radius(input, given);
  input.contact = canonical(input.contact);
  // A Hertz contact has a = √(R* δ), and a linear one no radius but that.
  if (law.coordinate != Coordinate::radius_root) input.surface.tangential_radius = DampingOn::overlap;
}

void check_surfaces(const Input& input, const Given& given) {
  for (const Meeting& meeting : meetings(input)) {
    if (input.surface.rolling == RollingModel::ar && meeting.surfaces.surface_energy == 0) {
      refuse(given, {"rolling", "ar", "adhesion", fmt::format("the surface_energy between {} is 0", meeting.who),
                     std::string("above 0, or ") + other_rolling});
    }
    if (input.surface.attraction != Attraction::none) check_liquid(input.surface, meeting, given);
  }
}

}  // namespace scalebreak
