// Decompositions of dense matrices and their products: those of Eigen, compiled once, as each takes seconds wherever it is compiled.
#pragma once

#include <optional>

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

// L, lower, with L L' = A; none where A, of which the lower triangle is read, is not positive definite.
std::optional<Eigen::MatrixXd> cholesky_root(const MatrixView& positive);

// A and its inverse where A is symmetric and not singular, be it positive or not (L D L').
class Symmetric {
 public:
  explicit Symmetric(const MatrixView& symmetric);
  Eigen::VectorXd solved(const VectorView& right) const;
  const Eigen::MatrixXd& inverse() const { return inverse_; }
  double log_determinant() const { return log_determinant_; }  // of its size

 private:
  Eigen::MatrixXd inverse_;
  double log_determinant_;
};

}  // namespace flexslip
