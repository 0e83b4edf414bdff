#include <scalebreak/scene/keys.hpp>

#include <algorithm>

#include <scalebreak/scene/advise_keys.hpp>
#include <scalebreak/scene/flow_keys.hpp>
#include <scalebreak/scene/key_makers.hpp>
#include <scalebreak/scene/study_keys.hpp>

namespace scalebreak {
namespace {

struct MaterialKey {
  const char *name, *unit, *meaning;
  double Material::*value;
  bool of_the_pair = false;  ///< what is given for a wall is the pair's
};

constexpr MaterialKey material_keys[] = {
    {"young", "Pa", "Young's modulus", &Material::young},
    {"poisson", "-", "Poisson's ratio", &Material::poisson},
    {"density", "kg/m3", "density", &Material::density},
    {"restitution", "-", "coefficient of restitution without adhesion", &Material::restitution, true},
    {"sliding_friction", "-", "coefficient of sliding friction (used with a tangential law)", &Material::sliding_friction, true},
    {"surface_energy", "J/m2", "surface energy of ONE surface; the work of adhesion is twice this", &Material::surface_energy},
    {"spring_constant", "N/m", "spring constant of the linear contact", &Material::spring_constant},
    {"spring_constant_tangential", "N/m", "spring constant of the linear tangential contact", &Material::spring_constant_tangential},
    {"rolling_friction", "-", "coefficient of rolling friction (cdt, epsd, epsd2, sds)", &Material::rolling_friction, true},
    {"rolling_damping", "-", "damping ratio of rolling (epsd)", &Material::rolling_damping, true},
    {"rolling_angle_max", "rad", "angle at which adhesive rolling yields (ar)", &Material::rolling_angle_max, true},
    {"rolling_spring_constant", "N/m", "force over displacement of the rolling spring (sds)", &Material::rolling_spring_constant, true},
    {"rolling_dashpot", "N s/m", "force over speed of the rolling dashpot (sds)", &Material::rolling_dashpot, true},
    {"surface_tension", "N/m", "surface tension of the liquid (capillary)", &Material::surface_tension},
    {"contact_angle", "rad", "contact angle of the liquid", &Material::contact_angle},
    {"viscosity", "Pa s", "viscosity of the liquid (viscous)", &Material::viscosity},
    {"liquid_volume", "m3", "volume of one liquid bridge, where there is no liquid_fraction", &Material::liquid_volume},
    {"liquid_fraction", "-", "volume of the liquid over that of the solids; 0: liquid_volume holds", &Material::liquid_fraction},
    {"separation_min", "m", "least separation in the viscous force; 0: separation_min_ratio holds", &Material::separation_min},
    {"separation_min_ratio", "-", "the same over the radius, where there is no separation_min", &Material::separation_min_ratio},
};

void add_material(std::vector<Key>& list, const std::string& section, const std::function<Material&(Input&)>& of) {
  for (const MaterialKey& key : material_keys) {
    const std::string meaning = std::string(key.meaning) + (key.of_the_pair && section == "wall" ? ", of the pair" : "");
    list.push_back(
        number(section, key.name, key.unit, meaning, [of, field = key.value](Input& input) -> double& { return of(input).*field; }));
  }
}

void add_contact(std::vector<Key>& list) {
  const auto add = [&](const char* name, const char* meaning, std::vector<std::string> words, auto part, auto member) {
    list.push_back(choice_of("contact", name, meaning, std::move(words), part, member));
  };
  add("normal", "normal force law", normal_names(), &Input::contact, &ContactKind::normal);
  add("adhesion_range", "where a JKR contact ends: tear-off fold, force minimum, zero overlap", {"full", "pull_off", "touch"},
      &Input::contact, &ContactKind::range);
  add("damping_on", "what the normal dashpot grows with", {"overlap", "contact_radius"}, &Input::contact, &ContactKind::damping_on);
  add("tangential", "tangential force law", words_of(tangential_words), &Input::surface, &SurfaceKind::tangential);
  add("tangential_radius", "what Mindlin's spring grows with", {"overlap", "contact_radius"}, &Input::surface,
      &SurfaceKind::tangential_radius);
  add("torque_arm", "lever of the tangential force: the radius, or the distance to the contact point", {"radius", "contact"},
      &Input::surface, &SurfaceKind::torque_arm);
  add("rolling", "rolling resistance", words_of(rolling_words), &Input::surface, &SurfaceKind::rolling);
  add("attraction", "forces of the liquid", words_of(attraction_words), &Input::surface, &SurfaceKind::attraction);
  add("attraction_range", "where they act: while the solids touch, or from first touch until the bridge ruptures",
      words_of(attraction_range_words), &Input::surface, &SurfaceKind::attraction_range);
}

std::vector<Key> make_keys() {
  std::vector<Key> list;
  add_material(list, "material", [](Input& input) -> Material& { return input.material; });
  add_material(list, "second", [](Input& input) -> Material& { return input.second; });
  add_material(list, "wall", [](Input& input) -> Material& { return input.wall.material; });
  list.push_back(
      flag("wall", "rigid", "the wall does not deform: its term drops out of E*", [](Input& input) -> bool& { return input.wall.rigid; }));
  list.push_back(flag("wall", "attraction", "particles adhere to the wall", [](Input& input) -> bool& { return input.wall.attraction; }));
  add_contact(list);
  list.push_back(numbers("pair", "radius", "m", "radii [r1, r2] of two spheres, [r1] against a wall", 1, 2,
                         [](Input& input) -> std::vector<double>& { return input.radius; }));
  list.push_back(choice(
      "pair", "partner", "what the first sphere meets", {"sphere", "wall"},
      [](Input& input, std::size_t i) { input.against_wall = i == 1; },
      [](const Input& input) { return static_cast<std::size_t>(input.against_wall); }));
  list.push_back(number("impact", "normal_speed", "m/s", "speed of approach at first touch",
                        [](Input& input) -> double& { return input.normal_speed; }));
  list.push_back(number("impact", "tangential_speed", "m/s", "speed of the first body along x at first touch",
                        [](Input& input) -> double& { return input.tangential_speed; }));
  list.push_back(vector3("impact", "spin1", "rad/s", "spin of the first body, about its centre",
                         [](Input& input) -> Eigen::Vector3d& { return input.spin1; }));
  list.push_back(vector3("impact", "spin2", "rad/s", "spin of the second body, about its centre",
                         [](Input& input) -> Eigen::Vector3d& { return input.spin2; }));
  add_particles(list);
  add_cell(list);
  const auto names = scaling_law_names();
  list.push_back(choice(
      "scaling", "law", "scaling law", names, [names](Input& input, std::size_t i) { input.scaling_law = names[i]; },
      [names](const Input& input) {
        return static_cast<std::size_t>(std::find(names.begin(), names.end(), input.scaling_law) - names.begin());
      }));
  list.push_back(number("scaling", "factor", "-", "stiffness ratio (at most 1) or size ratio (at least 1), as the law has it",
                        [](Input& input) -> double& { return input.scaling_factor; }));
  list.push_back(choice(
      "scaling", "keep",
      "of a flow under a law that enlarges: the same count in a cell larger by factor, or the same cell with count / factor^3",
      words_of(keep_words), [](Input& input, std::size_t i) { input.keep = static_cast<Keep>(i); },
      [](const Input& input) { return static_cast<std::size_t>(input.keep); }));
  add_run(list);
  add_output(list);
  add_study(list);
  add_advise(list);
  list.push_back(number("numerics", "tolerance", "-", "of the restitution and the relative contact time of an exact collision",
                        [](Input& input) -> double& { return input.tolerance; }));
  list.push_back(number("numerics", "table_tolerance", "-", "of a collision table, in e^2 and in relative contact time",
                        [](Input& input) -> double& { return input.table_tolerance; }));
  return list;
}

}  // namespace

const std::vector<Key>& keys() {
  static const std::vector<Key> list = make_keys();
  return list;
}

std::vector<Key> body_keys(std::size_t index) {
  const auto body = [index](Input& input) -> Body& { return input.bodies[index]; };
  return {vector3("body", "position", "m", "centre", [body](Input& input) -> Eigen::Vector3d& { return body(input).position; }),
          vector3("body", "velocity", "m/s", "velocity", [body](Input& input) -> Eigen::Vector3d& { return body(input).velocity; }),
          vector3("body", "spin", "rad/s", "spin", [body](Input& input) -> Eigen::Vector3d& { return body(input).spin; }),
          number("body", "radius", "m", "radius", [body](Input& input) -> double& { return body(input).radius; }),
          flag("body", "fixed", "moves on as it started, whatever acts on it", [body](Input& input) -> bool& { return body(input).fixed; }),
          choice(
              "body", "material", "section of its material; of two bodies the second one's default is \"second\"", {"material", "second"},
              [body](Input& input, std::size_t i) { body(input).second = i == 1; },
              [body](const Input& input) { return static_cast<std::size_t>(body(const_cast<Input&>(input)).second); })};
}

}  // namespace scalebreak
