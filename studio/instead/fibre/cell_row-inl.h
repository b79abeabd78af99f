// A row of a table cell, as src/fibre/cell_row-inl.h, in the vectors of the compiler. Only
// Highway's portable target has doubles here, and clang does not vectorise it. The operations and
// their order are the same, and so are the bits.
#pragma once

#include <cstddef>
#include <cstring>

#include <hwy/highway.h>

namespace flexslip {
inline constexpr std::size_t terms_of_row = 8;
}

namespace flexslip::HWY_NAMESPACE {

using Row = double __attribute__((vector_size(8 * terms_of_row)));
using InEachLane = double;

template <class V>
HWY_INLINE V floor_of(V vector) {
  for (double& lane : vector.raw) lane = __builtin_floor(lane);
  return vector;
}

HWY_INLINE double in_each_lane(double value) { return value; }

HWY_INLINE Row load_row(const double* from) {
  Row row;
  std::memcpy(&row, from, sizeof row);
  return row;
}

// a y + b
HWY_INLINE Row times_plus(const Row& a, double y, const Row& b) { return a * y + b; }

// Adds the upper half to the lower half until one number is left.
HWY_INLINE double dot(const Row& a, const Row& b) {
  const Row product = a * b;
  const auto fours =
      __builtin_shufflevector(product, product, 0, 1, 2, 3) + __builtin_shufflevector(product, product, 4, 5, 6, 7);
  const auto twos = __builtin_shufflevector(fours, fours, 0, 1) + __builtin_shufflevector(fours, fours, 2, 3);
  return twos[0] + twos[1];
}

class Powers {
 public:
  // 1, x, ..., x^7, computed from x, x^2 and x^4 by the bits of the exponents.
  HWY_INLINE Row of(double x) const {
    const double x2 = x * x, x4 = x2 * x2;
    return Row{1, x, x2, x * x2, x4, x * x4, x2 * x4, (x * x2) * x4};
  }
  // Their derivatives: 0, 1, 2x, ..., 7x^6.
  HWY_INLINE Row slopes_of(double x) const {
    const double x2 = x * x, x4 = x2 * x2;
    return Row{0, 1, 2, 3, 4, 5, 6, 7} * Row{1, 1, x, x2, x * x2, x4, x * x4, x2 * x4};
  }
};

}  // namespace flexslip::HWY_NAMESPACE
