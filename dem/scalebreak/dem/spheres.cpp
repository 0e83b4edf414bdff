#include <scalebreak/dem/spheres.hpp>

#include <numeric>

namespace scalebreak::dem {

namespace {

/// What a core's caches can be expected to hold [bytes].
constexpr std::size_t cached = 4u << 20;

}  // namespace

Spheres::Spheres(const System& system, bool turns, bool estimates) {
  const std::size_t n = system.count();
  id.resize(n);
  std::iota(id.begin(), id.end(), 0u);
  position.resize(n);
  velocity.resize(n);
  force.resize(n);
  if (turns) spin.resize(n), torque.resize(n);
  kind.assign(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const auto &x = system.position[i], &v = system.velocity[i];
    position[i] = {x.x(), x.y(), x.z(), system.radius[i]};
    velocity[i] = {v.x(), v.y(), v.z(), 1 / system.mass[i]};
    if (turns) spin[i] = {system.spin[i].x(), system.spin[i].y(), system.spin[i].z(), 1 / system.inertia(i)};
  }
  if (estimates) seen_velocity = velocity, seen_spin = spin;
}

SpheresView Spheres::view() {
  SpheresView view{.position = position.data(), .velocity = velocity.data(), .force = force.data(), .torque = torque.data()};
  view.spin = spin.empty() ? nullptr : spin.data();
  view.seen_velocity = seen_velocity.empty() ? velocity.data() : seen_velocity.data();
  view.seen_spin = seen_velocity.empty() ? view.spin : seen_spin.data();
  view.far = bytes() > cached;
  return view;
}

void Spheres::sort(const std::vector<std::uint32_t>& order) {
  const auto put = [&](auto& list) {
    if (list.empty()) return;
    auto sorted = list;
    for (std::size_t k = 0; k < order.size(); ++k) sorted[k] = list[order[k]];
    list.swap(sorted);
  };
  put(id), put(position), put(velocity), put(spin), put(force), put(torque), put(seen_velocity), put(seen_spin), put(kind);
}

std::size_t Spheres::bytes() const {
  const std::size_t quads = position.capacity() + velocity.capacity() + spin.capacity() + force.capacity() + torque.capacity() +
                            seen_velocity.capacity() + seen_spin.capacity();
  return quads * sizeof(Quad) + (id.capacity() + kind.capacity()) * sizeof(std::uint32_t);
}

}  // namespace scalebreak::dem
