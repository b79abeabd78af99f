#include "case/support_frictions.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "case/stage_programme.h"
#include "case/surface_study.h"
#include "contact/build_up.h"
#include "contact/over_rollers.h"
#include "fibre/elastica.h"
#include "instruments/trace_file.h"
#include "io/quantity.h"
#include "io/table.h"
#include "surface/slope_friction.h"

namespace flexslip {
namespace {

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
      refuse(row, 0, "a length greater than in the previous row", length, kind_in(input, kind::length));
    if (mu < 0) refuse(row, 1, "friction of at least 0", mu, kind::number);
    friction.S.push_back(scales.reduced_length(length));
    friction.mu.push_back(mu);
  }
  if (!(friction.S.back() > 1))
    refuse(table.rows() - 1, 0,
           fmt::format("lengths between the supports, which grow from the span of {}",
                       readable_length(input, scales.span())),
           table.columns[0].values.back(), kind_in(input, kind::length));
  return Friction::table(std::move(friction));
}

Friction friction_from(const Place& place, const RoughFriction& rough, const Scales& scales, double S_max) {
  const double correlation_length = scales.reduced_length(rough.correlation_length);
  if (!((S_max - 1) / correlation_length <= most_correlations))
    throw place.fault({.field = "correlation_length",
                       .expected = fmt::format("at least {:.0e} of the length pulled in", 1 / most_correlations),
                       .found = readable_length(place.input, rough.correlation_length),
                       .remedy = "check its unit"});
  return Friction::rough(rough.mu0, rough.rms, correlation_length, rough.seed, S_max);
}

// Between the heights of the trace, from midspan; the flat surface's beyond its ends.
Friction friction_from(const Place& place, const SurfaceFriction& surface, const Scales& scales, double) {
  const Case& input = place.input;
  const Kind length = kind_in(input, kind::length);
  TraceOptions options;
  options.position = surface.position;
  options.height = surface.height;
  options.step = surface.trace_step;
  const TraceFile file = read_trace(surface.trace, options, length);
  const double radius = surface.edge_radius.value_or(input.rig->roller_radius.value_or(0));
  PreparedTrace ready = prepared(file.sampled, surface.level, surface.cutoff, radius);
  if (const auto fault = too_steep(ready.path, ready.trace.step, surface.mu0, most_apparent, false))
    throw refusal_of(*fault, ready.trace, surface.mu0, file.source, length);
  if (surface.direction == TraceDirection::inwards) std::reverse(ready.path.begin(), ready.path.end());
  if (const auto fault = too_steep(ready.path, ready.trace.step, surface.mu0, most_apparent, false))
    throw refusal_of(*fault, ready.trace, surface.mu0, file.source, length);
  const double begin = surface.trace_begin.value_or(0.5 * scales.span());
  const double step = ready.trace.step, extent = step * static_cast<double>(ready.path.size() - 1);
  const double first = surface.direction == TraceDirection::inwards ? begin - extent : begin;
  if (!(first + extent > 0.5 * scales.span()))
    throw place.fault({.field = "trace_begin",
                       .expected = fmt::format("a trace that reaches beyond the support, {} from midspan",
                                               readable_length(input, 0.5 * scales.span())),
                       .found = fmt::format("one that ends at {}", readable_length(input, first + extent)),
                       .remedy = "check its unit, that of the trace, and direction"});
  FrictionTable table;
  const auto add = [&](double s, double mu) {
    const double S = 2 * scales.reduced_length(s);
    if (!(S > 0)) return;
    table.S.push_back(S);
    table.mu.push_back(mu);
  };
  const SlopeFriction shown = friction_of_heights(ready.path, step, surface.mu0);
  add(first - 0.5 * step, surface.mu0);
  for (std::size_t i = 0; i < shown.mu.size(); ++i) add(first + step * (static_cast<double>(i) + 0.5), shown.mu[i]);
  add(first + extent + 0.5 * step, surface.mu0);
  return Friction::table(std::move(table));
}

}  // namespace

std::optional<InputFault> misplaced(const Case& input, double reference, const Scales& scales) {
  constexpr double rounding = 1e-3;  // of the four digits that a length is shown in
  const double S = scales.reduced_length(reference);
  if (S >= 1 - rounding && S <= farthest_reduced) return std::nullopt;
  return InputFault{.field = "reference",
                    .expected = fmt::format("a length between the supports, from the span of {} to {:g} spans",
                                            readable_length(input, scales.span()), farthest_reduced),
                    .found = readable_length(input, reference),
                    .remedy = "check its unit"};
}

std::string friction_limit(const Fibre& fibre) {
  return fmt::format("friction of at most {:g}{}", fibre.most_friction(), fibre.on_edges() ? "" : " at the surface");
}

namespace {

// The friction of a support as asked for, the profile it was made from, and the fibre that is to meet it at lengths up to S_max [L].
struct Asked {
  const Case& input;
  const FrictionProfileInput& profile;
  const Friction& kinetic;
  const Fibre& fibre;
  const Scales& scales;
  double S_max;

  // [1/L] How steep it may be.
  double limit_of(const Fibre& on) const { return steepest_followed(on, kinetic.most_up_to(S_max), S_max); }
  std::string length(double reduced) const { return readable_length(input, scales.physical_length(reduced)); }
};

// [L] The greatest radius of rollers on which so steep a profile is followed; none where it is not on edges either.
std::optional<double> widest_that_follows(const Asked& asked) {
  const Supports& supports = asked.fibre.supports();
  const auto follows = [&](double radius) {
    return asked.kinetic.steepest() < asked.limit_of(Fibre({radius, supports.half_depth}));
  };
  if (!follows(0)) return std::nullopt;
  double good = 0, bad = supports.radius;
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (good + bad);
    (follows(middle) ? good : bad) = middle;
  }
  return good;
}

// What would be followed instead of a profile that is so many times too steep.
std::string less_steep(const Asked& asked, double excess) {
  constexpr double rounding = 1e-3;  // of the four digits that a quantity is shown in
  const double enough = excess * (1 + rounding);
  const auto* waves = std::get_if<FrictionWaves>(&asked.kinetic.form());
  std::string words = "write a profile that is less steep";
  if (const auto* rough = std::get_if<RoughFriction>(&asked.profile))
    words = fmt::format("write at least {}", readable_length(asked.input, rough->correlation_length * enough));
  else if (waves && waves->terms.empty())
    words = "write a smaller one";
  else if (waves && waves->terms.size() == 1 && waves->drift == 0)
    words = fmt::format("write a wavelength of at least {}", asked.length(waves->terms.front().wavelength * enough));
  if (asked.fibre.supports().radius == 0) return words + ", or [rig] friction_at = \"axis\"";
  const auto widest = widest_that_follows(asked);
  if (!widest) return words;
  return fmt::format("{}, or a roller_radius of at most {}", words, asked.length(*widest * (1 - rounding)));
}

// Where friction changes so fast along the specimen that the point that touches would jump.
std::optional<InputFault> too_steep(const Asked& asked) {
  const auto& [input, profile, kinetic, fibre, scales, S_max] = asked;
  const double steepest = kinetic.steepest();
  if (steepest == 0 || fibre.on_edges()) return std::nullopt;
  const double limit = asked.limit_of(fibre);
  if (steepest < limit) return std::nullopt;
  const auto* waves = std::get_if<FrictionWaves>(&kinetic.form());
  return InputFault{.field = !waves ? std::holds_alternative<RoughFriction>(profile)     ? "correlation_length"
                                      : std::holds_alternative<SurfaceFriction>(profile) ? "trace"
                                                                                         : "file"
                             : waves->terms.empty()                             ? "drift"
                             : input.friction->model == FrictionModel::sinusoid ? "wavelength"
                                                                                : "waves",
                    .expected = fmt::format(
                        "friction that changes by less than {} with the length between the {}, as the point of contact "
                        "moves with friction on these and would jump",
                        readable(limit / scales.span(), kind_in(input, kind::inverse_length)),
                        fibre.supports().radius > 0 ? "contacts" : "supports"),
                    .found = fmt::format("up to {:.5g} times as much", steepest / limit),
                    .remedy = less_steep(asked, steepest / limit)};
}

}  // namespace

std::optional<InputFault> uncovered(const Case& input, const FrictionProfileInput& profile, const Friction& kinetic,
                                    const Fibre& fibre, const Scales& scales, double S_max) {
  const double most = kinetic.most_up_to(S_max);
  const double limit = fibre.most_friction();
  const Asked asked{input, profile, kinetic, fibre, scales, S_max};
  if (most <= limit) return too_steep(asked);
  InputFault fault{.expected = friction_limit(fibre), .found = fmt::format("{:g}", most)};
  const auto* waves = std::get_if<FrictionWaves>(&kinetic.form());
  if (!waves) {
    const bool is_rough = std::holds_alternative<RoughFriction>(profile);
    const bool is_surface = std::holds_alternative<SurfaceFriction>(profile);
    fault.field = is_rough || is_surface ? "mu0" : "file";
    fault.expected += is_rough ? ", its roughness included" : is_surface ? ", on the slopes of its trace" : "";
    fault.remedy = is_rough     ? "write a smaller mu0 or rms"
                   : is_surface ? "write a smaller mu0, or a cutoff"
                                : "check the column of friction";
    return fault;
  }
  double without_drift = waves->mu0;
  for (const Sinusoid& term : waves->terms) without_drift += waves->mu0 * term.amplitude;
  fault.expected += ", its waves and drift included";
  if (!(without_drift <= limit)) {
    fault.field = "mu0";
    fault.remedy = "write a smaller mu0";
    return fault;
  }
  fault.field = "drift";
  fault.found = fmt::format("{}, which takes friction from {:g} at {} to {:g} at {}",
                            readable(waves->drift / scales.span(), kind_in(input, kind::inverse_length)), without_drift,
                            asked.length(waves->S_reference), most, asked.length(waves->drift > 0 ? S_max : 1));
  const bool is_at_span = waves->S_reference == 1;
  fault.remedy = is_at_span ? "check its unit, or bend less far" : "check its unit, and that of reference";
  return fault;
}

std::optional<double> pin_limit_of(const RigInput& rig) {
  if (rig.rollers != Rollers::pinned) return std::nullopt;
  return friction_of_pins(rig.pin_friction, rig.pin_radius, *rig.roller_radius);
}

Friction on_pins(const std::optional<double>& pin_limit, Friction friction, double S_max) {
  return pin_limit ? capped(friction, *pin_limit, S_max) : friction;
}

SupportFrictions frictions_of(const Case& input, const Fibre& fibre, const Scales& scales, double S_max) {
  if (!input.friction) throw missing(input, "friction");
  if (!input.friction->model) throw missing(input, "friction.model");
  if (input.friction->model == FrictionModel::roughness)
    throw wrong_value(input, "friction.model", "a model to compute with", "'roughness', which can only be fitted",
                      "write a model to compute with, such as model = \"constant\", or \"rough\" with its parameters");
  if (!input.friction->profile)
    throw missing(input, input.friction->model == FrictionModel::table ? "friction.file" : "friction.mu0");
  const double reach = one_sided_reach(input, S_max);
  const auto of_support = [&](const Place& place, const FrictionProfileInput& profile) {
    Friction friction =
        std::visit([&](const auto& form) { return friction_from(place, form, scales, reach); }, profile);
    if (const auto fault = uncovered(input, profile, friction, fibre, scales, reach)) throw place.fault(*fault);
    return on_pins(pin_limit_of(*input.rig), std::move(friction), reach);
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
                        fmt::format("at least {} with such a friction profile",
                                    readable_length(input, scales.physical_length(2e-5 * (S_max - 1)))),
                        readable_length(input, input.friction->build_up_length),
                        fmt::format("delete it ({})", error.what()));
    }
  if (!supports.other) return std::move(supports.first);
  if (fibre.supports().radius > 0)
    throw wrong_value(input, "rig.roller_radius", "edges, as [friction.other] says that the supports differ", "rollers",
                      "delete it, or [friction.other]");
  return Friction::on_two_supports(std::move(supports.first), *std::move(supports.other), S_max);
}

Friction friction_of(const Case& input, const Fibre& fibre, const Scales& scales, double S_max) {
  return together(input, frictions_of(input, fibre, scales, S_max), fibre, scales, S_max);
}

bool climbs_surface(const Case& input) {
  if (!input.friction || !input.friction->profile) return false;
  const auto& other = input.friction->other;
  return std::holds_alternative<SurfaceFriction>(*input.friction->profile) ||
         (other && std::holds_alternative<SurfaceFriction>(other->profile));
}

Friction on_both_ways(const Case& input, const Friction& inwards, const Fibre& fibre, const Scales& scales) {
  const FrictionInput& friction = *input.friction;
  const auto refuse = [&](std::string_view key, const std::string& found) {
    throw wrong_value(input, key, "a surface on two equal edges, as the stage turns back", found,
                      "delete it, or let the stage only load: a surface has another friction on the way back");
  };
  if (friction.other) refuse("friction.other", "another support");
  if (fibre.supports().radius > 0) refuse("rig.roller_radius", "rollers");
  if (friction.build_up_length > 0)
    refuse("friction.build_up_length", readable_length(input, friction.build_up_length));
  if (friction.static_excess > 0) refuse("friction.static_excess", fmt::format("{:g}", friction.static_excess));
  if (input.stage->snaps == SnapRest::overshoot) refuse("stage.snaps", "\"overshoot\"");
  FrictionTable out = std::get<FrictionTable>(inwards.form());
  const double mu0 = std::get<SurfaceFriction>(*friction.profile).mu0;
  for (std::size_t i = 0; i < out.mu.size(); ++i) {
    out.mu[i] = friction_on_the_way_back(out.mu[i], mu0);
    if (out.mu[i] > 0 && out.mu[i] <= fibre.most_friction()) continue;
    throw wrong_value(
        input, "friction.trace",
        fmt::format("slopes below the friction of {:g} in both directions, as the stage turns back", mu0),
        fmt::format("a steeper one at the length {}", readable_length(input, scales.physical_length(out.S[i]))),
        "write a cutoff or an edge_radius, or let the stage only load");
  }
  return Friction::on_a_way(std::make_shared<const OnSlopes>(inwards, Friction::table(std::move(out))));
}

double one_sided_reach(const Case& input, double S_max) {
  return input.friction && input.friction->other ? 1 + 2 * (S_max - 1) : S_max;
}

}  // namespace flexslip
