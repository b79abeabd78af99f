#include "cases/design_case.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "bending_test/rig.h"
#include "cases/problem.h"

namespace flexslip {
namespace {

constexpr double most_friction = 20;      // what the mechanics covers
constexpr double thickest = 0.2;          // [L] beyond it shear, which the elastica leaves out, matters
constexpr double nearest_reduced = 1e-6;  // [L] of the deflection: what the loading curve can be traced for
constexpr double farthest_reduced = 100;  // [L] of the stage
constexpr double most_periods = 1e6;      // of the roughness: what the curve can be traced for
constexpr double finest_period = 1e-9;    // [L] likewise

constexpr std::array parameters{
    DesignParameterName{DesignParameter::mu0, "mu0", kind::number},
    DesignParameterName{DesignParameter::amplitude, "amplitude", kind::number},
    DesignParameterName{DesignParameter::wavelength, "wavelength", kind::length},
    DesignParameterName{DesignParameter::phase, "phase", kind::angle},
    DesignParameterName{DesignParameter::span, "span", kind::length},
    DesignParameterName{DesignParameter::diameter, "diameter", kind::length},
    DesignParameterName{DesignParameter::modulus, "modulus", kind::pressure},
    DesignParameterName{DesignParameter::stiffness, "stiffness", kind::stiffness},
    DesignParameterName{DesignParameter::travel, "travel", kind::length},
    DesignParameterName{DesignParameter::step, "step", kind::length},
};

InputError wrong_number(DesignParameter parameter, std::string expected, double found, bool reduced,
                        std::string remedy = "") {
  const auto& [which, name, kind] = described(parameter);
  return InputError({.field = std::string(name),
                     .expected = std::move(expected),
                     .found = readable(found, reduced ? kind::number : kind),
                     .remedy = std::move(remedy)});
}

// What is expected of a parameter by itself; empty if the value is that.
std::string unmet(DesignParameter parameter, double value) {
  switch (parameter) {
    case DesignParameter::mu0:
      return value >= 0 && value <= most_friction ? "" : "friction of 0 to 20";
    case DesignParameter::amplitude:
      return value >= 0 && value <= 1 ? "" : "an amplitude of 0 to 1, relative to mu0";
    case DesignParameter::phase:
      return std::isfinite(value) ? "" : "a finite angle";
    case DesignParameter::stiffness:
      return value > 0 ? "" : "a stiffness above 0";
    case DesignParameter::step:
      return value >= 0 && std::isfinite(value) ? "" : "a step above 0, or 0 for a continuous record";
    case DesignParameter::wavelength:
    case DesignParameter::span:
    case DesignParameter::diameter:
    case DesignParameter::modulus:
    case DesignParameter::travel:
      return value > 0 && std::isfinite(value) ? "" : "a number above 0";
  }
  throw std::invalid_argument("no such parameter");
}

struct Loading {
  double travel, step;
};

// The one loading of a programme, up to its farthest position.
Loading loading_of(const Case& input) {
  if (!input.stage) throw missing(input, "stage");
  const auto* programme = std::get_if<TurningPoints>(&input.stage->programme);
  if (!programme)
    throw wrong_value(input, "stage.file", "a program of turning points, to plan one loading", "a measured programme",
                      R"(write program = ["0 um", "900 um"], or see what that programme does with flexslip simulate)");
  const auto& positions = programme->positions;
  const auto farthest = std::max_element(positions.begin(), positions.end());
  const auto shown = [&](double position) { return readable(position, kind_in(input, kind::length)); };
  if (positions.front() != 0)
    throw wrong_value(input, "stage.program[1]", "0, the straight specimen, to plan one loading",
                      shown(positions.front()));
  if (const auto turn = std::is_sorted_until(positions.begin(), farthest + 1); turn <= farthest)
    throw wrong_value(input, fmt::format("stage.program[{}]", turn - positions.begin() + 1),
                      fmt::format("one loading up to the farthest position, {}", shown(*farthest)),
                      fmt::format("a way back to {}", shown(*turn)),
                      "leave out what comes before, or see what the whole programme does with flexslip simulate");
  if (input.stage->snaps != SnapRest::nearest_stable)
    throw wrong_value(input, "stage.snaps", "snaps that rest at the nearest stable state, to plan one loading",
                      "\"overshoot\"", "leave it out, or see what overshooting does with flexslip simulate");
  if (input.friction && input.friction->static_excess > 0)
    throw wrong_value(input, "friction.static_excess", "friction that is the same at rest, to plan one loading",
                      fmt::format("{:g}", input.friction->static_excess),
                      "leave it out, or see what it does with flexslip simulate");
  return {*farthest, programme->step.value_or(0)};
}

}  // namespace

std::array<DesignParameterName, 10> design_parameters() { return parameters; }

const DesignParameterName& described(DesignParameter parameter) {
  return parameters[static_cast<std::size_t>(parameter)];
}

DesignCase::DesignCase(const Case& input) : input_(std::make_shared<const Case>(input)), span_(span_of(input)) {
  const Scales scales = scales_of(input, bending_stiffness_of(input));
  bending_stiffness_ = scales.bending_stiffness();
  const Loading loading = loading_of(input);
  programme_of(input);
  const double travel = scales.reduced_length(loading.travel);
  const Friction friction = bending_test_of(input, scales, travel).friction.kinetic;

  add(DesignParameter::travel, loading.travel);
  add(DesignParameter::step, loading.step);
  add(DesignParameter::stiffness, load_train_stiffness_of(input));
  if (!input.reduced) {
    add(DesignParameter::span, span_);
    if (const auto* modulus = std::get_if<Modulus>(&input.specimen->rigidity)) {
      add(DesignParameter::modulus, std::get<Known>(modulus->estimate).value);
      if (const auto* round = std::get_if<RoundSection>(&*input.specimen->section))
        add(DesignParameter::diameter, round->diameter);
    }
  }
  if (const auto* wavy = std::get_if<WavyFriction>(&*input.friction->profile)) {
    profile_ = *wavy;
    add(DesignParameter::mu0, wavy->mu0);
    if (wavy->waves.size() == 1) {
      add(DesignParameter::amplitude, wavy->waves.front().amplitude);
      add(DesignParameter::wavelength, wavy->waves.front().wavelength);
      add(DesignParameter::phase, wavy->waves.front().phase);
    }
  } else if (const auto* rough = std::get_if<RoughFriction>(&*input.friction->profile)) {
    profile_ = *rough;
  } else {
    profile_ = std::get<FrictionTable>(friction.form());
  }
}

bool DesignCase::has(DesignParameter parameter) const { return at(parameter).exists; }

double DesignCase::value(DesignParameter parameter) const {
  if (!has(parameter))
    throw InputError({.file = input_->source,
                      .field = std::string(described(parameter).name),
                      .expected = "a number of the case that can be varied",
                      .found = "none"});
  return at(parameter).number;
}

void DesignCase::set(DesignParameter parameter, double value) {
  this->value(parameter);
  if (std::string expected = unmet(parameter, value); !expected.empty())
    throw wrong_number(parameter, std::move(expected), value, reduced());
  at(parameter).number = value;
}

double DesignCase::bending_stiffness() const {
  if (has(DesignParameter::diameter))
    return at(DesignParameter::modulus).number * round_section_moment(at(DesignParameter::diameter).number);
  if (has(DesignParameter::modulus))
    return at(DesignParameter::modulus).number * second_moment(*input_->specimen->section);
  return bending_stiffness_;
}

Scales DesignCase::scales() const {
  const double span = has(DesignParameter::span) ? at(DesignParameter::span).number : span_;
  try {
    return {span, bending_stiffness()};
  } catch (const std::invalid_argument& error) {
    throw InputError({.field = "modulus",
                      .expected = "a bending stiffness and a span that a computer can hold",
                      .found = error.what()});
  }
}

void DesignCase::require_slender() const {
  if (reduced() || !input_->specimen->section) return;
  const bool varies = has(DesignParameter::diameter);
  const double thickness = varies ? at(DesignParameter::diameter).number : depth(*input_->specimen->section);
  const double span = at(DesignParameter::span).number;
  if (thickness < thickest * span) return;
  throw wrong_number(varies ? DesignParameter::diameter : DesignParameter::span,
                     varies ? fmt::format("less than a fifth of the span, {}", readable(span, kind::length))
                            : fmt::format("more than five times the thickness, {}", readable(thickness, kind::length)),
                     varies ? thickness : span, false, "beam theory does not hold for a thicker specimen");
}

Friction DesignCase::friction(const Scales& scales, double S_max) const {
  if (const auto* table = std::get_if<FrictionTable>(&profile_)) {
    FrictionTable scaled = *table;
    for (double& S : scaled.S) S *= span_ / scales.span();
    return Friction::table(std::move(scaled));
  }
  if (const auto* rough = std::get_if<RoughFriction>(&profile_))
    return Friction::rough(rough->mu0, rough->rms, scales.reduced_length(rough->correlation_length), rough->seed,
                           S_max);
  const auto& wavy = std::get<WavyFriction>(profile_);
  FrictionWaves waves{at(DesignParameter::mu0).number, wavy.drift * scales.span(), {}};
  waves.terms.reserve(wavy.waves.size());
  for (const WaveInput& wave : wavy.waves)
    waves.terms.push_back({wave.amplitude, scales.reduced_length(wave.wavelength), wave.phase});
  if (has(DesignParameter::wavelength))
    waves.terms.front() = {at(DesignParameter::amplitude).number,
                           scales.reduced_length(at(DesignParameter::wavelength).number),
                           at(DesignParameter::phase).number};
  double most = waves.mu0;
  for (const Sinusoid& term : waves.terms) {
    most += waves.mu0 * term.amplitude;
    const double period = 2 * term.wavelength;
    if (period >= finest_period && (S_max - 1) / period <= most_periods) continue;
    throw wrong_number(DesignParameter::wavelength,
                       fmt::format("at most {:.0e} periods along the specimen", most_periods),
                       term.wavelength * scales.span(), reduced());
  }
  if (most > most_friction)
    throw wrong_number(DesignParameter::mu0, "friction of at most 20, its waves included", waves.mu0, reduced());
  return Friction::waves(std::move(waves));
}

Design DesignCase::design() const {
  require_slender();
  const Scales units = scales();
  const double travel = units.reduced_length(at(DesignParameter::travel).number);
  const double stiffness = units.reduced_stiffness(at(DesignParameter::stiffness).number);
  const auto shown_span = [&] { return readable(units.span(), reduced() ? kind::number : kind::length); };
  if (!(travel <= farthest_reduced))
    throw wrong_number(DesignParameter::travel, fmt::format("at most {:g} spans of {}", farthest_reduced, shown_span()),
                       at(DesignParameter::travel).number, reduced());
  if (!(travel >= nearest_reduced))
    throw wrong_number(DesignParameter::travel, fmt::format("at least {:g} spans of {}", nearest_reduced, shown_span()),
                       at(DesignParameter::travel).number, reduced());
  if (!(travel / (1 + 48 / stiffness) >= nearest_reduced))
    throw wrong_number(DesignParameter::stiffness,
                       fmt::format("a rig that bends the specimen by at least {:g} spans", nearest_reduced),
                       at(DesignParameter::stiffness).number, reduced());
  return {friction(units, longest_at_stage(travel)),
          {stiffness},
          travel,
          units.reduced_length(at(DesignParameter::step).number)};
}

}  // namespace flexslip
