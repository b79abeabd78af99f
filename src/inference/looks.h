// A Gaussian process along the fibre, seen at many places through autocorrelated noise.
//
// At place x_i the value y_i = h_i'β + g(x_i) + D_i e_i + ε_i is seen: h_i known, β ~ N(0, diag(prior)), g of a Matérn kernel, e an AR(1)
// process over the rows of the record with variance σ², ε_i ~ N(0, variance_i).
#pragma once

#include <vector>

#include <Eigen/Dense>

#include "fibre/limits.h"
#include "inference/kernel.h"

namespace flexslip {

inline constexpr int most_columns = 16;

using Coefficients = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_columns, 1>;
using CoefficientMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_columns, most_columns>;

// One place where the process is seen.
struct Look {
  double place;       // [L] x
  double rows;        // rows of the record since the last look; 0 where this one is no reading
  double noise_gain;  // [L^2/EI] D; 0 where it is no reading
  double variance;    // [1] of ε; infinite where nothing is seen

  bool is_reading() const { return noise_gain != 0; }
};

struct Looks {
  std::vector<Look> looks;            // places not falling
  std::vector<double> values;         // [1] y
  std::vector<Coefficients> columns;  // h
  std::vector<double> prior;          // [1] variances of β
};

inline bool is_seen(const Look& look) { return look.variance < infinity; }

// Domain of all that looks at them: noise >= 0, 0 <= correlation < 1, roughness > 0 and length > 0 where there is a kernel, at most
// most_columns columns, all of one length: std::invalid_argument otherwise.
void require_domain(const Looks& looks, Kernel kernel, const Hyperparameters& at);

// The regression on the whitened columns: what is left of y, and of β.
struct Regression {
  CoefficientMatrix information;  // B'B + 1/prior
  Eigen::LLT<CoefficientMatrix> factor;
  Coefficients beta;
  double log_likelihood, log_determinant;
};

Regression regression_of(const CoefficientMatrix& products, const Coefficients& with_y, double y_squared,
                         double log_variances, double seen, const std::vector<double>& prior);

CoefficientMatrix covariance_of(const Regression& regression);  // [1] of β

}  // namespace flexslip
