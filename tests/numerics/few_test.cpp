#include "numerics/few.h"

#include <random>

#include <Eigen/Core>
#include <doctest/doctest.h>

namespace flexslip {
namespace {

template <int M>
void compare_with_eigen() {
  using Matrix = Eigen::Matrix<double, M, M, Eigen::RowMajor>;
  using Vector = Eigen::Matrix<double, M, 1>;
  std::mt19937_64 random(20210829);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int trial = 0; trial < 100; ++trial) {
    Square<M> A, B;
    Few<M> v, w;
    for (double& value : A.at_) value = number(random);
    for (double& value : B.at_) value = number(random);
    for (double& value : v) value = number(random);
    for (double& value : w) value = number(random);
    const Eigen::Map<const Matrix> a(A.at_.data()), b(B.at_.data());
    const Eigen::Map<const Vector> x(v.data()), y(w.data());
    const Matrix ab = a * b, turned = a.transpose();
    CHECK(Eigen::Map<const Matrix>(product(A, B).at_.data()) == ab);
    CHECK(Eigen::Map<const Matrix>(transposed(A).at_.data()) == turned);
    CHECK(dot<M>(v, w) == x.dot(y));
  }
}

}  // namespace

TEST_CASE("oracle: products have the same bits as in Eigen") {
  compare_with_eigen<1>();
  compare_with_eigen<2>();
  compare_with_eigen<3>();
  compare_with_eigen<4>();
  compare_with_eigen<6>();
}

}  // namespace flexslip
