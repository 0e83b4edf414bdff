#include <scalebreak/scene/check_bodies.hpp>

#include <algorithm>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <scalebreak/base/error.hpp>
#include <scalebreak/scene/keys.hpp>

namespace scalebreak {
namespace {

double touch(const Body& a, const Body& b) { return a.radius + b.radius; }
double distance(const Body& a, const Body& b) { return (b.position - a.position).norm(); }
double tolerated(const Body& a, const Body& b) { return touching_overlap * std::min(a.radius, b.radius); }

/// The least distance of the surfaces from now on, in straight flight; negative where they would overlap.
double least_gap(const Body& a, const Body& b) {
  const Eigen::Vector3d between = b.position - a.position, approach = a.velocity - b.velocity;
  if (!(approach.dot(between) > 0)) return between.norm() - touch(a, b);
  return between.cross(approach.stableNormalized()).norm() - touch(a, b);
}

bool meet(const Body& a, const Body& b) { return distance(a, b) - touch(a, b) <= tolerated(a, b) || least_gap(a, b) < 0; }

void check_apart(const Input& input, const Given& given) {
  for (std::size_t j = 1; j < input.bodies.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      const Body &a = input.bodies[i], &b = input.bodies[j];
      const double overlap = touch(a, b) - distance(a, b);
      if (!(overlap > tolerated(a, b))) continue;
      throw InputError(
          fmt::format("{}body.{} and body.{} overlap by {:g} m at the start (distance {:g} m, radii {:g} m and {:g} m); allowed: at most "
                      "{:g} of the radius",
                      place(given, {fmt::format("body.{}.position", j + 1)}), i + 1, j + 1, overlap, distance(a, b), a.radius, b.radius,
                      touching_overlap));
    }
  }
}

/// Whatever happens begins with two bodies that fly into each other, or touch already.
void check_meeting(const Input& input, const Given& given) {
  const std::string where = place(given, {"body.1.velocity", "body.1.position"});
  const auto pairs = meeting_pairs(input);
  if (pairs.empty())
    throw InputError(where + "the bodies never meet: all of them have fixed = true; allowed: at least one with fixed = false");
  const auto gap = [&](const auto& pair) { return least_gap(input.bodies[pair.first], input.bodies[pair.second]); };
  if (std::any_of(pairs.begin(), pairs.end(), [&](const auto& pair) { return meet(input.bodies[pair.first], input.bodies[pair.second]); }))
    return;
  const auto nearest = std::min_element(pairs.begin(), pairs.end(), [&](const auto& a, const auto& b) { return gap(a) < gap(b); });
  throw InputError(
      fmt::format("{}the bodies never meet: no two of them touch or are on a collision course, found a least distance of {:g} m "
                  "between the surfaces of body.{} and body.{}; allowed: 0",
                  where, gap(*nearest), nearest->first + 1, nearest->second + 1));
}

}  // namespace

void refuse_number_of_bodies(const Assignment& item, std::size_t bodies) {
  throw InputError(fmt::format("{}: {}: found {} {}; allowed: {} to {} [[body]] tables, or none", item.where.text, item.key, bodies,
                               bodies == 1 ? "body" : "bodies", fewest_bodies, most_bodies));
}

std::vector<std::pair<std::size_t, std::size_t>> meeting_pairs(const Input& input) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t j = 1; j < input.bodies.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      if (!input.bodies[i].fixed || !input.bodies[j].fixed) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

void check_bodies_are_whole(const Input& input, const Given& given) {
  if (input.bodies.size() < fewest_bodies) {
    const auto only = std::find_if(given.begin(), given.end(), [](const Assignment& item) { return item.key.rfind("body.", 0) == 0; });
    refuse_number_of_bodies(*only, input.bodies.size());
  }
  for (std::size_t i = 1; i <= input.bodies.size(); ++i) {
    for (const std::string_view name : required_body_keys) {
      if (!find_given(given, fmt::format("body.{}.{}", i, name)))
        throw InputError(fmt::format("body.{}.{} is missing; every [[body]] needs {}", i, name, fmt::join(required_body_keys, " and ")));
    }
  }
}

void check_bodies(const Input& input, const Given& given) {
  for (const Assignment& item : given) {
    if (item.key.rfind("pair.", 0) != 0 && item.key.rfind("impact.", 0) != 0) continue;
    throw InputError(
        fmt::format("{}: {} cannot stand beside [[body]]: the bodies say where they are and how they move", item.where.text, item.key));
  }
  check_apart(input, given);
  check_meeting(input, given);
}

}  // namespace scalebreak
