// The discrete Fourier transform, with the same bits on every processor: a library's takes its sines from the C library, whose variants differ
// (numerics/elementary.h).
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace flexslip {

using Complexes = std::vector<std::complex<double>>;

// The least power of two that is not below n. Domain: n >= 1.
std::size_t power_of_two_from(std::size_t n);

// Σ x_t exp(-2πi j t/n).
// Domain:     a power of two of numbers; std::invalid_argument otherwise.
// Max error:  1e-15 log2 n of the root of Σ |x|².
// Cost:       O(n log n).
Complexes fourier(Complexes x);

// The inverse, with its 1/n.
Complexes inverse_fourier(Complexes x);

}  // namespace flexslip
