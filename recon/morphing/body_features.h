#pragma once

#include <vector>

#include "recon/morphing/subdivision_morph.h"
#include "recon/subdivision/domain_alignment.h"

namespace isostack {

/// The vertices that each feature is between, step by step from one body to the next. `order[i]`: which of the features
/// the i-th pair is, all steps counted through; from and to in the order of the bodies. Throws InputError for shapes,
/// vertices and places that are not there, features of bodies that do not follow each other, and two of one vertex.
struct BodyFeatures {
  std::vector<std::vector<VertexPair>> pairs;
  std::vector<std::size_t> order;
};

BodyFeatures features_in(const std::vector<TriangleMesh>& bodies, const std::vector<CorrespondingPoints>& features);

/// Vertices at which at least three edges meet that turn more than the angle, those that turn most first; at most
/// `most`.
std::vector<int> sharp_corners(const TriangleMesh& body, double sharp_angle_rad, std::size_t most);

}  // namespace isostack
