#include "report/plot_units.h"

#include <doctest/doctest.h>

using namespace flexslip;

TEST_CASE("identity: an axis shows a quantity in the unit that reads best") {
  const PlotUnit force = plot_unit(0.012, kind::force, false, "EI/L²");
  CHECK(force.unit == "mN");
  CHECK(force(0.012) == doctest::Approx(12).epsilon(1e-15));  // one rounding each
  CHECK(force.column("force") == "force [mN]");
  CHECK(force.axis(force_label, 0, 0.012).to == force(0.012));
  CHECK(plot_unit(0.012, kind::force, true, "EI/L²").factor == 1);
}

TEST_CASE("identity: reduced variables are plotted in the units of their scales") {
  const PlotUnits units{Scales(1278e-6, 2.13e-9), false};
  const PlotUnit w = units.length(0.3);
  CHECK(w.unit == "µm");
  CHECK(w(0.3) == doctest::Approx(383.4).epsilon(1e-12));
  CHECK(units.force(9).unit == "mN");
  CHECK(PlotUnits{units.scales, true}.force(9).unit == "EI/L²");
  CHECK(PlotUnits{units.scales, false, true}.length(0.3).unit == "in");
}

TEST_CASE("axes, by hand: they end at a round number, not below the greatest value") {
  CHECK(rounded_up(1) == 1);
  CHECK(rounded_up(1.01) == 1.5);
  CHECK(rounded_up(9.6) == 10);
  CHECK(rounded_up(96) == 100);
  CHECK(rounded_up(0.0213) == doctest::Approx(0.025));
}
