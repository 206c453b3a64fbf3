#include <cmath>
#include <cstring>

#include "tests/io/volume_support.h"

namespace isostack::testing {
namespace {

template <class T>
StoredVolume stored(const std::string& type) {
  StoredVolume volume;
  volume.header.grid = oblique_grid();
  volume.header.value_type = type;
  std::vector<T> values(volume.header.grid.voxel_count());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<T>(static_cast<double>(std::numeric_limits<T>::max()) / 64 * static_cast<double>(i));
  const std::string bytes = as_bytes(values);
  volume.bytes.assign(bytes.begin(), bytes.end());
  return volume;
}

void expect_kept(const StoredVolume& volume) {
  const TemporaryFolder folder;
  for (const char* name : {"a.nii", "a.nii.gz", "a.nrrd", "a.nhdr", "a.mha", "a.mhd"})
    for (const bool compressed : {true, false}) {
      SCOPED_TRACE(volume.header.value_type + " in " + name);
      write_volume(volume, folder / name, {.compressed = compressed});
      const StoredVolume read = read_stored_volume(folder / name);
      EXPECT_EQ(read.header.value_type, volume.header.value_type);
      EXPECT_EQ(read.bytes, volume.bytes);
      // NIfTI-1 holds poses as floats, the others every digit.
      expect_same_grid(read.header.grid, volume.header.grid, name[2] == 'n' && name[3] == 'i' ? 1e-4 : 1e-12);
    }
}

TEST(VolumeWrite, StoredTypesStayInEveryFormat) {
  expect_kept(stored<std::uint8_t>("uint8"));
  expect_kept(stored<std::int8_t>("int8"));
  expect_kept(stored<std::int16_t>("int16"));
  expect_kept(stored<std::uint16_t>("uint16"));
  expect_kept(stored<std::int32_t>("int32"));
  expect_kept(stored<std::uint32_t>("uint32"));
  expect_kept(stored<std::int64_t>("int64"));
  expect_kept(stored<std::uint64_t>("uint64"));
  expect_kept(stored<float>("float"));
  expect_kept(stored<double>("double"));
}

TEST(VolumeWrite, DistancesAreMarkedAsSuchInEveryFormat) {
  const TemporaryFolder folder;
  Volume<float> distances(oblique_grid());
  distances.voxels.front() = -1.5f;
  for (const char* name : {"a.nii", "a.nii.gz", "a.nrrd", "a.nhdr", "a.mha", "a.mhd"}) {
    write_volume(stored_distances_of(distances), folder / name);
    EXPECT_TRUE(read_stored_volume(folder / name).header.is_distance) << name;
    EXPECT_EQ(read_volume(folder / name).voxels, distances.voxels) << name;
    write_volume(stored_volume_of(distances), folder / name);
    EXPECT_FALSE(read_stored_volume(folder / name).header.is_distance) << name;
  }
}

std::vector<double> values_in(const StoredVolume& volume) {
  std::vector<double> values;
  for_each_value(volume, [&](std::size_t, double value) { values.push_back(value); });
  return values;
}

TEST(VolumeWrite, RescaleIsKeptByNiftiAndAppliedExactlyByOthers) {
  const TemporaryFolder folder;
  StoredVolume volume = stored<std::int16_t>("int16");
  volume.header.intercept = -1024;
  for (const char* name : {"a.nii", "a.nrrd", "a.mha"}) {
    write_volume(volume, folder / name);
    EXPECT_EQ(values_in(read_stored_volume(folder / name)), values_in(volume)) << name;
  }
  EXPECT_EQ(read_stored_volume(folder / "a.nii").header.value_type, "int16");
  volume.header.slope = 0.1;  // not a float
  for (const char* name : {"a.nii", "a.nrrd", "a.mha"}) {
    write_volume(volume, folder / name);
    EXPECT_EQ(values_in(read_stored_volume(folder / name)), values_in(volume)) << name;
    EXPECT_EQ(read_stored_volume(folder / name).header.value_type, "double") << name;
  }
}

TEST(VolumeWrite, TypesAreTheNarrowestThatHold) {
  const auto type_of = [](float value) {
    Volume<float> volume(oblique_grid());
    volume.at(1, 1, 1) = value;
    return stored_volume_of(volume).header.value_type;
  };
  EXPECT_EQ(type_of(255), "uint8");
  EXPECT_EQ(type_of(-1024), "int16");
  EXPECT_EQ(type_of(65535), "uint16");
  EXPECT_EQ(type_of(-70000), "int32");
  EXPECT_EQ(type_of(0.25f), "float");
  EXPECT_EQ(type_of(1e30f), "float");
  EXPECT_EQ(type_of(std::nanf("")), "float");
}

TEST(VolumeWrite, LeftHandedAndShearedGridsStay) {
  const TemporaryFolder folder;
  StoredVolume volume = stored<std::int16_t>("int16");
  for (const bool sheared : {false, true}) {
    volume.header.grid = oblique_grid(true);
    if (sheared) volume.header.grid.index_to_world.linear().col(2) += 0.5 * oblique_pose().y_axis;
    for (const char* name : {"a.nrrd", "a.mha", "a.nii"}) {
      write_volume(volume, folder / name);
      expect_same_grid(read_grid(folder / name), volume.header.grid, 1e-4);
    }
  }
}

TEST(VolumeWrite, UnwritableFolderIsNamed) {
  for (const char* name : {"/proc/nowhere/a.nrrd", "/proc/nowhere/a.mhd", "/proc/nowhere/a.nii"})
    EXPECT_NE(message_of([&] { write_volume(stored<float>("float"), name); }).find("/proc/nowhere/a"),
              std::string::npos);
}

}  // namespace
}  // namespace isostack::testing
