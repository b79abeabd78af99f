// A row of a table cell (cell_table.cpp): eight coefficients of one polynomial, in as many vectors
// as needed. The bits do not depend on the vector width. If Highway has no doubles for an
// instruction set, studio/instead/fibre/cell_row-inl.h uses the vectors of the compiler.
//
// Included once for each instruction set (Highway's foreach_target.h), hence no #pragma once.
#if defined(FLEXSLIP_FIBRE_CELL_ROW_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FLEXSLIP_FIBRE_CELL_ROW_INL_H_
#undef FLEXSLIP_FIBRE_CELL_ROW_INL_H_
#else
#define FLEXSLIP_FIBRE_CELL_ROW_INL_H_
#endif

#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#ifndef FLEXSLIP_FIBRE_TERMS_OF_ROW_
#define FLEXSLIP_FIBRE_TERMS_OF_ROW_
namespace flexslip {
inline constexpr std::size_t terms_of_row = 8;
}
#endif

HWY_BEFORE_NAMESPACE();
namespace flexslip::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using RowTag = hn::CappedTag<double, terms_of_row>;
using RowVector = hn::Vec<RowTag>;
using InEachLane = RowVector;
constexpr RowTag row_tag;
constexpr std::size_t row_vectors = terms_of_row / hn::MaxLanes(row_tag);
struct Row {
  RowVector part[row_vectors];
};

HWY_INLINE InEachLane in_each_lane(double value) { return hn::Set(row_tag, value); }

HWY_INLINE Row load_row(const double* from) {
  Row row;
  for (std::size_t i = 0; i < row_vectors; ++i) row.part[i] = hn::LoadU(row_tag, from + i * hn::MaxLanes(row_tag));
  return row;
}

// a y + b
HWY_INLINE Row times_plus(const Row& a, InEachLane y, const Row& b) {
  Row row;
  for (std::size_t i = 0; i < row_vectors; ++i) row.part[i] = hn::Add(hn::Mul(a.part[i], y), b.part[i]);
  return row;
}

// The sum of a vector's lanes. The upper half is added to the lower half repeatedly, so the order
// does not depend on the width.
template <class D>
HWY_INLINE double folded([[maybe_unused]] D tag, hn::Vec<D> vector) {
#if HWY_TARGET != HWY_SCALAR
  if constexpr (hn::MaxLanes(tag) > 1) {
    const hn::Half<D> half;
    return folded(half, hn::Add(hn::LowerHalf(half, vector), hn::UpperHalf(half, vector)));
  }
#endif
  return hn::GetLane(vector);
}

HWY_INLINE Row times(const Row& a, const Row& b) {
  Row product;
  for (std::size_t i = 0; i < row_vectors; ++i) product.part[i] = hn::Mul(a.part[i], b.part[i]);
  return product;
}

HWY_INLINE double dot(const Row& a, const Row& b) {
  Row product = times(a, b);
  for (std::size_t n = row_vectors / 2; n > 0; n /= 2)
    for (std::size_t i = 0; i < n; ++i) product.part[i] = hn::Add(product.part[i], product.part[i + n]);
  return folded(row_tag, product.part[0]);
}

// Powers of x as products of x, x^2 and x^4, selected by the bits of the exponents.
class PowersBy {
 public:
  HWY_INLINE explicit PowersBy(const double (&exponents)[terms_of_row]) {
    const Row all = load_row(exponents);
    for (std::size_t i = 0; i < row_vectors; ++i) {
      const auto bits = hn::ConvertTo(hn::RebindToSigned<RowTag>(), all.part[i]);
      for (std::size_t bit = 0; bit < 3; ++bit) {
        const auto value = hn::Set(hn::RebindToSigned<RowTag>(), std::int64_t{1} << bit);
        has_[bit][i] = hn::RebindMask(row_tag, hn::Eq(hn::And(bits, value), value));
      }
    }
  }

  HWY_INLINE Row of(double x) const {
    const RowVector one = hn::Set(row_tag, 1.0);
    const RowVector x1 = hn::Set(row_tag, x);
    const RowVector x2 = hn::Mul(x1, x1);
    const RowVector x4 = hn::Mul(x2, x2);
    Row row;
    for (std::size_t i = 0; i < row_vectors; ++i)
      row.part[i] = hn::Mul(hn::Mul(hn::IfThenElse(has_[0][i], x1, one), hn::IfThenElse(has_[1][i], x2, one)),
                            hn::IfThenElse(has_[2][i], x4, one));
    return row;
  }

 private:
  hn::Mask<RowTag> has_[3][row_vectors];  // true if the exponent has this bit
};

class Powers {
 public:
  HWY_INLINE Powers() : powers_(exponents), lower_(lower_exponents), factors_(load_row(exponents)) {}
  // 1, x, ..., x^7
  HWY_INLINE Row of(double x) const { return powers_.of(x); }
  // Their derivatives: 0, 1, 2x, ..., 7x^6.
  HWY_INLINE Row slopes_of(double x) const { return times(factors_, lower_.of(x)); }

 private:
  static constexpr double exponents[terms_of_row] = {0, 1, 2, 3, 4, 5, 6, 7};
  static constexpr double lower_exponents[terms_of_row] = {0, 0, 1, 2, 3, 4, 5, 6};
  PowersBy powers_, lower_;
  Row factors_;
};

}  // namespace flexslip::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
