#include "viewers/window/background_task.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "recon/geometry/errors.h"

namespace isostack {
namespace {

using namespace std::chrono_literals;

/// Waits, a minute at most, until it is so.
template <class Condition>
bool comes_true(Condition condition) {
  for (int i = 0; i < 60'000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(1ms);
  }
  return false;
}

/// Work that goes on until it is cancelled.
int endless(const Progress& progress) {
  while (true) {
    progress.report("turning", 0.25);
    std::this_thread::sleep_for(1ms);
  }
}

TEST(BackgroundTask, GivesItsResultOnce) {
  BackgroundTask<int> task;
  EXPECT_EQ(task.status().state, TaskState::idle);
  EXPECT_FALSE(task.take().has_value());
  task.start([](const Progress&) { return 42; });
  ASSERT_TRUE(comes_true([&] { return task.status().state == TaskState::done; }));
  EXPECT_EQ(task.take(), 42);
  EXPECT_FALSE(task.take().has_value());
}

TEST(BackgroundTask, TellsHowFarItIsWhileTheCallerGoesOn) {
  BackgroundTask<int> task;
  task.start(endless);
  ASSERT_TRUE(comes_true([&] { return task.status().stage == "turning"; }));
  EXPECT_TRUE(task.is_running());
  EXPECT_EQ(task.status().fraction, 0.25);
  task.cancel();
  ASSERT_TRUE(comes_true([&] { return task.status().state == TaskState::cancelled; }));
  EXPECT_FALSE(task.take().has_value());
}

TEST(BackgroundTask, FailuresBecomeItsMessage) {
  BackgroundTask<int> task;
  task.start([](const Progress&) -> int { throw InputError("slice 3", "it is bad", "mend it"); });
  ASSERT_TRUE(comes_true([&] { return task.status().state == TaskState::failed; }));
  EXPECT_EQ(task.status().message, "slice 3: it is bad; mend it.");
  task.start([](const Progress&) -> int { throw std::bad_alloc(); });
  ASSERT_TRUE(comes_true([&] { return task.status().state == TaskState::failed; }));
  EXPECT_NE(task.status().message.find("memory"), std::string::npos);
}

TEST(BackgroundTask, ANewStartTakesThePlaceOfWhatRuns) {
  BackgroundTask<int> task;
  task.start(endless);
  task.start([](const Progress&) { return 7; });
  ASSERT_TRUE(comes_true([&] { return task.status().state == TaskState::done; }));
  EXPECT_EQ(task.take(), 7);
}

TEST(BackgroundTask, GoingAwayStopsTheWork) {
  std::atomic<bool> has_ended = false;
  {
    BackgroundTask<int> task;
    task.start([&has_ended](const Progress& progress) {
      try {
        return endless(progress);
      } catch (const Cancelled&) {
        has_ended = true;
        throw;
      }
    });
    ASSERT_TRUE(comes_true([&] { return !task.status().stage.empty(); }));
  }
  EXPECT_TRUE(has_ended);
}

}  // namespace
}  // namespace isostack
