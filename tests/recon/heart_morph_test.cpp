// A left ventricle's beat: the inner wall at end-diastole becomes that at end-systole.
#include <gtest/gtest.h>

#include <filesystem>

#include "recon/metrics/mesh_measures.h"
#include "recon/morphing/variational_morph.h"
#include "tests/support/fan_closed.h"
#include "tests/support/obj_mesh.h"

namespace isostack {
namespace {

TEST(HeartMorph, TheVentricleEmptiesSteadilyBetweenItsPhases) {
  const std::string data = std::string(ISOSTACK_SHARED_DATA) + "/cardiac_mr/patient1_LV_ENDOCARDIAL_";
  if (!std::filesystem::exists(data + "000.obj")) GTEST_SKIP() << "needs " << data;
  const TriangleMesh full = testing_support::fan_closed(testing_support::obj_mesh(data + "000.obj"));
  const TriangleMesh empty = testing_support::fan_closed(testing_support::obj_mesh(data + "009.obj"));
  VariationalMorphOptions options;
  options.max_constraints = 6000;
  options.resolution_mm = 2;
  const Morph morph = variational_morph({{.name = "full", .shape = full}, {.name = "empty", .shape = empty}}, options);
  std::vector<double> volumes;
  for (const Shape& frame : morph.frames(9)) {
    const MeshMeasures measures = measure(std::get<TriangleMesh>(frame));
    EXPECT_TRUE(measures.watertight());
    EXPECT_EQ(measures.components, 1U);
    EXPECT_EQ(measures.genus, 0);
    if (!volumes.empty()) {
      EXPECT_LT(measures.volume_mm3, volumes.back());
    }
    volumes.push_back(measures.volume_mm3);
  }
  EXPECT_NEAR(volumes.front() / measure(full).volume_mm3, 1, 0.01);
  EXPECT_NEAR(volumes.back() / measure(empty).volume_mm3, 1, 0.01);
}

}  // namespace
}  // namespace isostack
