#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scalebreak/ensembles/breakdown/study_quantities.hpp>
#include <scalebreak/ensembles/tradeoff/method_tradeoff.hpp>

namespace scalebreak {
namespace {

std::string in_percent(double value, double error) { return fmt::format("{:.1f} % ± {:.1f} %", 100 * value, 100 * error); }

std::string off(const WayPoint& point) {
  if (point.worst.empty()) return "nothing to compare";
  return fmt::format("{} off by {}{}", study_quantity(point.worst).what, in_percent(point.error, point.error_error),
                     point.told ? "" : ", not told from 0");
}

std::string of_reference(const MethodTradeoff& study) {
  std::vector<std::string> names;
  const WayPoint* part = nullptr;
  for (const WayPoint& point : study.points) {
    if (point.in_reference) names.push_back(point.way.name()), part = &point;
  }
  if (names.empty()) return "No way came to an end, so that there is no reference";
  if (names.size() == 1) return fmt::format("The reference is {} alone, so that its own error is not known", names.front());
  return fmt::format("The reference is the mean of {}; of the last the others say: {}", fmt::join(names, " and of "), off(*part));
}

std::string of_front(const MethodTradeoff& study, const std::string& cost, bool WayPoint::*on, double WayPoint::*price) {
  std::vector<const WayPoint*> front;
  for (const WayPoint& point : study.points) {
    if (point.*on) front.push_back(&point);
  }
  if (front.empty()) return fmt::format("There is no front by {}", cost);
  std::sort(front.begin(), front.end(), [&](const WayPoint* a, const WayPoint* b) { return a->*price < b->*price; });
  std::vector<std::string> words;
  for (const WayPoint* point : front) words.push_back(fmt::format("{} ({:.3g}; {})", point->way.name(), point->*price, off(*point)));
  return fmt::format("The front by {}, cheapest first: {}", cost, fmt::join(words, "; "));
}

/// How the hybrid stands beside soft spheres that are scaled.
std::string of_hybrid(const MethodTradeoff& study, const std::string& cost, double WayPoint::*price) {
  const auto hybrid = std::find_if(study.points.begin(), study.points.end(), [](const WayPoint& p) { return p.way.engine == "hybrid"; });
  if (hybrid == study.points.end() || !std::isfinite((*hybrid).*price)) return {};
  std::vector<std::string> cheaper, rivals;
  int beaten = 0, scaled = 0;
  for (const WayPoint& point : study.points) {
    if (point.way.original() || !std::isfinite(point.judged) || !std::isfinite(point.*price)) continue;
    ++scaled;
    if (point.*price >= (*hybrid).*price) {
      beaten += hybrid->judged <= point.judged;
      continue;
    }
    (point.judged > hybrid->judged ? cheaper : rivals).push_back(point.way.name());
  }
  if (scaled == 0) return {};
  std::string text =
      fmt::format("By {} the hybrid is at least as cheap and as accurate as {} of {} scaled flows of soft spheres", cost, beaten, scaled);
  if (!cheaper.empty()) text += fmt::format("; cheaper and less accurate: {}", fmt::join(cheaper, "; "));
  if (!rivals.empty()) text += fmt::format("; cheaper, and its error is not larger: {}", fmt::join(rivals, "; "));
  return text;
}

/// The cheapest way within each of some errors, in words; a way is named once.
std::string of_choice(const MethodTradeoff& study) {
  std::vector<std::string> words;
  const WayPoint* last = nullptr;
  for (const double allowed : {study.resolution, 0.1, 0.3}) {
    const WayPoint* best = nullptr;
    for (const WayPoint& point : study.points) {
      if (!(point.judged <= allowed) || !std::isfinite(point.seconds)) continue;
      if (!best || point.seconds < best->seconds) best = &point;
    }
    if (!best || best == last) continue;
    last = best;
    words.push_back(
        fmt::format("{}, {} ({:.3g} s)",
                    allowed == study.resolution ? "where no error may be told" : fmt::format("where one of {:.0f} % may be", 100 * allowed),
                    best->way.name(), best->seconds));
  }
  if (words.empty()) return {};
  return fmt::format("What to choose, by processor time: {}", fmt::join(words, "; "));
}

std::string of_quantities(const MethodTradeoff& study) {
  std::vector<std::string> names;
  for (const std::string& name : study.quantities) names.emplace_back(study_quantity(name).what);
  return fmt::format("An error is the largest relative deviation of {}", fmt::join(names, ", "));
}

}  // namespace

std::vector<std::string> sentences(const MethodTradeoff& study) {
  std::vector<std::string> list = {of_quantities(study), of_reference(study)};
  for (const WayPoint& point : study.points) {
    if (!point.failure.empty()) list.push_back(fmt::format("{} has no answer: {}", point.way.name(), point.failure));
  }
  list.push_back(fmt::format("Errors below {:.2g} % are not told apart", 100 * study.resolution));
  list.push_back(of_front(study, "counted work", &WayPoint::on_work_front, &WayPoint::work));
  list.push_back(of_front(study, "processor time", &WayPoint::on_time_front, &WayPoint::seconds));
  for (const std::string& each :
       {of_hybrid(study, "counted work", &WayPoint::work), of_hybrid(study, "processor time", &WayPoint::seconds)}) {
    if (!each.empty()) list.push_back(each);
  }
  if (const std::string choice = of_choice(study); !choice.empty()) list.push_back(choice);
  return list;
}

}  // namespace scalebreak
