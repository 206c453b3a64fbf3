#include "io/solid_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "recon/geometry/errors.h"

namespace isostack {
namespace {

std::filesystem::path written(const std::string& solid) {
  const auto* const test = testing::UnitTest::GetInstance()->current_test_info();
  const auto path = std::filesystem::path(testing::TempDir()) / (std::string("solid_file_") + test->name() + ".json");
  std::ofstream(path) << R"({"format": "isostack-solid", "version": 1, "solid": )" << solid << "}";
  return path;
}

std::string problem_of(const std::string& solid) {
  try {
    read_solid(written(solid));
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(SolidFile, TreeWithNestedMaps) {
  const CsgSolid solid = read_solid(written(R"({
    "name": "head", "affine": [[1, 0, 0, 5], [0, 1, 0, 0], [0, 0, 2, 0]],
    "difference": [
      {"superellipsoid": {"radii_mm": [7, 8, 9], "exponents": [0.5, 1.5]}},
      {"union": [{"superellipsoid": {"radii_mm": [1, 2, 3]}, "affine": [[1, 0, 0, 1], [0, 1, 0, 2], [0, 0, 1, 3]]}]}]})"));
  EXPECT_EQ(solid.name, "head");
  ASSERT_EQ(solid.kind, CsgSolid::Kind::difference);
  ASSERT_EQ(solid.parts.size(), 2u);
  EXPECT_EQ(solid.parts[0].radii_mm, Eigen::Vector3d(7, 8, 9));
  EXPECT_EQ(solid.parts[0].exponents, Eigen::Vector2d(0.5, 1.5));
  const CsgSolid& inner = solid.parts[1].parts.at(0);
  EXPECT_EQ(inner.exponents, Eigen::Vector2d(1, 1));
  EXPECT_EQ(inner.to_world * Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(6, 2, 8));  // its own map first
}

TEST(SolidFile, MistakesAreNamedWithTheirPlace) {
  const auto names = [](const std::string& problem, const char* place, const char* word) {
    EXPECT_NE(problem.find(place), std::string::npos) << problem;
    EXPECT_NE(problem.find(word), std::string::npos) << problem;
  };
  names(problem_of(R"({"union": []})"), "/solid/union", "empty");
  names(problem_of(R"({"union": [{"superellipsoid": {"radii_mm": [1, 1, 1], "colour": 3}}]})"),
        "/solid/union/0/superellipsoid", "'colour'");
  names(problem_of(R"({"superellipsoid": {"radii_mm": [1, -1, 1]}})"), "/solid/superellipsoid/radii_mm", "above 0");
  names(problem_of(R"({"superellipsoid": {"radii_mm": [1, 1]}})"), "/radii_mm", "3 numbers");
  names(problem_of(R"({"superellipsoid": {}})"), "/solid/superellipsoid", "'radii_mm' is missing");
  names(problem_of(R"({"name": "x"})"), "/solid", "nothing of a shape");
  names(problem_of(
            R"({"affine": [[1, 0, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0]], "superellipsoid": {"radii_mm": [1, 1, 1]}})"),
        "/solid/affine", "flattens");
  names(problem_of("3"), "/solid", "object");
  std::ofstream(written("1")) << "{ \"format\"";
  EXPECT_THROW(read_solid(std::filesystem::path(testing::TempDir()) / "solid_file_MistakesAreNamedWithTheirPlace.json"),
               InputError);
  EXPECT_THROW(read_solid("/nowhere/solid.json"), InputError);
}

}  // namespace
}  // namespace isostack
