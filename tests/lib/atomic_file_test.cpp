#include <scalebreak/output/atomic_file.hpp>

#include <csignal>
#include <thread>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <lib/surroundings.hpp>
#include <scalebreak/base/error.hpp>

namespace scalebreak {
namespace {

using tests::content_of;
using tests::entries_in;
using tests::TemporaryFolder;

/// The sentence of the WorkError with which writing fails.
std::string failure(const std::filesystem::path& path) {
  try {
    write_file(path, "new");
  } catch (const WorkError& error) {
    return error.what();
  }
  return "(it was written)";
}

TEST(AtomicFile, WritesEveryByteAndNothingBesideIt) {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\r\n\xff", 6);
  write_file(folder / "table.npy", bytes);
  EXPECT_EQ(content_of(folder / "table.npy"), bytes);
  EXPECT_EQ(entries_in(folder.path()), 1);
}

TEST(AtomicFile, MakesMissingFoldersAndEmptyFiles) {
  const TemporaryFolder folder;
  write_file(folder.path() / "a" / "b" / "empty.csv", "");
  EXPECT_TRUE(std::filesystem::is_regular_file(folder.path() / "a" / "b" / "empty.csv"));
}

TEST(AtomicFile, ReplacesALongerFileAsAWhole) {
  const TemporaryFolder folder;
  write_file(folder / "a.txt", "long, long, long");
  write_file(folder / "a.txt", "short");
  EXPECT_EQ(content_of(folder / "a.txt"), "short");
  EXPECT_EQ(entries_in(folder.path()), 1);
}

TEST(AtomicFile, AReaderSeesTheOldOrTheNewFileAndNeverAPart) {
  const TemporaryFolder folder;
  const std::string old(1 << 20, 'o'), fresh(1 << 20, 'n');
  write_file(folder / "a.bin", old);
  std::jthread writer([&] {
    for (int i = 0; i < 60; ++i) write_file(folder / "a.bin", i % 2 == 0 ? fresh : old);
  });
  for (int i = 0; i < 60; ++i) {
    const std::string seen = content_of(folder / "a.bin");
    ASSERT_TRUE(seen == old || seen == fresh) << "after " << i << " reads: " << seen.size() << " bytes";
  }
}

TEST(AtomicFile, AFileInTheWayOfAFolderIsNamed) {
  const TemporaryFolder folder;
  tests::put_file(folder / "taken", "old");
  EXPECT_EQ(failure(folder / "taken/result.json"), fmt::format("cannot make the folder {}: Not a directory", (folder / "taken").string()));
  EXPECT_EQ(content_of(folder / "taken"), "old");
}

TEST(AtomicFile, ANameThatTheSystemRefusesIsNamedWithItsReason) {
  const TemporaryFolder folder;
  const auto path = folder / std::string(300, 'a');
  EXPECT_EQ(failure(path), fmt::format("cannot write {}: File name too long", path.string()));
  EXPECT_EQ(entries_in(folder.path()), 0);
}

TEST(AtomicFile, AFolderInTheWayOfAFileIsNamedAndNoPartIsLeft) {
  const TemporaryFolder folder;
  tests::put_file(folder / "result.json/inside.txt", "old");
  EXPECT_EQ(failure(folder / "result.json"), fmt::format("cannot put {} in place: Is a directory", (folder / "result.json").string()));
  EXPECT_EQ(entries_in(folder.path()), 1) << "a .part was left";
}

TEST(AtomicFile, AppendsToWhatIsThereOrBeginsAFile) {
  const TemporaryFolder folder;
  append_file(folder / "sub/a.xyz", "one\n");
  append_file(folder / "sub/a.xyz", "two\n");
  EXPECT_EQ(content_of(folder / "sub/a.xyz"), "one\ntwo\n");
}

TEST(AtomicFile, AppendingToAFolderIsNamedWithTheSystemsReason) {
  const TemporaryFolder folder;
  try {
    append_file(folder.path(), "text");
    ADD_FAILURE() << "appended";
  } catch (const WorkError& error) {
    EXPECT_EQ(error.what(), fmt::format("cannot append to {}: Is a directory", folder.path().string()));
  }
}

TEST(AtomicFile, AppendsWholeOrNotAtAllWhereTheDiskIsFull) {
  const TemporaryFolder folder;
  const auto path = folder / "a.xyz";
  append_file(path, "frame\n");
  rlimit old{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old), 0);
  const rlimit small{1000, old.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  EXPECT_THROW(append_file(path, std::string(100'000, 'x')), WorkError);
  setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(content_of(path), "frame\n");
}

}  // namespace
}  // namespace scalebreak
