// Random numbers that are the same on every machine: std::uniform_real_distribution differs between libraries.
#pragma once

#include <random>

namespace flexslip {

class Uniform {
 public:
  double operator()(double from, double to) {
    return from + (to - from) * static_cast<double>(generator_() >> 11) * 0x1p-53;
  }

 private:
  std::mt19937_64 generator_{20210829};
};

}  // namespace flexslip
