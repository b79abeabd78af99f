#include "case/problem.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "contact/build_up.h"
#include "contact/capped.h"
#include "contact/over_rollers.h"
#include "data/names.h"
#include "fibre/elastica.h"
#include "inference/analysis.h"
#include "io/quantity.h"
#include "io/table.h"

namespace flexslip {
namespace {

std::string readable_length(const Case& input, double length) { return readable(length, kind_in(input, kind::length)); }

// What the case says of the bending stiffness, if it says something.
std::optional<BendingStiffnessUsed> stated_stiffness(const Case& input) {
  if (!input.specimen) return std::nullopt;
  const auto& rigidity = input.specimen->rigidity;
  const auto* modulus = std::get_if<Modulus>(&rigidity);
  const StatedStiffness& estimate = modulus ? modulus->estimate : std::get<BendingStiffness>(rigidity).estimate;
  const auto* known = std::get_if<Known>(&estimate);
  if (!known) return std::nullopt;
  const bool has_error = known->uncertainty > 0;
  constexpr double most_error = 0.3;  // beyond it the fit would be that of another specimen
  if (known->uncertainty > most_error * known->value)
    throw wrong_value(input, modulus ? "specimen.modulus" : "specimen.bending_stiffness",
                      "an uncertainty of at most 30 % of the value",
                      fmt::format("{:.0f} %", 100 * known->uncertainty / known->value),
                      "write \"fit\" to have it found from the initial slope");
  BendingStiffnessUsed used{known->value, has_error ? known->uncertainty / known->value : usual_stiffness_error,
                            has_error ? StiffnessSource::stated : StiffnessSource::assumed_error};
  if (!modulus) return used;
  if (!input.specimen->section) throw missing(input, "specimen.diameter");
  used.value *= second_moment(*input.specimen->section);
  return used;
}

void require_slender(const Case& input) {
  if (!input.specimen || !input.specimen->section) return;
  const double thickness = depth(*input.specimen->section);
  const double span = span_of(input);
  if (thickness < thickest * span) return;
  throw wrong_value(
      input, depth_key(*input.specimen->section),
      fmt::format("less than a fifth of the span, {}", readable_length(input, span)), readable_length(input, thickness),
      "beam theory does not hold for a thicker specimen: check the units of both, or take flexslip modulus");
}

// Where a friction stands in a case.
struct Place {
  const Case& input;
  std::string section;  // "friction" or "friction.other"

  InputError fault(const InputFault& of) const {
    return wrong_value(input, section + "." + of.field, of.expected, of.found, of.remedy);
  }
};

Friction friction_from(const Place& place, const WavyFriction& wavy, const Scales& scales, double S_max) {
  const Case& input = place.input;
  FrictionWaves waves{wavy.mu0, wavy.drift * scales.span(), {}};
  if (wavy.reference) {
    if (const auto fault = misplaced(input, *wavy.reference, scales)) throw place.fault(*fault);
    waves.S_reference = scales.reduced_length(*wavy.reference);
  }
  for (std::size_t i = 0; i < wavy.waves.size(); ++i) {
    const WaveInput& wave = wavy.waves[i];
    waves.terms.push_back({wave.amplitude, scales.reduced_length(wave.wavelength), wave.phase});
    if ((S_max - 1) / (2 * waves.terms.back().wavelength) <= most_periods) continue;
    const bool is_sum = input.lines.contains(place.section + ".waves");
    throw place.fault({.field = is_sum ? fmt::format("waves[{}].wavelength", i + 1) : "wavelength",
                       .expected = fmt::format("at most {:.0e} periods along the specimen", most_periods),
                       .found = readable_length(input, wave.wavelength),
                       .remedy = "check its unit"});
  }
  return Friction::waves(std::move(waves));
}

Friction friction_from(const Place& place, const TabulatedFriction& tabulated, const Scales& scales, double) {
  const Case& input = place.input;
  const Table table =
      read_table(tabulated.file, {{tabulated.length, kind_in(input, kind::length)}, {tabulated.mu, kind::number}});
  const auto refuse = [&](std::size_t row, std::size_t column, std::string expected, double found, const Kind& kind) {
    const std::string& name = table.columns[column].name;
    throw InputError({.file = table.source,
                      .line = table.line_of(row),
                      .field = fmt::format("column {}", in_quotes(name)),
                      .expected = std::move(expected),
                      .found = readable(found, kind)});
  };
  FrictionTable friction;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double length = table.columns[0].values[row];
    const double mu = table.columns[1].values[row];
    if (row > 0 && !(length > table.columns[0].values[row - 1]))
      refuse(row, 0, "a length greater than that of the row before", length, kind_in(input, kind::length));
    if (mu < 0) refuse(row, 1, "friction of at least 0", mu, kind::number);
    friction.S.push_back(scales.reduced_length(length));
    friction.mu.push_back(mu);
  }
  if (!(friction.S.back() > 1))
    refuse(table.rows() - 1, 0,
           fmt::format("lengths between the supports, which grow from the span, {}",
                       readable_length(input, scales.span())),
           table.columns[0].values.back(), kind_in(input, kind::length));
  return Friction::table(std::move(friction));
}

Friction friction_from(const Place& place, const RoughFriction& rough, const Scales& scales, double S_max) {
  const double correlation_length = scales.reduced_length(rough.correlation_length);
  if (!((S_max - 1) / correlation_length <= most_correlations))
    throw place.fault({.field = "correlation_length",
                       .expected = fmt::format("at least {:.0e} of the length drawn in", 1 / most_correlations),
                       .found = readable_length(place.input, rough.correlation_length),
                       .remedy = "check its unit"});
  return Friction::rough(rough.mu0, rough.rms, correlation_length, rough.seed, S_max);
}

// All positions at which the stage turns, halts or ends, cycle by cycle.
std::vector<double> written_out(const TurningPoints& programme) {
  std::vector<double> turns{programme.positions.front()};
  turns.reserve(1 + programme.cycles * (programme.positions.size() - 1));
  for (std::uint64_t cycle = 0; cycle < programme.cycles; ++cycle)
    turns.insert(turns.end(), programme.positions.begin() + 1, programme.positions.end());
  return turns;
}

std::vector<double> stepped(const std::vector<double>& turns, double step) {
  std::vector<double> stages{turns.front()};
  for (std::size_t i = 1; i < turns.size(); ++i) {
    const double from = turns[i - 1];
    const double way = turns[i] - from;
    // The last step may be shorter; a remainder of 1e-9 of a step is rounding.
    const auto steps = static_cast<long>(std::ceil(std::abs(way) / step - 1e-9));
    for (long n = 1; n < steps; ++n) stages.push_back(from + std::copysign(static_cast<double>(n) * step, way));
    stages.push_back(turns[i]);
  }
  return stages;
}

StageProgramme programme_from(const Case& input, const TurningPoints& programme) {
  const auto& positions = programme.positions;
  const auto farthest = std::max_element(positions.begin(), positions.end());
  const std::string key = fmt::format("stage.program[{}]", farthest - positions.begin() + 1);
  if (!(*farthest >= nearest_reduced * span_of(input)))
    throw wrong_value(input, fmt::format("stage.program[{}]", positions.size()),
                      fmt::format("a position of at least {:g} spans", nearest_reduced),
                      readable_length(input, positions.back()));
  if (!(*farthest <= farthest_reduced * span_of(input)))
    throw wrong_value(input, key, fmt::format("a position within {:g} spans", farthest_reduced),
                      readable_length(input, *farthest), "check its unit");
  std::vector<double> turns = written_out(programme);
  if (!programme.step) return {std::move(turns), *farthest, false, false};
  return {stepped(turns, *programme.step), *farthest, true, false};
}

StageProgramme programme_from(const Case& input, const MeasuredProgramme& measured) {
  std::vector<WantedColumn> wanted{{measured.stage, kind_in(input, kind::length)}};
  if (measured.time) wanted.push_back({*measured.time, kind_in(input, kind::time)});
  Table table = read_table(measured.file, wanted, measured.decimal);
  const auto refuse = [&](std::size_t row, const Column& column, std::string expected, std::string found,
                          std::string remedy) {
    throw InputError({.file = table.source,
                      .line = table.line_of(row),
                      .field = fmt::format("column {}", in_quotes(column.name)),
                      .expected = std::move(expected),
                      .found = std::move(found),
                      .remedy = std::move(remedy)});
  };
  const Column& stage = table.columns.front();
  const double span = span_of(input);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double position = stage.values[row];
    if (position < 0)
      refuse(row, stage, "a stage position of at least 0, the contact", readable_length(input, position),
             "count the stage from where it touches the specimen, and leave out what comes before");
    if (!(position <= farthest_reduced * span))
      refuse(row, stage, fmt::format("a stage position within {:g} spans", farthest_reduced),
             readable_length(input, position), "check its unit");
    if (!measured.time || row == 0) continue;
    const Column& time = table.columns[1];
    if (time.values[row] < time.values[row - 1])
      refuse(row, time,
             fmt::format("a time not before that of the row before, {}",
                         readable(time.values[row - 1], kind_in(input, kind::time))),
             readable(time.values[row], kind_in(input, kind::time)), "sort the rows by time");
  }
  const auto farthest = std::max_element(stage.values.begin(), stage.values.end());
  if (!(*farthest >= nearest_reduced * span))
    refuse(static_cast<std::size_t>(farthest - stage.values.begin()), stage,
           fmt::format("a stage that moves to at least {:g} spans", nearest_reduced),
           readable_length(input, *farthest) + " as the farthest", "check the unit");
  const double reach = *farthest;
  return {std::move(table.columns.front().values), reach, true, true};
}

}  // namespace

std::string_view name_of(StiffnessSource source) {
  return name_in_order<StiffnessSource::mirror>(
      source, {"stated", "stated_without_uncertainty", "initial_slope", "mirror_symmetry"});
}

double span_of(const Case& input) {
  if (!input.rig) throw missing(input, "rig");
  if (!input.rig->span) throw missing(input, "rig.span");
  return *input.rig->span;
}

double load_train_stiffness_of(const Case& input) {
  if (!input.rig) throw missing(input, "rig");
  if (!input.rig->stiffness) throw missing(input, "rig.stiffness");
  return *input.rig->stiffness;
}

double support_compliance_of(const Case& input) {
  return input.rig && input.rig->support_stiffness ? 0.5 / *input.rig->support_stiffness : 0;
}

double rig_stiffness_of(const Case& input) {
  return with_supports(load_train_stiffness_of(input), support_compliance_of(input));
}

bool states_stiffness(const Case& input) { return stated_stiffness(input).has_value(); }

BendingStiffnessUsed bending_stiffness_of(const Case& input) {
  if (const auto stated = stated_stiffness(input)) return *stated;
  if (!input.specimen) throw missing(input, "specimen");
  throw missing(input, std::holds_alternative<Modulus>(input.specimen->rigidity) ? "specimen.modulus"
                                                                                 : "specimen.bending_stiffness");
}

BendingStiffnessUsed bending_stiffness_of(const Case& input, const Measurement& measurement) {
  if (const auto stated = stated_stiffness(input)) return *stated;
  const double span = span_of(input);
  const auto slope = stiffness_from_slope(measurement.record, span);
  if (!slope.found)
    throw InputError(
        {.file = measurement.file,
         .expected = "a force that rises from the contact in at least 5 rows, to tell the bending stiffness",
         .found = "none",
         .remedy = "write the modulus or bending_stiffness into [specimen]"});
  return {slope.value, slope.relative_error, StiffnessSource::initial_slope};
}

Scales scales_of(const Case& input, const BendingStiffnessUsed& stiffness) {
  const double span = span_of(input);
  require_slender(input);
  try {
    return {span, stiffness.value};
  } catch (const std::invalid_argument& error) {
    throw wrong_value(input, "specimen", "a bending stiffness and a span that a computer can hold", error.what());
  }
}

Fibre fibre_of(const Case& input, const std::optional<Section>& section, const Scales& scales) {
  if (input.rig->rollers == Rollers::loose)
    throw wrong_value(input, "rig.rollers", "rollers that hold the specimen by friction", "\"loose\"",
                      "see with flexslip simulate what it does on these, or write \"fixed\" or \"pinned\"");
  return Fibre(supports_of(input, section, scales));
}

Supports supports_of(const Case& input, const std::optional<Section>& section, const Scales& scales) {
  const RigInput& rig = *input.rig;
  const bool is_thick = section && rig.friction_at == FrictionAt::surface;
  const Supports supports{scales.reduced_length(rig.roller_radius.value_or(0)),
                          is_thick ? 0.5 * scales.reduced_length(depth(*section)) : 0};
  if (!(supports.radius + supports.half_depth < widest_supports))
    throw wrong_value(
        input, "rig.roller_radius",
        fmt::format("a radius, and half of a thickness, of less than {:g} spans together", widest_supports),
        fmt::format("{:g} and {:g} spans", supports.radius, supports.half_depth), "check their units, and the span");
  return supports;
}

Fibre fibre_of(const Case& input, const Scales& scales) {
  return fibre_of(input, input.specimen ? input.specimen->section : std::nullopt, scales);
}

Rig rig_of(const Case& input, const Scales& scales) {
  return {scales.reduced_stiffness(rig_stiffness_of(input)), fibre_of(input, scales)};
}

double breaking_curvature_of(const SpecimenInput& specimen, const std::optional<SurfaceStrain>& surface) {
  if (surface && specimen.strain_at_break) return surface->curvature_at_strain(*specimen.strain_at_break);
  if (surface && specimen.strength) return surface->curvature_at_stress(*specimen.strength);
  return std::numeric_limits<double>::infinity();
}

std::optional<InputFault> misplaced(const Case& input, double reference, const Scales& scales) {
  constexpr double rounding = 1e-3;  // of the four digits that a length is shown in
  const double S = scales.reduced_length(reference);
  if (S >= 1 - rounding && S <= farthest_reduced) return std::nullopt;
  return InputFault{.field = "reference",
                    .expected = fmt::format("a length between the supports, from the span, {}, to {:g} spans",
                                            readable_length(input, scales.span()), farthest_reduced),
                    .found = readable_length(input, reference),
                    .remedy = "check its unit"};
}

std::string friction_limit(const Fibre& fibre) {
  return fmt::format("friction of at most {:g}{}", fibre.most_friction(), fibre.on_edges() ? "" : " at the surface");
}

// Where friction changes so fast along the specimen that the point that touches would jump.
std::optional<InputFault> too_steep(const Case& input, const FrictionProfileInput& profile, const Friction& kinetic,
                                    const Fibre& fibre, const Scales& scales, double S_max) {
  const double steepest = kinetic.steepest();
  if (steepest == 0 || fibre.on_edges()) return std::nullopt;
  const double limit = steepest_followed(fibre, kinetic.most_up_to(S_max), S_max);
  if (steepest < limit) return std::nullopt;
  const auto* waves = std::get_if<FrictionWaves>(&kinetic.form());
  const bool has_rollers = fibre.supports().radius > 0;
  return InputFault{
      .field = !waves                 ? std::holds_alternative<RoughFriction>(profile) ? "correlation_length" : "file"
               : waves->terms.empty() ? "drift"
               : input.friction->model == FrictionModel::sinusoid ? "wavelength"
                                                                  : "waves",
      .expected = fmt::format(
          "friction that changes by less than {} with the length between the {}: on these, the point "
          "that touches moves with friction, and would jump",
          readable(limit / scales.span(), kind_in(input, kind::inverse_length)), has_rollers ? "contacts" : "supports"),
      .found = fmt::format("up to {:.3g} times as much", steepest / limit),
      .remedy = fmt::format("write a profile that is less steep, {}",
                            has_rollers ? "or a smaller roller_radius" : "or [rig] friction_at = \"axis\"")};
}

std::optional<InputFault> uncovered(const Case& input, const FrictionProfileInput& profile, const Friction& kinetic,
                                    const Fibre& fibre, const Scales& scales, double S_max) {
  const double most = kinetic.most_up_to(S_max);
  const double limit = fibre.most_friction();
  if (most <= limit) return too_steep(input, profile, kinetic, fibre, scales, S_max);
  InputFault fault{.expected = friction_limit(fibre), .found = fmt::format("{:g}", most)};
  const auto* waves = std::get_if<FrictionWaves>(&kinetic.form());
  if (!waves) {
    const bool is_rough = std::holds_alternative<RoughFriction>(profile);
    fault.field = is_rough ? "mu0" : "file";
    fault.expected += is_rough ? ", its roughness included" : "";
    fault.remedy = is_rough ? "write a smaller mu0 or rms" : "check the column of friction";
    return fault;
  }
  double without_drift = waves->mu0;
  for (const Sinusoid& term : waves->terms) without_drift += waves->mu0 * term.amplitude;
  fault.expected += ", its waves and drift included";
  if (!(without_drift <= limit)) {
    fault.field = "mu0";
    fault.remedy = "write a smaller one";
    return fault;
  }
  const auto length = [&](double S) { return readable_length(input, scales.physical_length(S)); };
  fault.field = "drift";
  fault.found = fmt::format("{}, which brings it from {:g} at {} to {:g} at {}",
                            readable(waves->drift / scales.span(), kind_in(input, kind::inverse_length)), without_drift,
                            length(waves->S_reference), most, length(waves->drift > 0 ? S_max : 1));
  const bool is_at_span = waves->S_reference == 1;
  fault.remedy = is_at_span ? "check its unit, or go less far" : "check its unit, and that of reference";
  return fault;
}

Friction on_pins(const RigInput& rig, Friction friction, double S_max) {
  if (rig.rollers != Rollers::pinned) return friction;
  const double cap = friction_of_pins(rig.pin_friction, rig.pin_radius, *rig.roller_radius);
  return capped(friction, cap, S_max);
}

SupportFrictions frictions_of(const Case& input, const Fibre& fibre, const Scales& scales, double S_max) {
  if (!input.friction) throw missing(input, "friction");
  if (!input.friction->model) throw missing(input, "friction.model");
  if (input.friction->model == FrictionModel::roughness)
    throw wrong_value(input, "friction.model", "a model to compute with", "'roughness', which is fitted",
                      "write the one to compute with, such as model = \"constant\", or \"rough\" with its parameters");
  if (!input.friction->profile)
    throw missing(input, input.friction->model == FrictionModel::table ? "friction.file" : "friction.mu0");
  const double reach = one_sided_reach(input, S_max);
  const auto of_support = [&](const Place& place, const FrictionProfileInput& profile) {
    Friction friction =
        std::visit([&](const auto& form) { return friction_from(place, form, scales, reach); }, profile);
    if (const auto fault = uncovered(input, profile, friction, fibre, scales, reach)) throw place.fault(*fault);
    return on_pins(*input.rig, std::move(friction), reach);
  };
  SupportFrictions supports{of_support({input, "friction"}, *input.friction->profile), std::nullopt};
  if (const auto& other = input.friction->other) supports.other = of_support({input, "friction.other"}, other->profile);
  return supports;
}

Friction together(const Case& input, SupportFrictions supports, const Fibre& fibre, const Scales& scales,
                  double S_max) {
  const double build_up = scales.reduced_length(input.friction->build_up_length);
  if (build_up > 0 && fibre.supports().radius > 0)
    throw wrong_value(input, "friction.build_up_length", "none on rollers",
                      readable_length(input, input.friction->build_up_length), "delete it, or roller_radius");
  if (build_up > 0) try {
      return Friction::on_a_way(std::make_shared<const BuildUp>(std::move(supports.first), build_up, S_max));
    } catch (const std::invalid_argument& error) {
      throw wrong_value(input, "friction.build_up_length",
                        fmt::format("at least {} of such a profile",
                                    readable_length(input, scales.physical_length(2e-5 * (S_max - 1)))),
                        readable_length(input, input.friction->build_up_length),
                        fmt::format("delete it ({})", error.what()));
    }
  if (!supports.other) return std::move(supports.first);
  return Friction::on_two_supports(std::move(supports.first), *std::move(supports.other), S_max);
}

Friction friction_of(const Case& input, const Fibre& fibre, const Scales& scales, double S_max) {
  return together(input, frictions_of(input, fibre, scales, S_max), fibre, scales, S_max);
}

double one_sided_reach(const Case& input, double S_max) {
  return input.friction && input.friction->other ? 1 + 2 * (S_max - 1) : S_max;
}

StageProgramme programme_of(const Case& input) {
  if (!input.stage) throw missing(input, "stage");
  return std::visit([&](const auto& programme) { return programme_from(input, programme); }, input.stage->programme);
}

BendingTest bending_test_of(const Case& input, const Scales& scales, double farthest) {
  const Rig rig = rig_of(input, scales);
  if (!(farthest / (1 + 48 / rig.stiffness) >= nearest_reduced))
    throw wrong_value(input, "rig.stiffness",
                      fmt::format("a rig that bends the specimen by at least {:g} spans", nearest_reduced),
                      readable(load_train_stiffness_of(input), kind_in(input, kind::stiffness)), "check its unit");
  const double S_max = longest_at_stage(farthest);
  Friction kinetic = friction_of(input, rig.fibre, scales, S_max);
  const double excess = input.friction->static_excess;
  const double most = kinetic.most_up_to(S_max) + excess;
  if (excess > 0 && most > rig.fibre.most_friction())
    throw wrong_value(input, "friction.static_excess", "static " + friction_limit(rig.fibre),
                      fmt::format("{:g}, which brings it to {:g}", excess, most), "write a smaller one");
  if (kinetic.walk() && rig.fibre.supports().radius > 0)
    throw wrong_value(input, "rig.roller_radius", "edges, where [friction.other] says that the supports are not alike",
                      "rollers", "delete it, or [friction.other]");
  if (excess > 0 && rig.fibre.supports().radius > 0)
    throw wrong_value(input, "friction.static_excess", "no static friction above the kinetic one, on rollers",
                      fmt::format("{:g}", excess), "delete it, or roller_radius");
  if (kinetic.walk() && input.stage && input.stage->snaps == SnapRest::overshoot)
    throw wrong_value(input, "stage.snaps",
                      "snaps that rest at the nearest stable state, on two supports that are not alike",
                      "\"overshoot\"", "delete it, or [friction.other]");
  if (!kinetic.lets_stick() && input.stage && input.stage->snaps == SnapRest::overshoot)
    throw wrong_value(input, "stage.snaps", "snaps that rest at the nearest stable state, where friction builds up",
                      "\"overshoot\"", "delete it, or [friction] build_up_length");
  if (!kinetic.lets_stick() && input.specimen && !input.specimen->cracks.empty())
    throw wrong_value(input, "specimen.cracks", "a specimen without cracks, where friction builds up",
                      fmt::format("{} of them", input.specimen->cracks.size()),
                      "delete them, or [friction] build_up_length");
  return {{std::move(kinetic), Friction::constant(excess)},
          rig,
          input.stage ? input.stage->snaps : SnapRest::nearest_stable};
}

double periods_up_to(const Friction& friction, double stage) {
  constexpr double scales_a_period = 4;
  const double drawn_in = 2.5 * stage * stage;  // S - 1, a deflection as far as the stage
  return drawn_in / (scales_a_period * friction.smooth_scale());
}

std::optional<SurfaceStrain> surface_of(const Case& input, const Scales& scales) {
  const auto& section = input.specimen->section;
  return section ? std::optional(SurfaceStrain(*section, scales)) : std::nullopt;
}

double nose_curvature_of(const Case& input, const std::optional<Section>& section, const Scales& scales) {
  if (!input.rig || !input.rig->nose_radius) return std::numeric_limits<double>::infinity();
  return 1 / scales.reduced_length(*input.rig->nose_radius + (section ? 0.5 * depth(*section) : 0));
}

std::vector<Crack> cracks_of(const Case& input, const Scales& scales) {
  std::vector<Crack> cracks;
  for (const CrackInput& crack : input.specimen->cracks)
    cracks.push_back({scales.reduced_length(crack.deflection), crack.loss});
  return cracks;
}

MeasurementErrors errors_of(const Measurement& measurement, const BendingStiffnessUsed& stiffness,
                            const Scales& scales) {
  return {.force = scales.reduced_force(measurement.force_noise),
          .bending_stiffness = stiffness.relative_error,
          .contact = scales.reduced_length(measurement.contact_error)};
}

}  // namespace flexslip
