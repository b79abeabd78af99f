#include "case/modulus_study.h"

#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "case/fitted.h"
#include "io/input_error.h"
#include "io/quantity.h"

namespace flexslip {
namespace {

constexpr std::size_t least_points_of_line = 11;  // they tell the noise

}  // namespace

std::optional<ForceWindow> window_of(const std::vector<std::string>& words) {
  if (words.empty()) return std::nullopt;
  const auto share = [](const std::string& text) {
    try {
      return parse_quantity(text, kind::number, Range::non_negative);
    } catch (const InputError& error) {
      throw located(error, "", 0, "--window");
    }
  };
  const ForceWindow window{share(words.at(0)), share(words.at(1))};
  if (window.from < window.up_to && window.up_to <= 1) return window;
  throw InputError({.field = "--window",
                    .expected = "two rising shares of the greatest force, at most 1",
                    .found = fmt::format("{} and {}", words[0], words[1])});
}

ModulusStudy study_modulus(const Case& input, const std::optional<ForceWindow>& window) {
  Measurement measurement = read_measurement(input, least_points_of_line);
  const BeamGeometry geometry = geometry_of(measurement.test);
  const SmallDeflection numbers = small_deflection(measurement.record, geometry, {.window = window});
  return {std::move(measurement), geometry, numbers};
}

}  // namespace flexslip
