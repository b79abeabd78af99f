// Waves in a trace that stand out of the smooth part of its spectrum.
#pragma once

#include <optional>
#include <vector>

#include "surface/texture.h"

namespace flexslip {

// The likeliest coherent wave that no other explains; none where the F test finds none at 1 % over all frequencies.
std::optional<DominantWave> coherent_wave_in(const HeightTrace& trace, const Spectrum& spectrum);

// Taken off, as it was fitted.
HeightTrace without_wave(HeightTrace trace, const DominantWave& wave);

// Peaks that are no coherent waves: they stand out of the continuum, and of their neighbours, at 1 % over all frequencies.
struct Peak {
  DominantWave wave;
  FrequencyRange range;
};
std::vector<Peak> peaks_in(const Spectrum& spectrum, const Continuum& continuum, double longest);

}  // namespace flexslip
