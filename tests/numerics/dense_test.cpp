#include "numerics/dense.h"

#include <cmath>

#include <doctest/doctest.h>

namespace flexslip {
namespace {

constexpr double rounding = 1e-13;  // some hundred of the numbers in it

Eigen::Matrix3d example() {
  Eigen::Matrix3d A;
  A << 4, 1, -2, 1, 3, 0.5, -2, 0.5, 5;
  return A;
}

}  // namespace

TEST_CASE("identity: the eigenvectors and eigenvalues restore a symmetric matrix") {
  const Eigen::Matrix3d A = example();
  const auto [values, vectors] = eigen_of(A);
  CHECK((product(vectors * values.asDiagonal(), vectors.transpose()) - A).norm() < rounding);
  CHECK((values[0] <= values[1] && values[1] <= values[2]));
  const Eigen::MatrixXd L = cholesky_root(A);
  CHECK((product(L, L.transpose()) - A).norm() < rounding);
  CHECK(L(0, 2) == 0);
  const Eigen::Matrix2d singular{{1, 2}, {2, 4}};
  CHECK(cholesky_root(singular) == Eigen::Matrix2d{{1, 0}, {0, 2}});
}

TEST_CASE("table: systems, inverses and determinants, also for indefinite matrices") {
  Eigen::Matrix3d A = example();
  CHECK(Symmetric(A).log_determinant() == doctest::Approx(std::log(4 * 14.75 - 6 - 2 * 6.5)));
  A(1, 1) = -3;
  const Symmetric indefinite(A);
  CHECK((product(A, indefinite.inverse()) - Eigen::Matrix3d::Identity()).norm() < rounding);
  const Eigen::Vector3d x(1, -2, 3);
  CHECK((indefinite.solved(A * x) - x).norm() < rounding);
  CHECK(square_in(example(), example() * x) == doctest::Approx(x.dot(example() * x)));
}

TEST_CASE("identity: a block of a matrix is read in place") {
  const Eigen::MatrixXd A = example();
  CHECK((eigen_of(A.bottomRightCorner(2, 2)).values.sum()) == doctest::Approx(8));
}

}  // namespace flexslip
