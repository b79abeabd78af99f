#include <doctest/doctest.h>

#include "data/section.h"
#include "fibre/elastica.h"
#include "tests/approximately.h"

using namespace flexslip;

TEST_CASE("surface_strain: at small deflection it is the strain of the bending standards, 6 w h/L² and F L h/(8 I)") {
  const Section bar = RectangularSection{10e-3, 4e-3};
  const double L = 64e-3, E = 3e9;
  const Scales scales(L, E * second_moment(bar));
  const SurfaceStrain surface(bar, scales);
  const FibreState state = fibre_state(1 + 1e-7, 0);
  const double curvature = curvature_at_midspan(state), w = scales.physical_length(state.w),
               F = scales.physical_force(state.F);
  CHECK(surface.strain(curvature) == to(1e-6, 6 * w * 4e-3 / (L * L)));  // the neglected terms are of the size of S - 1
  CHECK(surface.stress(curvature) == to(1e-6, F * L * 4e-3 / (8 * second_moment(bar))));
  CHECK(surface.curvature_at_strain(surface.strain(1.7)) == to(1e-15, 1.7));
  CHECK(surface.curvature_at_stress(surface.stress(1.7)) == to(1e-15, 1.7));
}
