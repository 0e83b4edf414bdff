#include <scalebreak/contact/surface_kind.hpp>

namespace scalebreak {

const char* to_string(TangentialModel model) {
  switch (model) {
    case TangentialModel::none: return "none";
    case TangentialModel::linear: return "linear";
    case TangentialModel::mindlin: break;
  }
  return "mindlin";
}

const char* to_string(RollingModel model) {
  switch (model) {
    case RollingModel::none: return "none";
    case RollingModel::cdt: return "cdt";
    case RollingModel::epsd: return "epsd";
    case RollingModel::epsd2: return "epsd2";
    case RollingModel::ar: return "ar";
    case RollingModel::sds: break;
  }
  return "sds";
}

const char* to_string(Attraction attraction) {
  switch (attraction) {
    case Attraction::none: return "none";
    case Attraction::capillary: return "capillary";
    case Attraction::viscous: return "viscous";
    case Attraction::capillary_viscous: break;
  }
  return "capillary+viscous";
}

const char* to_string(AttractionRange range) { return range == AttractionRange::contact ? "contact" : "bridge"; }

const char* to_string(TorqueArm arm) { return arm == TorqueArm::radius ? "radius" : "contact"; }

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
