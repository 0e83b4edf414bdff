#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <scalebreak/collisions/bodies/collision_report.hpp>
#include <scalebreak/collisions/bodies/scene_collision.hpp>

#include "command.hpp"

namespace scalebreak::apps {
namespace {

using nlohmann::json;

json vector_json(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

json bodies_json(const std::vector<MovingBody>& bodies) {
  json list = json::array();
  for (const MovingBody& body : bodies)
    list.push_back({{"position", vector_json(body.position)}, {"velocity", vector_json(body.velocity)}, {"spin", vector_json(body.spin)}});
  return list;
}

json account_json(const EnergyAccount& account, double internal) {
  json terms;
  for (const auto& [name, value] : terms_of(account)) terms[name] = value;
  terms["kinetic"] = account.kinetic - internal;
  terms["internal"] = internal;
  return terms;
}

std::optional<double> time_or_none(double time) { return time < 0 ? std::nullopt : std::optional(time); }

/// What there is to say of every collision.
json common_json(const SceneCollision& result) {
  const MotionOutcome& m = result.motion;
  return {{"modelled", result.modelled},
          {"energy_before", result.energy_before()},
          {"energy_after", result.energy_after()},
          {"energy_account", {{"before", account_json(m.before, 0)}, {"after", account_json(m.after, result.internal)}}},
          {"momentum_before", vector_json(momentum(result.before))},
          {"momentum_after", vector_json(momentum(result.after))},
          {"angular_momentum_before", vector_json(angular_momentum(result.before))},
          {"angular_momentum_after", vector_json(angular_momentum(m.bodies))},
          {"contacts", m.touches},
          {"open_contacts", m.open_contacts},
          {"ruptures", m.ruptures},
          {"slides", m.slides},
          {"rolls", m.rolls},
          {"resting", m.resting},
          {"time", m.time},
          {"first_touch", or_null(time_or_none(m.first_touch))},
          {"last_separation", or_null(time_or_none(m.last_separation))},
          {"turned", m.turned},
          {"max_overlap", m.max_overlap},
          {"max_force", m.max_force},
          {"steps", m.steps}};
}

json pair_json(const PairMeasures& pair) {
  return {{"stuck", pair.stuck},
          {"restitution_normal", or_null(pair.restitution_normal)},
          {"restitution_tangential", or_null(pair.restitution_tangential)},
          {"restitution_surface", or_null(pair.restitution_surface)},
          {"contact_time", or_null(pair.contact_time)},
          {"sticking_speed", or_null(pair.sticking_speed)}};
}

json result_json(const Input& input, const SceneCollision& result) {
  json j = common_json(result);
  if (result.pair) j.update(pair_json(*result.pair));
  if (!input.bodies.empty()) {
    j["bodies"] = bodies_json(result.after);
    return j;
  }
  for (const std::size_t b : {0, 1}) {
    j[fmt::format("velocity{}", b + 1)] = vector_json(result.after[b].velocity);
    j[fmt::format("spin{}", b + 1)] = vector_json(result.after[b].spin);
  }
  return j;
}

void print_pair(const PairMeasures& pair) {
  fmt::print("impact speed      {:.6g} m/s", pair.impact_speed);
  if (pair.tangential_speed > 0) fmt::print(", past each other {:.6g} m/s", pair.tangential_speed);
  if (pair.surface_speed > 0 && pair.surface_speed != pair.tangential_speed) fmt::print(", the surfaces {:.6g} m/s", pair.surface_speed);
  fmt::print("\n");
  if (pair.sticking_speed) fmt::print("sticking speed    {:.6g} m/s\n", *pair.sticking_speed);
  if (pair.stuck) return fmt::print("the pair sticks\n");
  if (!pair.contact_time) return;
  if (pair.restitution_normal) fmt::print("restitution       {:.10g}\n", *pair.restitution_normal);
  if (pair.restitution_tangential) fmt::print("  of the centres' tangential speed (after/before)  {:.10g}\n", *pair.restitution_tangential);
  if (pair.restitution_surface) fmt::print("  of the surfaces (-after/before)                   {:.10g}\n", *pair.restitution_surface);
  fmt::print("contact time      {:.6g} s\n", *pair.contact_time);
}

void print_motion(const SceneCollision& result) {
  const MotionOutcome& m = result.motion;
  fmt::print("contacts          {} begun, {} at the end{}; began to slide: {}, to roll at the limit: {}", m.touches, m.open_contacts,
             m.resting ? " that cannot part" : "", m.slides, m.rolls);
  if (m.ruptures > 0) fmt::print("; bridges ruptured: {}", m.ruptures);
  fmt::print("\nended             {:.6g} s after the start\n", m.time);
}

void print_account(const SceneCollision& result) {
  const EnergyAccount& after = result.motion.after;
  const double size = std::max(std::abs(result.motion.before.total()), result.motion.before.kinetic);
  const auto line = [&](const char* name, double value) {
    if (value != 0) fmt::print("  {:<31} {:>12.6g} J {:>9.3f} %\n", name, value, 100 * value / size);
  };
  fmt::print("energy: {:.6g} J at the start, of which\n", result.motion.before.kinetic);
  line("kinetic", after.kinetic - result.internal);
  line("moving within the stuck pair", result.internal);
  line("elastic, in the contacts", after.elastic);
  line("taken by the normal dashpots", after.damping);
  line("taken by friction", after.friction);
  line("taken by rolling", after.rolling);
  line("lost where adhesion tore", after.adhesion);
  line("taken by the liquid", after.liquid);
}

void print(const Input& input, const SceneCollision& result) {
  fmt::print("modelled: {}; {}\n", result.modelled,
             result.head_on ? "no spins, since nothing acts tangentially in a head-on collision"
             : result.pair  ? "both bodies followed in space, with turns and spins"
                            : "all bodies followed in space, every contact resolved");
  if (input.scaling_law != "none" || input.scaling_factor != 1)
    fmt::print("scaled: {} at {:g}; what follows is the scaled system's\n", input.scaling_law, input.scaling_factor);
  if (result.pair) print_pair(*result.pair);
  if (!result.head_on) print_motion(result);
  fmt::print("largest overlap   {:.6g} m\nlargest force     {:.6g} N\n", result.motion.max_overlap, result.motion.max_force);
  print_account(result);
  for (std::size_t b = 0; b < result.after.size() && !result.head_on; ++b) {
    const MovingBody& body = result.after[b];
    if (body.plane) continue;
    const auto &v = body.velocity, &w = body.spin;
    fmt::print("body {:<2} velocity ({:.6g}, {:.6g}, {:.6g}) m/s, spin ({:.6g}, {:.6g}, {:.6g}) rad/s\n", b + 1, v[0], v[1], v[2], w[0],
               w[1], w[2]);
  }
  fmt::print("exact steps       {}\n", result.motion.steps);
}

void remark(const Options& options, const SceneCollision& result) {
  if (result.deep) options.say(too_deep);
  if (result.idle_spins) options.say("spins are given, but no law acts on them: they stay as they are");
}

std::string estimate(const Input& input) {
  if (is_head_on(input)) return "below 1 ms, below 1 MB";
  const std::size_t bodies = std::max<std::size_t>(2, input.bodies.size());
  const auto n = static_cast<double>(bodies);
  // Measured: a cloud of 27 that collides twice each takes 0.5 s, one of 50 takes 5 s.
  return fmt::format("{} bodies in space, about {:.1g} s if all of them collide a few times, three times that with --out; below {} MB",
                     bodies, 4e-5 * n * n * n, bodies < 10 ? 20 : 100);
}

}  // namespace

void add_collide(CLI::App& app, Options& options, std::function<void()>& job) {
  CLI::App* command = app.add_subcommand(
      "collide", "one collision, resolved exactly: two spheres, a sphere and a wall, or a few bodies with friction and liquid");
  add_options(*command, options);
  command->callback([&] {
    job = [&options] {
      if (answered_early(options, estimate)) return;
      const Input input = options.input();
      const SceneCollision result = resolve_collision(input);
      remark(options, result);
      if (!options.out.empty()) {
        for (const std::string& plot : write_collision_files(input, result, options.out))
          options.say(plot + " was not drawn: gnuplot is missing or failed; its script is kept in " + options.out);
      }
      deliver(options, input, "collide", result_json(input, result));
      if (!options.json) print(input, result);
    };
  });
}

}  // namespace scalebreak::apps
