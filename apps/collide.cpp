#include <cmath>

#include <fmt/format.h>

#include <scalebreak/collisions/pair_collision.hpp>
#include <scalebreak/output/atomic_file.hpp>
#include <scalebreak/output/csv.hpp>
#include <scalebreak/output/plot.hpp>

#include "command.hpp"

namespace scalebreak::apps {
namespace {

using nlohmann::json;

json vector_json(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }
const json no_spin = {0.0, 0.0, 0.0};

json pair_json(const CollisionResult& result) {
  const PairCollision& c = result.collision;
  return {{"modelled", to_string(c.kind)},
          {"stuck", c.stuck},
          {"restitution_normal", c.restitution},
          {"restitution_tangential", nullptr},
          {"restitution_surface", nullptr},
          {"contact_time", or_null(c.contact_time)},
          {"max_overlap", c.max_overlap},
          {"max_force", c.max_force},
          {"velocity1", vector_json(result.bodies[0].velocity)},
          {"velocity2", vector_json(result.bodies[1].velocity)},
          {"spin1", no_spin},
          {"spin2", no_spin},
          {"energy_before", result.energy_before},
          {"energy_after", result.energy_after},
          {"sticking_speed", or_null(c.sticking_speed)},
          {"steps", c.steps}};
}

json bodies_json(const CollisionResult& result) {
  json j = pair_json(result);
  for (const char* pair_only : {"velocity1", "velocity2", "spin1", "spin2"}) j.erase(pair_only);
  j["bodies"] = json::array();
  for (const BodyState& body : result.bodies)
    j["bodies"].push_back({{"position", vector_json(body.position)}, {"velocity", vector_json(body.velocity)}, {"spin", no_spin}});
  j["contacts"] = 1;
  return j;
}

void print(const CollisionResult& result) {
  const PairCollision& c = result.collision;
  fmt::print("modelled: {}; no spins, since nothing acts tangentially\n", to_string(c.kind));
  fmt::print("impact speed      {:.6g} m/s\n", result.speed);
  if (c.sticking_speed) fmt::print("sticking speed    {:.6g} m/s\n", *c.sticking_speed);
  if (c.stuck) {
    fmt::print("the pair sticks\n");
  } else {
    fmt::print("restitution       {:.10g}\ncontact time      {:.6g} s\n", c.restitution, *c.contact_time);
  }
  fmt::print("largest overlap   {:.6g} m\nlargest force     {:.6g} N\n", c.max_overlap, c.max_force);
  fmt::print("kinetic energy    {:.6g} J before, {:.6g} J after\nexact steps       {}\n", result.energy_before, result.energy_after,
             c.steps);
}

void write_files(const Options& options, const Input& input) {
  const auto [contact, speed] = contact_of(input);
  Csv csv({"time [s]", "overlap [m]", "contact_radius [m]", "approach_speed [m/s]", "elastic_force [N]", "damping_force [N]", "force [N]"});
  for (const TrajectoryPoint& p : contact.trajectory(speed, input.tolerance, 400)) {
    csv.add({p.time, p.overlap, p.contact_radius, p.speed, p.elastic_force, p.damping_force, p.elastic_force + p.damping_force});
  }
  write_file(std::filesystem::path(options.out) / "trajectory.csv", csv.text());
  Plot plot{"force_overlap",
            fmt::format("Normal force and overlap at {:.4g} m/s ({})", speed, to_string(contact.kind())),
            "overlap [m]",
            "force, positive in repulsion [N]",
            false,
            false,
            {}};
  plot.curves = {{"trajectory.csv", "2", "7", "with the dashpot"}, {"trajectory.csv", "2", "5", "without the dashpot", false, 2}};
  if (!draw(plot, options.out))
    options.say("force_overlap was not drawn: gnuplot is missing or failed; its script is kept in " + options.out);
}

}  // namespace

void add_collide(CLI::App& app, Options& options, std::function<void()>& job) {
  CLI::App* command = app.add_subcommand("collide", "one collision of two spheres, or of a sphere and a wall, resolved exactly");
  add_options(*command, options);
  command->callback([&] {
    job = [&options] {
      if (answered_early(options, [](const Input&) { return "below 1 ms, below 1 MB"; })) return;
      const Input input = options.input();
      const CollisionResult result = resolve_collision(input);
      if (result.deep) options.say(too_deep);
      if (!options.out.empty()) write_files(options, input);
      deliver(options, input, "collide", input.bodies.empty() ? pair_json(result) : bodies_json(result));
      if (!options.json) print(result);
    };
  });
}

}  // namespace scalebreak::apps
