#pragma once

#include <Eigen/Core>
#include <vector>

#include "recon/geometry/triangle_mesh.h"
#include "recon/subdivision/surface_domain.h"

namespace isostack {

/// Two corners of a sequence's surfaces that are to become each other.
struct VertexPair {
  int from = 0, to = 0;  ///< vertices of a surface and of the next
};

/// Surfaces of one genus, each spread over its own domain, brought onto one: the sphere turned, the torus's periods
/// matched and shifted, so that equal points of the domain are near each other on the surfaces (mean square of all
/// places, centroids and sizes made equal; from a spread of starts and then downhill). The first surface decides the
/// way the sphere lies; a torus becomes that of `torus_base(around)`. Pairs of corners count much, one list for each
/// neighbouring two surfaces (or none).
struct AlignedDomains {
  std::vector<DomainMesh> drawn;                     ///< one for each surface
  Eigen::Vector2i around = Eigen::Vector2i::Zero();  ///< genus 1: for torus_base()
};

AlignedDomains aligned(const std::vector<const TriangleMesh*>& surfaces, std::vector<DomainMesh> drawn,
                       const std::vector<std::vector<VertexPair>>& pairs = {});

/// Places of points of the domain on a surface, mm: 3 × points.
Eigen::Matrix3Xd places_on(const TriangleMesh& surface, const DomainMesh& drawn,
                           const std::vector<Eigen::Vector3d>& points);

}  // namespace isostack
