#include <scalebreak/scene/check_flow.hpp>

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/scene/check_cell.hpp>
#include <scalebreak/scene/sphere_sizes.hpp>

namespace scalebreak {
namespace {

bool in_section(const std::string& key, const char* section) { return key.rfind(std::string(section) + ".", 0) == 0; }

/// Keys that a particle file answers.
bool said_by_file(const std::string& dotted) {
  return dotted == "cell.size" || (in_section(dotted, "particles") && dotted != "particles.file");
}

/// Does [second] play a part?
bool uses_second(const Input& input) { return input.particles.size == SizeKind::bidisperse || !input.particles.file.empty(); }

bool enlarges(const Input& input) {
  return find_scaling_law(input.scaling_law)->factor_of != FactorOf::stiffness && input.scaling_factor >= 1;
}

bool above_zero(const Given& given, const std::string& key) {
  const Assignment* item = find_given(given, key);
  if (!item) return false;
  if (const auto* numbers = std::get_if<std::vector<double>>(&item->value))
    return std::any_of(numbers->begin(), numbers->end(), [](double x) { return x > 0; });
  return std::get<double>(item->value) > 0;
}

void check_file(Input& input, const Given& given) {
  for (const Assignment& item : given) {
    if (said_by_file(item.key))
      throw InputError(
          fmt::format("{}: {} cannot stand beside particles.file: the file says how many spheres there are, of what sizes, how "
                      "they move and in what cell",
                      item.where.text, item.key));
  }
  if (!std::filesystem::is_regular_file(input.particles.file))
    throw InputError(fmt::format("{}particles.file: found {}, which is no file; allowed: a particle file", place(given, {"particles.file"}),
                                 to_toml(Value(input.particles.file))));
  if (input.keep == Keep::cell && input.scaling_factor > 1)
    throw InputError(
        fmt::format("{}scaling.keep = \"cell\" cannot stand beside particles.file: larger spheres of a file do not fit where they "
                    "are; allowed: \"count\"",
                    place(given, {"scaling.keep", "particles.file"})));
  input.particles.count = 0, input.particles.volume_fraction = 0;
}

/// Two of count, volume_fraction and size fix the third.
void complete_three(Input& input, const Given& given) {
  const bool count = above_zero(given, "particles.count"), fraction = above_zero(given, "particles.volume_fraction"),
             size = above_zero(given, "cell.size");
  if (count && fraction && size) {
    const std::vector<std::string> keys = {"particles.count", "particles.volume_fraction", "cell.size"};
    const Assignment* last = nullptr;
    for (const std::string& key : keys) last = std::max(last, find_given(given, key));
    throw InputError(
        fmt::format("{}: particles.count, particles.volume_fraction and cell.size are all given, and two of them fix the third; "
                    "allowed: two of the three",
                    last->where.text));
  }
  if (size && (input.cell.size.array() == 0).any())
    throw InputError(
        fmt::format("{}cell.size: found {}; allowed: three numbers above 0, or [0, 0, 0] for a cube that follows from count "
                    "and volume_fraction",
                    place(given, {"cell.size"}), to_toml(find_given(given, "cell.size")->value)));
  const Particles defaults;
  input.particles.count = count ? input.particles.count : size ? 0 : defaults.count;
  input.particles.volume_fraction = fraction ? input.particles.volume_fraction : size && count ? 0 : defaults.volume_fraction;
}

void check_sizes(const Input& input, const Given& given) {
  const Particles& particles = input.particles;
  const std::string word = size_kind_words[static_cast<std::size_t>(particles.size)];
  const auto refuse = [&](const char* key, double value, const std::string& needs, const std::string& allowed) {
    throw InputError(fmt::format("{}particles.{} = {:g} needs {}, and particles.size = \"{}\"; allowed: {}",
                                 place(given, {std::string("particles.") + key, "particles.size"}), key, value, needs, word, allowed));
  };
  const bool two = particles.size == SizeKind::bidisperse;
  const bool spread = particles.size == SizeKind::gaussian || particles.size == SizeKind::lognormal;
  if (!two && particles.large_radius != 0) refuse("large_radius", particles.large_radius, "two sizes", "0, or size = \"bidisperse\"");
  if (!two && particles.large_mass_fraction != 0)
    refuse("large_mass_fraction", particles.large_mass_fraction, "two sizes", "0, or size = \"bidisperse\"");
  if (!spread && particles.size_spread != 0)
    refuse("size_spread", particles.size_spread, "a distribution", "0, or size = \"gaussian\" or \"lognormal\"");
  if (spread && particles.size_spread == 0)
    throw InputError(fmt::format("{}particles.size = \"{}\" needs a size_spread, found 0; allowed: above 0, or size = \"mono\"",
                                 place(given, {"particles.size_spread", "particles.size"}), word));
  if (particles.size == SizeKind::gaussian && particles.size_spread > gaussian_spread_max)
    throw InputError(
        fmt::format("{}particles.size_spread = {:g} is too wide for size = \"gaussian\", which would have radii near 0 or below; "
                    "allowed: at most {:g}, or size = \"lognormal\"",
                    place(given, {"particles.size_spread"}), particles.size_spread, gaussian_spread_max));
  if (two && particles.large_radius <= particles.radius)
    throw InputError(fmt::format("{}particles.large_radius: found {:g} beside particles.radius = {:g}; allowed: a larger one",
                                 place(given, {"particles.large_radius", "particles.radius"}), particles.large_radius, particles.radius));
  for (const Assignment& item : given) {
    if (in_section(item.key, "second") && !two)
      throw InputError(
          fmt::format("{}: {} cannot stand beside particles.size = \"{}\": [second] is the material of the large spheres of "
                      "size = \"bidisperse\"",
                      item.where.text, item.key, word));
  }
}

void complete_and_check_keep(Input& input, const Given& given) {
  const bool walls =
      input.cell.boundary[0] == Boundary::wall || input.cell.boundary[1] == Boundary::wall || input.cell.boundary[2] == Boundary::wall;
  const Assignment* item = find_given(given, "scaling.keep");
  if (item && !enlarges(input))
    throw InputError(
        fmt::format("{}: scaling.keep = \"{}\" needs a law that enlarges the spheres, and scaling.law = \"{}\" with "
                    "scaling.factor = {:g} makes them softer; allowed: no scaling.keep",
                    item->where.text, keep_words[static_cast<std::size_t>(input.keep)], input.scaling_law, input.scaling_factor));
  if (!item) input.keep = enlarges(input) && walls && input.particles.file.empty() ? Keep::cell : Keep::count;
}

}  // namespace

bool begins_flow(const Given& given) {
  return std::any_of(given.begin(), given.end(),
                     [](const Assignment& item) { return in_section(item.key, "particles") || in_section(item.key, "cell"); });
}

bool of_flow_only(const std::string& dotted) {
  return in_section(dotted, "particles") || in_section(dotted, "cell") || in_section(dotted, "output") || dotted == "scaling.keep" ||
         (in_section(dotted, "run") && dotted != "run.duration");
}

bool holds_in_flow(const Input& input, const std::string& dotted) {
  if (in_section(dotted, "pair") || in_section(dotted, "impact") || in_section(dotted, "body")) return false;
  if (in_section(dotted, "second")) return uses_second(input);
  if (said_by_file(dotted)) return input.particles.file.empty();
  return dotted != "scaling.keep" || enlarges(input);
}

void refuse_flow_keys(const Given& given) {
  for (const Assignment& item : given) {
    if (of_flow_only(item.key))
      throw InputError(fmt::format("{}: {} cannot stand without [particles] or [cell]: it is a key of flows", item.where.text, item.key));
  }
}

void check_flow_is_whole(const Input& input, const Given& given) {
  for (const Assignment& item : given) {
    if (in_section(item.key, "pair") || in_section(item.key, "impact") || in_section(item.key, "body"))
      throw InputError(
          fmt::format("{}: {} cannot stand beside [particles] or [cell]: a flow is no pair and no few bodies", item.where.text, item.key));
  }
  if (input.particles.size != SizeKind::bidisperse) return;
  for (const char* key : {"particles.large_radius", "particles.large_mass_fraction"}) {
    if (!find_given(given, key))
      throw InputError(fmt::format("{} is missing; particles.size = \"bidisperse\" needs large_radius and large_mass_fraction", key));
  }
}

void complete_and_check_flow(Input& input, const Given& given) {
  complete_and_check_cell(input, given);
  complete_and_check_keep(input, given);
  if (!input.particles.file.empty()) {
    check_file(input, given);
  } else {
    complete_three(input, given);
    check_sizes(input, given);
    check_room(input, given);
  }
  complete_and_check_run(input, given);
}

}  // namespace scalebreak
