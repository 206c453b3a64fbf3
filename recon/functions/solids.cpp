#include "recon/functions/solids.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "recon/functions/over_points.h"
#include "recon/geometry/errors.h"
#include "recon/metrics/contour_distance.h"

namespace isostack {

SolidFunction figure_solid(std::vector<Contour> contours) {
  struct Figure {
    explicit Figure(std::vector<Contour> given) : contours(std::move(given)), distance(contours) {}
    std::vector<Contour> contours;
    ContourDistance distance;
  };
  const auto figure = std::make_shared<const Figure>(std::move(contours));
  return [figure](const Eigen::MatrixXd& points) {
    return over_points(points.cols(), [&](Eigen::Index i) {
      const Eigen::Vector2d point = points.col(i);
      const double mm = figure->distance.to(point);
      return is_inside(figure->contours, point) ? mm : -mm;
    });
  };
}

SolidFunction volume_solid(Volume<float> distances_mm) {
  if (distances_mm.grid.size.minCoeff() < 2)
    throw InputError("volume", "there is nothing between its nodes", "give two nodes or more along each axis");
  struct Nodes {
    Volume<float> mm;
    Eigen::Affine3d world_to_index;
  };
  const Eigen::Affine3d world_to_index = distances_mm.grid.index_to_world.inverse();
  const auto nodes = std::make_shared<const Nodes>(Nodes{std::move(distances_mm), world_to_index});
  return [nodes](const Eigen::MatrixXd& points) {
    return over_points(points.cols(), [&](Eigen::Index i) {
      const Grid& grid = nodes->mm.grid;
      const Eigen::Vector3d point = points.col(i), index = nodes->world_to_index * point;
      const Eigen::Vector3d held = index.cwiseMax(0).cwiseMin((grid.size.array() - 1).matrix().cast<double>());
      const Eigen::Vector3i cell = held.cast<int>().cwiseMin((grid.size.array() - 2).matrix());
      const Eigen::Vector3d share = held - cell.cast<double>();
      double sum = 0;
      for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3i up(corner & 1, corner >> 1 & 1, corner >> 2);
        double weight = 1;
        for (int axis = 0; axis < 3; ++axis) weight *= up[axis] != 0 ? share[axis] : 1 - share[axis];
        sum += weight * static_cast<double>(nodes->mm.at(cell.x() + up.x(), cell.y() + up.y(), cell.z() + up.z()));
      }
      return sum - (grid.index_to_world * held - point).norm();
    });
  };
}

SolidFunction superellipsoid_solid(const Superellipsoid& shape) {
  if (!(shape.half_axes_mm.minCoeff() > 0) || !(shape.south_north > 0) || !(shape.east_west > 0))
    throw InputError("superellipsoid", "a half-axis or an exponent is not above 0", "give sizes and exponents above 0");
  return [shape, to_own = shape.to_world.inverse()](const Eigen::MatrixXd& points) {
    return over_points(points.cols(), [&](Eigen::Index i) {
      const Eigen::Vector3d own = to_own * Eigen::Vector3d(points.col(i));
      const Eigen::Array3d scaled = own.array().abs() / shape.half_axes_mm.array();
      const double round = std::pow(scaled.x(), 2 / shape.east_west) + std::pow(scaled.y(), 2 / shape.east_west);
      const double both =
          std::pow(round, shape.east_west / shape.south_north) + std::pow(scaled.z(), 2 / shape.south_north);
      return (1 - std::pow(both, shape.south_north / 2)) * shape.half_axes_mm.minCoeff();
    });
  };
}

}  // namespace isostack
