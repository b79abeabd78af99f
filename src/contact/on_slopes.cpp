#include "contact/on_slopes.h"

#include <stdexcept>
#include <utility>

namespace flexslip {

OnSlopes::OnSlopes(Friction in, Friction out) : direction_(1) {
  if (in.depends_on_way() || out.depends_on_way())
    throw std::invalid_argument("the friction of a slope has two ways by itself");
  ways_ = std::make_shared<const Ways>(Ways{std::move(in), std::move(out)});
}

std::shared_ptr<const FrictionOnAWay> OnSlopes::from(double /*S*/, double /*q*/, double direction) const {
  return std::shared_ptr<const OnSlopes>(new OnSlopes(ways_, direction));
}

}  // namespace flexslip
