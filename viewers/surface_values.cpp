#include "viewers/surface_values.h"

#include <oneapi/tbb/parallel_for.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticPointLocator.h>

#include <cmath>
#include <cstddef>

#include "recon/distance/winding_number.h"
#include "recon/geometry/errors.h"
#include "recon/metrics/contour_distance.h"
#include "recon/metrics/mesh_curvature.h"
#include "recon/metrics/mesh_measures.h"
#include "recon/metrics/surface_distance.h"

namespace isostack {

namespace {

std::vector<Eigen::Vector3d> sampled(const ContourStack& contours, double step_mm) {
  std::vector<Eigen::Vector3d> points;
  for (const ContourSlice& slice : contours.slices)
    for (const Eigen::Vector2d& point : points_along(slice.contours, step_mm))
      points.push_back(slice.pose.slice_to_world(point));
  if (points.empty())
    throw InputError(contours.name.empty() ? "contours" : contours.name, "there is no contour to measure residuals at",
                     "give the contours the surface was made of");
  return points;
}

VertexValues labelled(std::string label, std::vector<double> values) {
  const ColourRange range = automatic_range(values);
  return {.label = std::move(label), .values = std::move(values), .range = range};
}

}  // namespace

VertexValues distance_values(const TriangleMesh& mesh, const TriangleMesh& other, const std::string& name) {
  std::vector<double> distances = distances_to_mesh_mm(mesh.vertices_mm, other);
  const bool is_closed = measure(other).boundary_edges == 0;
  if (is_closed) {
    const WindingNumber winding(other);
    tbb::parallel_for(std::size_t{0}, distances.size(), [&](std::size_t i) {
      if (std::abs(winding.at(mesh.vertices_mm[i])) > 0.5) distances[i] = -distances[i];
    });
  }
  return labelled("distance to " + name + (is_closed ? ", mm (+ outside)" : ", mm"), std::move(distances));
}

VertexValues residual_values(const TriangleMesh& mesh, const ContourStack& contours, double step_mm) {
  const std::vector<Eigen::Vector3d> points = sampled(contours, step_mm);
  const std::vector<double> residuals = distances_to_mesh_mm(points, mesh);
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (const Eigen::Vector3d& point : points) places->InsertNextPoint(point.data());
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(places);
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(cloud);
  locator->BuildLocator();
  std::vector<double> values(mesh.vertices_mm.size());
  tbb::parallel_for(std::size_t{0}, values.size(), [&](std::size_t i) {
    values[i] = residuals[static_cast<std::size_t>(locator->FindClosestPoint(mesh.vertices_mm[i].data()))];
  });
  return labelled("residual of contours, mm", std::move(values));
}

VertexValues curvature_values(const TriangleMesh& mesh) {
  std::vector<double> curvatures = mean_curvatures_per_mm(mesh);
  VertexValues shown = labelled("mean curvature, 1/mm", std::move(curvatures));
  // White is flat also on a body that is convex all over.
  shown.range = {.low = -shown.range.high, .high = shown.range.high, .map = ColourMap::diverging};
  return shown;
}

}  // namespace isostack
