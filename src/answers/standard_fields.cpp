#include "answers/standard_fields.h"

#include <vector>

#include "case/studies.h"

namespace flexslip {
namespace {

std::optional<Estimate> with_error_of_slope(const std::optional<double>& value, const Estimate& slope) {
  if (!value) return std::nullopt;
  return normal_estimate(*value, *value * (slope.standard_error / slope.value));
}

Fields<Chord> chord_fields() {
  return Fields<Chord>()
      .own_numbers("strain", kind::number, "flexural strains between which the chord is drawn",
                   [](const Chord&) {
                     return std::vector{0.0005, 0.0025};
                   })
      .own_numbers("deflection", kind::length, "deflections at the ends of the chord, from the origin",
                   [](const Chord& chord) {
                     return std::vector{chord.deflection_from, chord.deflection_to};
                   })
      .own_estimate("stiffness", kind::stiffness, "force over deflection between the ends of the chord",
                    &Chord::stiffness)
      .own_estimate("modulus", kind::pressure, "flexural modulus of the chord, as defined by ISO 178",
                    [](const Chord& chord) { return with_error_of_slope(chord.modulus, chord.stiffness); });
}

Fields<StandardTest> window_fields() {
  return Fields<StandardTest>()
      .number("from", "beginning of the straight part, as a share of of_force",
              [](const StandardTest& t) { return t.numbers.window.from; })
      .number("up_to", "end of the straight part, as a share of of_force",
              [](const StandardTest& t) { return t.numbers.window.up_to; })
      .own("of_force", kind::force, "greatest force reached at a small deflection",
           [](const StandardTest& t) { return t.numbers.window_force; })
      .own_numbers("rows", kind::number, "first and last row of the straight part in the file",
                   [](const StandardTest& t) {
                     return std::vector{file_row(t.measurement, t.numbers.first),
                                        last_file_row(t.measurement, t.numbers.last - 1)};
                   });
}

// The unit of a kind that needs no factor; "1" for plain numbers.
std::string si_unit(const Kind& kind) {
  for (const std::string_view unit : kind.units)
    if (parse_unit(unit) == Unit{kind.dimension, 0, 1}) return std::string(unit);
  return "1";
}

StandardTest standard_test(const Measurement& measurement, const BeamGeometry& geometry,
                           const SmallDeflection& numbers) {
  const bool ok = numbers.status == SmallDeflectionStatus::ok;
  return {measurement, geometry, numbers, ok ? supports_share(measurement, numbers) : std::nullopt,
          measurement.test.reduced};
}

}  // namespace

StandardTest standard_test(const FittedTest& test) {
  return standard_test(test.measurement, test.geometry, test.small_deflection);
}

StandardTest standard_test(const ModulusStudy& study) {
  return standard_test(study.measurement, study.geometry, study.numbers);
}

std::optional<Estimate> modulus_less_supports(const StandardTest& test) {
  const auto& chord = test.numbers.chord;
  const auto told = chord ? with_error_of_slope(chord->modulus, chord->stiffness)
                          : with_error_of_slope(test.numbers.modulus, test.numbers.stiffness);
  if (!told || !test.supports_share) return std::nullopt;
  const double factor = 1 + *test.supports_share;
  return normal_estimate(told->value / factor, told->standard_error / factor);
}

std::optional<BesideFit> small_deflection_beside_fit(const FittedTest& test) {
  const SmallDeflection& numbers = test.small_deflection;
  if (test.analysis.status != AnalysisStatus::ok || !numbers.bending_stiffness) return std::nullopt;
  const Estimate straight = *with_error_of_slope(numbers.bending_stiffness, numbers.stiffness);
  const Estimate& fitted = test.analysis.fit.bending_stiffness;
  const double unit = test.analysis.scales.bending_stiffness();
  return BesideFit{straight.value / (unit * fitted.value),
                   straight.high < unit * fitted.low || straight.low > unit * fitted.high};
}

Fields<StandardTest> modulus_fields() {
  const auto ok = [](const StandardTest& t) { return t.numbers.status == SmallDeflectionStatus::ok; };
  return Fields<StandardTest>()
      .words("status", "whether there are numbers: ok, or no_straight_part",
             [ok](const StandardTest& t) { return ok(t) ? "ok" : "no_straight_part"; })
      .only_where(ok)
      .own_estimate("stiffness", kind::stiffness, "force over deflection, slope of the straight part",
                    [](const StandardTest& t) { return t.numbers.stiffness; })
      .own_estimate(
          "bending_stiffness", kind::bending_stiffness, "EI = F L³/(48 δ); null without a span",
          [](const StandardTest& t) { return with_error_of_slope(t.numbers.bending_stiffness, t.numbers.stiffness); })
      .own_estimate("modulus", kind::pressure, "flexural modulus F L³/(48 I δ); null without a section",
                    [](const StandardTest& t) { return with_error_of_slope(t.numbers.modulus, t.numbers.stiffness); })
      .group("chord", "chord of ISO 178; null if the record does not cover both strains", chord_fields(),
             [](const StandardTest& t) { return t.numbers.chord; })
      .group("window", "straight part of the curve", window_fields())
      .own_quantity("origin", kind::length, "deflection at which the straight part would meet zero force",
                    [](const StandardTest& t) { return t.numbers.origin; })
      .own_quantity("greatest_force", kind::force, "greatest force",
                    [](const StandardTest& t) { return t.numbers.greatest_force; })
      .own_quantity("deflection", kind::length, "deflection at the greatest force, from the origin",
                    [](const StandardTest& t) { return t.numbers.deflection; })
      .own_quantity("stress", kind::pressure, "flexural stress at the greatest force, F L depth/(8 I)",
                    [](const StandardTest& t) { return t.numbers.stress; })
      .own_quantity("strain", kind::number, "flexural strain at the greatest force, 6 δ depth/L²",
                    [](const StandardTest& t) { return t.numbers.strain; })
      .yes_no("deflection_large",
              "the deflection exceeds a tenth of the span, so stress and strain of the standards do not hold",
              [](const StandardTest& t) { return t.numbers.deflection_large; })
      .number("supports_share",
              "share that rollers and thickness, which are neglected, add to the stiffness between the deflections of "
              "chord or straight part, without friction",
              &StandardTest::supports_share)
      .own_estimate("modulus_less_supports", kind::pressure,
                    "modulus of the chord, or else of the straight part, without that share", modulus_less_supports)
      .number("shear_share", "share that shear, which is neglected, adds to a small deflection",
              [](const StandardTest& t) { return t.numbers.shear_share; })
      .anywhere()
      .list(
          "preparation", "steps from the file to the record", preparation_fields(),
          [](const StandardTest& t) -> const auto& { return t.measurement.preparation.steps; });
}

Fields<PreparationStep> preparation_fields() {
  using S = const PreparationStep&;
  return Fields<PreparationStep>()
      .words("step",
             "name of the step: columns, missing, metadata, first, repeated, held, interpolated, sign, thinning, zero, "
             "compliance, end, turn, stage or contact",
             [](S step) { return step.name; })
      .yes_no("changed", "numbers differ from those in the file, or rows are left out",
              [](S step) { return step.changed; })
      .words("done", "what was done, in words", [](S step) { return step.done; })
      .own("value", kind::number, "value that was subtracted, applied or found",
           [](S step) { return step.value ? std::optional(step.value->value) : std::nullopt; })
      .own("uncertainty", kind::number, "standard deviation of value, if it is known",
           [](S step) { return step.value ? step.value->error : std::nullopt; })
      .words("unit", "unit of value and uncertainty",
             [](S step) { return step.value ? std::optional(si_unit(step.value->kind)) : std::nullopt; })
      .own_numbers("rows", kind::number, "first and last row of the file that the step concerns; null for all",
                   [](S step) {
                     return step.rows ? std::optional(std::vector{step.rows->first, step.rows->last}) : std::nullopt;
                   })
      .words("key", "what to write into the case to have the step done otherwise",
             [](S step) { return step.otherwise ? std::optional(step.otherwise->in_case()) : std::nullopt; })
      .words("flag", "flag of the command line that has the step done otherwise",
             [](S step) { return step.otherwise ? std::optional(step.otherwise->flag()) : std::nullopt; });
}

Frame frame_of(const StandardTest& test) {
  return {.scales = Scales(1, 1), .reduced = test.reduced, .row = [&test](std::size_t point) {
            return file_row(test.measurement, point);
          }};
}

}  // namespace flexslip
