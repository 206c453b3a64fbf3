#include "recon/geometry/progress.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "recon/geometry/errors.h"

namespace isostack {
namespace {

TEST(Progress, IsSilentAndNeverCancelsByDefault) { EXPECT_NO_THROW(Progress().report("solve", 0.5)); }

TEST(Progress, PassesOnStageAndFraction) {
  std::vector<std::pair<std::string, double>> seen;
  Progress progress;
  progress.on_report = [&](std::string_view stage, double fraction) { seen.emplace_back(stage, fraction); };
  progress.report("solve", 0.25);
  progress.report("surface", 1);
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_EQ(seen[0], std::make_pair(std::string("solve"), 0.25));
  EXPECT_EQ(seen[1], std::make_pair(std::string("surface"), 1.0));
}

TEST(Progress, ReportsBeforeItCancels) {
  int reports = 0;
  bool stop = false;
  const Progress progress{.on_report = [&](std::string_view, double) { ++reports; },
                          .is_cancelled = [&] { return stop; }};
  EXPECT_NO_THROW(progress.report("solve", 0));
  stop = true;
  EXPECT_THROW(progress.report("solve", 0.5), Cancelled);
  EXPECT_EQ(reports, 2);
}

}  // namespace
}  // namespace isostack
