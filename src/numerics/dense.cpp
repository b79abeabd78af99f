#include "numerics/dense.h"

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

std::optional<MatrixXd> cholesky_root(const MatrixView& positive) {
  const Eigen::LLT<MatrixXd> factor{MatrixXd(positive)};
  if (factor.info() != Eigen::Success) return std::nullopt;
  return MatrixXd(factor.matrixL());
}

Symmetric::Symmetric(const MatrixView& symmetric) : log_determinant_(0) {
  const Eigen::LDLT<MatrixXd> factor{MatrixXd(symmetric)};
  inverse_ = factor.solve(MatrixXd::Identity(symmetric.rows(), symmetric.cols()));
  for (Index i = 0; i < symmetric.rows(); ++i) log_determinant_ += elementary::log(std::abs(factor.vectorD()[i]));
}

VectorXd Symmetric::solved(const VectorView& right) const { return inverse_ * right; }

}  // namespace flexslip
