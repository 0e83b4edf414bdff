#include <scalebreak/scene/check_input.hpp>

#include <algorithm>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/scaling/scaling_law.hpp>

namespace scalebreak {
namespace {

using Given = std::vector<Assignment>;

const Assignment* find(const Given& given, const std::string& key) {
  const auto at = std::find_if(given.begin(), given.end(), [&](const Assignment& item) { return item.key == key; });
  return at == given.end() ? nullptr : &*at;
}

/// The place to blame: that of the first of these keys that was given.
std::string place(const Given& given, std::initializer_list<const char*> blame) {
  for (const char* key : blame) {
    if (const Assignment* item = find(given, key)) return item->where.text + ": ";
  }
  return "";
}

void check_contact(Input& input, const Given& given) {
  const NormalModel normal = input.contact.normal;
  if (normal == NormalModel::jkr) return;
  const Assignment* range = find(given, "contact.adhesion_range");
  if (range && input.contact.range != AdhesionRange::touch) {
    throw InputError(
        fmt::format("{}: contact.adhesion_range = \"{}\" needs adhesion, and contact.normal = \"{}\" has none; allowed: \"touch\", or "
                    "normal = \"jkr\"",
                    range->where.text, to_string(input.contact.range), to_string(normal)));
  }
  const Assignment* damping = find(given, "contact.damping_on");
  if (damping && normal == NormalModel::linear && input.contact.damping_on == DampingOn::contact_radius) {
    throw InputError(
        fmt::format("{}: contact.damping_on = \"contact_radius\" needs a contact radius, and contact.normal = \"linear\" has none; "
                    "allowed: \"overlap\", or normal = \"hertz\" or \"jkr\"",
                    damping->where.text));
  }
  input.contact = canonical(input.contact);
}

void check_pair(Input& input, const Given& given) {
  const bool radius_given = find(given, "pair.radius") != nullptr;
  if (input.against_wall && !radius_given) input.radius.resize(1);
  const std::size_t wanted = input.against_wall ? 1 : 2;
  if (input.radius.size() != wanted) {
    throw InputError(fmt::format("{}pair.radius holds {} for pair.partner = \"{}\"; allowed: {}",
                                 place(given, {"pair.radius", "pair.partner"}), input.radius.size() == 1 ? "one radius" : "two radii",
                                 input.against_wall ? "wall" : "sphere", input.against_wall ? "one, [r1]" : "two, [r1, r2]"));
  }
}

void check_bodies(const Input& input, const Given& given) {
  for (const Assignment& item : given) {
    if (item.key.rfind("pair.", 0) == 0 || item.key.rfind("impact.", 0) == 0) {
      throw InputError(
          fmt::format("{}: {} cannot stand beside [[body]]: the bodies say where they are and how they move", item.where.text, item.key));
    }
  }
  for (std::size_t i = 1; i <= 2; ++i) {
    for (const char* name : {"position", "radius"}) {
      if (!find(given, fmt::format("body.{}.{}", i, name)))
        throw InputError(fmt::format("body.{}.{} is missing; two [[body]] tables are needed, each with position and radius", i, name));
    }
  }
  const Body& a = input.bodies[0];
  const Body& b = input.bodies[1];
  const Eigen::Vector3d between = b.position - a.position;
  const double distance = between.norm(), touch = a.radius + b.radius;
  const std::string where = place(given, {"body.2.position"});
  if (touch - distance > touching_overlap * std::min(a.radius, b.radius)) {
    throw InputError(
        fmt::format("{}body.1 and body.2 overlap by {:g} m at the start (distance {:g} m, radii {:g} m and {:g} m); allowed: at most {:g} "
                    "of the radius",
                    where, touch - distance, distance, a.radius, b.radius, touching_overlap));
  }
  const Eigen::Vector3d normal = between / distance, approach = a.velocity - b.velocity;
  const double speed = approach.dot(normal);
  if (!(speed > 0))
    throw InputError(
        fmt::format("{}body.1 and body.2 do not approach each other, found a closing speed of {:g} m/s; allowed: above 0", where, speed));
  if ((approach - speed * normal).norm() > head_on_share * speed) {
    throw InputError(
        fmt::format("{}body.1 and body.2 do not meet head-on, and contact.tangential = \"none\" resolves head-on collisions only; found "
                    "{:g} m/s across the line of centres; allowed: {:g} of the closing speed",
                    where, (approach - speed * normal).norm(), head_on_share));
  }
}

void check_scaling(const Input& input, const Given& given) {
  const ScalingLaw& chosen = *find_scaling_law(input.scaling_law);
  // Every law takes the factor 1: what is refused there is refused for the contact.
  const bool contact = refusal(chosen, 1, input.contact.normal).has_value();
  const std::string where = contact ? place(given, {"scaling.law", "contact.normal"}) : place(given, {"scaling.factor", "scaling.law"});
  if (const auto why = refusal(chosen, input.scaling_factor, input.contact.normal)) throw InputError(where + *why);
  for (const std::string& name : input.study_laws) {
    const ScalingLaw& law = *find_scaling_law(name);
    std::optional<std::string> last;
    const bool some = std::any_of(input.study_factors.begin(), input.study_factors.end(),
                                  [&](double factor) { return !(last = refusal(law, factor, input.contact.normal)); });
    if (!some)
      throw InputError(fmt::format("{}study.laws holds \"{}\", which no factor of study.factors suits: {}",
                                   place(given, {"study.laws", "study.factors"}), name, *last));
  }
}

}  // namespace

void complete_and_check(Input& input, const Given& given) {
  check_contact(input, given);
  input.bodies.empty() ? check_pair(input, given) : check_bodies(input, given);
  check_scaling(input, given);
}

}  // namespace scalebreak
