#include "viewers/window/view_session.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "recon/geometry/errors.h"
#include "viewers/window/view_session_json.h"

namespace isostack {
namespace {

namespace fs = std::filesystem;

class ViewSessionFile : public testing::Test {
 protected:
  void SetUp() override {
    folder = fs::path(testing::TempDir()) / ("isostack_session_" + std::to_string(::getpid()));
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }
  fs::path write(const std::string& text) const {
    std::ofstream(folder / "session.json") << text;
    return folder / "session.json";
  }
  fs::path folder;
};

/// Every field unlike its default.
ViewState unusual_state() {
  ViewState state;
  state.plane = 12;
  state.layout = WindowLayout::slice;
  state.pointer = PointerMode::measure;
  state.layers = {.surfaces = false, .contours = false, .cut_lines = false, .marks = false, .images = ImagesShown::all};
  state.clip = ClipSide::back;
  state.side_by_side = true;
  state.surface_opacity = 0.25;
  state.reach_mm = 2.5;
  state.frame = 3;
  state.grey = GreyWindow{-100, 300};
  state.camera = ViewCamera{{1, 2, 3}, {4, 5, 6}, {0, 0.6, 0.8}, 250};
  state.picks_mm = {{1, 1, 2}};
  state.measurements = {{{0, 0, 0}, {3, 4, 0}}};
  state.seeds = {{{7, 8, 9}, "liver"}};
  state.is_segmented = true;
  state.is_solved = true;
  state.edits = {{{.kind = EditKind::move_point,
                   .organ = 1,
                   .slice = 2,
                   .contour = 3,
                   .point = 4,
                   .to_mm = {5, 6.25},
                   .reach_mm = 7}},
                 {{.kind = EditKind::add_point, .slice = 1, .point = 2, .to_mm = {0.1, -0.2}},
                  {.kind = EditKind::delete_point, .slice = 1, .point = 9}},
                 {{.kind = EditKind::drop_slice, .organ = 2, .slice = 3}}};
  return state;
}

TEST_F(ViewSessionFile, ComesBackAsItWas) {
  ViewSession session;
  session.inputs = {folder / "series", folder / "organ.stl"};
  session.frames = {folder / "morph" / "frame_000.stl"};
  session.beside = {folder / ".." / "other.stl"};
  session.title = "Phantom";
  session.dark = true;
  session.state = unusual_state();
  write_view_session(session, folder / "session.json");
  EXPECT_TRUE(is_view_session(folder / "session.json"));
  const ViewSession back = read_view_session(folder / "session.json");
  EXPECT_EQ(back.inputs, session.inputs);
  EXPECT_EQ(back.frames, session.frames);
  EXPECT_EQ(back.beside, std::vector<fs::path>{(folder / ".." / "other.stl").lexically_normal()});
  EXPECT_EQ(back.title, "Phantom");
  EXPECT_TRUE(back.dark);
  EXPECT_EQ(to_json(back.state), to_json(unusual_state()));
  const nlohmann::json unusual = to_json(unusual_state()), usual = to_json(ViewState{});
  for (const auto& [key, value] : usual.items()) EXPECT_NE(unusual[key], value) << key << " is not tried";
}

TEST_F(ViewSessionFile, MovesWithItsFiles) {
  ViewSession session;
  session.inputs = {folder / "organ.stl"};
  write_view_session(session, folder / "session.json");
  const fs::path moved = folder / "moved";
  fs::create_directories(moved);
  fs::rename(folder / "session.json", moved / "session.json");
  EXPECT_EQ(read_view_session(moved / "session.json").inputs, std::vector<fs::path>{moved / "organ.stl"});
}

TEST_F(ViewSessionFile, WhatIsNotSaidHasItsDefault) {
  const fs::path path =
      write(R"({"format": "isostack-view", "version": 1, "inputs": ["a.stl"], "state": {"plane": 2}})");
  ViewState expected;
  expected.plane = 2;
  EXPECT_EQ(to_json(read_view_session(path).state), to_json(expected));
}

TEST_F(ViewSessionFile, RefusalsNameTheFileAndWhatIsWrong) {
  const std::string head = R"({"format": "isostack-view", "version": 1, "inputs": ["a.stl"], "state": )";
  const std::vector<std::pair<std::string, std::string>> bad = {
      {"{", "session"},
      {R"({"format": "isostack-contours", "version": 1})", "isostack-view"},
      {R"({"format": "isostack-view", "version": 2, "inputs": ["a.stl"]})", "version"},
      {R"({"format": "isostack-view", "version": 1, "inputs": []})", "no input"},
      {head + R"({"plane": -1}})", "plane"},
      {head + R"({"plane": "x"}})", "number"},
      {head + R"({"layout": "round"}})", "round"},
      {head + R"({"surface_opacity": 0}})", "surface_opacity"},
      {head + R"({"picks_mm": [[1, 2]]}})", "3 numbers"},
      {head + R"({"camera": {"position_mm": [0,0,5], "focal_mm": [0,0,0], "up": [0,0,1], "height_mm": 9}}})", "up"},
      {head + R"({"edits": [[{"organ": 0}]]}})", "kind"},
      {head + R"({"edits": [[{"kind": "move_point"}]]}})", "to_mm"}};
  for (const auto& [text, word] : bad) {
    const fs::path path = write(text);
    try {
      read_view_session(path);
      ADD_FAILURE() << "accepted: " << text;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  }
}

TEST_F(ViewSessionFile, ContoursAreNoSession) {
  EXPECT_FALSE(is_view_session(write(R"({"format": "isostack-contours", "version": 1, "organs": []})")));
  EXPECT_FALSE(is_view_session(write("[1, 2]")));
  EXPECT_FALSE(is_view_session(folder / "missing.json"));
}

}  // namespace
}  // namespace isostack
