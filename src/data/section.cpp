#include "data/section.h"

#include "data/scales.h"

namespace flexslip {
namespace {

double moment_of(const RoundSection& round) { return round_section_moment(round.diameter); }

double moment_of(const TubularSection& tube) { return tubular_section_moment(tube.diameter, tube.inner_diameter); }

double moment_of(const RectangularSection& rectangle) {
  return rectangular_section_moment(rectangle.width, rectangle.height);
}

double depth_of(const RoundSection& round) { return round.diameter; }
double depth_of(const TubularSection& tube) { return tube.diameter; }
double depth_of(const RectangularSection& rectangle) { return rectangle.height; }

constexpr double poisson = 0.3;

// I/(κ A) [m^2] with Cowper's κ.
double moment_over_shear_area(const RoundSection& round) {
  const double k = 6 * (1 + poisson) / (7 + 6 * poisson);
  return round.diameter * round.diameter / 16 / k;
}
double moment_over_shear_area(const TubularSection& tube) {
  const double m = tube.inner_diameter / tube.diameter, m2 = m * m, sum = (1 + m2) * (1 + m2);
  const double k = 6 * (1 + poisson) * sum / ((7 + 6 * poisson) * sum + (20 + 12 * poisson) * m2);
  return tube.diameter * tube.diameter * (1 + m2) / 16 / k;
}
double moment_over_shear_area(const RectangularSection& rectangle) {
  const double k = 10 * (1 + poisson) / (12 + 11 * poisson);
  return rectangle.height * rectangle.height / 12 / k;
}

}  // namespace

double second_moment(const Section& section) {
  return std::visit([](const auto& shape) { return moment_of(shape); }, section);
}

double depth(const Section& section) {
  return std::visit([](const auto& shape) { return depth_of(shape); }, section);
}

double shear_share(const Section& section, double span) {
  const double ratio = std::visit([](const auto& shape) { return moment_over_shear_area(shape); }, section);
  return 24 * (1 + poisson) * ratio / (span * span);
}

bool is_thin_tube(const Section& section) {
  const auto* tube = std::get_if<TubularSection>(&section);
  return tube && tube->diameter - tube->inner_diameter < 0.1 * tube->diameter;  // twice the wall
}

}  // namespace flexslip
