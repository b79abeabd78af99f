// The model with Boost.Math's elliptic functions, without their promotion to long double.
#include <cmath>

#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>

#include "bench/rival.h"

namespace flexslip {
namespace {

JacobiPoint boost_jacobi(double u, double k) {
  const boost::math::policies::policy<boost::math::policies::promote_double<false>> policy;
  double cn = 0;
  double dn = 0;
  const double sn = boost::math::jacobi_elliptic(k, u, &cn, &dn, policy);
  return {sn, cn, dn, boost::math::ellint_2(k, std::atan2(sn, cn), policy)};
}

BENCHMARK(states_by<boost_jacobi>)->Name("states_by_boost");
BENCHMARK(equilibrium_curve_by<boost_jacobi>)->Name("equilibrium_curve_2000_by_boost");

}  // namespace
}  // namespace flexslip
