#include "design/design_result.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <doctest/doctest.h>

#include "bending_test/rig.h"
#include "tests/design/some_design.h"
#include "tests/generators.h"

namespace flexslip {

TEST_CASE("design result, table: what is no test, and what is beyond FlexSlip, are told apart") {
  const auto status_with = [](DesignParameter parameter, double value) {
    Test input = loading_of(spicule);
    set(input, parameter, value);
    return result_of(input).status;
  };
  CHECK(status_with(DesignParameter::step, 3e-6) == ResultStatus::ok);
  CHECK(status_with(DesignParameter::diameter, 300e-6) == ResultStatus::impossible);
  CHECK(status_with(DesignParameter::stiffness, 1e-6) == ResultStatus::impossible);
  CHECK(status_with(DesignParameter::wavelength, 1e-12) == ResultStatus::not_computable);
  CHECK(status_with(DesignParameter::mu0, 19) == ResultStatus::not_computable);  // the wave goes beyond 20
  CHECK(status_with(DesignParameter::step, 1e-30) == ResultStatus::not_computable);
  CHECK(status_with(DesignParameter::travel, 1) == ResultStatus::not_computable);
  CHECK(status_with(DesignParameter::modulus, 1e308) == ResultStatus::impossible);  // the rig is too soft for it
}

TEST_CASE("design result, contract: whatever the numbers, it is computed or refused with a word") {
  CHECK(rc::check([] {
    Test input = loading_of(spicule);
    for (const auto& known : design_parameters()) {
      if (!value_of(input, known.parameter).has_value() || *whole(0, 2) > 0) continue;
      const double value = *whole(0, 4) == 0 ? std::pow(10, *between(-300, 300))
                                             : value_of(input, known.parameter).value() * std::pow(10, *between(-3, 3));
      if (is_within(known, value)) set(input, known.parameter, value);
    }
    std::optional<Design> planned;
    try {
      planned = design_of(input).design;
    } catch (const InputError&) {  // finds all that cannot be computed
    }
    // Millions of periods take their time.
    const bool is_quick = !planned || longest_at_stage(planned->travel) - 1 < 1e4 * planned->friction.smooth_scale();
    RC_PRE(is_quick);
    const auto result = result_of(input);
    RC_ASSERT(result.outcome.has_value() == planned.has_value());
    if (planned) RC_ASSERT(!std::isnan(stiffness_margin(*planned, *result.outcome)));
  }));
}

}  // namespace flexslip
