#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include <ensembles/flows.hpp>
#include <lib/resolving.hpp>
#include <lib/surroundings.hpp>
#include <scalebreak/contact/hertz.hpp>
#include <scalebreak/ensembles/tradeoff/collision_choice.hpp>
#include <scalebreak/ensembles/tradeoff/collision_methods.hpp>
#include <scalebreak/ensembles/tradeoff/collision_tradeoff.hpp>
#include <scalebreak/ensembles/tradeoff/flow_tradeoff.hpp>
#include <scalebreak/ensembles/tradeoff/front.hpp>
#include <scalebreak/ensembles/tradeoff/stepped_collision.hpp>

namespace scalebreak::tests {
namespace {

using testing::ElementsAre;

TableStore tables() {
  static const TemporaryFolder folder;
  return {.folder = folder.path()};
}

TEST(ConvergenceOrder, IsThatOfAPower) {
  const ConvergenceOrder exact = convergence_order({0.4, 0.2, 0.1, 0.05}, {3 * 0.16, 3 * 0.04, 3 * 0.01, 3 * 0.0025});
  EXPECT_NEAR(exact.order, 2, 1e-12);
  EXPECT_NEAR(exact.error, 0, 1e-7);
  const ConvergenceOrder scattered = convergence_order({0.4, 0.2, 0.1, 0.05}, {0.5, 0.19, 0.11, 0.048});
  EXPECT_NEAR(scattered.order, 1, 3 * scattered.error);
  EXPECT_GT(scattered.error, 0.01);
  EXPECT_TRUE(std::isnan(convergence_order({0.4, 0.2}, {1, 0.5}).order));
}

TEST(Front, HoldsWhatNothingBeats) {
  EXPECT_THAT(on_front({1, 2, 3, 2.5}, {9, 4, 1, 5}), ElementsAre(true, true, true, false));
  EXPECT_THAT(on_front({1, 1, 2}, {3, 3, 3}), ElementsAre(true, true, false));
}

/// Glass spheres, elastic, without adhesion: a collision whose exact outcome is known without any engine.
Input elastic() {
  Input input;
  input.contact = canonical({.normal = NormalModel::hertz});
  for (Material* material : {&input.material, &input.second}) material->surface_energy = 0, material->restitution = 1;
  input.tradeoff = {.methods = {}, .step_fractions = {0.2, 0.1, 0.05, 0.025}, .tolerances = {1e-4, 1e-6, 1e-8}, .phases = 8};
  return input;
}

TEST(CollisionScene, ErrorsAreThoseOfVelocitiesOverTheImpactSpeed) {
  const CollisionScene scene = collision_scene(elastic());
  EXPECT_DOUBLE_EQ(scene.speed, 0.1);
  CollisionOutcome outcome{.bodies = scene.reference.bodies, .contact_time = 1.01 * scene.reference.last_separation};
  outcome.bodies[1].velocity.x() += 0.002;
  outcome.bodies[0].spin.y() += 2;  // times 0.5 mm
  const CollisionError error = collision_error(scene, outcome);
  EXPECT_NEAR(error.motion, 0.02, 1e-12);
  EXPECT_NEAR(*error.contact_time, 0.01, 1e-9);
  EXPECT_GT(error.energy, 0);
}

TEST(CollisionScene, RefusesWhatHasNoEnd) {
  Input sticking;
  sticking.normal_speed = 1e-4;
  EXPECT_EQ(message_of<InputError>([&] { (void)collision_scene(sticking); }),
            "the bodies stick, so that there is no end to compare; allowed: bodies that part, or [[body]] with run.duration");
  Input apart = elastic();
  apart.bodies = {{.position = {0, 0, 2e-3}, .velocity = {0, 0, 1}, .radius = 5e-4}, {.radius = 5e-4}};
  EXPECT_EQ(message_of<InputError>([&] { (void)collision_scene(apart); }), "nothing collides in this scene; allowed: bodies that meet");
  Input fixed = elastic();
  fixed.bodies = {{.position = {0, 0, 2e-3}, .velocity = {0, 0, -1}, .radius = 5e-4}, {.radius = 5e-4, .fixed = true}};
  EXPECT_EQ(message_of<InputError>([&] { (void)step_collision(collision_scene(fixed), Integrator::verlet, 1e-7, 0); }),
            "body.2 is fixed, and the soft-sphere engine has no fixed spheres; allowed: free bodies");
}

TEST(SteppedCollision, CountsAForceForEachStepOfTheContact) {
  const CollisionScene scene = collision_scene(elastic());
  const double contact_time = scene.reference.last_separation;
  const CollisionOutcome outcome = step_collision(scene, Integrator::verlet, contact_time / 50.5, 0.5);
  EXPECT_NEAR(outcome.force_evaluations, 50.5, 1);
  EXPECT_TRUE(outcome.parted);
  EXPECT_NEAR(*outcome.contact_time / contact_time, 1, 1e-3);
  Input wall = elastic();
  wall.against_wall = true, wall.radius = {5e-4};
  const CollisionScene at_wall = collision_scene(wall);
  EXPECT_NEAR(step_collision(at_wall, Integrator::verlet, at_wall.reference.last_separation / 50.5, 0.5).force_evaluations, 50.5, 1);
}

/// Near the sticking speed coarse steps lose so much that the pair sticks.
TEST(SteppedCollision, SaysWhatDidNotPart) {
  Input input;
  input.normal_speed = 1.35e-3;  // a little above its sticking speed
  const CollisionScene scene = collision_scene(input);
  int unparted = 0;
  for (int k = 0; k < 16; ++k) unparted += !step_collision(scene, Integrator::verlet, step_of(scene, 2), (k + 0.5) / 16).parted;
  EXPECT_GT(unparted, 0);
}

/// With forces that see the velocity half a step before, v(t + dt/2) = v(t − dt/2) + a(x(t), v(t − dt/2)) dt, x(t + dt) = x(t) + v(t + dt/2) dt:
/// symplectic Euler, with v(t − dt/2) called v(t). Before touch both velocities are one.
TEST(SteppedCollision, ByVerletIsThatOfSymplecticEuler) {
  const Input input = resolved("[material]\nsurface_energy = 0\n[contact]\nnormal = \"hertz\"\n");
  const CollisionScene scene = collision_scene(input);
  const double step = step_of(scene, 0.2), phase = 0.3;
  const NormalPair pair = input.colliding().pair();
  const auto law = Hertz<double>::make(pair, AdhesionRange::touch);
  double overlap = -phase * step * scene.speed, speed = scene.speed;
  const long steps = stepped_start(scene, Integrator::verlet, step, phase).steps;
  for (long k = 0; k < steps + 10; ++k) {
    if (overlap > 0) {
      const double x = law.coordinate(overlap);
      speed -= (law.force(x) + law.damping(x) * speed) / pair.mass * step;
    }
    overlap += speed * step;
  }
  const auto parting = [&](Integrator integrator) {
    const auto bodies = step_collision(scene, integrator, step, phase).bodies;
    return bodies[1].velocity.z() - bodies[0].velocity.z();
  };
  EXPECT_NEAR(parting(Integrator::verlet) / speed, 1, 1e-11);
  EXPECT_GT(std::abs(parting(Integrator::synchronized) / speed - 1), 1e-5);
}

CollisionTradeoff tabulated(const std::string& toml) {
  Input input = resolved(toml);
  input.tradeoff = {.methods = {}, .step_fractions = {0.3}, .tolerances = {1e-3, 1e-4, 1e-8}, .phases = 2};
  return collision_tradeoff(input, tables());
}

std::vector<CollisionPoint> by(const std::string& method, const CollisionTradeoff& study) {
  std::vector<CollisionPoint> own;
  for (const CollisionPoint& point : study.points) {
    if (point.method->name() == method) own.push_back(point);
  }
  return own;
}

TEST(TabulatedCollision, IsAsGoodAsItsTables) {
  for (const std::string& contact :
       std::vector<std::string>{"[contact]\nnormal = \"jkr\"\n",
                                "[material]\nsurface_energy = 0\n[contact]\nnormal = \"hertz\"\n"
                                "tangential = \"mindlin\"\n[impact]\nnormal_speed = 0.01\ntangential_speed = 0.003\nspin1 = [0, 5, 0]\n"}) {
    const CollisionTradeoff study = tabulated(contact);
    const auto points = by("table", study);
    ASSERT_EQ(points.size(), 2u) << contact;
    for (const CollisionPoint& p : points) {
      EXPECT_LT(p.motion_rms, p.setting) << contact;
      EXPECT_LT(*p.time_rms, p.setting) << contact;
      EXPECT_GT(p.motion_rms, 0) << contact;
      EXPECT_EQ(p.force_evaluations, 1);
    }
    EXPECT_TRUE(by("closed_form", study).empty());
    EXPECT_THAT(study.refusals[0],
                testing::MatchesRegex("table at 1e-08: tables of such contacts are built down to 1e-0[57]; finer ones take long to build"));
  }
}

TEST(TabulatedCollision, SaysWhereItHasNoAnswer) {
  const std::string formulas = "closed_form: formulas are of linear contacts and of elastic Hertz contacts, without liquid";
  const std::string wet =
      "[material]\nsurface_energy = 0\nsurface_tension = 0.07\nliquid_volume = 1e-12\n[contact]\nnormal = \"hertz\"\n"
      "attraction = \"capillary\"\n[impact]\nnormal_speed = 1\n";
  EXPECT_THAT(tabulated(wet).refusals,
              ElementsAre("table at 0.001, 0.0001, 1e-08: no table answers this collision: a liquid acts at a distance", formulas));
  const std::string bodies =
      "[material]\nsurface_energy = 0\n[contact]\nnormal = \"hertz\"\n[[body]]\nposition = [0, 0, 0]\nradius = 1e-3\nvelocity = [0, 0, 0.1]\n"
      "[[body]]\nposition = [0, 0, 2.1e-3]\nradius = 1e-3\n";
  EXPECT_THAT(tabulated(bodies).refusals,
              ElementsAre("table at 0.001, 0.0001, 1e-08: tables are of one collision of a pair, given by [pair] and [impact]",
                          "closed_form: formulas are of pairs that meet head-on without spin, and part"));
}

TEST(ClosedFormCollision, IsThatOfTheReference) {
  for (
      const std::string& scene : std::vector<std::string>{
          "[material]\nsurface_energy = 0\n[contact]\nnormal = \"linear\"\n",
          "[material]\nsurface_energy = 0\nrestitution = 1\n[contact]\nnormal = \"hertz\"\n[scaling]\nlaw = \"rps\"\nfactor = 0.01\n",
          "[material]\nsurface_energy = 0\nrestitution = 1\n[contact]\nnormal = \"hertz\"\n[pair]\nradius = [1e-3]\npartner = \"wall\"\n",
          "[material]\nsurface_energy = 0\nrestitution = 1\n[contact]\nnormal = \"hertz\"\n[scaling]\nlaw = \"chen_elliott\"\nfactor = 2\n"}) {
    const auto points = by("closed_form", tabulated(scene));
    ASSERT_EQ(points.size(), 1u) << scene;
    EXPECT_LT(points[0].motion_rms, 1e-11) << scene;
    EXPECT_LT(*points[0].time_rms, 1e-11) << scene;
    EXPECT_TRUE(points[0].on_front) << scene;
  }
  EXPECT_TRUE(by("closed_form", tabulated("[material]\nsurface_energy = 0\n[contact]\nnormal = \"hertz\"\n")).empty());
}

TEST(CollisionTradeoff, FindsOrdersAndTheFront) {
  double share = 0;
  const CollisionTradeoff study = collision_tradeoff(elastic(), tables(), [&](double done) { share = done; });
  EXPECT_EQ(share, 1);
  ASSERT_EQ(study.points.size(), 4u + 4u + 5u * 3u + 2u + 1u);
  EXPECT_NEAR(*study.contact_time, collision_scene(elastic()).reference.last_separation, 1e-18);
  for (const CollisionConvergence& c : study.convergence) {
    if (!c.method->steps) continue;
    EXPECT_TRUE(std::isnan(c.motion.order));  // of four settings the finer two are too few
  }
  for (const CollisionPoint& p : study.points) {
    EXPECT_LE(p.motion_rms, p.motion_largest * (1 + 1e-12));
    EXPECT_GT(p.force_evaluations, 0);
    EXPECT_EQ(p.unparted, 0);
    EXPECT_EQ(p.phases, p.method->steps ? 8 : 1);
  }
  for (const CollisionPoint& p : study.points) {
    const bool beaten = std::any_of(study.points.begin(), study.points.end(), [&](const CollisionPoint& q) {
      return q.motion_rms < p.motion_rms && q.force_evaluations < p.force_evaluations;
    });
    EXPECT_FALSE(p.on_front && beaten);
  }
  EXPECT_GE(std::count_if(study.points.begin(), study.points.end(), [](const CollisionPoint& p) { return p.on_front; }), 3);
  Input one = elastic();
  one.tradeoff.methods = {Method::verlet};
  EXPECT_EQ(collision_tradeoff(one, tables()).points.size(), 4u);
  one.tradeoff.methods = {Method::table, Method::closed_form, Method::dopri5};
  EXPECT_EQ(collision_tradeoff(one, tables()).points.size(), 2u + 1u + 3u);
}

/// A point with this error, work and wall time [s].
CollisionPoint known(Method word, double setting, double error, double work, double seconds) {
  return {.method = &collision_methods()[static_cast<std::size_t>(word)],
          .setting = setting,
          .motion_rms = error,
          .force_evaluations = work,
          .seconds = seconds};
}

TEST(CollisionChoice, IsTheCheapestWhoseErrorIsAllowed) {
  CollisionTradeoff study;
  study.points = {known(Method::verlet, 0.4, 5e-3, 20, 6e-6), known(Method::verlet, 0.2, 5e-4, 40, 12e-6),
                  known(Method::exact, 1e-4, 5e-5, 300, 40e-6), known(Method::dopri5, 1e-4, 4e-5, 200, 50e-6),
                  known(Method::table, 1e-3, 9e-4, 1, 1e-7)};
  study.points[0].unparted = 1;
  EXPECT_THAT(
      choices(study),
      ElementsAre(
          "For an error below 0.01: table at 0.001 (1 evaluation, 0.1 µs); of what integrates verlet at 0.2 (40 evaluations, 12 µs)",
          "For an error below 0.001: table at 0.001 (1 evaluation, 0.1 µs); of what integrates verlet at 0.2 (40 evaluations, 12 µs)",
          "For an error below 0.0001: exact at 0.0001 (300 evaluations, 40 µs); by evaluations dopri5 at 0.0001 (200 evaluations, 50 µs)",
          "For an error below 1e-06: none of these"));
}

TEST(CollisionTradeoff, CountsTheSameWorkAndFrontAgain) {
  const CollisionTradeoff first = collision_tradeoff(elastic(), tables()), second = collision_tradeoff(elastic(), tables());
  ASSERT_EQ(first.points.size(), second.points.size());
  for (std::size_t i = 0; i < first.points.size(); ++i) {
    const CollisionPoint &a = first.points[i], &b = second.points[i];
    EXPECT_EQ(a.force_evaluations, b.force_evaluations) << a.method->name();
    EXPECT_EQ(a.motion_rms, b.motion_rms) << a.method->name();
    EXPECT_EQ(a.on_front, b.on_front) << a.method->name();
  }
}

/// Two that stick and spin on: what a step sees of them grows with run.duration, and there is a bound to that.
Input sticking(double duration) {
  Input input = resolved("[material]\nrolling_angle_max = 0.01\n[contact]\nnormal = \"jkr\"\ntangential = \"mindlin\"\nrolling = \"ar\"\n");
  input.run.duration = duration;
  input.bodies = {{.position = {0, 0, 5e-4}, .velocity = {0, 0, -0.001}, .spin = {0, 20, 0}, .radius = 5e-4},
                  {.position = {0, 0, -5e-4}, .radius = 5e-4}};
  return input;
}

TEST(CollisionTradeoff, OfAPairThatSticksIsBounded) {
  Input input = sticking(4e-3);
  input.tradeoff = {.methods = {Method::synchronized, Method::exact}, .step_fractions = {0.4}, .tolerances = {1e-4, 1e-8}, .phases = 2};
  for (const CollisionPoint& p : collision_tradeoff(input, tables()).points) EXPECT_LT(p.motion_rms, 1e-3) << p.method->name();
  EXPECT_THAT(
      message_of<InputError>([] { (void)collision_tradeoff(sticking(10), tables()); }),
      testing::MatchesRegex("run.duration: 10 s are [0-9.e+]+ steps of all study.step_fractions at study.phases = 32; allowed: at most "
                            "2e.09, by a shorter run.duration, larger steps or fewer phases"));
}

TEST(FlowTradeoff, ComparesEachStepWithTheSmallest) {
  Input input = resolved(small_shear);
  input.run.strain = 0.6;
  input.tradeoff.methods = {Method::synchronized};
  input.tradeoff.step_fractions = {0.3, 0.15};
  const FlowTradeoff study = flow_tradeoff(input, 1);
  ASSERT_EQ(study.points.size(), 2u);
  EXPECT_EQ(study.reference, 1u);
  const FlowPoint &coarse = study.points[0], &fine = study.points[1];
  EXPECT_NEAR(fine.particle_steps / coarse.particle_steps, 2, 0.1);
  EXPECT_NEAR(fine.force_evaluations / coarse.force_evaluations, 2, 0.6);
  ASSERT_EQ(fine.deviations.size(), tradeoff_quantities().size());
  for (const Comparison& c : fine.deviations) EXPECT_EQ(c.difference.value, 0) << c.name;
  for (const Comparison& c : coarse.deviations) EXPECT_NE(c.difference.value, 0) << c.name;
  EXPECT_FALSE(fine.on_front);
  input.tradeoff.methods = {Method::exact};
  EXPECT_EQ(message_of<InputError>([&] { (void)flow_tradeoff(input, 1); }),
            "study.methods: found \"exact\", which follows no flow; allowed: \"verlet\", \"synchronized\"");
  input.tradeoff.methods = {Method::synchronized, Method::table};
  EXPECT_EQ(message_of<InputError>([&] { (void)flow_tradeoff(input, 1); }),
            "study.methods: found \"table\", which follows no flow; allowed: \"verlet\", \"synchronized\"");
}

}  // namespace
}  // namespace scalebreak::tests
