// Comparison to a relative tolerance, and to nothing else: doctest's own adds an absolute one.
#pragma once

#include <doctest/doctest.h>

namespace flexslip {

inline doctest::Approx to(double epsilon, double value) { return doctest::Approx(value).scale(0).epsilon(epsilon); }

}  // namespace flexslip
