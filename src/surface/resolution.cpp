#include "surface/resolution.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "fibre/elementary.h"

namespace flexslip {

double least_amplitude(double density, double width, std::size_t frequencies) {
  constexpr double by_chance = 0.05;
  constexpr double of_20_missed = 1.6448536269514722 / 1.4142135623730951;  // of |1 + noise|, in one of its components
  if (!(density >= 0 && width > 0) || frequencies == 0)
    throw std::invalid_argument("the least amplitude in a field of " + std::to_string(width) + " and a density of " +
                                std::to_string(density));
  const double among = elementary::log(static_cast<double>(frequencies) / by_chance);
  return std::sqrt(2 * density / width) * (std::sqrt(among) + of_20_missed);
}

WaveResolution resolution_of(const TraceResolution& trace, double wavelength, double density, double amplitude) {
  if (!(trace.step > 0 && trace.width > 0 && trace.pixel >= 0 && wavelength > 0))
    throw std::invalid_argument("a trace of step " + std::to_string(trace.step) + " and width " +
                                std::to_string(trace.width) + " shows no waves of " + std::to_string(wavelength));
  const double heights = trace.width / trace.step;
  const auto frequencies = static_cast<std::size_t>(std::fmax(1, std::floor(0.5 * heights)));
  WaveResolution out{};
  out.wavelength = wavelength;
  out.heights_a_wave = wavelength / trace.step;
  out.waves_in_field = trace.width / wavelength;
  out.least_by_pixels = 0.5 * pixels_wanted * trace.pixel;
  out.least_by_spectrum = least_amplitude(density, trace.width, frequencies);
  out.pixel_wanted = wanted_image(wavelength, 2 * amplitude).pixel;
  out.is_sampled = out.heights_a_wave >= 2;
  out.has_field = out.waves_in_field >= periods_wanted;
  return out;
}

WantedImage wanted_image(double wavelength, double crest_to_trough) {
  return {periods_wanted * wavelength, crest_to_trough / pixels_wanted};
}

}  // namespace flexslip
