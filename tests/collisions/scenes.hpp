#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <lib/resolving.hpp>
#include <scalebreak/collisions/bodies/moving_scene.hpp>

namespace scalebreak::tests {

/// The words of one [contact] table.
struct Words {
  std::string normal, tangential, rolling, attraction, arm;  ///< each one or more settings

  [[nodiscard]] std::string toml() const { return fmt::format("[contact]\n{}{}{}{}{}", normal, tangential, rolling, attraction, arm); }
  /// On one line, for messages.
  [[nodiscard]] std::string name() const {
    std::string line = normal + tangential + rolling + attraction + arm;
    std::replace(line.begin(), line.end(), '\n', ';');
    return line;
  }
};

inline std::string setting(const std::string& key, const std::string& word) { return fmt::format("{} = \"{}\"\n", key, word); }

/// In the order of all_contact_kinds.
inline std::vector<std::string> all_normals() {
  std::vector<std::string> all;
  for (const ContactKind& kind : all_contact_kinds()) {
    all.push_back(setting("normal", to_string(kind.normal)));
    if (kind.adhesive()) all.back() += setting("adhesion_range", to_string(kind.range)) + setting("damping_on", to_string(kind.damping_on));
  }
  return all;
}
inline std::vector<std::string> all_tangentials() {
  std::vector<std::string> all = {setting("tangential", "none"), setting("tangential", "linear")};
  for (const char* radius : {"contact_radius", "overlap"})
    all.push_back(setting("tangential", "mindlin") + setting("tangential_radius", radius));
  return all;
}
inline std::vector<std::string> all_rollings() {
  std::vector<std::string> all;
  for (const char* word : {"none", "cdt", "epsd", "epsd2", "ar"}) all.push_back(setting("rolling", word));
  return all;
}
inline std::vector<std::string> all_attractions() {
  std::vector<std::string> all = {setting("attraction", "none")};
  for (const char* word : {"capillary", "viscous", "capillary+viscous"}) {
    for (const char* range : {"contact", "bridge"}) all.push_back(setting("attraction", word) + setting("attraction_range", range));
  }
  return all;
}
inline std::vector<std::string> all_arms() { return {setting("torque_arm", "radius"), setting("torque_arm", "contact")}; }

/// The input of a text, or nothing if it is refused.
inline std::optional<Input> allowed(const std::string& toml) {
  try {
    return resolved(toml);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

inline std::string vector_text(const Eigen::Vector3d& v) { return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", v[0], v[1], v[2]); }

inline std::string body_text(const Eigen::Vector3d& position, const Eigen::Vector3d& velocity, const Eigen::Vector3d& spin, double radius,
                             bool fixed = false) {
  return fmt::format("[[body]]\nposition = {}\nvelocity = {}\nspin = {}\nradius = {:.17g}\nfixed = {}\n", vector_text(position),
                     vector_text(velocity), vector_text(spin), radius, fixed);
}

/// Two unlike glass spheres on a skew course, with spins that roll, slide and twist; `speed` [m/s] is that of the first.
inline std::string skew_pair(double speed) {
  const Eigen::Vector3d between = Eigen::Vector3d(0.3, -0.5, 0.9).normalized() * 0.95e-3;
  return body_text(between, speed * Eigen::Vector3d(0.4, 0.7, -0.8), speed * Eigen::Vector3d(500, -300, 800), 0.5e-3) +
         body_text({0, 0, 0}, speed * Eigen::Vector3d(0.1, 0, 0.05), speed * Eigen::Vector3d(-200, 400, 300), 0.4e-3);
}

/// Largest of the bodies' m|v| and of m|x||v| + I|ω|: what momentum and angular momentum are compared with.
inline double momentum_size(const std::vector<MovingBody>& bodies) {
  double size = 0;
  for (const MovingBody& b : bodies) size = std::max(size, std::isfinite(b.mass) ? b.mass * b.velocity.norm() : 0.0);
  return size;
}
inline double angular_momentum_size(const std::vector<MovingBody>& bodies) {
  double size = 0;
  for (const MovingBody& b : bodies) {
    if (std::isfinite(b.mass))
      size = std::max(size, b.mass * b.velocity.norm() * (b.position.norm() + b.radius) + b.inertia * b.spin.norm());
  }
  return size;
}

}  // namespace scalebreak::tests
