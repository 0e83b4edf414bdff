#include <scalebreak/scene/check_input.hpp>

#include <algorithm>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/scaling/scaling_law.hpp>
#include <scalebreak/scene/alternatives.hpp>
#include <scalebreak/scene/check_bodies.hpp>
#include <scalebreak/scene/check_contact.hpp>
#include <scalebreak/scene/check_flow.hpp>

namespace scalebreak {
namespace {

void check_pair(Input& input, const Given& given) {
  for (const Assignment& item : given) {
    if (item.key.rfind("run.", 0) == 0)
      throw InputError(fmt::format("{}: {} cannot stand without [[body]], [particles] or [cell]: a pair of [pair] ends by itself",
                                   item.where.text, item.key));
  }
  const bool radius_given = find_given(given, "pair.radius") != nullptr;
  if (input.against_wall && !radius_given) input.radius.resize(1);
  const std::size_t wanted = input.against_wall ? 1 : 2;
  if (input.radius.size() != wanted) {
    throw InputError(fmt::format("{}pair.radius holds {} for pair.partner = \"{}\"; allowed: {}",
                                 place(given, {"pair.radius", "pair.partner"}), input.radius.size() == 1 ? "one radius" : "two radii",
                                 input.against_wall ? "wall" : "sphere", input.against_wall ? "one, [r1]" : "two, [r1, r2]"));
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
  input.flow = begins_flow(given);
  const bool bodies = !input.bodies.empty();
  if (input.flow) {
    check_flow_is_whole(input, given);
  } else if (bodies) {
    check_bodies_are_whole(input, given);
  }
  for (const char* section : {"material", "second", "wall"}) check_alternatives(section, given);
  check_contact(input, given);
  if (!input.flow) {
    refuse_flow_keys(given);
    bodies ? check_bodies(input, given) : check_pair(input, given);
  }
  check_scaling(input, given);
  if (input.flow) complete_and_check_flow(input, given);
  check_surfaces(input, given);
}

}  // namespace scalebreak
