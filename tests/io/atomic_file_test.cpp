#include "io/atomic_file.h"

#include "tests/io/io_support.h"

namespace isostack::testing {
namespace {

std::size_t file_count(const TemporaryFolder& folder) {
  return static_cast<std::size_t>(
      std::distance(std::filesystem::directory_iterator(folder.path()), std::filesystem::directory_iterator()));
}

TEST(AtomicFile, ReplacesTheTargetOnCommitOnly) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.nii.gz", "old");
  AtomicFile file(folder / "a.nii.gz");
  write_bytes(file.temporary(), "new");
  EXPECT_EQ(bytes_of(folder / "a.nii.gz"), "old");
  EXPECT_TRUE(file.temporary().filename().string().ends_with("a.nii.gz"));
  file.commit();
  EXPECT_EQ(bytes_of(folder / "a.nii.gz"), "new");
  EXPECT_EQ(file_count(folder), 1u);
}

TEST(AtomicFile, LeavesNothingBehindWithoutCommit) {
  const TemporaryFolder folder;
  { AtomicFile file(folder / "a.stl"); }
  EXPECT_EQ(file_count(folder), 0u);
}

TEST(AtomicFile, NamesTheTargetThatCannotBeWritten) {
  const TemporaryFolder folder;
  EXPECT_NE(message_of([&] { AtomicFile file(folder / "missing/a.stl"); }).find("missing/a.stl"), std::string::npos);
  EXPECT_NE(message_of([&] { AtomicFile file(folder.path()); }).find("folder"), std::string::npos);
}

TEST(AtomicFile, TwoWritersOfOneTargetDoNotMeet) {
  const TemporaryFolder folder;
  AtomicFile first(folder / "a.json"), second(folder / "a.json");
  EXPECT_NE(first.temporary(), second.temporary());
}

}  // namespace
}  // namespace isostack::testing
