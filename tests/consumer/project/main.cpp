#include <cmath>
#include <cstdio>

#include <scalebreak/collisions/normal/normal_collision.hpp>
#include <scalebreak/contact/damping.hpp>

// A Hertz pair with the damping ratio of e = 0.5 comes apart with that restitution, at any speed.
int main() {
  const scalebreak::ContactKind hertz = scalebreak::canonical({.normal = scalebreak::NormalModel::hertz});
  const auto outcome = scalebreak::resolve_normal_collision<double>(hertz, scalebreak::damping_ratio(0.5), 1.0, {.tolerance = 1e-10});
  const bool good = !outcome.stuck && std::abs(outcome.restitution - 0.5) < 1e-8;
  std::printf("%s\n", good ? "OK" : "the restitution is wrong");
  return good ? 0 : 1;
}
