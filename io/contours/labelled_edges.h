#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "io/contours/section_planes.h"

namespace isostack {

/// A straight piece of boundary between two vertices of a plane and the labels beside it.
struct LabelledEdge {
  int from = 0, to = 0;
  int left = 0, right = 0;
};

/// The closed curves of every label but the lowest, which is the outside; each label on the left of its own curves.
/// Where more than two of a label's edges meet, its curves touch but do not cross. Vertices at one place are one.
/// Throws InputError naming the plane when an edge ends in nothing.
std::vector<SectionLoop> loops_of_labels(const SectionPlane& plane, const std::vector<LabelledEdge>& edges,
                                         int outside_label);

}  // namespace isostack
