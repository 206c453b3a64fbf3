#pragma once

#include <array>
#include <vector>

#include "recon/geometry/progress.h"
#include "recon/geometry/triangle_mesh.h"
#include "recon/subdivision/domain_alignment.h"
#include "recon/subdivision/multiresolution_fit.h"
#include "recon/subdivision/simplicial_mesh.h"
#include "recon/subdivision/subdivided_surface.h"

namespace isostack {

/// A body at its place on the blending axis.
struct BodyLayer {
  double t_mm = 0;
  TriangleMesh body;  ///< closed, outside out, in one part
};

/// A source within the interpolator.
struct SourceSurface {
  TriangleMesh body;
  DomainMesh drawn;  ///< the body on the domain of all
  SubdividedSurface surface;
  std::vector<int> vertices;  ///< of its base, the numbers in the interpolator's base
  SurfaceFit fit;             ///< of the finest level
};

/// Level 0 of the interpolator of bodies: tetrahedra in (x, y, z, t) between the base meshes of neighbouring sources,
/// and what the finer levels add.
struct BodyInterpolator {
  SimplicialMesh base;
  std::vector<Eigen::Vector3d> on_domain;    ///< where each base vertex is on the domain of all
  std::vector<SourceSurface> sources;        ///< in the order of the layers
  std::vector<std::array<int, 2>> features;  ///< base vertices of each pair, layer by layer: the ends of an edge
};

struct BodyInterpolatorOptions {
  int levels = 4;
  /// Pairs of corners of a layer's body and the next one's that are to become each other; a list for each step, or
  /// none.
  std::vector<std::vector<VertexPair>> features = {};
  /// Of each layer: corners that are base vertices whatever happens, or none.
  std::vector<std::vector<int>> kept = {};
};

/// Initial meshing of bodies (Ohbuchi, Kokojima & Takahashi 2001, Section 2.2, steps 1A to 1C). Throws InputError for
/// bodies that are open, in several parts, of different genus (naming both, and the methods that can do it) or of a
/// genus above 1.
BodyInterpolator body_interpolator(const std::vector<BodyLayer>& layers, const BodyInterpolatorOptions& options,
                                   const Progress& progress = {});

/// The numbers in the interpolator's finest level of a source's vertices, level by level those it has there.
std::vector<int> source_numbers(const SourceSurface& source, const SubdivisionLevels& levels);

/// What is to be optimised: sources held at every level. With `details` the reference is the straight blend of both
/// surfaces, each by its share of t, at the vertex's place on the domain, half-way between those of the edge that it
/// halves: their details stay (the paper's first wish, Section 4). Else they die away.
FitProblem fit_problem(const BodyInterpolator& interpolator, bool details);

}  // namespace isostack
