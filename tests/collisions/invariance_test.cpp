#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <scalebreak/collisions/invariance/invariance.hpp>
#include <scalebreak/collisions/invariance/invariance_words.hpp>

namespace scalebreak {
namespace {

const LawSummary& summary(const InvarianceStudy& study, const std::string& law, bool softer) {
  return *std::find_if(study.summaries.begin(), study.summaries.end(),
                       [&](const LawSummary& s) { return s.law == law && s.softer == softer; });
}

TEST(Invariance, TellsWhatEachLawKeepsOfAnAdhesivePair) {
  const InvarianceStudy study = run_invariance(Input{}, 0);
  for (const char* law : {"rps", "sup", "torque_cubed", "sakai", "chen_elliott", "thakur"}) {
    const LawSummary& s = summary(study, law, std::string(law) == "rps");
    EXPECT_TRUE(s.exact) << law;
    EXPECT_LT(s.restitution_change, 1e-8) << law;
    EXPECT_TRUE(s.sticking_speed.kept) << law;
    EXPECT_EQ(s.verdict_changes, 0) << law;
  }
  EXPECT_NEAR(summary(study, "rps", true).contact_time.exponent, -0.4, 1e-9);
  EXPECT_NEAR(summary(study, "sup", false).contact_time.exponent, 1, 1e-9);
  EXPECT_TRUE(summary(study, "sakai", false).contact_time.kept);
  // Moved, by the powers of v_stick ∝ (γ⁵R⁴/E²)^{1/6} m^{−1/2}.
  for (const auto& [law, softer, power] :
       {std::tuple{"none", true, -1.0 / 3}, {"none", false, -5.0 / 6}, {"bond", false, 5.0 / 6}, {"cohesion", false, 0.5}}) {
    const LawSummary& s = summary(study, law, softer);
    EXPECT_FALSE(s.exact) << law;
    EXPECT_NEAR(s.sticking_speed.exponent, power, 1e-9) << law;
    EXPECT_LT(s.sticking_speed.exponent_error, 1e-9) << law;
    EXPECT_LT(s.reduced_restitution_change, 1e-8) << law;
    EXPECT_GT(s.verdict_changes, 0) << law;
  }
  // These change the damping ratio too, so that no speed ratio brings the original back.
  EXPECT_GT(summary(study, "overlap_kept", false).reduced_restitution_change, 1e-2);
  EXPECT_GT(summary(study, "force_cubed", false).reduced_restitution_change, 1e-2);
}

TEST(Invariance, PredictsTheContactTimeOfExactLaws) {
  const InvarianceStudy study = run_invariance(Input{}, 0);
  int predicted = 0;
  for (const InvarianceRecord& r : study.records) {
    if (!r.contact_time_ratio || !r.contact_time_ratio_predicted) continue;
    EXPECT_NEAR(*r.contact_time_ratio / *r.contact_time_ratio_predicted, 1, 1e-8);
    ++predicted;
  }
  EXPECT_GT(predicted, 100);
}

TEST(Invariance, OfAHertzPairWithoutLawIsKeptButForItsTime) {
  Input input;
  input.contact = canonical({.normal = NormalModel::hertz});
  const InvarianceStudy study = run_invariance(input, 0);
  EXPECT_FALSE(study.sticking_speed.has_value());
  const LawSummary& s = summary(study, "none", true);
  EXPECT_LT(s.restitution_change, 1e-8);
  EXPECT_FALSE(s.sticking_speed.exists);
  EXPECT_NEAR(s.contact_time.exponent, -0.4, 1e-9);
  EXPECT_EQ(std::count_if(study.summaries.begin(), study.summaries.end(), [](const auto& x) { return x.law == "bond"; }), 0);
}

TEST(Invariance, IsTheSameForAnyNumberOfThreads) {
  const InvarianceStudy one = run_invariance(Input{}, 1), three = run_invariance(Input{}, 3);
  ASSERT_EQ(one.records.size(), three.records.size());
  for (std::size_t i = 0; i < one.records.size(); ++i) {
    EXPECT_EQ(one.records[i].law, three.records[i].law);
    EXPECT_EQ(one.records[i].restitution, three.records[i].restitution);
    EXPECT_EQ(one.records[i].contact_time_ratio, three.records[i].contact_time_ratio);
  }
}

TEST(Invariance, UsesTheSpeedsLawsAndFactorsItIsGiven) {
  Input input;
  input.study_laws = {"sup", "rps"}, input.study_factors = {2, 0.5}, input.study_speeds = {0.1, 1.0};
  const InvarianceStudy study = run_invariance(input, 0);
  ASSERT_EQ(study.records.size(), 4u);
  EXPECT_EQ(study.skipped, 2);
  EXPECT_EQ(study.records[0].law, "sup");
  EXPECT_EQ(study.records[0].factor, 2);
  EXPECT_EQ(study.records[0].normal_speed, 0.1);
}

const MotionTrend& motion(const LawSummary& summary, const std::string& key) {
  return *std::find_if(summary.motion.begin(), summary.motion.end(), [&](const MotionTrend& t) { return t.quantity->key == key; });
}

TEST(Invariance, OfAnObliquePairTellsKeptFromKeptToFirstOrderFromMoved) {
  Input input;
  input.surface.tangential = TangentialModel::mindlin;
  input.tangential_speed = 3 * input.normal_speed;
  input.study_speeds = {0.05, 0.1, 0.5};
  const InvarianceStudy study = run_invariance(input, 0);
  EXPECT_EQ(motion(summary(study, "thakur", false), "spin_ratio").verdict, TrendVerdict::kept);
  EXPECT_EQ(motion(summary(study, "torque_cubed", false), "spin_ratio").verdict, TrendVerdict::kept);
  const MotionTrend& rps = motion(summary(study, "rps", true), "restitution_normal");
  EXPECT_EQ(rps.verdict, TrendVerdict::kept_to_first_order);
  EXPECT_GT(rps.largest, 1e-3);
  ASSERT_TRUE(rps.overlap_power);
  EXPECT_NEAR(rps.overlap_exponent, 1, 0.1);
  const MotionTrend& sup = motion(summary(study, "sup", false), "spin_ratio");
  EXPECT_EQ(sup.verdict, TrendVerdict::moved);
  EXPECT_NEAR(sup.power.exponent, -1, 1e-6);
  EXPECT_LT(sup.power.exponent_error, 1e-6);
  for (const InvarianceRecord& r : study.records) {
    ASSERT_TRUE(r.motions.has_value());
    EXPECT_EQ(r.restitution, r.motions->scaled.restitution_normal);
  }
}

TEST(Invariance, AHeadOnDryPairCostsNoMotion) {
  Input input;
  EXPECT_FALSE(moves_beyond_normal(input));
  input.surface.tangential = TangentialModel::mindlin;
  EXPECT_FALSE(moves_beyond_normal(input));
  input.study_speeds = {0.1}, input.study_factors = {2};
  for (const InvarianceRecord& r : run_invariance(input, 1).records) EXPECT_FALSE(r.motions.has_value());
  input.spin2 = {0, 0, 1};
  EXPECT_TRUE(moves_beyond_normal(input));
}

TEST(Invariance, AnotherNormalSpeedKeepsAngleAndSpinRatio) {
  Input input;
  input.tangential_speed = 0.3, input.spin1 = {1, 2, 3};
  const Input slow = at_normal_speed(input, 0.05);
  EXPECT_DOUBLE_EQ(slow.tangential_speed, 0.15);
  EXPECT_TRUE(slow.spin1.isApprox(input.spin1 / 2));
}

TEST(InvarianceReport, SaysInWordsWhatALawKeeps) {
  LawSummary s{.law = "rps", .softer = true};
  s.sticking_speed = {true, true, 0, 0, 0};
  s.contact_time = {true, false, 39, -0.4, 1e-12};
  s.max_overlap = {true, false, 1, 0.3, 0.2};
  EXPECT_EQ(in_words(s),
            "rps keeps the restitution at every speed; it keeps the sticking speed; it moves the contact time as factor^-0.400; it moves "
            "the largest overlap by up to 1 times itself, not by one power of the factor.");
  LawSummary n{.law = "none", .softer = false, .restitution_change = 0.25, .verdict_changes = 3};
  EXPECT_EQ(in_words(n),
            "none (larger) changes the restitution by up to 0.25 (3 of its collisions stick where the original's do not, or the reverse).");
}

}  // namespace
}  // namespace scalebreak
