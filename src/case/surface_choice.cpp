#include "case/surface_choice.h"

#include <optional>
#include <string_view>

#include "io/input_error.h"
#include "io/quantity.h"

namespace flexslip {

SurfaceOptions options_of(const SurfaceChoice& choice) {
  const auto quantity = [](const std::string& text, std::string_view flag, const Kind& kind, Range range) {
    try {
      return parse_quantity(text, kind, range);
    } catch (const InputError& error) {
      throw located(error, "", 0, flag);
    }
  };
  const auto length = [&](const std::string& text, std::string_view flag,
                          Range range = Range::positive) -> std::optional<double> {
    if (text.empty()) return std::nullopt;
    return quantity(text, flag, kind::length, range);
  };
  SurfaceOptions options;
  options.level = choice.level;
  options.cutoff = length(choice.cutoff, "--cutoff");
  options.edge_radius = length(choice.edge_radius, "--edge-radius", Range::non_negative).value_or(0);
  if (!choice.friction.empty())
    options.friction = quantity(choice.friction, "--friction", kind::number, Range::positive);
  options.pixel = length(choice.pixel, "--pixel");
  options.amplitude = length(choice.amplitude, "--amplitude");
  for (const std::string& text : choice.wavelengths) options.wavelengths.push_back(*length(text, "--wavelength"));
  options.texture.tapers = choice.tapers;
  options.texture.shortest = length(choice.shortest, "--shortest");
  options.texture.longest = length(choice.longest, "--longest");
  options.texture.noise = length(choice.noise, "--noise", Range::non_negative);
  return options;
}

}  // namespace flexslip
