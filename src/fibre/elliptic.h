// Jacobi's elliptic functions, and the two integrals of them that determine an elastica.
//
// The state of a bent specimen is a small difference of lengths: S - 1 is of order u^4, the terms
// of its closed form are of order u. An AGM ladder computes the terms accurately but not their
// difference. The integrals P and R are the differences themselves. Doubling formulas whose terms
// barely cancel keep every digit (docs/design.md, "Why not the AGM"; the AGM is the oracle in the
// test).
#pragma once

namespace flexslip {

// The parameter m = k^2 in [0, 1] and its complement, both to full relative accuracy: m1 is not
// computed as 1 - m.
struct EllipticParameter {
  double m;   // [1]
  double m1;  // [1]
};

// The result of one evaluation at (u | m).
struct EllipticArc {
  double sn, cn, dn;    // [1] Jacobi's functions
  double one_minus_cn;  // [1] 1 - cn, without cancellation
  double P;             // [1] integral from 0 to u of (1 - cn)(m1 + m cn)/dn^2 dv, of order u^3/6
  double R;             // [1] integral from 0 to u of ((1 - cn)/dn)^2 dv, of order u^5/20
};

// Domain:     0 <= u <= 2 K(m) (a specimen needs u <= K); m in [0, 1].
// Max error:  for u <= K(m) and m in [6e-4, 1 - 6e-4] (q in [-20, 20]), in units of 2^-52 relative:
//             sn 3, dn 10, one_minus_cn 6, P 10, R 30; cn 5 absolute.
// Method:     ℘-series for sn, and Taylor series for P and R, at u/2^n <= 1/8; then n doublings.
// Cost:       about 0.1 µs.
EllipticArc elliptic_arc(double u, const EllipticParameter& parameter);

// The same for small u in less time: 0.02 µs below 1/8.
EllipticArc nearby_arc(double u, const EllipticParameter& parameter);

// Complete integrals of the first and second kind.
struct CompleteElliptic {
  double K, E;  // [1]
};

// Domain:     m in [0, 1); at m = 1, K is infinite.
// Max error:  for m <= 1 - 6e-4, in units of 2^-52 relative: K 3, E 8.
// Method:     arithmetic-geometric mean, both integrals from one ladder (DLMF 19.8.5-7).
CompleteElliptic complete_elliptic(const EllipticParameter& parameter);

// E(u | m) = E(am u | m), Jacobi's epsilon function, from an arc already evaluated.
// Max error:  6 ulp for u <= K(m).
double jacobi_epsilon(double u, const EllipticArc& arc, const EllipticParameter& parameter);

}  // namespace flexslip
