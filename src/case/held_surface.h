// The surface that would explain a friction, held against a height trace of the specimen.
#pragma once

#include <optional>
#include <string>

#include "case/surface_study.h"
#include "inference/implied_surface.h"
#include "surface/placement.h"

namespace flexslip {

// Units: those of the test.
struct HeldSurface {
  std::string file;
  double step, width;                  // [m] of the trace
  double pixel;                        // [m] as SurfaceStudy has it
  Texture texture;                     // of the trace, of waves no longer than the implied surface is told of
  std::optional<WaveResolution> wave;  // how the likeliest wave of friction would show in it, if there is one
  Placement
      placement;  // of the slopes that the friction implies along the trace; position of the trace = offset ± position from midspan
  double begin;  // [m] of the trace, where the support stood at first
};

// Domain:     lengths [m] of one [L] of the implied surface; the likeliest wave of the fit, null without one.
// Fails:      InputError for a trace that is all level, or too short to be held against.
HeldSurface held_against(const ImpliedSurface& implied, const WaveEstimate* wave, double span, const TraceFile& file);

}  // namespace flexslip
