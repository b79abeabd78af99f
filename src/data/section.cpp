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

}  // namespace

double second_moment(const Section& section) {
  return std::visit([](const auto& shape) { return moment_of(shape); }, section);
}

double depth(const Section& section) {
  return std::visit([](const auto& shape) { return depth_of(shape); }, section);
}

bool is_thin_tube(const Section& section) {
  const auto* tube = std::get_if<TubularSection>(&section);
  return tube && tube->diameter - tube->inner_diameter < 0.1 * tube->diameter;  // twice the wall
}

}  // namespace flexslip
