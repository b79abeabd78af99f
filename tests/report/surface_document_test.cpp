#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "report/answer_documents.h"
#include "report/figures.h"
#include "tests/has.h"
#include "tests/refusal.h"
#include "tests/surface/simulated_surface.h"

namespace flexslip {
namespace {

TraceFile some_trace(double amplitude, double wavelength) {
  SimulatedSurface surface(3);
  HeightTrace trace{0, 1e-7, surface.gaussian(2000, 1e-7, 2e-8, 1e-6)};
  for (std::size_t i = 0; i < trace.height.size(); ++i)
    trace.height[i] += amplitude * std::cos(2 * std::numbers::pi * trace.position(i) / wavelength);
  return {"trace.csv", "x", "z", {}, {trace, false, 0, false}, {}};
}

}  // namespace

TEST_CASE("surface document, table: what a wave, a question and a friction come to") {
  SurfaceOptions options;
  options.friction = 0.5;
  options.wavelengths = {10.9e-6, 1.5e-7};
  options.amplitude = 0.11e-6;
  options.pixel = 0.29e-6;
  const SurfaceStudy study = study_surface(some_trace(0.11e-6, 10.9e-6), options);
  const std::string text = in_text(document_of(study), 10'000);
  for (const char* words :
       {"trace.csv: The surface slope is", "one phase along the whole trace (p below 0.0001)",
        "10.9 µm: 109 heights per wave, 18.3 waves in the field",
        "(10 pixels of 290 nm from crest to trough), from 1.45 µm", "needs pixels of 22 nm in a field of 109 µm",
        "150 nm: cannot be seen, with 1.5 heights per wave where at least 2 are needed"})
    CHECK_MESSAGE(has(text, words), words, " in ", text);
  CHECK(has(text, "with A = 0.1"));  // 2π 0.11/10.9 (1 + 0.25)/0.5 = 0.16
  const Plot figure = surface_figure(study);
  CHECK(figure.data.size() == 5);
  CHECK(figure.panels.size() == 3);
}

TEST_CASE("surface document, limit: a friction on which it would slide by itself is refused with its place") {
  SurfaceOptions options;
  options.friction = 0.01;
  const std::string message = message_of([&] { study_surface(some_trace(0.11e-6, 10.9e-6), options); });
  CHECK(has(message, "trace.csv: expected slopes between -0.01"));
  CHECK(has(message, "at the position"));
  CHECK(has(message, "times the limit; if it is noise"));
}

}  // namespace flexslip
