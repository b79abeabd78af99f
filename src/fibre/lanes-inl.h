// Arithmetic for one number and for a vector of numbers. The mathematics of this room is written
// once for a type T: double, Lanes (a vector of doubles), or Dual of either.
//
// Every operation rounds as IEEE requires, in each lane, without fusion. All types and all
// processors therefore give the same bits.
//
// Included once for each instruction set (Highway's foreach_target.h), hence no #pragma once.
#if defined(FLEXSLIP_FIBRE_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FLEXSLIP_FIBRE_LANES_INL_H_
#undef FLEXSLIP_FIBRE_LANES_INL_H_
#else
#define FLEXSLIP_FIBRE_LANES_INL_H_
#endif

#include <cmath>
#include <cstddef>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace flexslip::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using DoubleTag = hn::ScalableTag<double>;

struct Lanes {
  hn::Vec<DoubleTag> v;
  HWY_INLINE Lanes(hn::Vec<DoubleTag> vector) : v(vector) {}              // NOLINT(google-explicit-constructor)
  HWY_INLINE Lanes(double value = 0) : v(hn::Set(DoubleTag(), value)) {}  // NOLINT(google-explicit-constructor)
};

struct LanesMask {
  hn::Mask<DoubleTag> m;
};

HWY_INLINE Lanes operator+(Lanes a, Lanes b) { return hn::Add(a.v, b.v); }
HWY_INLINE Lanes operator-(Lanes a, Lanes b) { return hn::Sub(a.v, b.v); }
HWY_INLINE Lanes operator*(Lanes a, Lanes b) { return hn::Mul(a.v, b.v); }
HWY_INLINE Lanes operator/(Lanes a, Lanes b) { return hn::Div(a.v, b.v); }
HWY_INLINE Lanes operator-(Lanes a) { return hn::Neg(a.v); }
HWY_INLINE LanesMask operator<(Lanes a, Lanes b) { return {hn::Lt(a.v, b.v)}; }
HWY_INLINE LanesMask operator&(LanesMask a, LanesMask b) { return {hn::And(a.m, b.m)}; }
HWY_INLINE Lanes sqrt(Lanes a) { return hn::Sqrt(a.v); }
HWY_INLINE Lanes abs(Lanes a) { return hn::Abs(a.v); }
HWY_INLINE Lanes floor(Lanes a) { return hn::Floor(a.v); }
HWY_INLINE Lanes choose(LanesMask mask, Lanes yes, Lanes no) { return hn::IfThenElse(mask.m, yes.v, no.v); }

HWY_INLINE Lanes reciprocal(Lanes a) { return 1.0 / a; }

HWY_INLINE double reciprocal(double a) { return 1.0 / a; }
HWY_INLINE double sqrt(double a) { return std::sqrt(a); }
HWY_INLINE double abs(double a) { return std::abs(a); }
HWY_INLINE double floor(double a) { return std::floor(a); }
HWY_INLINE double choose(bool mask, double yes, double no) { return mask ? yes : no; }

// Two reciprocals from one division, because divisions dominate the cost.
template <class T>
struct Reciprocals {
  T of_a, of_b;
};
template <class T>
HWY_INLINE Reciprocals<T> reciprocals(const T& a, const T& b) {
  const T both = reciprocal(a * b);
  return {both * b, both * a};
}

// Calls f(i, n, a, b) for successive groups of n elements of two arrays, from index i. In the last
// call n may be smaller than the vector; the remaining lanes are zero.
template <class Function>
HWY_INLINE void for_each_lanes(const double* a, const double* b, std::size_t count, const Function& f) {
  constexpr DoubleTag tag;
  const std::size_t width = hn::Lanes(tag);
  std::size_t i = 0;
  for (; i + width <= count; i += width) f(i, width, Lanes(hn::LoadU(tag, a + i)), Lanes(hn::LoadU(tag, b + i)));
  if (i == count) return;
  HWY_ALIGN double rest[2][hn::MaxLanes(tag)] = {};
  for (std::size_t j = 0; i + j < count; ++j) {
    rest[0][j] = a[i + j];
    rest[1][j] = b[i + j];
  }
  f(i, count - i, Lanes(hn::Load(tag, rest[0])), Lanes(hn::Load(tag, rest[1])));
}

// Stores the first n lanes.
HWY_INLINE void store(Lanes value, double* to, std::size_t n) {
  constexpr DoubleTag tag;
  if (n == hn::Lanes(tag)) {
    hn::StoreU(value.v, tag, to);
    return;
  }
  HWY_ALIGN double all[hn::MaxLanes(tag)];
  hn::Store(value.v, tag, all);
  for (std::size_t j = 0; j < n; ++j) to[j] = all[j];
}

// A number with one derivative. Derivatives of code written for both types are exact by
// construction.
template <class T>
struct Dual {
  T v;  // value
  T d;  // derivative in the caller's variable
  HWY_INLINE Dual(T value, T derivative) : v(value), d(derivative) {}
};

template <class T>
HWY_INLINE Dual<T> operator+(const Dual<T>& a, const Dual<T>& b) {
  return {a.v + b.v, a.d + b.d};
}
template <class T>
HWY_INLINE Dual<T> operator-(const Dual<T>& a, const Dual<T>& b) {
  return {a.v - b.v, a.d - b.d};
}
template <class T>
HWY_INLINE Dual<T> operator*(const Dual<T>& a, const Dual<T>& b) {
  return {a.v * b.v, a.d * b.v + a.v * b.d};
}
// With a plain number, whose derivative is zero.
template <class T>
using Plain = std::type_identity_t<T>;
template <class T>
HWY_INLINE Dual<T> operator+(const Plain<T>& a, const Dual<T>& b) {
  return {a + b.v, b.d};
}
template <class T>
HWY_INLINE Dual<T> operator+(const Dual<T>& a, const Plain<T>& b) {
  return {a.v + b, a.d};
}
template <class T>
HWY_INLINE Dual<T> operator-(const Plain<T>& a, const Dual<T>& b) {
  return {a - b.v, -b.d};
}
template <class T>
HWY_INLINE Dual<T> operator-(const Dual<T>& a, const Plain<T>& b) {
  return {a.v - b, a.d};
}
template <class T>
HWY_INLINE Dual<T> operator*(const Plain<T>& a, const Dual<T>& b) {
  return {a * b.v, a * b.d};
}
template <class T>
HWY_INLINE Dual<T> reciprocal(const Dual<T>& b) {
  const T value = reciprocal(b.v);
  return {value, -(value * value * b.d)};
}
template <class T>
HWY_INLINE Reciprocals<Dual<T>> reciprocals(const Dual<T>& a, const Dual<T>& b) {
  const auto [of_a, of_b] = reciprocals(a.v, b.v);
  return {{of_a, -(of_a * of_a * a.d)}, {of_b, -(of_b * of_b * b.d)}};
}
template <class T>
HWY_INLINE auto operator<(const Dual<T>& a, const Plain<T>& b) {
  return a.v < b;
}
template <class T>
HWY_INLINE Dual<T> sqrt(const Dual<T>& a) {
  const T root = sqrt(a.v);
  return {root, T(0.5) * a.d * reciprocal(root)};
}
template <class Mask, class T>
HWY_INLINE Dual<T> choose(Mask mask, const Dual<T>& yes, const Dual<T>& no) {
  return {choose(mask, yes.v, no.v), choose(mask, yes.d, no.d)};
}

}  // namespace flexslip::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // FLEXSLIP_FIBRE_LANES_INL_H_
