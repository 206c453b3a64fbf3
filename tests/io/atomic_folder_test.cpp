#include "io/atomic_folder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "recon/geometry/errors.h"

namespace isostack {
namespace {

namespace fs = std::filesystem;

class AtomicFolderTest : public testing::Test {
 protected:
  void SetUp() override {
    scratch = fs::path(testing::TempDir()) / ("isostack_atomic_folder_" + std::to_string(::getpid()));
    fs::create_directories(scratch);
  }
  void TearDown() override { fs::remove_all(scratch); }
  static void put(const fs::path& file) { std::ofstream(file) << "x"; }
  static std::size_t count(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }
  fs::path scratch;
};

TEST_F(AtomicFolderTest, AppearsOnCommitOnly) {
  {
    AtomicFolder folder(scratch / "frames/", "frame_");
    put(folder.temporary() / "frame_000.png");
    EXPECT_FALSE(fs::exists(scratch / "frames"));
  }
  EXPECT_TRUE(fs::is_empty(scratch));
  AtomicFolder folder(scratch / "frames/", "frame_");
  put(folder.temporary() / "frame_000.png");
  folder.commit();
  EXPECT_TRUE(fs::exists(scratch / "frames" / "frame_000.png"));
  EXPECT_EQ(count(scratch), 1u);
}

TEST_F(AtomicFolderTest, ReplacesFramesOfAnEarlierRunAsAWhole) {
  fs::create_directory(scratch / "frames");
  put(scratch / "frames" / "frame_007.png");
  AtomicFolder folder(scratch / "frames", "frame_");
  put(folder.temporary() / "frame_000.png");
  folder.commit();
  EXPECT_FALSE(fs::exists(scratch / "frames" / "frame_007.png"));
  EXPECT_TRUE(fs::exists(scratch / "frames" / "frame_000.png"));
  EXPECT_EQ(count(scratch), 1u);
}

TEST_F(AtomicFolderTest, LeavesOtherPeoplesFilesAlone) {
  fs::create_directory(scratch / "photos");
  put(scratch / "photos" / "cat.jpg");
  EXPECT_THROW(AtomicFolder(scratch / "photos", "frame_"), InputError);
  put(scratch / "file");
  EXPECT_THROW(AtomicFolder(scratch / "file", "frame_"), InputError);
  EXPECT_THROW(AtomicFolder(scratch / "nowhere" / "frames", "frame_"), InputError);
  EXPECT_TRUE(fs::exists(scratch / "photos" / "cat.jpg"));
  EXPECT_EQ(count(scratch), 2u);
}

}  // namespace
}  // namespace isostack
