// Decompositions of dense matrices and their products: those of Eigen, compiled once, as each takes seconds wherever it is compiled.
#pragma once

#include <cmath>

#include <Eigen/Core>

namespace flexslip {

using MatrixView = Eigen::Ref<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using VectorView = Eigen::Ref<const Eigen::VectorXd>;

Eigen::MatrixXd product(const MatrixView& a, const MatrixView& b);

// Of a symmetric matrix, of which the lower triangle is read: A = vectors diag(values) vectors'.
struct SymmetricEigen {
  Eigen::VectorXd values;   // rising
  Eigen::MatrixXd vectors;  // columns of length 1
};
SymmetricEigen eigen_of(const MatrixView& symmetric);

// L, lower, with L L' = A, of which the lower triangle is read. Where rounding leaves A not positive definite, that of its diagonal, of which nothing
// is taken for less than 1e-16.
Eigen::MatrixXd cholesky_root(const MatrixView& positive);

// a' A^-1 a of a positive definite A, of which the lower triangle is read.
double square_in(const MatrixView& positive, const VectorView& a);

// Systems of a positive definite A, of which the lower triangle is read.
class Positive {
 public:
  explicit Positive(const MatrixView& positive);
  bool is_definite() const { return std::isfinite(log_determinant_); }
  Eigen::VectorXd solved(const VectorView& right) const;
  double log_determinant() const { return log_determinant_; }  // NaN where it is not positive definite

 private:
  Eigen::MatrixXd root_;
  double log_determinant_ = 0;
};

// Systems and the inverse of A, which is symmetric and not singular, be it positive or not (L D L').
class Symmetric {
 public:
  explicit Symmetric(const MatrixView& symmetric);
  Eigen::VectorXd solved(const VectorView& right) const;
  const Eigen::MatrixXd& inverse() const { return inverse_; }
  double log_determinant() const { return log_determinant_; }  // of its size

 private:
  Eigen::MatrixXd matrix_, inverse_;
  double log_determinant_;
};

}  // namespace flexslip
