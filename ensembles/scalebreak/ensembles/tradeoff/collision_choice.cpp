#include <scalebreak/ensembles/tradeoff/collision_choice.hpp>

#include <fmt/format.h>

namespace scalebreak {
namespace {

bool integrates(const CollisionPoint& point) { return point.method->word != Method::table && point.method->word != Method::closed_form; }

std::string point_text(const CollisionPoint& point) {
  const std::string setting = point.method->has_setting() ? fmt::format(" at {:g}", point.setting) : "";
  return fmt::format("{}{} ({:.4g} evaluation{}, {:.2g} µs)", point.method->name(), setting, point.force_evaluations,
                     point.force_evaluations == 1 ? "" : "s", 1e6 * point.seconds);
}

}  // namespace

const CollisionPoint* cheapest(const std::vector<CollisionPoint>& points, double error, double CollisionPoint::*cost,
                               const std::function<bool(const CollisionPoint&)>& considered) {
  const CollisionPoint* found = nullptr;
  for (const CollisionPoint& point : points) {
    if (point.unparted > 0 || !(point.motion_rms <= error) || !considered(point)) continue;
    if (!found || point.*cost < found->*cost) found = &point;
  }
  return found;
}

std::vector<std::string> choices(const CollisionTradeoff& study) {
  std::vector<std::string> sentences;
  const auto all = [](const CollisionPoint&) { return true; };
  for (const double error : {1e-2, 1e-3, 1e-4, 1e-6}) {
    const CollisionPoint* fastest = cheapest(study.points, error, &CollisionPoint::seconds, all);
    if (!fastest) {
      sentences.push_back(fmt::format("For an error below {:g}: none of these", error));
      continue;
    }
    std::string sentence = fmt::format("For an error below {:g}: {}", error, point_text(*fastest));
    if (!integrates(*fastest)) {
      const CollisionPoint* integrated = cheapest(study.points, error, &CollisionPoint::seconds, integrates);
      sentence += integrated ? fmt::format("; of what integrates {}", point_text(*integrated)) : "; nothing that integrates";
      fastest = integrated;
    }
    const CollisionPoint* least = cheapest(study.points, error, &CollisionPoint::force_evaluations, integrates);
    if (least && least != fastest) sentence += fmt::format("; by evaluations {}", point_text(*least));
    sentences.push_back(sentence);
  }
  return sentences;
}

}  // namespace scalebreak
