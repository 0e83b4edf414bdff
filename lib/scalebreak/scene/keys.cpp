#include <scalebreak/scene/keys.hpp>

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scalebreak/base/error.hpp>

namespace scalebreak {
namespace {

/// A reference to a member of an Input, given one: lets a key be written once for reading and writing.
template <class T>
using Member = std::function<T&(Input&)>;

std::string found(const Value& value) { return "found " + to_toml(value); }

template <class T>
const T& expect(const Value& value) {
  if (const T* held = std::get_if<T>(&value)) return *held;
  throw found(value);
}

void check(const Bounds& bounds, double number, const Value& value) {
  if (!std::isfinite(number) || !bounds.contain(number)) throw found(value);
}

/// The bounds by section and name; materials share theirs.
const std::map<std::string, Bounds, std::less<>>& all_bounds() {
  static const std::map<std::string, Bounds, std::less<>> map = {
      {"young", {1e2, 1e14}},
      {"poisson", {0, 0.5}},
      {"density", {1e-2, 1e6}},
      {"restitution", {0, 1, false}},
      {"sliding_friction", {0, 1e3}},
      {"surface_energy", {0, 1e3}},
      {"spring_constant", {1e-6, 1e12}},
      {"pair.radius", {1e-9, 1e2}},
      {"impact.normal_speed", {1e-9, 1e4}},
      {"body.position", {-1e3, 1e3}},
      {"body.velocity", {-1e4, 1e4}},
      {"body.radius", {1e-9, 1e2}},
      {"scaling.factor", {1e-8, 1e3}},
      {"study.factors", {1e-8, 1e3}},
      {"study.speeds", {1e-9, 1e4}},
      {"numerics.tolerance", {1e-13, 1e-6}},
      {"numerics.table_tolerance", {1e-7, 1e-2}},
  };
  return map;
}

Key number(const std::string& section, const std::string& name, const std::string& unit, const std::string& meaning,
           Member<double> member) {
  const Bounds bounds = bounds_of(section + "." + name);
  return {section,
          name,
          unit,
          meaning,
          "a number " + bounds.text(),
          [=](Input& input, const Value& value) {
            const double given = expect<double>(value);
            check(bounds, given, value);
            member(input) = given;
          },
          [=](const Input& input) { return Value(member(const_cast<Input&>(input))); }};
}

Key numbers(const std::string& section, const std::string& name, const std::string& unit, const std::string& meaning, std::size_t least,
            std::size_t most, Member<std::vector<double>> member) {
  const Bounds bounds = bounds_of(section + "." + name);
  const std::string how_many = least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most);
  return {section,
          name,
          unit,
          meaning,
          fmt::format("an array of {} numbers {}", how_many, bounds.text()),
          [=](Input& input, const Value& value) {
            const auto& given = expect<std::vector<double>>(value);
            if (given.size() < least || given.size() > most) throw found(value);
            for (const double item : given) check(bounds, item, value);
            member(input) = given;
          },
          [=](const Input& input) { return Value(member(const_cast<Input&>(input))); }};
}

Key vector3(const std::string& name, const std::string& unit, const std::string& meaning, Member<Eigen::Vector3d> member) {
  const Bounds bounds = bounds_of("body." + name);
  return {"body",
          name,
          unit,
          meaning,
          fmt::format("an array of 3 numbers {}", bounds.text()),
          [=](Input& input, const Value& value) {
            const auto& given = expect<std::vector<double>>(value);
            if (given.size() != 3) throw found(value);
            for (const double item : given) check(bounds, item, value);
            member(input) = Eigen::Vector3d(given[0], given[1], given[2]);
          },
          [=](const Input& input) {
            const Eigen::Vector3d& v = member(const_cast<Input&>(input));
            return Value(std::vector<double>{v[0], v[1], v[2]});
          }};
}

Key flag(const std::string& section, const std::string& name, const std::string& meaning, Member<bool> member) {
  return {section,
          name,
          "-",
          meaning,
          "true or false",
          [=](Input& input, const Value& value) { member(input) = expect<bool>(value); },
          [=](const Input& input) { return Value(member(const_cast<Input&>(input))); }};
}

/// A word out of a list; `put` takes its index, `take` gives it.
Key choice(const std::string& section, const std::string& name, const std::string& meaning, std::vector<std::string> words,
           std::function<void(Input&, std::size_t)> put, std::function<std::size_t(const Input&)> take) {
  return {section,
          name,
          "-",
          meaning,
          fmt::format("\"{}\"", fmt::join(words, "\", \"")),
          [=](Input& input, const Value& value) {
            const auto at = std::find(words.begin(), words.end(), expect<std::string>(value));
            if (at == words.end()) throw found(value);
            put(input, static_cast<std::size_t>(at - words.begin()));
          },
          [=](const Input& input) { return Value(words[take(input)]); }};
}

template <class Enum>
Key choice_of(const std::string& section, const std::string& name, const std::string& meaning, std::vector<std::string> words,
              Enum ContactKind::*member) {
  return choice(
      section, name, meaning, std::move(words), [=](Input& input, std::size_t i) { input.contact.*member = static_cast<Enum>(i); },
      [=](const Input& input) { return static_cast<std::size_t>(input.contact.*member); });
}

/// A law that this version does not have: the key is there, its one value is "none".
Key none_only(const std::string& name, const std::string& meaning) {
  return choice(
      "contact", name, meaning, {"none"}, [](Input&, std::size_t) {}, [](const Input&) { return std::size_t{0}; });
}

std::vector<std::string> law_names() {
  std::vector<std::string> names;
  for (const ScalingLaw& law : scaling_laws()) names.emplace_back(law.name);
  return names;
}

void add_material(std::vector<Key>& list, const std::string& section, const std::function<Material&(Input&)>& of) {
  const auto member = [of](double Material::*field) { return Member<double>([=](Input& input) -> double& { return of(input).*field; }); };
  list.push_back(number(section, "young", "Pa", "Young's modulus", member(&Material::young)));
  list.push_back(number(section, "poisson", "-", "Poisson's ratio", member(&Material::poisson)));
  list.push_back(number(section, "density", "kg/m3", "density", member(&Material::density)));
  list.push_back(number(section, "restitution", "-",
                        section == "wall" ? "coefficient of restitution, of the pair" : "coefficient of restitution, without adhesion",
                        member(&Material::restitution)));
  list.push_back(number(section, "sliding_friction", "-", "coefficient of sliding friction (used with a tangential law)",
                        member(&Material::sliding_friction)));
  list.push_back(number(section, "surface_energy", "J/m2", "surface energy of ONE surface; the work of adhesion is twice this",
                        member(&Material::surface_energy)));
  list.push_back(number(section, "spring_constant", "N/m", "spring constant of the linear contact", member(&Material::spring_constant)));
}

std::vector<Key> make_keys() {
  std::vector<Key> list;
  add_material(list, "material", [](Input& input) -> Material& { return input.material; });
  add_material(list, "second", [](Input& input) -> Material& { return input.second; });
  add_material(list, "wall", [](Input& input) -> Material& { return input.wall.material; });
  list.push_back(
      flag("wall", "rigid", "the wall does not deform: its term drops out of E*", [](Input& input) -> bool& { return input.wall.rigid; }));
  list.push_back(flag("wall", "attraction", "particles adhere to the wall", [](Input& input) -> bool& { return input.wall.attraction; }));
  list.push_back(choice_of("contact", "normal", "normal force law", {"linear", "hertz", "jkr"}, &ContactKind::normal));
  list.push_back(choice_of("contact", "adhesion_range", "where a JKR contact ends: tear-off fold, force minimum, zero overlap",
                           {"full", "pull_off", "touch"}, &ContactKind::range));
  list.push_back(
      choice_of("contact", "damping_on", "what the normal dashpot grows with", {"overlap", "contact_radius"}, &ContactKind::damping_on));
  list.push_back(none_only("tangential", "tangential law (this version has none)"));
  list.push_back(none_only("rolling", "rolling law (this version has none)"));
  list.push_back(none_only("attraction", "liquid force (this version has none)"));
  list.push_back(numbers("pair", "radius", "m", "radii [r1, r2] of two spheres, [r1] against a wall", 1, 2,
                         [](Input& input) -> std::vector<double>& { return input.radius; }));
  list.push_back(choice(
      "pair", "partner", "what the first sphere meets", {"sphere", "wall"},
      [](Input& input, std::size_t i) { input.against_wall = i == 1; },
      [](const Input& input) { return static_cast<std::size_t>(input.against_wall); }));
  list.push_back(number("impact", "normal_speed", "m/s", "speed of approach at first touch",
                        [](Input& input) -> double& { return input.normal_speed; }));
  const auto names = law_names();
  list.push_back(choice(
      "scaling", "law", "scaling law", names, [names](Input& input, std::size_t i) { input.scaling_law = names[i]; },
      [names](const Input& input) {
        return static_cast<std::size_t>(std::find(names.begin(), names.end(), input.scaling_law) - names.begin());
      }));
  list.push_back(number("scaling", "factor", "-", "stiffness ratio (at most 1) or size ratio (at least 1), as the law has it",
                        [](Input& input) -> double& { return input.scaling_factor; }));
  list.push_back({"study", "laws", "-", "scaling laws to compare; empty: all that suit the contact",
                  fmt::format("an array of \"{}\"", fmt::join(names, "\", \"")),
                  [names](Input& input, const Value& value) {
                    if (const auto* empty = std::get_if<std::vector<double>>(&value); empty && empty->empty())
                      return input.study_laws.clear();
                    for (const std::string& name : expect<std::vector<std::string>>(value)) {
                      if (std::find(names.begin(), names.end(), name) == names.end()) throw found(value);
                    }
                    input.study_laws = std::get<std::vector<std::string>>(value);
                  },
                  [](const Input& input) { return Value(input.study_laws); }});
  list.push_back(numbers("study", "factors", "-", "factors to compare; each law takes those on its side of 1", 1, 1000,
                         [](Input& input) -> std::vector<double>& { return input.study_factors; }));
  list.push_back(numbers("study", "speeds", "m/s", "impact speeds; empty: about the sticking speed", 0, 1000,
                         [](Input& input) -> std::vector<double>& { return input.study_speeds; }));
  list.push_back(number("numerics", "tolerance", "-", "of the restitution and the relative contact time of an exact collision",
                        [](Input& input) -> double& { return input.tolerance; }));
  list.push_back(number("numerics", "table_tolerance", "-", "of a collision table, in e^2 and in relative contact time",
                        [](Input& input) -> double& { return input.table_tolerance; }));
  return list;
}

}  // namespace

std::string Bounds::text() const { return fmt::format("{} {} and at most {:g}", low_allowed ? "of at least" : "above", low, high); }

Bounds bounds_of(std::string_view dotted) {
  const auto& map = all_bounds();
  if (const auto at = map.find(dotted); at != map.end()) return at->second;
  if (const std::size_t dot = dotted.find('.'); dot != std::string_view::npos) {
    if (const auto at = map.find(dotted.substr(dot + 1)); at != map.end()) return at->second;
  }
  throw WorkError(fmt::format("{} has no bounds", dotted));
}

const std::vector<Key>& keys() {
  static const std::vector<Key> list = make_keys();
  return list;
}

std::vector<Key> body_keys(std::size_t index) {
  const auto body = [index](Input& input) -> Body& { return input.bodies[index]; };
  return {vector3("position", "m", "centre", [body](Input& input) -> Eigen::Vector3d& { return body(input).position; }),
          vector3("velocity", "m/s", "velocity", [body](Input& input) -> Eigen::Vector3d& { return body(input).velocity; }),
          number("body", "radius", "m", "radius", [body](Input& input) -> double& { return body(input).radius; })};
}

}  // namespace scalebreak
