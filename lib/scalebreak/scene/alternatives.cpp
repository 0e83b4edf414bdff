#include <scalebreak/scene/alternatives.hpp>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>

namespace scalebreak {
namespace {

struct Alternative {
  const char* first;
  double Material::*first_value;
  const char* other;
  double Material::*other_value;
};

constexpr Alternative alternatives[] = {
    {"liquid_fraction", &Material::liquid_fraction, "liquid_volume", &Material::liquid_volume},
    {"separation_min", &Material::separation_min, "separation_min_ratio", &Material::separation_min_ratio},
};

double number_given(const Assignment* item) { return item ? std::get<double>(item->value) : 0.0; }

}  // namespace

void settle_alternatives(Material& material, const std::string& section, const Given& given) {
  for (const auto& [first, first_value, other, other_value] : alternatives) {
    if (find_given(given, section + "." + other) && !find_given(given, section + "." + first)) material.*first_value = 0;
    if (material.*first_value > 0) material.*other_value = Material{}.*other_value;
  }
}

void check_alternatives(const std::string& section, const Given& given) {
  for (const Alternative& a : alternatives) {
    const Assignment* first = find_given(given, section + "." + a.first);
    const Assignment* other = find_given(given, section + "." + a.other);
    if (number_given(first) == 0 || number_given(other) == 0) continue;
    throw InputError(fmt::format("{}: {} and {} exclude each other, found {} and {}; allowed: one of the two, or {} = 0",
                                 std::max(first, other)->where.text, first->key, other->key, to_toml(first->value), to_toml(other->value),
                                 first->key));
  }
}

bool overruled(const Material& material, const std::string& name) {
  for (const Alternative& a : alternatives) {
    if (name == a.other) return material.*a.first_value > 0;
  }
  return false;
}

}  // namespace scalebreak
