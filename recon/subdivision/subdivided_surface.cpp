#include "recon/subdivision/subdivided_surface.h"

#include <algorithm>

#include "recon/metrics/closest_point.h"
#include "recon/subdivision/domain_alignment.h"

namespace isostack {

namespace {

std::size_t index(Eigen::Index i) { return static_cast<std::size_t>(i); }

}  // namespace

SubdividedSurface subdivided(const TriangleMesh& surface, const DomainMesh& drawn, const DomainMesh& base, int levels) {
  Eigen::MatrixXi triangles(3, static_cast<Eigen::Index>(base.triangles.size()));
  for (std::size_t t = 0; t < base.triangles.size(); ++t)
    triangles.col(static_cast<Eigen::Index>(t)) = base.triangles[t];
  SubdividedSurface made;
  made.levels = subdivision_levels(triangles, static_cast<Eigen::Index>(base.positions.size()), levels);
  std::vector<Eigen::Vector3d> points = base.positions;
  for (const SimplexSubdivision& step : made.levels.steps)
    for (const auto& [a, b] : step.edges) points.push_back(base.domain.halfway(points[index(a)], points[index(b)]));
  made.places_mm = places_on(surface, drawn, points);
  made.on_domain.domain = base.domain;
  const Eigen::MatrixXi& finest = made.levels.simplices(levels);
  for (Eigen::Index t = 0; t < finest.cols(); ++t) {
    made.on_domain.triangles.emplace_back(finest.col(t));
    CornerOffsets& copies = made.on_domain.offsets.emplace_back();
    for (int c = 0; c < 3; ++c)
      copies[index(c)] = base.domain.copy_near(points[index(finest(0, t))], points[index(finest(c, t))]);
  }
  made.on_domain.positions = std::move(points);
  return made;
}

TriangleMesh SubdividedSurface::mesh() const {
  TriangleMesh made;
  for (Eigen::Index v = 0; v < places_mm.cols(); ++v) made.vertices_mm.emplace_back(places_mm.col(v));
  const Eigen::MatrixXi& triangles = levels.simplices(levels.finest());
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) made.triangles.emplace_back(triangles.col(t));
  return made;
}

std::vector<Eigen::Matrix3Xd> details_of(const SubdividedSurface& surface) {
  std::vector<Eigen::Matrix3Xd> details;
  for (int k = 0; k < surface.levels.finest(); ++k) {
    const auto& edges = surface.levels.steps[index(k)].edges;
    Eigen::Matrix3Xd& added = details.emplace_back(3, static_cast<Eigen::Index>(edges.size()));
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const auto i = static_cast<Eigen::Index>(e);
      added.col(i) = surface.places_mm.col(surface.levels.vertex_count(k) + i) -
                     (surface.places_mm.col(edges[e][0]) + surface.places_mm.col(edges[e][1])) / 2;
    }
  }
  return details;
}

Eigen::Matrix3Xd with_details(const SubdivisionLevels& levels, const Eigen::Matrix3Xd& base_mm,
                              const std::vector<Eigen::Matrix3Xd>& details) {
  Eigen::MatrixXd places = base_mm;
  for (std::size_t k = 0; k < details.size(); ++k) {
    places = midpoint_refined(places, levels.steps[k]);
    places.rightCols(details[k].cols()) += details[k];
  }
  return places;
}

SurfaceFit fit_of(const SubdividedSurface& subdivided, const TriangleMesh& surface) {
  const ClosestPoint nearest(subdivided.mesh());
  SurfaceFit fit;
  for (const Eigen::Vector3d& p : surface.vertices_mm) {
    const double distance = (nearest.on_mesh(p) - p).norm();
    fit.mean_mm += distance / static_cast<double>(surface.vertices_mm.size());
    fit.largest_mm = std::max(fit.largest_mm, distance);
  }
  return fit;
}

}  // namespace isostack
