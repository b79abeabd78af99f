// Cosines of periodic friction for any number type of fibre/lanes-inl.h. Included once for each
// instruction set.
#if defined(FLEXSLIP_CONTACT_WAVES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FLEXSLIP_CONTACT_WAVES_INL_H_
#undef FLEXSLIP_CONTACT_WAVES_INL_H_
#else
#define FLEXSLIP_CONTACT_WAVES_INL_H_
#endif

#include "contact/friction.h"
#include "fibre/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace flexslip::HWY_NAMESPACE {

// The nearest integer, for |x| < 2^51.
template <class T>
HWY_INLINE T nearest(const T& x) {
  constexpr double units_end_here = 0x1.8p52;
  return (x + units_end_here) - units_end_here;
}

template <class T>
struct CosSin {
  T cos, sin;
};

// The cosine of an angle in turns.
// Domain:     |turns| < 2^51.
// Max error:  2 ulp. The turns are reduced to an eighth without rounding; the polynomials are
//             __kernel_cos and __kernel_sin of fdlibm.
template <class T>
HWY_INLINE CosSin<T> cos_sin_of_turns(const T& turns) {
  const T within = turns - nearest(turns);
  const T quarter = nearest(4.0 * within);
  const T x = 6.283185307179586 * (within - 0.25 * quarter);
  const T z = x * x;
  const T sine = x + x * z *
                         (-1.66666666666666324348e-01 +
                          z * (8.33333333332248946124e-03 +
                               z * (-1.98412698298579493134e-04 +
                                    z * (2.75573137070700676789e-06 +
                                         z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)))));
  const T cosine =
      1.0 - (0.5 * z - z * z *
                           (4.16666666666666019037e-02 +
                            z * (-1.38888888888741095749e-03 +
                                 z * (2.48015872894767294178e-05 +
                                      z * (-2.75573143513906633035e-07 +
                                           z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11))))));
  const T quarters = abs(quarter);
  const auto odd = (T(0.5) < quarters) & (quarters < T(1.5));
  const auto half = T(1.5) < quarters;
  return {choose(odd, -quarter * sine, choose(half, -cosine, cosine)),
          choose(odd, quarter * cosine, choose(half, -sine, sine))};
}

template <class T>
struct WaveSum {
  T mu, slope;
};

// At least zero, if a drift leads below.
template <class T>
HWY_INLINE WaveSum<T> held(const WaveSum<T>& sum) {
  const auto above = T(0.0) < sum.mu;
  return {choose(above, sum.mu, T(0.0)), choose(above, sum.slope, T(0.0))};
}

// One term for each of waves.terms.
template <class T>
HWY_INLINE WaveSum<T> wave_sum(const FrictionWaves& waves, const WaveTerm* terms, const T& S) {
  WaveSum<T> sum{waves.mu0 + waves.drift * (S - waves.S_reference), T(waves.drift)};
  for (std::size_t i = 0; i < waves.terms.size(); ++i) {
    const auto wave = cos_sin_of_turns<T>(terms[i].frequency * S + terms[i].phase);
    sum.mu = sum.mu + terms[i].height * wave.cos;
    sum.slope = sum.slope - terms[i].steepness * wave.sin;
  }
  return sum;
}

}  // namespace flexslip::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // FLEXSLIP_CONTACT_WAVES_INL_H_
