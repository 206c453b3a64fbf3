#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "recon/geometry/contour.h"

namespace isostack {

/// One plane of a file of labelled cross-sections (.csl, .contour).
struct SectionPlane {
  Eigen::Vector4d equation = Eigen::Vector4d::Zero();  ///< A, B, C, D as the file has them
  std::vector<Eigen::Vector3d> vertices_mm;
  std::string where;  ///< file and line for messages
};

/// A closed curve of a label, as numbers of vertices of its plane.
struct SectionLoop {
  int label = 0;
  std::vector<int> vertices;
  int hole_of = -1;  ///< the loop of the same plane that it is said to be a hole of; -1: none
};

/// The poses of all planes. Their axes follow from A, B, C alone; the origin is the point of the plane nearest to the
/// world's. Whether the file means Ax + By + Cz + D = 0 or = D is told by its vertices. Pixels, which such files do not
/// have, are as large as the median edge of the loops, 1 mm without any. Throws InputError naming the plane whose
/// normal is zero or whose vertices do not lie in it.
std::vector<SlicePose> section_poses(const std::vector<SectionPlane>& planes,
                                     const std::vector<std::vector<SectionLoop>>& loops);

/// One organ per label, named by it, in the labels' order, with a slice for every plane: such a file says of each
/// plane all that there is. Label 0, the outside, is left out. A hole bounds the label of the loop around it, whatever
/// its own says; loops may be counted from 0 or from 1. `label_count` is the number of labels with 0 that the file
/// announces: those below it that no loop has are organs that are absent everywhere, unless other labels contradict it.
/// Throws InputError naming file and plane.
std::vector<ContourStack> section_organs(const std::vector<SectionPlane>& planes,
                                         const std::vector<std::vector<SectionLoop>>& loops, const std::string& file,
                                         long long label_count = 0);

/// For writing: the organs' slices gathered by plane, each organ's contours in the axes of the first.
struct WrittenPlane {
  SlicePose pose;
  std::vector<std::vector<Contour>> contours;  ///< of each organ
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
};
std::vector<WrittenPlane> planes_of(const std::vector<ContourStack>& organs);

}  // namespace isostack
