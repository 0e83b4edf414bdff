#include <scalebreak/statistics/block_series.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <scalebreak/base/error.hpp>

namespace scalebreak {
namespace {

BlockSeries counted(int from, int to, BlockSeries series = {}) {
  for (int i = from; i < to; ++i) series.add(Eigen::Array2d(i, 1));
  return series;
}

TEST(BlockSeries, HoldsEverythingInFewBlocksInOrder) {
  for (const int count : {1, 255, 256, 257, 5000}) {
    const auto blocks = counted(0, count).blocks();
    EXPECT_LE(blocks.size(), BlockSeries::capacity);
    Eigen::Array2d sum(0, 0);
    double before = -1;
    for (const Eigen::ArrayXd& block : blocks) {
      sum += block;
      EXPECT_GT(block[0] / block[1], before);
      before = block[0] / block[1];
    }
    EXPECT_EQ(sum[0], count * (count - 1.0) / 2);
    EXPECT_EQ(sum[1], count);
  }
}

TEST(BlockSeries, GoesOnAfterALoadAsIfNothingHadHappened) {
  std::string bytes, after, straight;
  counted(0, 700).save(bytes);
  BlockSeries loaded;
  std::string_view rest = bytes;
  loaded.load(rest);
  EXPECT_TRUE(rest.empty());
  counted(700, 1500, loaded).save(after);
  counted(0, 1500).save(straight);
  EXPECT_EQ(after, straight);
}

TEST(BlockSeries, RefusesWhatIsCutShortOrOfAnotherLength) {
  std::string bytes;
  counted(0, 300).save(bytes);
  for (const std::size_t length : {std::size_t{0}, std::size_t{5}, std::size_t{40}, bytes.size() - 1}) {
    std::string_view rest = std::string_view(bytes).substr(0, length);
    BlockSeries loaded;
    EXPECT_THROW(loaded.load(rest), WorkError) << length;
  }
  BlockSeries series = counted(0, 3);
  EXPECT_THROW(series.add(Eigen::Array3d(1, 2, 3)), WorkError);
}

}  // namespace
}  // namespace scalebreak
