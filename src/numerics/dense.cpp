#include "numerics/dense.h"

#include <cmath>
#include <limits>

#include <Eigen/Dense>

#include "numerics/elementary.h"

namespace flexslip {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd product(const MatrixView& a, const MatrixView& b) { return a * b; }

SymmetricEigen eigen_of(const MatrixView& symmetric) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen{MatrixXd(symmetric)};
  return {eigen.eigenvalues(), eigen.eigenvectors()};
}

MatrixXd cholesky_root(const MatrixView& positive) {
  const Eigen::LLT<MatrixXd> factor{MatrixXd(positive)};
  if (factor.info() == Eigen::Success) return factor.matrixL();
  constexpr double least = 1e-16;
  return positive.diagonal().cwiseMax(least).cwiseSqrt().asDiagonal();
}

double square_in(const MatrixView& positive, const VectorView& a) {
  return Eigen::LLT<MatrixXd>{MatrixXd(positive)}.matrixL().solve(a).squaredNorm();
}

Positive::Positive(const MatrixView& positive) {
  const Eigen::LLT<MatrixXd> factor{MatrixXd(positive)};
  root_ = factor.matrixL();
  for (Index i = 0; i < root_.rows(); ++i) log_determinant_ += 2 * elementary::log(root_(i, i));
  if (factor.info() != Eigen::Success) log_determinant_ = std::numeric_limits<double>::quiet_NaN();
}

VectorXd Positive::solved(const VectorView& right) const {
  const auto lower = root_.triangularView<Eigen::Lower>();
  return lower.transpose().solve(VectorXd(lower.solve(right)));
}

Symmetric::Symmetric(const MatrixView& symmetric) : matrix_(symmetric), log_determinant_(0) {
  const Eigen::LDLT<MatrixXd> factor{MatrixXd(symmetric)};
  inverse_ = factor.solve(MatrixXd::Identity(symmetric.rows(), symmetric.cols()));
  for (Index i = 0; i < symmetric.rows(); ++i) log_determinant_ += elementary::log(std::abs(factor.vectorD()[i]));
}

// One refinement step: the inverse alone is less accurate than a solution from the factors.
VectorXd Symmetric::solved(const VectorView& right) const {
  const VectorXd x = inverse_ * right;
  return x + inverse_ * (right - matrix_ * x);
}

}  // namespace flexslip
