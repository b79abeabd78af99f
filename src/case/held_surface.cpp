#include "case/held_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "io/input_error.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

// At even distances; in [m].
Slopes slopes_of(const ImpliedSurface& implied, double span) {
  std::vector<double> position;
  for (const double each : implied.position) position.push_back(span * each);
  const HeightTrace even = sampled(position, implied.mean.slope).trace;
  return {even.begin, even.step, even.height};
}

Slopes slopes_of(const HeightTrace& trace) {
  Slopes out{trace.begin + 0.5 * trace.step, trace.step, {}};
  for (std::size_t i = 1; i < trace.height.size(); ++i)
    out.value.push_back((trace.height[i] - trace.height[i - 1]) / trace.step);
  return out;
}

}  // namespace

HeldSurface held_against(const ImpliedSurface& implied, const WaveEstimate* wave, double span, const TraceFile& file) {
  constexpr std::size_t fewest = 16;  // slopes of either that are held against each other
  const HeightTrace trace = levelled(file.sampled.trace, 1);
  SurfaceOptions options;
  const double finest = 2 * trace.step;
  const double longest = std::min(span * implied.longest, trace.width());
  if (longest > 2 * finest) options.texture.longest = longest;
  if (wave) options.wavelengths = {span * wave->wavelength.value};
  if (wave) options.amplitude = span * wave->height.value;
  const SurfaceStudy study = study_surface(file, options);
  Slopes profile = slopes_of(implied, span), of_trace = slopes_of(trace);
  const double step = std::max(profile.step, of_trace.step);
  profile = averaged(profile, step);
  of_trace = averaged(of_trace, step);
  if (std::min(profile.value.size(), of_trace.value.size()) < fewest)
    throw InputError({.file = file.source,
                      .expected = fmt::format("a trace that overlaps the friction by at least {} slopes", fewest),
                      .found = fmt::format("{} slopes at steps of {}, and {} of the friction", of_trace.value.size(),
                                           readable(step, kind::length), profile.value.size()),
                      .remedy = "use a longer trace, or a finer one"});
  HeldSurface held{
      file.source, trace.step, trace.width(), study.pixel, study.texture, {}, placed(profile, of_trace), 0};
  if (wave) held.wave = study.resolution.front();
  held.begin = held.placement.offset + (held.placement.turned ? -0.5 : 0.5) * span;
  return held;
}

}  // namespace flexslip
