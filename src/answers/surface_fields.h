// What `surface` tells of a height trace.
#pragma once

#include <vector>

#include "case/surface_study.h"
#include "result/fields.h"

namespace flexslip {

Fields<SurfaceStudy> surface_fields();

// A height of a trace, and what is shown from it to the next.
struct TracePoint {
  const SurfaceStudy& study;
  std::size_t index;
};
std::vector<TracePoint> points_of(const SurfaceStudy& study);
Fields<TracePoint> trace_fields();

// A frequency of its spectrum.
struct SpectrumPoint {
  const SurfaceStudy& study;
  std::size_t index;
};
std::vector<SpectrumPoint> spectrum_points_of(const SurfaceStudy& study);
Fields<SpectrumPoint> spectrum_fields();

}  // namespace flexslip
