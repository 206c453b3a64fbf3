#include "recon/solvers/spanned_space.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <vector>

namespace isostack {

Eigen::MatrixXd reduced_to_span(const Eigen::MatrixXd& points) {
  constexpr double nothing = 1e-10;  // of the largest extent
  const Eigen::VectorXd low = points.rowwise().minCoeff(), extents = points.rowwise().maxCoeff() - low;
  std::vector<Eigen::Index> axes;
  for (Eigen::Index a = 0; a < points.rows(); ++a)
    if (extents[a] > nothing * extents.maxCoeff()) axes.push_back(a);
  if (axes.empty()) axes.push_back(0);
  Eigen::MatrixXd varying(static_cast<Eigen::Index>(axes.size()), points.cols());
  for (std::size_t k = 0; k < axes.size(); ++k)
    varying.row(static_cast<Eigen::Index>(k)) = points.row(axes[k]).array() - (low[axes[k]] + extents[axes[k]] / 2);

  const Eigen::VectorXd mean = varying.rowwise().mean();
  const Eigen::MatrixXd centred = varying.colwise() - mean;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(centred * centred.transpose());
  const Eigen::MatrixXd turned = eigen.eigenvectors().transpose() * centred;
  const Eigen::VectorXd reach = turned.cwiseAbs().rowwise().maxCoeff();
  const auto spanned = std::max<Eigen::Index>(1, (reach.array() > nothing * reach.maxCoeff()).count());
  return spanned == varying.rows() ? varying : turned.bottomRows(spanned).eval();
}

}  // namespace isostack
