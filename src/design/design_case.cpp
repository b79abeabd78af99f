#include "design/design_case.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "bending_test/rig.h"
#include "case/case_keys.h"
#include "case/problem.h"
#include "fibre/elastica.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

constexpr double finest_period = 1e-9;  // [L] of a wave: what trace_loading_curve takes
constexpr double most_readings = 1e9;   // what they can be counted for

std::string words_of_range(const DesignParameterName& parameter) {
  const std::string upper = std::isfinite(parameter.most) ? fmt::format(" and at most {:g}", parameter.most) : "";
  switch (parameter.range) {
    case Range::any:
      return "a finite number";
    case Range::non_negative:
      return fmt::format("a number of at least 0{}", upper);
    case Range::positive:
    case Range::positive_or_infinite:
      return fmt::format("a number above 0{}", upper);
  }
  throw std::invalid_argument("words_of_range: no such range");
}

struct Loading {
  double travel, step;
};

// The one loading of a programme, up to its farthest position.
Loading loading_of(const Case& input) {
  if (!input.stage) throw missing(input, "stage");
  const auto* programme = std::get_if<TurningPoints>(&input.stage->programme);
  if (!programme)
    throw wrong_value(input, "stage.file", "a program of turning points, as one loading is planned",
                      "a measured programme",
                      R"(write program = ["0 um", "900 um"]; flexslip simulate shows what a measured programme does)");
  const auto& positions = programme->positions;
  const auto farthest = std::max_element(positions.begin(), positions.end());
  const auto shown = [&](double position) { return readable(position, kind_in(input, kind::length)); };
  if (positions.front() != 0)
    throw wrong_value(input, "stage.program[1]", "0, the straight specimen, as one loading is planned",
                      shown(positions.front()));
  if (const auto turn = std::is_sorted_until(positions.begin(), farthest + 1); turn <= farthest)
    throw wrong_value(input, fmt::format("stage.program[{}]", turn - positions.begin() + 1),
                      fmt::format("one loading up to the farthest position of {}", shown(*farthest)),
                      fmt::format("a way back to {}", shown(*turn)),
                      "leave out the positions before; flexslip simulate shows what the whole programme does");
  if (input.stage->snaps != SnapRest::nearest_stable)
    throw wrong_value(input, "stage.snaps", "snaps that rest at the nearest stable state, as one loading is planned",
                      "\"overshoot\"", "leave it out; flexslip simulate shows what overshooting does");
  if (input.friction && input.friction->static_excess > 0)
    throw wrong_value(input, "friction.static_excess", "no excess of static friction, as one loading is planned",
                      fmt::format("{:g}", input.friction->static_excess),
                      "leave it out; flexslip simulate shows what it does");
  if (!input.specimen->cracks.empty())
    throw wrong_value(input, "specimen.cracks", "a specimen without cracks, as one loading is planned",
                      fmt::format("{} of them", input.specimen->cracks.size()),
                      "leave them out; flexslip simulate shows what they do");
  return {*farthest, programme->step.value_or(0)};
}

}  // namespace

DesignCase::DesignCase(const Case& input) : input_(std::make_shared<const Case>(input)), span_(span_of(input)) {
  const Scales scales = scales_of(input, bending_stiffness_of(input));
  bending_stiffness_ = scales.bending_stiffness();
  support_compliance_ = support_compliance_of(input);
  const Loading loading = loading_of(input);
  programme_of(input);
  const double travel = scales.reduced_length(loading.travel);
  bending_test_of(input, scales, travel);
  const SupportFrictions supports = frictions_of(input, fibre_of(input, scales), scales, longest_at_stage(travel));

  add(DesignParameter::travel, loading.travel);
  add(DesignParameter::step, loading.step);
  add(DesignParameter::stiffness, load_train_stiffness_of(input));
  if (input.rig->rollers == Rollers::pinned) add(DesignParameter::pin_friction, input.rig->pin_friction);
  if (!input.reduced) {
    add(DesignParameter::span, span_);
    if (const auto* modulus = std::get_if<Modulus>(&input.specimen->rigidity)) {
      add(DesignParameter::modulus, std::get<Known>(modulus->estimate).value);
      if (const auto* round = std::get_if<RoundSection>(&*input.specimen->section))
        add(DesignParameter::diameter, round->diameter);
      if (const auto* flat = std::get_if<RectangularSection>(&*input.specimen->section)) {
        add(DesignParameter::height, flat->height);
        add(DesignParameter::width, flat->width);
      }
    }
  }
  profile_ = profile_of(*input.friction->profile, supports.first);
  if (supports.other) other_ = profile_of(input.friction->other->profile, *supports.other);
  if (const auto* wavy = std::get_if<WavyFriction>(&profile_)) {
    add(DesignParameter::mu0, wavy->mu0);
    if (wavy->reference) add(DesignParameter::reference, *wavy->reference);
    if (wavy->waves.size() == 1) {
      add(DesignParameter::amplitude, wavy->waves.front().amplitude);
      add(DesignParameter::wavelength, wavy->waves.front().wavelength);
      add(DesignParameter::phase, wavy->waves.front().phase);
    }
  }
}

DesignCase::Profile DesignCase::profile_of(const FrictionProfileInput& input, const Friction& friction) {
  if (const auto* wavy = std::get_if<WavyFriction>(&input)) return *wavy;
  if (const auto* rough = std::get_if<RoughFriction>(&input)) return *rough;
  return std::get<FrictionTable>(friction.form());
}

DesignCase::Profile DesignCase::varied_profile() const {
  const auto* wavy = std::get_if<WavyFriction>(&profile_);
  if (!wavy) return profile_;
  WavyFriction varied = *wavy;
  varied.mu0 = at(DesignParameter::mu0).number;
  if (has(DesignParameter::reference)) varied.reference = at(DesignParameter::reference).number;
  if (has(DesignParameter::wavelength))
    varied.waves.front() = {at(DesignParameter::amplitude).number, at(DesignParameter::wavelength).number,
                            at(DesignParameter::phase).number};
  return varied;
}

bool DesignCase::has(DesignParameter parameter) const { return at(parameter).exists; }

double DesignCase::value(DesignParameter parameter) const {
  if (!has(parameter))
    throw InputError({.file = input_->source,
                      .field = std::string(described(parameter).name),
                      .expected = "a number that the case has and that can be varied",
                      .found = "none"});
  return at(parameter).number;
}

void DesignCase::set(DesignParameter parameter, double value) {
  this->value(parameter);
  const DesignParameterName& known = described(parameter);
  if (!is_within(known, value))
    throw InputError({.field = std::string(known.name),
                      .expected = words_of_range(known),
                      .found = readable(value, shown_as(known.kind))});
  at(parameter).number = value;
}

// None if the case has none.
std::optional<Section> DesignCase::section() const {
  if (has(DesignParameter::diameter)) return RoundSection{at(DesignParameter::diameter).number};
  if (has(DesignParameter::height))
    return RectangularSection{at(DesignParameter::width).number, at(DesignParameter::height).number};
  return reduced() ? std::nullopt : input_->specimen->section;
}

double DesignCase::bending_stiffness() const {
  if (has(DesignParameter::modulus)) return at(DesignParameter::modulus).number * second_moment(*section());
  return bending_stiffness_;
}

std::optional<SurfaceStrain> DesignCase::surface(const Scales& scales) const {
  const auto section = reduced() ? input_->specimen->section : this->section();
  return section ? std::optional(SurfaceStrain(*section, scales)) : std::nullopt;
}

// None if they are out of what a computer can hold.
std::optional<Scales> DesignCase::scales() const {
  try {
    return Scales(has(DesignParameter::span) ? at(DesignParameter::span).number : span_, bending_stiffness());
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

DesignRefusal DesignCase::refusal(DesignFault fault, DesignParameter parameter, std::string expected) const {
  const DesignParameterName& known = described(parameter);
  return {fault, InputError({.field = std::string(known.name),
                             .expected = std::move(expected),
                             .found = has(parameter) ? readable(at(parameter).number, shown_as(known.kind))
                                                     : "what the case has"})};
}

std::optional<DesignRefusal> DesignCase::fault_of_specimen() const {
  const auto section = this->section();
  if (!section) return std::nullopt;
  const double thickness = depth(*section);
  const double span = at(DesignParameter::span).number;
  if (thickness < thickest * span) return std::nullopt;
  for (const auto parameter : {DesignParameter::diameter, DesignParameter::height})
    if (has(parameter))
      return refusal(
          DesignFault::impossible, parameter,
          fmt::format("less than a fifth of the span of {}, for beam theory to hold", readable(span, kind::length)));
  return refusal(DesignFault::impossible, DesignParameter::span,
                 fmt::format("more than five times the thickness of {}, for beam theory to hold",
                             readable(thickness, kind::length)));
}

RigInput DesignCase::rig() const {
  RigInput rig = *input_->rig;
  if (has(DesignParameter::pin_friction)) rig.pin_friction = at(DesignParameter::pin_friction).number;
  return rig;
}

std::optional<double> DesignCase::pin_limit() const { return pin_limit_of(rig()); }

std::optional<DesignRefusal> DesignCase::fault_of_pins() const {
  if (rig().pins_turn()) return std::nullopt;
  return refusal(DesignFault::impossible, DesignParameter::pin_friction,
                 "less than the ratio of the radii of roller and pin");
}

std::optional<DesignRefusal> DesignCase::fault_of_loading(const Scales& scales) const {
  const double travel = scales.reduced_length(at(DesignParameter::travel).number);
  const double stiffness =
      scales.reduced_stiffness(with_supports(at(DesignParameter::stiffness).number, support_compliance_));
  const std::string span = readable(scales.span(), shown_as(kind::length));
  if (!(travel <= farthest_reduced))
    return refusal(DesignFault::not_computable, DesignParameter::travel,
                   fmt::format("at most {:g} spans of {}", farthest_reduced, span));
  if (!(travel >= nearest_reduced))
    return refusal(DesignFault::not_computable, DesignParameter::travel,
                   fmt::format("at least {:g} spans of {}", nearest_reduced, span));
  if (!(travel / (1 + 48 / stiffness) >= nearest_reduced))
    return refusal(DesignFault::impossible, DesignParameter::stiffness,
                   fmt::format("a rig that bends the specimen by at least {:g} spans", nearest_reduced));
  const double step = scales.reduced_length(at(DesignParameter::step).number);
  if (!std::isfinite(step) || (step > 0 && travel / step > most_readings))
    return refusal(
        DesignFault::not_computable, DesignParameter::step,
        fmt::format("0, or a step of at least {:g} of the travel, which a computer can hold", 1 / most_readings));
  return std::nullopt;
}

std::optional<DesignRefusal> DesignCase::fault_of_roughness(const Profile& profile, const Scales& scales,
                                                            double S_max) const {
  if (const auto* table = std::get_if<FrictionTable>(&profile)) {
    const double S_last = table->S.back() * (span_ / scales.span());
    if (S_last > 1 && std::isfinite(S_last)) return std::nullopt;
    return refusal(DesignFault::impossible, DesignParameter::span,
                   "a span that is less than the last length of the friction table");
  }
  if (const auto* rough = std::get_if<RoughFriction>(&profile)) {
    if ((S_max - 1) / scales.reduced_length(rough->correlation_length) <= most_correlations) return std::nullopt;
    return refusal(DesignFault::not_computable, DesignParameter::travel,
                   fmt::format("at most {:.1e} correlation lengths along the specimen", most_correlations));
  }
  const auto& wavy = std::get<WavyFriction>(profile);
  if (wavy.reference)
    if (auto fault = misplaced(*input_, *wavy.reference, scales))
      return DesignRefusal{DesignFault::impossible, InputError(*std::move(fault))};
  const auto is_fine = [&](const WaveInput& wave) {
    const double period = 2 * scales.reduced_length(wave.wavelength);
    return std::isfinite(period) && period >= finest_period && (S_max - 1) / period <= most_periods;
  };
  if (std::all_of(wavy.waves.begin(), wavy.waves.end(), is_fine)) return std::nullopt;
  return refusal(DesignFault::not_computable, DesignParameter::wavelength,
                 fmt::format("at most {:.0e} periods along the specimen", most_periods));
}

// Once its roughness is without fault.
Friction DesignCase::friction(const Profile& profile, const Scales& scales, double S_max) const {
  if (const auto* table = std::get_if<FrictionTable>(&profile)) {
    FrictionTable scaled = *table;
    for (double& S : scaled.S) S *= span_ / scales.span();
    return Friction::table(std::move(scaled));
  }
  if (const auto* rough = std::get_if<RoughFriction>(&profile))
    return Friction::rough(rough->mu0, rough->rms, scales.reduced_length(rough->correlation_length), rough->seed,
                           S_max);
  const auto& wavy = std::get<WavyFriction>(profile);
  FrictionWaves waves{wavy.mu0, wavy.drift * scales.span(), {}};
  if (wavy.reference) waves.S_reference = scales.reduced_length(*wavy.reference);
  waves.terms.reserve(wavy.waves.size());
  for (const WaveInput& wave : wavy.waves)
    waves.terms.push_back({wave.amplitude, scales.reduced_length(wave.wavelength), wave.phase});
  return Friction::waves(std::move(waves));
}

double DesignCase::nose_curvature(const Scales& scales) const {
  return nose_curvature_of(*input_, reduced() ? input_->specimen->section : section(), scales);
}

std::variant<PlannedDesign, DesignRefusal> DesignCase::plan() const {
  if (auto fault = fault_of_specimen()) return *std::move(fault);
  if (auto fault = fault_of_pins()) return *std::move(fault);
  const auto units = scales();
  if (!units)
    return refusal(DesignFault::not_computable, DesignParameter::span,
                   "a bending stiffness and a span that a computer can hold");
  if (auto fault = fault_of_loading(*units)) return *std::move(fault);
  const double travel = units->reduced_length(at(DesignParameter::travel).number);
  const double S_max = longest_at_stage(travel);
  const double reach = one_sided_reach(*input_, S_max);
  Fibre fibre;
  try {
    fibre = fibre_of(*input_, reduced() ? input_->specimen->section : section(), *units);
  } catch (const InputError& error) {
    return DesignRefusal{DesignFault::not_computable, error};
  }
  const auto of_support = [&](const Profile& profile,
                              const FrictionProfileInput& input) -> std::variant<Friction, DesignRefusal> {
    if (auto fault = fault_of_roughness(profile, *units, reach)) return *std::move(fault);
    Friction along = friction(profile, *units, reach);
    if (auto fault = uncovered(*input_, input, along, fibre, *units, reach))
      return DesignRefusal{DesignFault::not_computable, InputError(*std::move(fault))};
    return on_pins(pin_limit(), std::move(along), reach);
  };
  auto first = of_support(varied_profile(), *input_->friction->profile);
  if (auto* refused = std::get_if<DesignRefusal>(&first)) return std::move(*refused);
  SupportFrictions supports{std::get<Friction>(std::move(first)), std::nullopt};
  if (other_) {
    auto other = of_support(*other_, input_->friction->other->profile);
    if (auto* refused = std::get_if<DesignRefusal>(&other)) return std::move(*refused);
    supports.other = std::get<Friction>(std::move(other));
  }
  std::optional<Friction> along;
  try {
    along = together(*input_, std::move(supports), fibre, *units, S_max);
  } catch (const InputError& error) {
    return DesignRefusal{DesignFault::not_computable, error};
  }
  PlannedDesign planned{
      {*std::move(along),
       {units->reduced_stiffness(with_supports(at(DesignParameter::stiffness).number, support_compliance_)),
        std::move(fibre)},
       travel,
       units->reduced_length(at(DesignParameter::step).number)},
      {*units, surface(*units)}};
  planned.design.breaking_curvature = breaking_curvature_of(*input_->specimen, planned.units.surface);
  return planned;
}

PlannedDesign DesignCase::planned() const {
  const auto planned = plan();
  if (const auto* refused = std::get_if<DesignRefusal>(&planned)) throw refused->error;
  return std::get<PlannedDesign>(planned);
}

}  // namespace flexslip
