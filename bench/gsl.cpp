// The model with the elliptic functions of the GNU Scientific Library.
#include <cmath>

#include <gsl/gsl_sf_ellint.h>
#include <gsl/gsl_sf_elljac.h>

#include "bench/rival.h"

namespace flexslip {
namespace {

JacobiPoint gsl_jacobi(double u, double k) {
  JacobiPoint point{};
  gsl_sf_elljac_e(u, k * k, &point.sn, &point.cn, &point.dn);
  gsl_sf_result E{};
  gsl_sf_ellint_E_e(std::atan2(point.sn, point.cn), k, GSL_PREC_DOUBLE, &E);
  point.E = E.val;
  return point;
}

BENCHMARK(states_by<gsl_jacobi>)->Name("states_by_gsl");
BENCHMARK(equilibrium_curve_by<gsl_jacobi>)->Name("equilibrium_curve_2000_by_gsl");

}  // namespace
}  // namespace flexslip
