// Products and decompositions of dense matrices. They wrap Eigen's, which take seconds to compile
// in each source. Of a symmetric matrix, only the lower triangle is read.
#pragma once

#include <cmath>

#include <Eigen/Core>

namespace flexslip {

using MatrixView = Eigen::Ref<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using VectorView = Eigen::Ref<const Eigen::VectorXd>;

Eigen::MatrixXd product(const MatrixView& a, const MatrixView& b);

// The eigenvalues and eigenvectors of a symmetric matrix: A = vectors diag(values) vectors'.
struct SymmetricEigen {
  Eigen::VectorXd values;   // in increasing order
  Eigen::MatrixXd vectors;  // columns of length 1
};
SymmetricEigen eigen_of(const MatrixView& symmetric);

// The lower triangular L with L L' = A. If rounding makes A indefinite, the root of its diagonal,
// with every element at least 1e-16.
Eigen::MatrixXd cholesky_root(const MatrixView& positive);

// a' A^-1 a for a positive definite A.
double square_in(const MatrixView& positive, const VectorView& a);

// Solves systems of a positive definite A.
class Positive {
 public:
  explicit Positive(const MatrixView& positive);
  bool is_definite() const { return std::isfinite(log_determinant_); }
  Eigen::VectorXd solved(const VectorView& right) const;
  double log_determinant() const { return log_determinant_; }  // NaN unless A is positive definite

 private:
  Eigen::MatrixXd root_;
  double log_determinant_ = 0;
};

// Solves systems of a symmetric, regular A, which may be indefinite, and computes the inverse (L D
// L').
class Symmetric {
 public:
  explicit Symmetric(const MatrixView& symmetric);
  Eigen::VectorXd solved(const VectorView& right) const;
  const Eigen::MatrixXd& inverse() const { return inverse_; }
  double log_determinant() const { return log_determinant_; }  // ln |det A|

 private:
  Eigen::MatrixXd matrix_, inverse_;
  double log_determinant_;
};

}  // namespace flexslip
