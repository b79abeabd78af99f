#include "inference/looks.h"

#include <stdexcept>
#include <string>

#include "data/names.h"
#include "fibre/elementary.h"

namespace flexslip {
namespace {

using Eigen::Index;
constexpr double log_two_pi = 1.8378770664093454836;

void require(bool ok, const char* name, double value) {
  if (!ok) throw std::invalid_argument(std::string(name) + " = " + std::to_string(value) + " is out of range");
}

}  // namespace

std::string_view name_of(Kernel kernel) {
  return name_in_order<Kernel::matern_5_2>(kernel, {"none", "exponential", "matern_3_2", "matern_5_2"});
}

void require_domain(const Looks& looks, Kernel kernel, const Hyperparameters& at) {
  require(at.noise >= 0, "noise", at.noise);
  require(at.correlation >= 0 && at.correlation < 1, "correlation", at.correlation);
  if (kernel != Kernel::none) {
    require(at.roughness > 0, "roughness", at.roughness);
    require(at.length > 0, "correlation length", at.length);
  }
  require(looks.prior.size() <= most_columns, "columns", static_cast<double>(looks.prior.size()));
  if (looks.values.size() != looks.looks.size() || looks.columns.size() != looks.looks.size())
    throw std::invalid_argument("the columns of the looks differ in length");
}

Regression regression_of(const CoefficientMatrix& products, const Coefficients& with_y, double y_squared,
                         double log_variances, double seen, const std::vector<double>& prior) {
  Regression r;
  r.information = products;
  double log_prior = 0;
  for (std::size_t j = 0; j < prior.size(); ++j) {
    r.information(static_cast<Index>(j), static_cast<Index>(j)) += 1 / prior[j];
    log_prior += elementary::log(prior[j]);
  }
  r.factor.compute(r.information);
  r.beta = r.factor.solve(with_y);
  r.log_determinant = log_variances + log_prior;
  for (Index j = 0; j < r.information.rows(); ++j) r.log_determinant += 2 * elementary::log(r.factor.matrixLLT()(j, j));
  r.log_likelihood = -0.5 * (seen * log_two_pi + y_squared - r.beta.dot(with_y) + r.log_determinant);
  return r;
}

CoefficientMatrix covariance_of(const Regression& regression) {
  const Index p = regression.beta.size();
  return regression.factor.solve(CoefficientMatrix::Identity(p, p));
}

}  // namespace flexslip
