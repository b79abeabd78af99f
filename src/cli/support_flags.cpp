#include "cli/support_flags.h"

#include <fmt/format.h>

#include "case/problem.h"
#include "io/input_error.h"

namespace flexslip {

const Supports& within_limits(const Supports& stated) {
  if (!(stated.half_depth >= 0 && 2 * stated.half_depth < thickest))
    throw InputError({.field = "--thickness",
                      .expected = fmt::format("0 or more, and less than {:g} spans, for beam theory to hold", thickest),
                      .found = fmt::format("{:g} spans", 2 * stated.half_depth),
                      .remedy = "check its unit, and the span"});
  if (!(stated.radius >= 0 && stated.radius + stated.half_depth < widest_supports))
    throw InputError(
        {.field = "--roller-radius",
         .expected = fmt::format("0 or more, and with half the thickness less than {:g} spans", widest_supports),
         .found = fmt::format("{:g} and {:g} spans", stated.radius, stated.half_depth),
         .remedy = "check the units of both, and the span"});
  return stated;
}

}  // namespace flexslip
