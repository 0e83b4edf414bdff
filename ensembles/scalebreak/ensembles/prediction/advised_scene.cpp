#include <cmath>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/ensembles/prediction/advice.hpp>
#include <scalebreak/scene/flow_scene.hpp>

namespace scalebreak {
namespace {

[[noreturn]] void refuse(const char* key, double value, const std::string& why) {
  throw InputError(fmt::format("advise.{}: found {:g}, and {}; allowed: 0, or another scene", key, value, why));
}

/// The volume fraction stays, or becomes `fraction`; the number of spheres follows where the cell is given.
void fill(Input& scene, double fraction) {
  scene.particles.volume_fraction = fraction;
  if (!scene.cell.size.isZero(0)) scene.particles.count = 0;
}

}  // namespace

Input advised_scene(const Input& input) {
  const AdviseInput& asked = input.advise;
  Input scene = original_of(input);
  const bool file = !scene.particles.file.empty();
  if (asked.volume_fraction > 0) {
    if (file) refuse("volume_fraction", asked.volume_fraction, "particles.file says how many spheres there are");
    fill(scene, asked.volume_fraction);
  }
  if (asked.size > 0) {
    if (file) refuse("size", asked.size, "particles.file says what sizes there are");
    fill(scene, plan_flow(scene).volume_fraction);
    scene.particles.large_radius *= asked.size / scene.particles.radius;
    scene.particles.radius = asked.size;
  }
  if (asked.shear_rate > 0) {
    const CellKind kind = scene.cell.kind;
    if (kind == CellKind::cooling || kind == CellKind::box)
      refuse("shear_rate", asked.shear_rate,
             fmt::format("cell.kind = \"{}\" is not sheared", cell_kind_words[static_cast<std::size_t>(kind)]));
    const bool walls = kind == CellKind::couette;  // there it is the walls that shear
    walls ? void(scene.cell.wall_speed = asked.shear_rate * scene.cell.size.z() / 2) : void(scene.cell.shear_rate = asked.shear_rate);
    if (walls && scene.cell.size.z() == 0) scene.cell.shear_rate = asked.shear_rate;
  }
  if (asked.pressure > 0) scene.cell.pressure = asked.pressure;
  if (asked.speed > 0) scene.particles.speed = asked.speed;
  return scene;
}

}  // namespace scalebreak
