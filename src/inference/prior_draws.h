// Samples of a Gaussian process (Observations) from its prior.
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

// One sample of the process and of its observations.
struct Drawn {
  Coefficients beta;
  std::vector<double> f;       // h'β + g at each observation
  std::vector<double> values;  // y
};

// A source of such samples.
class PriorDraws {
 public:
  // Domain:     as require_domain. The observations must outlive this object.
  PriorDraws(const Observations& observations, Kernel kernel, const Hyperparameters& at);

  Drawn operator()(NormalSource& normal) const;

 private:
  const Observations& observations_;
  Kernel kernel_;
  Hyperparameters at_;
  std::vector<double> steps_;  // for each observation: the transition of g, and the root of the added covariance
};

}  // namespace flexslip
