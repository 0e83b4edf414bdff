#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/dem/engine.hpp>

// How the cell's height follows the normal stress. Velocities are those about the affine motion of the height, so that with its rate
// ε = Ḣ/H
//
//     ẋ = v_x,  m v̇_x = F_x + m γ̇ ε (z − H/2),  ż = v_z + ε z,  m v̇_z = F_z − m ε v_z
//
// A step moves the spheres by their velocities, as in any cell, and then maps places and velocities onto the new height. Each sphere keeps
// its velocity about the shear at its own height, and an image its distance, to rounding.

namespace scalebreak {

using namespace dem;

void Dem::Engine::set_up_height(const System& start) {
  if (setup_.pressure == 0) return;
  if (!(setup_.pressure > 0) || !std::isfinite(setup_.pressure))
    throw InputError(fmt::format("the pressure is {} Pa; allowed: above 0, or 0 for a height that is kept", setup_.pressure));
  if (!cell_.periodic(0) || !cell_.periodic(1) || !cell_.periodic(2) || !setup_.gravity.isZero(0))
    throw InputError("a height that follows the pressure needs periodic faces all around and no gravity");
  double mass = 0, area = 0;
  for (std::size_t i = 0; i < start.count(); ++i) mass += start.mass[i], area += 4 * start.radius[i] * start.radius[i];
  height_ = {.pressure = setup_.pressure, .inertia = mass / area};
}

void Dem::Engine::map_onto_height(Worker& worker) {
  const double middle = cell_.size.z() / 2, faster = cell_.shear_rate * (stretch_ - 1), slower = 1 / stretch_;
  for (std::uint32_t i = worker.begin; i < worker.end; ++i) {
    Quad &x = spheres_.position[i], &v = spheres_.velocity[i];
    const double gain = faster * (x.z - middle);
    v.x += gain, v.z *= slower;
    if (!spheres_.seen_velocity.empty()) spheres_.seen_velocity[i].x += gain, spheres_.seen_velocity[i].z *= slower;
    x.z *= stretch_;
  }
}

void Dem::Engine::stretch_cell() {
  grid_offset_ += cell_.shear_rate * cell_.size.z() * setup_.step;
  cell_ = advanced(cell_, setup_.step);
  cell_.size.z() *= stretch_;
  volume_fraction_ /= stretch_;
  stretch_rate_ = height_.speed / cell_.size.z();
  const double least = 2 * (2 * largest_ + rows_.largest_reach());
  if (!(cell_.size.z() > least))
    throw WorkError(
        fmt::format("at t = {:.6g} s (step {}) the cell is {:g} m high, so that a sphere could meet two images of another; allowed: above "
                    "{:g} m; take more spheres, or a cell that is shorter along x and y",
                    time(), steps_, cell_.size.z(), least));
}

void Dem::Engine::sum_normal_flux(Worker& worker) {
  double flux = 0;
  for (std::uint32_t i = worker.begin; i < worker.end; ++i) {
    const Quad& v = spheres_.velocity[i];
    const double speed = v.z + setup_.step / 2 * v.w * spheres_.force[i].z;
    flux += speed * speed / v.w;
  }
  worker.normal_flux = flux;
}

void Dem::Engine::push_height() {
  double moment = 0;  // V P_zz
  for (const Worker& worker : workers_) moment += worker.normal_flux + worker.tally.moment[8];
  const double height = cell_.size.z(), pushed = height_.pushed(height, moment / cell_.volume(), setup_.step);
  totals_.wall_work -= moment / height * setup_.step * (height_.speed + pushed) / 2;
  height_.speed = pushed;
  stretch_ = 1 + setup_.step * pushed / height;
}

}  // namespace scalebreak
