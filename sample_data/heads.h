#pragma once

#include <string>

#include "recon/geometry/volume.h"
#include "sample_data/shapes.h"

namespace isostack {

// Three heads of the size and at the place of the head CT (sample_data/real_skull.sh), for a morph between models of
// different types (Breen et al. 2001): world LPS mm, so that they face -y, the crown at z = 168.

/// With cheeks, nose, chin, ears, eye sockets and a neck, made to be a polygonal mesh.
Body modelled_head();

/// The file of a constructive solid: superellipsoids united, with eye sockets and a mouth taken away.
std::string solid_head_json();

/// CT of a third head: skin, bone, brain and an air cavity, in Hounsfield units, with noise. Same voxels on every run.
Volume<float> scanned_head();

/// The grey value at the skin: between air and soft tissue.
inline constexpr double scanned_skin_hu = -480;

}  // namespace isostack
