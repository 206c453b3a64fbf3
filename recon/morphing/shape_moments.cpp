#include "recon/morphing/shape_moments.h"

#include <Eigen/LU>
#include <vector>

#include "recon/geometry/pixel_lattice.h"

namespace isostack {

namespace {

/// The shape is the signed sum of the simplices that a point and its edges or triangles span: each a matrix of columns.
std::vector<Eigen::MatrixXd> boundary_of(const Shape& shape, const SlicePose& pose) {
  std::vector<Eigen::MatrixXd> faces;
  if (const auto* mesh = std::get_if<TriangleMesh>(&shape)) {
    for (const Eigen::Vector3i& t : mesh->triangles) {
      Eigen::MatrixXd corners(3, 3);
      for (int i = 0; i < 3; ++i) corners.col(i) = mesh->vertices_mm[static_cast<std::size_t>(t[i])];
      faces.push_back(corners);
    }
    return faces;
  }
  const auto& figure = std::get<ContourSlice>(shape);
  for (const Contour& contour : moved_to(pose, figure.contours, figure.pose))
    for (std::size_t i = 0; i < contour.points_mm.size(); ++i) {
      Eigen::MatrixXd edge(2, 2);
      edge << contour.points_mm[i], contour.points_mm[(i + 1) % contour.points_mm.size()];
      faces.push_back(edge);
    }
  return faces;
}

/// n! times the signed content of the simplex of the origin and these corners.
double spanned(const Eigen::MatrixXd& corners) { return corners.determinant(); }

double factorial(Eigen::Index n) { return n <= 1 ? 1 : static_cast<double>(n) * factorial(n - 1); }

}  // namespace

ShapeMoments moments_of(const Shape& shape, const SlicePose& pose) {
  const std::vector<Eigen::MatrixXd> faces = boundary_of(shape, pose);
  const Eigen::Index n = dimension_of(shape);
  // About a corner of the shape rather than the far origin, where digits are lost.
  const Eigen::VectorXd about = faces.front().col(0);
  double content = 0;
  Eigen::VectorXd first = Eigen::VectorXd::Zero(n);
  Eigen::MatrixXd second = Eigen::MatrixXd::Zero(n, n);
  for (const Eigen::MatrixXd& face : faces) {
    const Eigen::MatrixXd corners = face.colwise() - about;
    const double size = spanned(corners);
    const Eigen::VectorXd sum = corners.rowwise().sum();
    content += size / factorial(n);
    first += size / factorial(n + 1) * sum;
    second += size / factorial(n + 2) * (corners * corners.transpose() + sum * sum.transpose());
  }
  const Eigen::VectorXd centre = first / content;
  return {content, about + centre, second / content - centre * centre.transpose()};
}

Eigen::VectorXd third_moments(const Shape& shape, const SlicePose& pose, const Eigen::VectorXd& centre,
                              const Eigen::MatrixXd& axes) {
  const Eigen::Index n = dimension_of(shape);
  double content = 0;
  Eigen::VectorXd third = Eigen::VectorXd::Zero(n);
  for (const Eigen::MatrixXd& face : boundary_of(shape, pose)) {
    const Eigen::MatrixXd corners = face.colwise() - centre;
    const double size = spanned(corners);
    content += size / factorial(n);
    const Eigen::MatrixXd along = axes.transpose() * corners;  // axis × corner
    for (Eigen::Index axis = 0; axis < n; ++axis) {
      // Over a simplex ∫ f³ = content · n! 3! / (n + 3)! · h₃ of f's values at the corners, of which one is 0 here:
      // h₃ = (p₁³ + 3 p₁ p₂ + 2 p₃) / 6 with the power sums p.
      const auto values = along.row(axis).array();
      const double p1 = values.sum(), p2 = values.square().sum(), p3 = values.cube().sum();
      third[axis] += size / factorial(n + 3) * (p1 * p1 * p1 + 3 * p1 * p2 + 2 * p3);
    }
  }
  return third / content;
}

}  // namespace isostack
