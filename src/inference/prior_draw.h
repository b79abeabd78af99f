// A Gaussian process drawn from what is expected of it beforehand.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "inference/looks.h"

namespace flexslip {

// Standard normal numbers, the same on every machine.
class NormalSource {
 public:
  explicit NormalSource(std::uint64_t seed) : generator_(seed) {}
  double operator()();

 private:
  std::mt19937_64 generator_;
};

// The process with all that the looks would see of it, drawn from what is expected beforehand.
struct Drawn {
  Coefficients beta;
  std::vector<double> f;       // h'β + g at each look
  std::vector<double> values;  // y
};
Drawn draw_from_prior(const Looks& looks, Kernel kernel, const Hyperparameters& at, NormalSource& normal);

}  // namespace flexslip
