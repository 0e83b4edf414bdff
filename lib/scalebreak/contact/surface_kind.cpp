#include <scalebreak/contact/surface_kind.hpp>

namespace scalebreak {

std::string to_string(const SurfaceKind& kind) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (kind.tangential != TangentialModel::none) {
    add(std::string(to_string(kind.tangential)) +
        (kind.tangential == TangentialModel::mindlin ? std::string(" on ") + to_string(kind.tangential_radius) : ""));
  }
  if (kind.rolling != RollingModel::none) add(std::string("rolling ") + to_string(kind.rolling));
  if (kind.attraction != Attraction::none) add(std::string(to_string(kind.attraction)) + " in " + to_string(kind.attraction_range));
  if (kind.spins()) add(std::string("torque arm ") + to_string(kind.torque_arm));
  return text.empty() ? "nothing tangential" : text;
}

}  // namespace scalebreak
