#include "viewers/window/view_keys.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>

namespace isostack {
namespace {

TEST(ViewKeys, EveryKeyDoesOneThing) {
  std::set<std::pair<std::string, bool>> seen;
  for (const ViewKey& key : view_keys()) EXPECT_TRUE(seen.emplace(key.symbol, key.control).second) << key.symbol;
}

TEST(ViewKeys, EveryActionHasAKeyAndIsInTheHelp) {
  std::set<ViewAction> bound;
  for (const ViewKey& key : view_keys()) bound.insert(key.action);
  for (int action = 0; action <= static_cast<int>(ViewAction::quit); ++action)
    EXPECT_TRUE(bound.contains(static_cast<ViewAction>(action))) << action;
  for (const ViewKey& key : view_keys()) EXPECT_NE(key_help().find(key.help), std::string::npos) << key.symbol;
}

TEST(ViewKeys, ControlTellsKeysApart) {
  EXPECT_EQ(action_of("s", false), ViewAction::show_surfaces);
  EXPECT_EQ(action_of("s", true), ViewAction::save_session);
  EXPECT_EQ(action_of("question", false), ViewAction::help);
  EXPECT_FALSE(action_of("F12", false).has_value());
}

}  // namespace
}  // namespace isostack
