// A Gaussian process along the fibre (Observations) drawn from what is expected of it beforehand.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "inference/chain.h"
#include "inference/matern.h"

namespace flexslip {

// Standard normal numbers, the same on every machine.
class NormalSource {
 public:
  explicit NormalSource(std::uint64_t seed) : generator_(seed) {}
  double operator()();

 private:
  std::mt19937_64 generator_;
};

// The process with all that the observations would see of it, drawn from what is expected beforehand.
struct Drawn {
  Coefficients beta;
  std::vector<double> f;       // h'β + g at each observation
  std::vector<double> values;  // y
};

// As many of them as are asked for.
class PriorDraws {
 public:
  // Domain:     as require_domain. The observations outlive this.
  PriorDraws(const Observations& observations, Kernel kernel, const Hyperparameters& at);

  Drawn operator()(NormalSource& normal) const;

 private:
  const Observations& observations_;
  Kernel kernel_;
  Hyperparameters at_;
  std::vector<double>
      steps_;  // for each observation: how g goes on to it, and the root of the covariance that it gains
};

}  // namespace flexslip
