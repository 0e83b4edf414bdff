#include <scalebreak/measure/flow_measurement.hpp>

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <lib/measure/states.hpp>
#include <scalebreak/base/error.hpp>

namespace scalebreak {
namespace {

TEST(FlowMeasurement, WeighsUnequalIntervalsByTheirLength) {
  System system = ideal_gas(periodic_cell(1, 1, 1), 2, 0, 1);
  const std::vector<ContactForce> none, one = {{.first = 0, .second = 1}};
  FlowMeasurement measurement;
  for (const auto& [time, contacts] : {std::pair{0.0, &none}, std::pair{1.0, &one}, std::pair{3.0, &one}}) {
    system.time = time;
    measurement.add({system, *contacts});
  }
  EXPECT_DOUBLE_EQ(found(measurement.result(), "coordination").value, (0.5 * 1 + 1 * 2) / 3);
  EXPECT_DOUBLE_EQ(measurement.result().duration, 3);
}

TEST(FlowMeasurement, CollisionRateCountsBothSpheresOfEachStart) {
  System system = ideal_gas(periodic_cell(1, 1, 1), 10, 0, 1);
  FlowMeasurement measurement;
  measurement.add({.system = system, .contacts = {}, .contact_starts = 100});  // before the measurement began
  system.time = 4;
  measurement.add({.system = system, .contacts = {}, .contact_starts = 130});
  EXPECT_DOUBLE_EQ(found(measurement.result(), "collision_rate").value, 2 * 30.0 / (10 * 4));
}

TEST(FlowMeasurement, DissipationIsWorkThatIsNotGained) {
  System system = ideal_gas(periodic_cell(1, 1, 2), 1, 0, 1);
  FlowMeasurement measurement;
  measurement.add({.system = system, .contacts = {}, .work = 1, .elastic_energy = 0.5});
  system.time = 3;
  system.velocity[0] = {2, 0, 0};  // 4 J of 2 kg
  system.spin[0] = {0, 100, 0};    // ½·0.4·2·1e-4·1e4 = 0.4 J
  measurement.add({.system = system, .contacts = {}, .work = 11, .elastic_energy = 0.2});
  EXPECT_NEAR(found(measurement.result(), "dissipation").value, (10 - 4 - 0.4 + 0.3) / (2 * 3), 1e-14);
  EXPECT_NEAR(found(measurement.result(), "rotational_energy").value, 0.2, 1e-15);
  EXPECT_TRUE(std::isnan(found(measurement.result(), "energy_drift").value));  // no account of what the laws took
}

TEST(FlowMeasurement, EnergyDriftIsWhatTheAccountLeavesOverPerCollision) {
  System system = ideal_gas(periodic_cell(1, 1, 1), 1, 0, 1);
  system.velocity[0] = {1, 0, 0};  // 1 J
  FlowMeasurement measurement;
  measurement.add({.system = system, .contacts = {}, .dissipated = 2});
  system.time = 1;
  measurement.add({.system = system, .contacts = {}, .contact_starts = 10, .work = 3, .elastic_energy = 0.01, .dissipated = 5});
  EXPECT_NEAR(found(measurement.result(), "energy_drift").value, 0.01 / 10, 1e-15);
}

TEST(FlowMeasurement, OfContactsWithoutForcesCountsThemAndLeavesOutTheStressOfSlabs) {
  System system;
  system.cell = periodic_cell(1, 1, 1);
  for (const double x : {0.2, 0.22, 0.24}) add_sphere(system, {x, 0.5, 0.5});
  const std::vector<ContactForce> row = {{.first = 0, .second = 1}, {.first = 1, .second = 2}};
  FlowMeasurement measurement(1);
  for (const double moment : {0.0, 6.0}) {
    const Eigen::Matrix3d total = moment * Eigen::Matrix3d::Identity();
    measurement.add({.system = system, .contacts = row, .forces_known = false, .contact_moment = total});
    system.time += 2;
  }
  EXPECT_DOUBLE_EQ(found(measurement.result(), "multi_contact_fraction").value, 1.0 / 3);
  EXPECT_DOUBLE_EQ(found(measurement.result(), "pressure").value, 3);
  EXPECT_TRUE(std::isnan(profile_of(measurement.result(), "stress_xx")[0].value));
}

TEST(FlowMeasurement, RunningTotalsOfAnEngineReplaceItsSamples) {
  Cell cell = periodic_cell(1, 1, 1);
  cell.shear_rate = 10;
  System system = ideal_gas(cell, 4, 0, 1);
  for (std::size_t i = 0; i < 4; ++i) system.velocity[i] = mean_flow(cell, system.position[i].z());
  const std::vector<ContactForce> sampled = {{.first = 0, .second = 1, .branch = {1, 1, 1}, .force = {9, 9, 9}}};
  const Eigen::Matrix3d moment = Eigen::Vector3d(1, 2, 3) * Eigen::RowVector3d(4, 5, -6);
  Sample sample{.system = system, .contacts = sampled, .contact_time = 0, .contact_moment = Eigen::Matrix3d::Zero()};
  FlowMeasurement measurement, with_work;
  measurement.add(sample);
  sample.shear_work = 1;
  sample.dissipated = 0;
  with_work.add(sample);
  system.time = 2;
  sample.contact_time = 3;
  sample.contact_moment = moment;
  sample.shear_work = 5;
  sample.dissipated = 4;
  with_work.add(sample);
  sample.shear_work = std::nullopt;
  measurement.add(sample);
  const FlowResult result = measurement.result();
  EXPECT_NEAR((result.stress_contact.value - moment / 2).norm(), 0, 1e-13);
  EXPECT_DOUBLE_EQ(found(result, "coordination").value, 2 * 3.0 / (4 * 2));
  EXPECT_NEAR(found(result, "dissipation").value, -10 * moment(0, 2) / 2, 1e-12);
  EXPECT_TRUE(std::isnan(found(result, "energy_drift").value));
  EXPECT_NEAR(found(with_work.result(), "dissipation").value, 2, 1e-12);
}

TEST(FlowMeasurement, SpinsAndDensitiesAreThoseOfTheirSlabs) {
  System system;
  system.cell = walled_cell(1, 2, 4);
  add_sphere(system, {0.5, 0.5, 0.5});
  add_sphere(system, {0.5, 0.5, 3.5});
  add_sphere(system, {0.5, 0.5, 4});  // on the face itself
  system.spin = {{1, 2, 3}, {0, 4, 0}, {0, 8, 0}};
  const FlowResult result = held(system, {}, 4);
  EXPECT_THAT(result.profile.height, testing::ElementsAre(0.5, 1.5, 2.5, 3.5));
  EXPECT_DOUBLE_EQ(profile_of(result, "spin_y")[0].value, 2);
  EXPECT_DOUBLE_EQ(profile_of(result, "spin_z")[0].value, 3);
  EXPECT_DOUBLE_EQ(profile_of(result, "spin_y")[3].value, 6);
  EXPECT_DOUBLE_EQ(profile_of(result, "number_density")[3].value, 1);
  EXPECT_EQ(profile_of(result, "number_density")[1].value, 0);
  EXPECT_TRUE(std::isnan(profile_of(result, "temperature")[1].value));
}

TEST(FlowMeasurement, SpheresBeyondAnOpenEndAreSaidAndLeftOut) {
  System system;
  system.cell = {.size = {1, 1, 1}, .boundary = {Boundary::periodic, Boundary::periodic, Boundary::open}};
  add_sphere(system, {0.5, 0.5, 0.2}, 0.01, 2, {0, 0, 1});
  add_sphere(system, {0.5, 0.5, 0.7}, 0.01, 2, {0, 0, -1});
  add_sphere(system, {0.5, 0.5, 1.5}, 0.01, 2, {0, 0, 100});
  const FlowResult result = held(system);
  EXPECT_EQ(result.outside, 1);
  EXPECT_NEAR(found(result, "temperature").value, 1.0 / 3, 1e-14);
}

TEST(FlowMeasurement, GoesOnAfterALoadBitForBit) {
  const auto feed = [](FlowMeasurement& measurement, int from, int to) {
    for (int k = from; k < to; ++k) {
      System system = ideal_gas(walled_cell(1, 1, 1), 10, 0.04, static_cast<std::uint64_t>(k));
      system.time = 0.1 * k;
      measurement.add({.system = system, .contacts = {}, .contact_starts = std::sqrt(k), .work = 0.3 * k});
    }
  };
  FlowMeasurement straight, first, second;
  feed(straight, 0, 700);
  feed(first, 0, 333);
  second.load(first.save());
  feed(second, 333, 700);
  EXPECT_EQ(second.save(), straight.save());
  EXPECT_EQ(flow_json(second.result()), flow_json(straight.result()));
  EXPECT_FALSE(flow_json(straight.result())["temperature_error"].is_null());
}

TEST(FlowMeasurement, RefusesWhatItCannotGoOnWith) {
  System system = ideal_gas(periodic_cell(1, 1, 1), 3, 1, 1);
  FlowMeasurement measurement;
  system.time = 2;
  measurement.add({system, {}});
  system.time = 1;
  EXPECT_THROW(measurement.add({system, {}}), WorkError);
  const std::string bytes = measurement.save();
  EXPECT_THROW(FlowMeasurement(7).load(bytes), WorkError);
  EXPECT_THROW(FlowMeasurement().load(bytes.substr(0, bytes.size() - 1)), WorkError);
  EXPECT_THROW(FlowMeasurement(0), WorkError);
}

TEST(FlowMeasurement, OneStateAloneSaysNothing) {
  const System system = ideal_gas(periodic_cell(1, 1, 1), 3, 1, 1);
  FlowMeasurement measurement;
  measurement.add({system, {}});
  EXPECT_TRUE(std::isnan(found(measurement.result(), "temperature").value));
  EXPECT_TRUE(measurement.result().profile.height.empty());
}

}  // namespace
}  // namespace scalebreak
