// What is asked of a height trace, in words: those of a flag on the command line, or of an argument in Python.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "case/surface_study.h"

namespace flexslip {

// Quantities with their units; empty where nothing is said.
struct SurfaceChoice {
  std::string cutoff, edge_radius, friction, pixel, amplitude, shortest, longest, noise;
  std::vector<std::string> wavelengths{};
  std::size_t level = SurfaceOptions{}.level;    // as SurfaceOptions
  std::size_t tapers = TextureOptions{}.tapers;  // from least_tapers to most_tapers
};

inline constexpr std::size_t least_tapers = 2, most_tapers = 30;

// Fails:      InputError that names the flag.
SurfaceOptions options_of(const SurfaceChoice& choice);

}  // namespace flexslip
