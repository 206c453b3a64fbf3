#include "io/dicom/child_processes.h"

#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace isostack::testing {
namespace {

std::string text(const std::vector<char>& bytes) { return {bytes.begin(), bytes.end()}; }

TEST(ChildProcesses, OnlyTasksThatFailAreLost) {
  enum { kAbort = 3, kSegfault = 5, kThrow = 8, kFalse = 9, kExit = 11, kCount = 20 };
  const auto results = run_in_children(std::vector<std::size_t>(kCount, 4), [](std::size_t task, char* result) {
    if (task == kAbort) std::abort();
    if (task == kSegfault) std::raise(SIGSEGV);
    if (task == kThrow) throw std::runtime_error("no");
    if (task == kExit) std::_Exit(1);
    std::snprintf(result, 4, "%zu", task);
    return task != kFalse;
  });
  ASSERT_EQ(results.size(), static_cast<std::size_t>(kCount));
  for (std::size_t task = 0; task < kCount; ++task) {
    const bool is_lost = task == kAbort || task == kSegfault || task == kThrow || task == kFalse || task == kExit;
    EXPECT_EQ(results[task].empty(), is_lost) << task;
    if (is_lost) continue;
    EXPECT_STREQ(text(results[task]).c_str(), std::to_string(task).c_str());
  }
}

TEST(ChildProcesses, WhatNeverEndsIsStopped) {
  const auto results = run_in_children(
      {1, 1},
      [](std::size_t task, char*) {
        std::atomic<int> turns = 0;
        while (task == 0) ++turns;
        return true;
      },
      1);
  EXPECT_TRUE(results[0].empty());
  EXPECT_FALSE(results[1].empty());
}

TEST(ChildProcesses, NothingToDo) {
  EXPECT_TRUE(run_in_children({}, [](std::size_t, char*) { return true; }).empty());
}

TEST(ChildProcesses, AreSilent) {
  ::testing::internal::CaptureStderr();
  run_in_children({1}, [](std::size_t, char*) -> bool {
    std::fputs("a library's assertion", stderr);
    std::abort();
  });
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace isostack::testing
