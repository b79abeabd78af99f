#include "numerics/kept_array.h"

#include <utility>

#include <doctest/doctest.h>

namespace flexslip {

TEST_CASE("kept arrays, identity: two arrays share nothing, and a moved array keeps its values") {
  KeptArray<int> a(1001);
  KeptArray<double> b(1001);
  for (std::size_t i = 0; i < 1001; ++i) a[i] = static_cast<int>(i), b[i] = -1;
  KeptArray<int> moved = std::move(a);
  KeptArray<int> other(3);
  other[0] = 7;
  other = std::move(moved);
  for (std::size_t i = 0; i < 1001; ++i) CHECK(other[i] == static_cast<int>(i));
}

TEST_CASE("kept arrays, identity: a new array of at most that size reuses the memory of a destroyed one") {
  const double* before = nullptr;
  {
    const KeptArray<double> first(100'000);
    before = first.data();
  }
  for (int i = 0; i < 100; ++i) CHECK(KeptArray<double>(99'000).data() == before);
}

}  // namespace flexslip
