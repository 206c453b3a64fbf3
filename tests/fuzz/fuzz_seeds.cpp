/// Writes small good files of each format, from which the fuzzers start: fuzz_seeds FOLDER makes FOLDER/<format>/.

#include <cstdio>
#include <numbers>

#include "io/contours/contours_csl.h"
#include "io/contours/contours_edges.h"
#include "io/contours/contours_json.h"
#include "io/dicom/dicom_seg.h"
#include "io/dicom/rtstruct.h"
#include "io/meshes/mesh_ply.h"
#include "io/volumes/metaimage.h"
#include "io/volumes/nifti.h"
#include "io/volumes/nrrd.h"
#include "tests/io/label_support.h"
#include "tests/io/rtstruct_support.h"
#include "tests/io/seg_support.h"

namespace isostack::testing {
namespace {

using Path = std::filesystem::path;

/// A ring on three planes.
std::vector<ContourStack> ring() {
  ContourStack stack{.name = "ring", .slices = {}, .color = Color{10, 200, 30}, .roi_type = "ORGAN"};
  for (int k = 0; k < 3; ++k) {
    ContourSlice& slice = stack.slices.emplace_back();
    slice.name = "slice " + std::to_string(k);
    slice.pose.origin_mm = {0, 0, 4.0 * k};
    slice.size_pixels = {64, 64};
    for (const double radius_mm : {10.0, 5.0}) {
      Contour& contour = slice.contours.emplace_back();
      for (int i = 0; i < 6; ++i) {
        const double angle = i * std::numbers::pi / 3;
        contour.points_mm.emplace_back(30 + radius_mm * std::cos(angle), 30 + radius_mm * std::sin(angle));
      }
    }
    orient_by_nesting(slice.contours);
  }
  return {stack};
}

DicomBytes placed_frame(double z_mm) {
  DicomBytes frame;
  frame.sequence(0x00209113, {DicomBytes().text(0x00200032, "DS", decimals({-10, -20, z_mm}))});
  return frame.sequence(0x00289145, {DicomBytes().text(0x00281052, "DS", "-5").text(0x00281053, "DS", "0.5")});
}

DicomBytes multi_frame() {
  DicomBytes data = picture_without_place("1.2.3.4.5"), shared;
  shared.sequence(0x00209116, {DicomBytes().text(0x00200037, "DS", "1\\0\\0\\0\\1\\0")});
  shared.sequence(0x00289110, {DicomBytes().text(0x00280030, "DS", "3\\2").text(0x00180050, "DS", "4")});
  data.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.4.1").text(0x00280008, "IS", "2");
  data.sequence(0x52009229, {shared}).sequence(0x52009230, {placed_frame(0), placed_frame(4)});
  return data.set(0x7fe00010, "OW", counting_pixels(2 * test_pixels), 2);
}

void write_dicom_seeds(const Path& folder) {
  const DicomBytes::Encoding implicit{false, false}, big_endian{true, true};
  write_bytes(folder / "picture", picture_at(3, "1.2.3.4.5").file());
  write_bytes(folder / "implicit", picture_at(3, "1.2.3.4.5").file(implicit));
  write_bytes(folder / "big_endian", picture_at(3, "1.2.3.4.5").file(big_endian));
  write_bytes(folder / "multi_frame", multi_frame().file());
  write_bytes(folder / "multi_frame_implicit", multi_frame().file(implicit));
  write_bytes(folder / "fragments", fragments_that_end_with(0));
  write_bytes(folder / "fragments_bad_end", fragments_that_end_with(0x53010000));
  write_bytes(folder / "without_preamble", picture_at(3, "1.2.3.4.5").file().substr(132));
  write_bytes(folder / "bare_explicit", picture_at(3, "1.2.3.4.5").encoded({}));
  write_bytes(folder / "bare_implicit", multi_frame().encoded(implicit));
  write_bytes(folder / "bare_big_endian", picture_at(3, "1.2.3.4.5").encoded(big_endian));
}

void write_rtstruct_seeds(const Path& folder) {
  write_rtstruct(ring(), folder / "ring.dcm");
  const FileContour square{"CLOSED_PLANAR", {{0, 0, 1}, {9, 0, 1}, {9, 9, 1}, {0, 9, 1}}};
  const FileContour overlapping{"CLOSED_PLANAR", {{5, 5, 1}, {14, 5, 1}, {14, 14, 1}, {5, 14, 1}}};
  const FileContour oblique{"CLOSEDPLANAR_XOR", {{0, 0, 0}, {9, 0, 3}, {9, 9, 6}, {0, 9, 3}}};
  const DicomBytes several = structure_set(
      {{"one", "ORGAN", "255\\0\\0", {square, overlapping}}, {"two", "PTV", "", {oblique, {"POINT", {{1, 2, 3}}}}}});
  write_bytes(folder / "several", several.file());
  write_bytes(folder / "implicit", several.file({false, false}));
  write_bytes(folder / "bare_implicit", several.encoded({false, false}));
}

void write_seg_seeds(const Path& folder) {
  const std::vector<TestFrame> even = {{1, 100, dot}, {2, 104, other}, {1, 108, dot}},
                               uneven = {{1, 100, dot}, {2, 101, other}, {1, 107.43, dot}, {2, 107.43, dot}};
  write_dicom_seg(overlapping_organs(), folder / "organs.dcm");
  write_bytes(folder / "uneven", segmentation(uneven).file());
  write_bytes(folder / "bare_implicit", segmentation(even).encoded({false, false}));
  DicomBytes label_map = with_bytes(segmentation(even), even, [](char pixel) { return pixel == '#' ? '\2' : '\0'; });
  label_map.text(0x00620001, "CS", "LABELMAP").text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.66.7");
  write_bytes(folder / "label_map", label_map.file());
}

void write_volume_seeds(const Path& top) {
  const LabelMap organs = overlapping_organs(), single = flattened(organs);
  StoredVolume grey;
  grey.header.grid = oblique_grid();
  grey.header.value_type = "int16";
  grey.header.slope = 0.5;
  grey.bytes.assign(grey.header.grid.voxel_count() * 2, 3);
  write_nifti(grey, top / "nifti" / "grey.nii");
  write_nifti_labels(single, top / "nifti" / "labels.nii");
  write_nifti_labels(single, top / "nifti" / "labels.nii.gz");
  for (const bool compressed : {false, true}) {
    const WriteOptions options{.compressed = compressed};
    const std::string name = compressed ? "compressed" : "plain";
    write_nrrd(grey, top / "nrrd" / (name + "_grey.nrrd"), options);
    write_nrrd_labels(organs, top / "nrrd" / (name + "_organs.nrrd"), options);
    write_metaimage(grey, top / "metaimage" / (name + "_grey.mha"), options);
    write_metaimage_labels(single, top / "metaimage" / (name + "_labels.mha"), options);
  }
}

/// Sixteen points of one wall, and behind the line that guide_points_fuzz expects the pose of their slice.
void write_guide_points(const Path& folder) {
  std::ostringstream text;
  text << "x\ty\tz\tcontour type\tframeID\tweight\ttime frame\n";
  for (int i = 0; i < 16; ++i)
    text << 20 * std::cos(i * 0.4) << '\t' << 20 * std::sin(i * 0.4) << "\t0\t"
         << (i < 12 ? "SAX_LV_ENDOCARDIAL" : "MITRAL_VALVE") << "\t1\t1.0\t0\n";
  text << "====\na.dcm\tsliceID: \t1\tImagePositionPatient\t-50\t-50\t0\tImageOrientationPatient\t1\t0\t0\t0\t1\t0\t"
          "PixelSpacing\t1.5\t2\n";
  write_bytes(folder / "ventricle", text.str());
}

void write_ply_seeds(const Path& folder) {
  TriangleMesh mesh;
  mesh.vertices_mm = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  write_ply(mesh, folder / "binary.ply");
  write_bytes(folder / "text.ply",
              "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
              "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
}

void write_all(const Path& top) {
  for (const char* format :
       {"dicom", "rtstruct", "seg", "nifti", "nrrd", "metaimage", "json", "csl", "edges", "guide_points", "ply"})
    std::filesystem::create_directories(top / format);
  write_dicom_seeds(top / "dicom");
  write_rtstruct_seeds(top / "rtstruct");
  write_seg_seeds(top / "seg");
  write_volume_seeds(top);
  write_json_contours(ring(), top / "json" / "ring.json");
  write_csl(ring(), top / "csl" / "ring.csl");
  write_edge_contours(ring(), top / "edges" / "ring.contour");
  write_guide_points(top / "guide_points");
  write_ply_seeds(top / "ply");
}

}  // namespace
}  // namespace isostack::testing

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: fuzz_seeds FOLDER\n", stderr);
    return 2;
  }
  isostack::testing::write_all(argv[1]);
  return 0;
}
