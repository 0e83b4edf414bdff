#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <scalebreak/collisions/tables/table_builder.hpp>
#include <scalebreak/collisions/tables/table_store.hpp>
#include <scalebreak/contact/damping.hpp>
#include <scalebreak/table/table_file.hpp>

namespace scalebreak {
namespace {

namespace fs = std::filesystem;

class TableOnDiskTest : public testing::Test {
 protected:
  void SetUp() override {
    folder = fs::path(testing::TempDir()) / ("tables_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder);
    store = {.folder = folder, .say = [this](const std::string& sentence) { said = sentence; }};
  }
  void TearDown() override { fs::remove_all(folder); }

  [[nodiscard]] fs::path file(const char* ending) const { return folder / (table_file_name(key) + ending); }
  static std::string read(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  static void write(const fs::path& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

  TableKey key{ContactKind{}, 1e-4};
  fs::path folder;
  TableStore store;
  std::string said;
};

TEST_F(TableOnDiskTest, IsReadBackBitForBit) {
  const StoredTable built = obtain_table(key, store);
  EXPECT_TRUE(built.built);
  const StoredTable read_back = obtain_table(key, store);
  EXPECT_FALSE(read_back.built);
  EXPECT_EQ(said, "");
  EXPECT_EQ(read_back.table.quality().error_max, built.table.quality().error_max);
  for (const double speed : {1.0, 2.0, 37.0, 5e3}) {
    EXPECT_EQ(read_back.table.find(0.1, speed)->restitution, built.table.find(0.1, speed)->restitution);
    EXPECT_EQ(read_back.table.find(0.1, speed)->contact_time, built.table.find(0.1, speed)->contact_time);
  }
}

TEST_F(TableOnDiskTest, SaysWhatItIs) {
  (void)obtain_table(key, store);
  const auto j = nlohmann::json::parse(read(file(".json")));
  EXPECT_EQ(j["format"], "scalebreak collision table");
  EXPECT_EQ(j["format_version"], 1);
  EXPECT_EQ(j["key"]["normal"], "jkr");
  EXPECT_EQ(j["key"]["adhesion_range"], "full");
  EXPECT_EQ(j["key"]["damping_on"], "contact_radius");
  EXPECT_EQ(j["key"]["tolerance"], 1e-4);
  EXPECT_LT(j["quality"]["error_max"], 1e-4);
  EXPECT_EQ(read(file(".npy")).substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
}

/// Any single damage, anywhere in either file, is noticed; the table is built anew, and said to be.
TEST_F(TableOnDiskTest, IsNeverUsedDamaged) {
  (void)obtain_table(key, store);
  for (const char* ending : {".npy", ".json"}) {
    const std::string good = read(file(ending));
    for (const double place : {0.001, 0.02, 0.3, 0.7, 0.999}) {
      std::string bad = good;
      bad[static_cast<std::size_t>(place * static_cast<double>(bad.size()))] ^= 0x11;
      write(file(ending), bad);
      EXPECT_FALSE(read_table(folder, key).table.has_value()) << ending << " at " << place;
    }
    write(file(ending), good.substr(0, good.size() / 2));
    EXPECT_FALSE(read_table(folder, key).table.has_value());
    fs::remove(file(ending));
    EXPECT_EQ(read_table(folder, key).problem, "one of its two files is missing");
    write(file(ending), good);
    EXPECT_TRUE(read_table(folder, key).table.has_value());
  }
  write(file(".npy"), "");
  const StoredTable again = obtain_table(key, store);
  EXPECT_TRUE(again.built);
  EXPECT_NE(said.find("is not used: its checksum does not fit; it is built anew"), std::string::npos) << said;
  EXPECT_FALSE(obtain_table(key, store).built);
}

TEST_F(TableOnDiskTest, OfAnotherVersionOrKeyIsStale) {
  (void)obtain_table(key, store);
  auto j = nlohmann::json::parse(read(file(".json")));
  j["format_version"] = 0;
  write(file(".json"), j.dump());
  EXPECT_EQ(read_table(folder, key).problem, "it has format version 0, this program has 1");
  j["format_version"] = 1, j["key"]["adhesion_range"] = "touch";
  write(file(".json"), j.dump());
  EXPECT_EQ(read_table(folder, key).problem, "it is of another key");
}

TEST_F(TableOnDiskTest, IsRebuiltOnRequest) {
  (void)obtain_table(key, store);
  EXPECT_TRUE(obtain_table(key, store, true).built);
}

TEST(CollisionSource, ResolvesExactlyWhatLeavesTheTableAndCounts) {
  const CollisionTable table = build_collision_table({ContactKind{}, 1e-5});
  CollisionSource source(table, damping_ratio(0.9), 1e-10);
  EXPECT_FALSE(source.collide(5.0).stuck);
  EXPECT_TRUE(source.collide(0.1).stuck);
  EXPECT_EQ(source.looked_up(), 2);
  EXPECT_EQ(source.resolved_exactly(), 0);
  EXPECT_NEAR(source.collide(1e6).restitution, exact_table_outcome({}, damping_ratio(0.9), 1e6, 1e-10).restitution, 1e-15);
  EXPECT_EQ(source.resolved_exactly(), 1);
  CollisionSource strong(table, damping_ratio(0.01), 1e-10);
  (void)strong.collide(50);
  EXPECT_EQ(strong.resolved_exactly(), 1);
}

}  // namespace
}  // namespace scalebreak
