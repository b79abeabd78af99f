#include "answers/standard_fields.h"

#include <string>
#include <vector>

#include <fmt/format.h>

#include "case/studies.h"

namespace flexslip {
namespace {

Fields<Chord> chord_fields() {
  return Fields<Chord>()
      .own_numbers("strain", kind::number, "flexural strains at the ends of the chord",
                   [](const Chord&) {
                     return std::vector{0.0005, 0.0025};
                   })
      .own_numbers("deflection", kind::length, "deflections at the ends of the chord, from the origin",
                   [](const Chord& chord) {
                     return std::vector{chord.deflection_from, chord.deflection_to};
                   })
      .own_estimate("stiffness", kind::stiffness, "slope ΔF/Δw between the ends of the chord", &Chord::stiffness)
      .own_estimate("modulus", kind::pressure, "flexural modulus of the chord, as defined by ISO 178", &Chord::modulus);
}

Fields<StandardTest> window_fields() {
  return Fields<StandardTest>()
      .number("from", "start of the linear region, as a share of of_force",
              [](const StandardTest& t) { return t.numbers.window.from; })
      .number("up_to", "end of the linear region, as a share of of_force",
              [](const StandardTest& t) { return t.numbers.window.up_to; })
      .own("of_force", kind::force, "maximum force at small deflection",
           [](const StandardTest& t) { return t.numbers.window_force; })
      .own_numbers("rows", kind::number, "first and last row of the linear region in the file",
                   [](const StandardTest& t) {
                     const RowRange rows = rows_of_first_curve(t.measurement, t.numbers.first, t.numbers.last);
                     return std::vector{rows.first, rows.last};
                   });
}

// The unit of a kind that needs no factor; "1" for plain numbers.
std::string si_unit(const Kind& kind) {
  for (const std::string_view unit : kind.units)
    if (parse_unit(unit) == Unit{kind.dimension, 0, 1}) return std::string(unit);
  return "1";
}

Fields<LoadPoint> reached_fields() {
  return Fields<LoadPoint>()
      .own_quantity("force", kind::force, "force", &LoadPoint::force)
      .own_quantity("deflection", kind::length, "deflection, from the origin", &LoadPoint::deflection)
      .own_quantity("stress", kind::pressure, "flexural stress, F L depth/(8 I)", &LoadPoint::stress)
      .own_quantity("strain", kind::number, "flexural strain, 6 δ depth/L²", &LoadPoint::strain);
}

auto ends(ShareRange FrictionGain::*range) {
  return [range](const FrictionGain& gain) { return std::vector{(gain.*range).least, (gain.*range).most}; };
}

Fields<FrictionGain> friction_gain_fields() {
  return Fields<FrictionGain>()
      .own_numbers("mu", kind::number, "minimum and maximum friction", ends(&FrictionGain::friction))
      .yes_no("stated", "stated in the call or the case; otherwise a default", &FrictionGain::is_stated)
      .yes_no("turns", "rollers turn on their pins before friction reaches the maximum, and limit it",
              &FrictionGain::turns)
      .own_numbers("modulus_share", kind::number,
                   "smallest and largest share that friction in this range adds to the modulus",
                   ends(&FrictionGain::modulus))
      .own_numbers("strength_share", kind::number,
                   "smallest and largest share that it adds to the stress at the maximum force",
                   ends(&FrictionGain::strength))
      .own_numbers("work_share", kind::number,
                   "smallest and largest share of the work up to the maximum force that goes into friction",
                   ends(&FrictionGain::work));
}

}  // namespace

StandardTest standard_test(const FittedTest& test) {
  const bool ok = test.small_deflection.status == SmallDeflectionStatus::ok;
  return {test.measurement, test.geometry, test.small_deflection,
          ok ? supports_gain(test.measurement, test.small_deflection) : SupportsGain{}, test.reduced};
}

StandardTest standard_test(const ModulusStudy& study) {
  return {study.measurement, study.geometry, study.numbers, study.supports, study.measurement.test.reduced};
}

bool is_broken(const StandardTest& test) { return test.measurement.end == MeasurementEnd::failure; }

std::string_view name_of(SmallDeflectionStatus status) {
  switch (status) {
    case SmallDeflectionStatus::ok:
      return "ok";
    case SmallDeflectionStatus::no_straight_part:
      return "no_straight_part";
    case SmallDeflectionStatus::uncertain:
      return "uncertain";
    case SmallDeflectionStatus::too_stiff:
      break;
  }
  return "too_stiff";
}

std::optional<Estimate> modulus_less_supports(const StandardTest& test) {
  const auto modulus = standard_modulus(test.numbers);
  if (!modulus || !test.supports.alone) return std::nullopt;
  const double factor = 1 + *test.supports.alone;
  return normal_estimate(modulus->value / factor, modulus->standard_error / factor);
}

std::optional<StiffnessComparison> compare_stiffness(const FittedTest& test) {
  const SmallDeflection& numbers = test.small_deflection;
  if (test.analysis.status != AnalysisStatus::ok || !numbers.bending_stiffness) return std::nullopt;
  const Estimate& straight = *numbers.bending_stiffness;
  const Estimate& fitted = test.analysis.fit.bending_stiffness;
  const double unit = test.analysis.scales.bending_stiffness();
  return StiffnessComparison{straight.value / (unit * fitted.value),
                             straight.high < unit * fitted.low || straight.low > unit * fitted.high};
}

Fields<StandardTest> modulus_fields() {
  const auto ok = [](const StandardTest& t) { return t.numbers.status == SmallDeflectionStatus::ok; };
  return Fields<StandardTest>()
      .words("status",
             "ok, no_straight_part, uncertain (the error exceeds half of the stiffness), or too_stiff (no material has "
             "such a modulus)",
             [](const StandardTest& t) { return name_of(t.numbers.status); })
      .number(
          "load_train_share",
          "share of the stage travel that the load train takes, over the linear region or else up to the maximum force",
          [](const StandardTest& t) { return t.numbers.load_train_share; })
      .only_where(ok)
      .own_estimate("stiffness", kind::stiffness, "slope dF/dw of the linear region",
                    [](const StandardTest& t) { return t.numbers.stiffness; })
      .own_estimate("bending_stiffness", kind::bending_stiffness, "EI = F L³/(48 δ); null without a span",
                    [](const StandardTest& t) { return t.numbers.bending_stiffness; })
      .own_estimate(
          "modulus", kind::pressure,
          "flexural modulus to report: of the chord, or else (no chord, or chord_in_toe) of the linear region; "
          "null without a section",
          [](const StandardTest& t) { return standard_modulus(t.numbers); })
      .own_estimate(
          "linear_modulus", kind::pressure,
          "flexural modulus F L³/(48 I δ) of the linear region, the steepest part, which friction can steepen",
          [](const StandardTest& t) { return t.numbers.modulus; })
      .group("chord", "chord of ISO 178; null if the record does not cover both strains", chord_fields(),
             [](const StandardTest& t) { return t.numbers.chord; })
      .yes_no("chord_in_toe", "the chord of ISO 178 lies in the toe, so the linear region gives the modulus to report",
              [](const StandardTest& t) { return t.numbers.chord_in_toe; })
      .group("window", "linear region of the curve", window_fields())
      .own_quantity("origin", kind::length,
                    "displacement in the file at which the linear region extrapolates to zero force, at the earliest "
                    "the start of the record; origin of deflections and strains",
                    [](const StandardTest& t) { return t.measurement.contact_offset + t.numbers.origin; })
      .own_quantity("greatest_force", kind::force, "maximum force",
                    [](const StandardTest& t) { return t.numbers.greatest.force; })
      .own_quantity("deflection", kind::length, "deflection at the maximum force, from the origin",
                    [](const StandardTest& t) { return t.numbers.greatest.deflection; })
      .own_quantity("stress", kind::pressure, "flexural stress at the maximum force, F L depth/(8 I)",
                    [](const StandardTest& t) { return t.numbers.greatest.stress; })
      .own_quantity("strain", kind::number, "flexural strain at the maximum force, 6 δ depth/L²",
                    [](const StandardTest& t) { return t.numbers.greatest.strain; })
      .group("at_break", "the same at break; null if the record shows no break", reached_fields(),
             [](const StandardTest& t) { return is_broken(t) ? std::optional(t.numbers.end) : std::nullopt; })
      .group("at_conventional_strain",
             "the same at a flexural strain of 3.5 % (ISO 178); null if the record does not reach it", reached_fields(),
             [](const StandardTest& t) { return t.numbers.at_conventional_strain; })
      .yes_no("yields", "the force levels off at small deflection without a break",
              [](const StandardTest& t) { return !is_broken(t) && yields(t.numbers); })
      .yes_no("ends_rising", "the record ends while the force rises, so the stress at its maximum is no strength",
              [](const StandardTest& t) { return !is_broken(t) && ends_rising(t.numbers); })
      .yes_no("deflection_large",
              "the deflection exceeds a tenth of the span, where the stress and strain of the standards are invalid",
              [](const StandardTest& t) { return t.numbers.deflection_large; })
      .number("supports_share",
              "share that rollers and thickness add to the stiffness over the chord or the linear region, without "
              "friction; neglected by the standards",
              [](const StandardTest& t) { return t.supports.alone; })
      .own_estimate("modulus_less_supports", kind::pressure,
                    "modulus of the chord, or else of the linear region, without that share", modulus_less_supports)
      .group("friction", "possible effect of friction at the supports; null without a section", friction_gain_fields(),
             [](const StandardTest& t) { return t.supports.friction; })
      .number("shear_share", "share that shear adds to a small deflection; neglected by the standards",
              [](const StandardTest& t) { return t.numbers.shear_share; })
      .anywhere()
      .list(
          "preparation", "steps from the file to the record", preparation_fields(),
          [](const StandardTest& t) -> const auto& { return t.measurement.preparation; });
}

Fields<PreparationStep> preparation_fields() {
  using S = const PreparationStep&;
  static const std::string names =
      fmt::format("name of the step: one of {}, done in this order", fmt::join(preparation_steps, ", "));
  return Fields<PreparationStep>()
      .words("step", names, [](S step) { return std::string(step.name); })
      .yes_no("changed", "numbers differ from the file, or rows are omitted", [](S step) { return step.changed; })
      .words("done", "what was done, in words", [](S step) { return step.done; })
      .own("value", kind::number, "value that was subtracted, applied or determined",
           [](S step) { return step.value ? std::optional(step.value->value) : std::nullopt; })
      .own("uncertainty", kind::number, "standard deviation of value, if it is known",
           [](S step) { return step.value ? step.value->error : std::nullopt; })
      .words("unit", "unit of value and uncertainty",
             [](S step) { return step.value ? std::optional(si_unit(step.value->kind)) : std::nullopt; })
      .own_numbers("rows", kind::number, "first and last row of the file that the step affects; null for all",
                   [](S step) {
                     return step.rows ? std::optional(std::vector{step.rows->first, step.rows->last}) : std::nullopt;
                   })
      .words("key", "key of the case that changes the step",
             [](S step) { return step.otherwise ? std::optional(step.otherwise->in_case()) : std::nullopt; });
}

Frame frame_of(const StandardTest& test) {
  return {.scales = Scales(1, 1), .reduced = test.reduced, .row = [&test](std::size_t point) {
            return file_row(test.measurement, point);
          }};
}

}  // namespace flexslip
