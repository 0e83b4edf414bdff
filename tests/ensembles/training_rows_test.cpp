#include <cmath>

#include <gmock/gmock.h>

#include <scalebreak/base/error.hpp>
#include <scalebreak/ensembles/prediction/deviation_model.hpp>
#include <scalebreak/ensembles/prediction/training_rows.hpp>
#include <scalebreak/scene/input_file.hpp>

#include <ensembles/prediction_scenes.hpp>

namespace scalebreak::tests {
namespace {

TEST(TrainingRows, ForecastsAStudyBeforeItRuns) {
  const Input input = resolved(undamped + "[study]\nlaws = [\"rps\"]\nfactors = [0.01, 0.001]\nvolume_fractions = [0.2, 0.3]\n");
  const TrainingRows forecast = forecast_rows(input, "coming");
  ASSERT_EQ(forecast.rows.size(), 4 * predicted_quantities().size());
  const TrainingRow& row = forecast.rows.front();
  EXPECT_TRUE(std::isnan(row.deviation.value));
  EXPECT_EQ(row.law, "rps");
  EXPECT_NEAR(row.scaled.busy / row.original.busy, std::pow(0.01, -0.4), 1e-4);
  const TrainingRows gas = forecast_rows(resolved(cooling + "[study]\nlaws = [\"rps\"]\nfactors = [0.01]\n"), "gas");
  EXPECT_EQ(gas.rows.size(), predicted_quantities().size() - 1);  // nothing shears it
}

TEST(TrainingRows, ReadsAStudysFolder) {
  const TemporaryFolder folder;
  const Input input = resolved(undamped + "[study]\nlaws = [\"rps\"]\nfactors = [0.01]\nvolume_fractions = [0.2, 0.3]\n");
  put_file(folder / "input.toml", write_input(input));
  const std::string header =
      "law,factor [-],engine,volume_fraction [-],parameter_value [SI],quantity,deviation [-],deviation_error [-],version\n";
  put_file(folder / "study.csv", header +
                                     "none,1,dem,0.20000000000000001,,temperature,,,1\n"
                                     "rps,0.01,dem,0.20000000000000001,,temperature,0.25,0.125,1\n"
                                     "rps,0.01,dem,0.20000000000000001,,coordination,0.25,0.125,1\n"
                                     "rps,0.01,dem,0.29999999999999999,,pressure,-0.5,,1\n");
  TrainingRows training;
  add_study(training, folder.path());
  ASSERT_EQ(training.rows.size(), 1u);
  EXPECT_EQ(training.without_error, 1);
  const TrainingRow& row = training.rows.front();
  EXPECT_EQ(row.deviation.value, 0.25);
  EXPECT_EQ(row.deviation.error, 0.125);
  EXPECT_NEAR(row.scaled.busy / row.original.busy, std::pow(0.01, -0.4), 1e-4);

  put_file(folder / "study.csv", header + "rps,0.02,dem,0.2,,temperature,0.25,0.125,1\n");
  EXPECT_THAT([&] { add_study(training, folder.path()); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("study.csv, line 2: rps at 0.02 is no cell of the study")));
  const TemporaryFolder empty;
  EXPECT_THAT([&] { add_study(training, empty.path()); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("holds no finished study")));
}

}  // namespace
}  // namespace scalebreak::tests
