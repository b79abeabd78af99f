// Jacobi's elliptic functions, and the two integrals of them that an elastica is made of.
//
// The state of a bent fibre is a difference of nearly equal lengths: S - 1 is of order u^4 while the terms of its closed
// form are of order u. An AGM ladder gives those terms to full accuracy and their difference to none. The integrals P and
// R below are the differences themselves. They are built by doubling the argument with formulas whose terms hardly
// cancel, so every digit survives (docs/design.md, "Why not the AGM"; the AGM is the oracle in the test).
#pragma once

namespace flexslip {

// The parameter m = k^2 in [0, 1] with its complement, both to full relative accuracy: m1 = 1 - m is not computed from m.
struct EllipticParameter {
  double m;   // [1]
  double m1;  // [1]
};

// Everything that one evaluation at (u | m) gives.
struct EllipticArc {
  double sn, cn, dn;    // [1] Jacobi's functions
  double one_minus_cn;  // [1] 1 - cn, without the loss of a subtraction
  double P;             // [1] integral from 0 to u of (1 - cn)(m1 + m cn)/dn^2 dv, of order u^3/6
  double R;             // [1] integral from 0 to u of ((1 - cn)/dn)^2 dv, of order u^5/20
};

// Domain:     0 <= u <= 2 K(m) (a fibre needs u <= K); m in [0, 1].
// Max error:  for u <= K(m) and m in [6e-4, 1 - 6e-4] (q in [-20, 20]), in units of 2^-52 relative: sn 3, dn 10,
//             one_minus_cn 6, P 10, R 30; cn 5 absolute.
// Method:     ℘-series for sn, and Taylor series for P and R, at u/2^n <= 1/8; then n doublings.
// Cost:       about 0.1 µs.
EllipticArc elliptic_arc(double u, const EllipticParameter& parameter);

// The same in less time where u is small: 0.02 µs below 1/8.
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
