#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "recon/geometry/errors.h"
#include "recon/geometry/slice.h"

namespace isostack::testing {

/// A folder of its own for one test, deleted with everything in it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    path_ = std::filesystem::path(::testing::TempDir()) / (std::string("isostack_") + test->test_suite_name() + "_" +
                                                           test->name() + "_" + std::to_string(::getpid()));
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  return bytes.str();
}

inline void write_bytes(const std::filesystem::path& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// The message of the Error that the call must throw; a failure if it throws none.
template <class Call>
std::string message_of(Call call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "no Error was thrown";
  return {};
}

/// A file's text with the first `from` replaced by `to`.
inline std::string damaged(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// A pose with no axis along any world axis and pixels that are not square.
inline SlicePose oblique_pose() {
  const Eigen::Matrix3d rotation = (Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -0.5).normalized()) *
                                    Eigen::AngleAxisd(-0.4, Eigen::Vector3d::UnitX()))
                                       .toRotationMatrix();
  SlicePose pose;
  pose.origin_mm = {-31.25, 47.5, -112.75};
  pose.x_axis = rotation.col(0);
  pose.y_axis = rotation.col(1);
  pose.spacing_mm = {0.75, 1.25};
  return pose;
}

/// A value that is different at every place, whole, and within 16 bits.
inline float field_at(const Eigen::Vector3d& world_mm) {
  return static_cast<float>(std::round(3 * world_mm.x() - 2 * world_mm.y() + 5 * world_mm.z()));
}

/// Slices of 7 columns and 5 rows at the given distances from oblique_pose() along its normal, with
/// pixels that say where in the world they are.
inline SliceStack oblique_stack(const std::vector<double>& positions_mm, const Eigen::Vector2d& drift = {0, 0}) {
  SliceStack stack;
  for (const double position_mm : positions_mm) {
    Slice& slice = stack.slices.emplace_back();
    slice.name = "slice " + std::to_string(stack.slices.size());
    slice.pose = oblique_pose();
    slice.pose.origin_mm +=
        position_mm * (slice.pose.normal() + drift.x() * slice.pose.x_axis + drift.y() * slice.pose.y_axis);
    slice.pixels.resize(5, 7);
    for (int row = 0; row < 5; ++row)
      for (int column = 0; column < 7; ++column)
        slice.pixels(row, column) = field_at(slice.pose.pixel_to_world({column, row}));
  }
  return stack;
}

/// Every pixel must say where it is. `tolerance` in grey values covers rounding of poses in files.
inline void expect_pixels_at_their_place(const SliceStack& stack, float tolerance) {
  for (const Slice& slice : stack.slices)
    for (int row = 0; row < slice.pixels.rows(); ++row)
      for (int column = 0; column < slice.pixels.cols(); ++column)
        ASSERT_NEAR(slice.pixels(row, column), field_at(slice.pose.pixel_to_world({column, row})), tolerance)
            << slice.name << " row " << row << " column " << column;
}

inline bool has_warning(const std::vector<std::string>& warnings, std::string_view beginning) {
  return std::any_of(warnings.begin(), warnings.end(), [&](const auto& text) { return text.starts_with(beginning); });
}

inline std::filesystem::path shared_data() { return ISOSTACK_SHARED_DATA; }

}  // namespace isostack::testing
