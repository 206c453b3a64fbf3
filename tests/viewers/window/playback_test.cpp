#include "viewers/window/playback.h"

#include <gtest/gtest.h>

namespace isostack {
namespace {

TEST(Playback, StepsStopAtTheEnds) {
  Playback playback(3);
  playback.step(-1);
  EXPECT_EQ(playback.position(), 0U);
  playback.step(2);
  playback.step(1);
  EXPECT_EQ(playback.position(), 2U);
}

TEST(Playback, PlaysAtItsRateAndRoundAndRound) {
  Playback playback(4, 10);
  EXPECT_FALSE(playback.advance(1)) << "it does not play yet";
  playback.play_or_pause();
  EXPECT_FALSE(playback.advance(0.06));
  EXPECT_TRUE(playback.advance(0.06));
  EXPECT_EQ(playback.position(), 1U);
  EXPECT_TRUE(playback.advance(0.5));
  EXPECT_EQ(playback.position(), 2U) << "six pictures after the first of four";
  playback.play_or_pause();
  EXPECT_FALSE(playback.advance(1));
}

TEST(Playback, NothingToPlay) {
  Playback playback(1);
  playback.play_or_pause();
  EXPECT_FALSE(playback.is_playing());
  Playback none;
  none.show(5);
  EXPECT_EQ(none.position(), 0U);
}

}  // namespace
}  // namespace isostack
