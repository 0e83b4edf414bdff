#pragma once

#include <cmath>
#include <set>

#include <gmock/gmock.h>

#include <apps/program.hpp>

namespace scalebreak::tests {

/// Tests of the command collide.
struct Collide : ProgramTest {};

inline const std::set<std::string> result_keys = {"stuck",
                                                  "restitution_normal",
                                                  "restitution_tangential",
                                                  "restitution_surface",
                                                  "contact_time",
                                                  "max_overlap",
                                                  "max_force",
                                                  "velocity1",
                                                  "velocity2",
                                                  "spin1",
                                                  "spin2",
                                                  "energy_before",
                                                  "energy_after",
                                                  "sticking_speed",
                                                  "steps",
                                                  "modelled",
                                                  "energy_account",
                                                  "momentum_before",
                                                  "momentum_after",
                                                  "angular_momentum_before",
                                                  "angular_momentum_after",
                                                  "contacts",
                                                  "open_contacts",
                                                  "ruptures",
                                                  "slides",
                                                  "rolls",
                                                  "resting",
                                                  "time",
                                                  "first_touch",
                                                  "last_separation",
                                                  "turned"};

/// The sum of an account's terms.
inline double total(const nlohmann::json& account) {
  double sum = 0;
  for (const auto& [name, value] : account.items()) sum += value.get<double>();
  return sum;
}

inline void expect_balanced(const nlohmann::json& j, double tolerance) {
  const nlohmann::json& account = j["energy_account"];
  EXPECT_NEAR(total(account["after"]) / total(account["before"]), 1, tolerance);
  EXPECT_EQ(account["before"]["kinetic"], j["energy_before"]);
  EXPECT_NEAR(account["after"]["kinetic"].get<double>(), j["energy_after"].get<double>(), 1e-12 * j["energy_before"].get<double>());
}

/// A collision with these settings, in JSON.
inline nlohmann::json collide(std::vector<std::string> settings) {
  std::vector<std::string> words = {"collide", "--json"};
  for (const std::string& setting : settings) words.insert(words.end(), {"--set", setting});
  const ProgramRun result = run(words);
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, testing::IsEmpty());
  return result.json();
}

inline double mass(double radius, double density = 2500) { return 4.0 / 3 * M_PI * radius * radius * radius * density; }

inline constexpr const char* two_bodies = R"([contact]
normal = "hertz"
[material]
restitution = 0.5
[[body]]
position = [0, 0, 0.01]
velocity = [0, 0, -0.5]
radius = 1e-3
[[body]]
position = [0, 0, 0]
velocity = [0, 0, 0.25]
radius = 2e-3
)";

inline constexpr const char* three_bodies = R"([contact]
normal = "hertz"
tangential = "mindlin"
[[body]]
position = [-3e-3, 0, 0.3e-3]
velocity = [0.5, 0, 0]
spin = [0, 50, 0]
radius = 1e-3
[[body]]
position = [0, 0, 0]
radius = 1e-3
[[body]]
position = [2.1e-3, 0.5e-3, 0]
radius = 1e-3
)";

}  // namespace scalebreak::tests
