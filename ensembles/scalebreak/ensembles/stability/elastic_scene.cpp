#include <scalebreak/ensembles/stability/elastic_scene.hpp>

namespace scalebreak {

Input elastic_scene(Input input) {
  for (Material* material : {&input.material, &input.second, &input.wall.material}) material->restitution = 1, material->surface_energy = 0;
  input.contact = effective_kind(input.contact, 0);
  input.surface = {};
  input.cell.shear_rate = input.cell.wall_speed = input.cell.pressure = 0;
  input.cell.gravity.setZero();
  input.cell.wall_no_slip = false;
  return input;
}

}  // namespace scalebreak
