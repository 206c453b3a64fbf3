#include "recon/subdivision/local_bending.h"

#include <Eigen/SparseCholesky>
#include <utility>

namespace isostack {

namespace {

class Bending {
 public:
  explicit Bending(const BendingProblem& problem)
      : problem_(problem), row_weight_(problem.counted.cwiseQuotient(problem.operators.mass())) {
    free_ = Eigen::VectorXd::Ones(problem.operators.vertex_count());
    for (Eigen::Index v = 0; v < free_.size(); ++v)
      if (problem.fixed[static_cast<std::size_t>(v)]) free_[v] = 0;
    const Eigen::VectorXd diagonal =
        problem.operators.bending_diagonal(problem.counted) + problem.eta * problem.operators.mass();
    scale_ = (diagonal.array() > 0).select(free_.cwiseQuotient(diagonal), 0);
  }

  double energy(const Eigen::MatrixXd& d) const {
    const Eigen::MatrixXd bent = problem_.operators.stiffness(d) + problem_.load;
    return bent.colwise().squaredNorm() * row_weight_ +
           problem_.eta * (d.colwise().squaredNorm() * problem_.operators.mass())(0);
  }

  /// Half the derivative by the free displacements, without or with the load.
  Eigen::MatrixXd apply(const Eigen::MatrixXd& d, bool loaded) const {
    Eigen::MatrixXd bent = problem_.operators.stiffness(d);
    if (loaded) bent += problem_.load;
    bent = bent * row_weight_.asDiagonal();
    Eigen::MatrixXd result = problem_.operators.stiffness(bent);
    result += problem_.eta * d * problem_.operators.mass().asDiagonal();
    return result * free_.asDiagonal();
  }

  Eigen::MatrixXd preconditioned(const Eigen::MatrixXd& residual) const { return residual * scale_.asDiagonal(); }

 private:
  const BendingProblem& problem_;
  Eigen::VectorXd row_weight_, free_, scale_;
};

/// Row by row: each coordinate is a system of its own.
Eigen::VectorXd inner(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) { return a.cwiseProduct(b).rowwise().sum(); }

Eigen::VectorXd ratio(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return (b.array() > 0).select(a.cwiseQuotient(b), 0);
}

}  // namespace

BendingSolution least_bending(const BendingProblem& problem, Eigen::MatrixXd start, double tolerance,
                              int most_iterations) {
  const Bending bending(problem);
  BendingSolution solution{.displacement = std::move(start), .first_energy = 0, .energy = 0, .iterations = 0};
  Eigen::MatrixXd& d = solution.displacement;
  solution.first_energy = bending.energy(d);
  Eigen::MatrixXd residual = -bending.apply(d, true);
  Eigen::MatrixXd direction = bending.preconditioned(residual);
  Eigen::VectorXd size = inner(residual, direction);
  const double enough = tolerance * tolerance * size.sum();
  while (size.sum() > enough && solution.iterations < most_iterations) {
    const Eigen::MatrixXd bent = bending.apply(direction, false);
    const Eigen::VectorXd step = ratio(size, inner(direction, bent));
    d += step.asDiagonal() * direction;
    residual -= step.asDiagonal() * bent;
    const Eigen::MatrixXd scaled = bending.preconditioned(residual);
    const Eigen::VectorXd next = inner(residual, scaled);
    direction = scaled + ratio(next, size).asDiagonal() * direction;
    size = next;
    ++solution.iterations;
  }
  solution.converged = size.sum() <= enough;
  solution.energy = bending.energy(d);
  return solution;
}

BendingSolution least_bending_factored(const BendingProblem& problem, Eigen::MatrixXd start) {
  const Bending bending(problem);
  BendingSolution solution{.displacement = std::move(start), .first_energy = 0, .energy = 0, .iterations = 0};
  solution.first_energy = solution.energy = bending.energy(solution.displacement);
  std::vector<int> number(problem.fixed.size(), -1), vertices;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (problem.fixed[v]) continue;
    number[v] = static_cast<int>(vertices.size());
    vertices.push_back(static_cast<int>(v));
  }
  if (vertices.empty()) return solution;
  const Eigen::SparseMatrix<double> k = problem.operators.stiffness_columns(number, static_cast<int>(vertices.size()));
  const Eigen::VectorXd row_weight = problem.counted.cwiseQuotient(problem.operators.mass());
  Eigen::SparseMatrix<double> normal = k.transpose() * row_weight.asDiagonal() * k;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    normal.coeffRef(at, at) += problem.eta * problem.operators.mass()[vertices[i]];
  }
  const Eigen::MatrixXd downhill = -bending.apply(solution.displacement, true);
  Eigen::MatrixXd right(static_cast<Eigen::Index>(vertices.size()), downhill.rows());
  for (std::size_t i = 0; i < vertices.size(); ++i)
    right.row(static_cast<Eigen::Index>(i)) = downhill.col(vertices[i]).transpose();
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(normal);
  const Eigen::MatrixXd step = factor.solve(right);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    solution.displacement.col(vertices[i]) += step.row(static_cast<Eigen::Index>(i)).transpose();
  solution.energy = bending.energy(solution.displacement);
  solution.converged = factor.info() == Eigen::Success;
  return solution;
}

}  // namespace isostack
