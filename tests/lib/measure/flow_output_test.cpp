#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <lib/measure/states.hpp>
#include <scalebreak/base/error.hpp>
#include <scalebreak/measure/flow_csv.hpp>
#include <scalebreak/measure/flow_json.hpp>

namespace scalebreak {
namespace {

FlowResult pressed_pair() {
  System system;
  system.cell = periodic_cell(1, 1, 1);
  add_sphere(system, {0.2, 0.2, 0.2}, 0.01, 2, {0, 0, 1});
  add_sphere(system, {0.2, 0.2, 0.22}, 0.01, 2, {0, 0, -1});
  return held(system, {{.first = 0, .second = 1, .branch = {0, 0, 0.02}, .force = {1, 0, -3}}}, 2);
}

TEST(FlowJson, NamesEveryQuantityWithItsErrorAndNullsWhatIsUnknown) {
  const nlohmann::json json = flow_json(pressed_pair());
  for (const std::string name : {"temperature", "rotational_energy", "collision_rate", "coordination", "multi_contact_fraction",
                                 "volume_fraction", "dissipation", "energy_drift", "pressure", "stress", "stress_contact"}) {
    EXPECT_TRUE(json.contains(name)) << name;
    EXPECT_TRUE(json.contains(name + "_error")) << name;
  }
  EXPECT_TRUE(json["temperature_error"].is_null());
  EXPECT_TRUE(json["energy_drift"].is_null());
  EXPECT_DOUBLE_EQ(json["stress_contact"][2][2], 0.06);
  EXPECT_DOUBLE_EQ(json["stress_contact"][0][2], -0.02);  // force along x, branch along z
  EXPECT_EQ(json["stress_contact"][2][0], 0);
  EXPECT_TRUE(json["stress_error"][1][1].is_null());
}

TEST(FlowJson, ReadsBackForComparison) {
  const FlowResult result = pressed_pair();
  const auto written = all_quantities(result), read = quantities_of(nlohmann::json::parse(flow_json(result).dump()));
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].name, written[i].name);
    EXPECT_EQ(read[i].unit, written[i].unit);
    EXPECT_THAT(read[i].measured.value, testing::NanSensitiveDoubleEq(written[i].measured.value)) << read[i].name;
  }
  EXPECT_TRUE(quantities_of(nlohmann::json::object()).empty());
  EXPECT_THROW(static_cast<void>(quantities_of({{"temperature", "warm"}})), WorkError);
}

TEST(FlowCsv, ProfileHasARowASlabWithErrors) {
  const std::string text = profile_csv(pressed_pair().profile).text();
  EXPECT_THAT(text, testing::StartsWith("z [m],volume_fraction [-],volume_fraction_error [-],number_density [1/m3]"));
  EXPECT_THAT(text, testing::HasSubstr("\n0.25,"));
  EXPECT_THAT(text, testing::HasSubstr("\n0.75,0,,0,,,,"));  // an empty slab
}

TEST(FlowCsv, ARowOfTheSeriesSaysWhatTheHeldStateMeasures) {
  System system = ideal_gas(periodic_cell(1, 1, 1), 50, 0.04, 1);
  const std::vector<ContactForce> contacts = {{.first = 0, .second = 1, .branch = {0, 0, 0.02}, .force = {1, 0, -3}}};
  const FlowResult result = held(system, contacts);
  const auto header = series_header();
  const auto row = series_row({.system = system, .contacts = contacts, .contact_starts = 7, .work = 2, .elastic_energy = 0.5});
  ASSERT_EQ(row.size(), header.size());
  int compared = 0;
  for (const Quantity& quantity : all_quantities(result)) {
    for (std::size_t i = 0; i < header.size(); ++i) {
      if (header[i] != quantity.name + " [" + quantity.unit + "]") continue;
      EXPECT_NEAR(std::get<double>(row[i]), quantity.measured.value, 1e-13) << header[i];
      ++compared;
    }
  }
  EXPECT_EQ(compared, 14);
}

}  // namespace
}  // namespace scalebreak
