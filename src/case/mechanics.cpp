#include "case/mechanics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "bending_test/history.h"
#include "contact/over_rollers.h"
#include "contact/slope_friction.h"
#include "data/names.h"
#include "inference/analysis.h"
#include "instruments/trace_file.h"
#include "io/quantity.h"
#include "io/table.h"
#include "numerics/beam.h"
#include "numerics/elementary.h"
#include "numerics/root.h"

namespace flexslip {
namespace {

// Limits on the wavelength of friction.
constexpr double max_periods = 1e6;         // of a wave: the limit of trace_loading_curve, half a minute
constexpr double finest_period = 1e-9;      // [L] of a wave, by the same limit
constexpr double max_correlations = 2.4e5;  // of a rough profile, with four knots for each

constexpr std::array lengths_of_sections{&SpecimenInput::diameter, &SpecimenInput::inner_diameter, &SpecimenInput::wall,
                                         &SpecimenInput::width, &SpecimenInput::height};

bool states_section_error(const SpecimenInput& specimen) {
  return std::any_of(lengths_of_sections.begin(), lengths_of_sections.end(),
                     [&](auto length) { return specimen.*length && (specimen.*length)->uncertainty; });
}

// [1] The error of a second moment from the uncertainties of its lengths.
double section_error_of(const Test& test) {
  const auto moment_with = [&](auto length, double change) {
    Test other = test;
    (*other.specimen.*length)->value += change;
    return second_moment(*section_of(other));
  };
  double error = 0;
  for (auto length : lengths_of_sections) {
    const std::optional<Known>& known = *test.specimen.*length;
    if (!known) continue;
    constexpr double small = 1e-4;  // relative step of a length, over which I is linear
    const double step = small * known->value;
    const double slope = (moment_with(length, step) - moment_with(length, -step)) / (2 * step);
    error = elementary::length(error, slope * known->uncertainty.value_or(0));
  }
  return error / second_moment(*section_of(test));
}

// The stated bending stiffness of the test; empty if it states none.
std::optional<BendingStiffnessUsed> stated_stiffness(const Test& test) {
  if (!test.specimen) return std::nullopt;
  const auto& [product, modulus] = std::pair(test.specimen->bending_stiffness, test.specimen->modulus);
  const auto& estimate = product ? product : modulus;
  const Known* known = estimate ? std::get_if<Known>(&*estimate) : nullptr;
  if (!known) return std::nullopt;
  const std::optional<double> own = known->relative_uncertainty();
  BendingStiffnessUsed used{known->value, own.value_or(default_stiffness_error),
                            own ? StiffnessSource::stated : StiffnessSource::assumed_error};
  if (product) return used;
  constexpr double softest = 1000;  // [Pa] numbers that were meant in GPa are smaller
  if (!test.reduced && known->value < softest)
    throw wrong_value(
        test, "specimen.modulus",
        fmt::format("{} is softer than any specimen that can be bent", readable(known->value, kind::pressure)),
        "write the value with its unit, such as \"29.6 GPa\"");
  const auto section = section_of(test);
  if (!section) throw missing(test, "specimen.diameter");
  used.value *= second_moment(*section);
  if (states_section_error(*test.specimen))
    used.relative_error =
        std::min(elementary::length(own.value_or(default_modulus_error), section_error_of(test)), max_stiffness_error);
  return used;
}

// All positions at which the stage turns, rests or ends, cycle by cycle.
std::vector<double> written_out(const StageInput& stage) {
  std::vector<double> turns{stage.program.front()};
  turns.reserve(1 + static_cast<std::size_t>(stage.cycles) * (stage.program.size() - 1));
  for (std::uint64_t cycle = 0; cycle < stage.cycles; ++cycle)
    turns.insert(turns.end(), stage.program.begin() + 1, stage.program.end());
  return turns;
}

StageProgramme stated_programme(const Test& test) {
  const auto& positions = test.stage->program;
  const auto farthest = std::max_element(positions.begin(), positions.end());
  const std::string key = fmt::format("stage.program[{}]", farthest - positions.begin() + 1);
  if (!(*farthest >= min_stage * span_of(test)))
    throw wrong_value(test, fmt::format("stage.program[{}]", positions.size()),
                      fmt::format("The program ends at {}, less than {:g} spans",
                                  readable_length(test, positions.back()), min_stage));
  if (!(*farthest <= max_stage * span_of(test)))
    throw wrong_value(
        test, key, fmt::format("The position {} lies beyond {:g} spans", readable_length(test, *farthest), max_stage),
        "check its unit");
  std::vector<double> turns = written_out(*test.stage);
  if (!test.stage->step) return {std::move(turns), *farthest, false, false};
  return {stage_steps(turns, *test.stage->step), *farthest, true, false};
}

StageProgramme measured_programme(const Test& test) {
  const StageInput& measured = *test.stage;
  std::vector<WantedColumn> wanted{{*measured.stage, kind_in(test, kind::length)}};
  if (measured.time) wanted.push_back({*measured.time, kind_in(test, kind::time)});
  Table table = read_table(*measured.file, wanted, measured.decimal);
  const Column& stage = table.columns.front();
  const double span = span_of(test);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double position = stage.values[row];
    if (position < 0)
      throw wrong_cell(
          table, row, stage,
          fmt::format("The stage position {} lies before the point of contact, 0", readable_length(test, position)),
          "count the stage from where it touches the specimen, and leave out the rows before");
    if (!(position <= max_stage * span))
      throw wrong_cell(
          table, row, stage,
          fmt::format("The stage position {} lies beyond {:g} spans", readable_length(test, position), max_stage),
          "check its unit");
    if (!measured.time || row == 0) continue;
    const Column& time = table.columns[1];
    if (time.values[row] < time.values[row - 1])
      throw wrong_cell(table, row, time,
                       fmt::format("The time {} is earlier than {} in the previous row",
                                   readable(time.values[row], kind_in(test, kind::time)),
                                   readable(time.values[row - 1], kind_in(test, kind::time))),
                       "sort the rows by time");
  }
  const auto farthest = std::max_element(stage.values.begin(), stage.values.end());
  if (!(*farthest >= min_stage * span))
    throw wrong_cell(
        table, static_cast<std::size_t>(farthest - stage.values.begin()), stage,
        fmt::format("The stage moves to {} at most, less than {:g} spans", readable_length(test, *farthest), min_stage),
        "check the unit");
  const double reach = *farthest;
  return {std::move(table.columns.front().values), reach, true, true};
}

// True if the stage ever unloads.
bool turns_back(const Test& test) {
  if (!test.stage) return false;
  const auto positions = test.stage->file ? programme_of(test).positions : written_out(*test.stage);
  return !std::is_sorted(positions.begin(), positions.end());
}

void require_slender(const Test& test) {
  const auto section = section_of(test);
  if (!section) return;
  const double thickness = depth(*section);
  const double span = span_of(test);
  if (thickness < thickest * span) return;
  throw ImpossibleTest(
      wrong_value(test, depth_key(*section),
                  fmt::format("The specimen is {} thick; beam theory holds for less than a fifth of the span of {}",
                              readable_length(test, thickness), readable_length(test, span)),
                  "check the units of both, or use flexslip modulus"));
}

// The friction of a support in a test.
struct Side {
  const Test& test;
  const FrictionInput& friction;
  std::string section;  // "friction" or "friction.other"

  InputError wrong(std::string_view name, std::string problem, std::string remedy) const {
    return wrong_value(test, fmt::format("{}.{}", section, name), std::move(problem), std::move(remedy));
  }
};

// A table over lengths [m].
FrictionTable read_friction_table(const Side& side) {
  const Test& test = side.test;
  const Kind length_kind = kind_in(test, kind::length);
  const Table table = read_table(
      *side.friction.file, {{*side.friction.length, length_kind}, {side.friction.mu.value_or("mu"), kind::number}});
  FrictionTable friction{table.columns[0].values, table.columns[1].values};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (row > 0 && !(friction.S[row] > friction.S[row - 1]))
      throw wrong_cell(
          table, row, table.columns[0],
          fmt::format("The length {} is not greater than in the previous row", readable(friction.S[row], length_kind)));
    if (friction.mu[row] < 0)
      throw wrong_cell(table, row, table.columns[1],
                       fmt::format("Friction is {}, less than 0", readable(friction.mu[row], kind::number)));
  }
  if (const double span = span_of(test); !(friction.S.back() / span > 1))
    throw wrong_cell(table, table.rows() - 1, table.columns[0],
                     fmt::format("The last length is {}, but the length between the supports grows from the span of {}",
                                 readable(friction.S.back(), length_kind), readable_length(test, span)));
  return friction;
}

// Refuses a path over a height profile with slopes beyond the limits of friction. [m], [1]
void require_climbable(const std::vector<double>& path, const HeightTrace& trace, double mu, const std::string& source,
                       const Kind& kind) {
  constexpr double most = 20;  // [1] of any computed friction
  const auto fault = too_steep(path, trace.step, mu, most);
  if (!fault) return;
  const double steepest = slope_of_friction(most, mu);
  const bool falls = fault->slope < 0;
  throw InputError(
      {.file = source,
       .problem = fmt::format(
           "The slope of {:.3g} at the position {} is {:.2g} times the limit: slopes must lie between {:.3g}, where a "
           "contact of friction {:g} would slide unaided, and {:.3g}, where friction would reach {:g}",
           fault->slope, readable(trace.position(fault->interval), kind),
           std::abs(fault->slope) / (falls ? mu : steepest), -mu, mu, steepest, most),
       .remedy = falls ? "if it is noise, remove short waves with a cutoff, or state the radius of the edge; otherwise "
                         "check the unit of the heights"
                       : "if it is noise, remove short waves with a cutoff; otherwise check the unit of the heights"});
}

// Between the heights of the profile, from midspan; beyond its ends the flat surface. Over lengths
// [m].
FrictionTable read_surface(const Side& side) {
  const Test& test = side.test;
  const FrictionInput& surface = side.friction;
  const double mu0 = *surface.mu0, half_span = 0.5 * span_of(test);
  const Kind length = kind_in(test, kind::length);
  const TraceFile file = read_trace(
      *surface.trace,
      {.position = surface.position.value_or(""), .height = surface.height.value_or(""), .step = surface.trace_step},
      length);
  HeightTrace trace = levelled(file.trace, static_cast<std::size_t>(surface.level));
  if (surface.cutoff) trace = smoothed(std::move(trace), *surface.cutoff);
  const double step = trace.step;
  std::vector<double> path =
      path_of_edge(trace.height, step, surface.edge_radius.value_or(test.rig->roller_radius.value_or(0)));
  const bool is_inwards = surface.direction == TraceDirection::inwards;
  require_climbable(path, trace, mu0, file.source, length);
  if (is_inwards) {
    std::reverse(path.begin(), path.end());
    require_climbable(path, trace, mu0, file.source, length);
  }
  const double begin = surface.trace_begin.value_or(half_span);
  const double extent = step * static_cast<double>(path.size() - 1);
  const double first = is_inwards ? begin - extent : begin;
  if (!(first + extent > half_span))
    throw side.wrong("trace_begin",
                     fmt::format("The trace ends at {}, before the support, {} from midspan",
                                 readable_length(test, first + extent), readable_length(test, half_span)),
                     "check its unit, the unit of the trace, and direction");
  FrictionTable table;
  const auto add = [&](double s, double mu) {
    if (!(s > 0)) return;
    table.S.push_back(2 * s);
    table.mu.push_back(mu);
  };
  const std::vector<double> shown = friction_of_heights(path, step, mu0);
  add(first - 0.5 * step, mu0);
  for (std::size_t i = 0; i < shown.size(); ++i) add(first + step * (static_cast<double>(i) + 0.5), shown[i]);
  add(first + extent + 0.5 * step, mu0);
  return table;
}

// The content of the friction file, if there is one.
std::shared_ptr<const FrictionTable> points_of(const Side& side) {
  const FrictionInput& friction = side.friction;
  if (friction.points) return friction.points;
  if (friction.file) return std::make_shared<const FrictionTable>(read_friction_table(side));
  if (friction.trace) return std::make_shared<const FrictionTable>(read_surface(side));
  return nullptr;
}

Friction of_points(const Side& side, const FrictionTable& points, const Scales& scales) {
  FrictionTable reduced = points;
  for (double& S : reduced.S) S = scales.reduced_length(S);
  if (!(reduced.S.back() > 1 && std::isfinite(reduced.S.back())))
    throw ImpossibleTest(wrong_value(
        side.test, "rig.span",
        fmt::format("The friction table ends before the span of {}", readable_length(side.test, scales.span()))));
  return Friction::table(std::move(reduced));
}

Friction of_roughness(const Side& side, const Scales& scales, double S_max) {
  const double correlation_length = scales.reduced_length(*side.friction.correlation_length);
  if (!((S_max - 1) / correlation_length <= max_correlations))
    throw side.wrong("correlation_length",
                     fmt::format("The correlation length of {} is less than {:.0e} of the length pulled in",
                                 readable_length(side.test, *side.friction.correlation_length), 1 / max_correlations),
                     "check its unit");
  return Friction::rough(*side.friction.mu0, *side.friction.rms, correlation_length, *side.friction.seed, S_max);
}

// Without a reference, mu0 holds at the span.
Friction of_waves(const Side& side, const Scales& scales, double S_max) {
  const Test& test = side.test;
  const FrictionInput& friction = side.friction;
  FrictionWaves waves{*friction.mu0, friction.drift.value_or(0) * scales.span(), {}};
  if (friction.reference) {
    constexpr double rounding = 1e-3;  // of the four digits of a displayed length
    waves.S_reference = scales.reduced_length(*friction.reference);
    if (!(waves.S_reference >= 1 - rounding && waves.S_reference <= max_stage))
      throw ImpossibleTest(side.wrong(
          "reference",
          fmt::format("The reference length of {} is not between the span of {} and {:g} spans",
                      readable_length(test, *friction.reference), readable_length(test, scales.span()), max_stage),
          "check its unit"));
  }
  const auto add = [&](const std::string& name, double amplitude, double wavelength, double phase) {
    waves.terms.push_back({amplitude, scales.reduced_length(wavelength), phase});
    const double period = 2 * waves.terms.back().wavelength;
    if (!((S_max - 1) / period <= max_periods && period >= finest_period && std::isfinite(period)))
      throw side.wrong(name,
                       fmt::format("A wavelength of {} gives more than {:.0e} periods along the specimen",
                                   readable_length(test, wavelength), max_periods),
                       "check its unit");
  };
  if (friction.model == FrictionModel::sinusoid)
    add("wavelength", *friction.amplitude, *friction.wavelength, friction.phase.value_or(0));
  for (std::size_t i = 0; i < friction.waves.size(); ++i)
    add(fmt::format("waves[{}].wavelength", i + 1), friction.waves[i].amplitude, friction.waves[i].wavelength,
        friction.waves[i].phase.value_or(0));
  return Friction::waves(std::move(waves));
}

// The limit of friction in words.
std::string friction_limit(const Fibre& fibre) {
  return fmt::format("the limit{} is {:g}", fibre.on_edges() ? "" : " at the surface", fibre.max_friction());
}

// The requested friction of a support, and the fibre that meets it at lengths up to S_max [L].
struct Asked {
  const Side& side;
  const Friction& kinetic;
  const Fibre& fibre;
  const Scales& scales;
  double S_max;

  // [1/L] The maximum steepness.
  double limit_of(const Fibre& on) const { return steepest_followed(on, kinetic.max_up_to(S_max), S_max); }
  std::string length(double reduced) const { return readable_length(side.test, scales.physical_length(reduced)); }
};

// [L] The largest roller radius at which a profile of this steepness can be followed; empty if no
// radius suffices.
std::optional<double> widest_that_follows(const Asked& asked) {
  // The search stays below the limit by twice this share, a rounding of the four displayed digits.
  // The limit is nearly linear in the radius, and each radius needs its own tables.
  constexpr double close = 1e-4;
  const Supports& supports = asked.fibre.supports();
  const auto excess = [&](double radius) {
    return asked.kinetic.steepest() / asked.limit_of(Fibre({radius, supports.half_depth})) - (1 - 2 * close);
  };
  const Tried on_edges{0, excess(0)};
  if (!(on_edges.value < 0)) return std::nullopt;
  return zero_by_secant(excess, on_edges, {supports.radius, excess(supports.radius)}, close);
}

// The remedy for a profile that is too steep by a factor.
std::string less_steep(const Asked& asked, double excess) {
  constexpr double rounding = 1e-3;  // of the four digits of a displayed quantity
  const double enough = excess * (1 + rounding);
  const auto* waves = std::get_if<FrictionWaves>(&asked.kinetic.form());
  std::string words = "write a profile that is less steep";
  if (asked.side.friction.model == FrictionModel::rough)
    words = fmt::format("write at least {}",
                        readable_length(asked.side.test, *asked.side.friction.correlation_length * enough));
  else if (waves && waves->terms.empty())
    words = "write a smaller one";
  else if (waves && waves->terms.size() == 1 && waves->drift == 0)
    words = fmt::format("write a wavelength of at least {}", asked.length(waves->terms.front().wavelength * enough));
  if (asked.fibre.supports().radius == 0) return words + ", or [rig] friction_at = \"axis\"";
  const auto widest = widest_that_follows(asked);
  if (!widest) return words;
  return fmt::format("{}, or a roller_radius of at most {}", words, asked.length(*widest * (1 - rounding)));
}

// Refuses friction that changes so fast along the specimen that the contact point would jump.
void require_followed(const Asked& asked) {
  const auto& [side, kinetic, fibre, scales, S_max] = asked;
  const double steepest = kinetic.steepest();
  if (steepest == 0 || fibre.on_edges()) return;
  const double limit = asked.limit_of(fibre);
  if (steepest < limit) return;
  const auto* waves = std::get_if<FrictionWaves>(&kinetic.form());
  const FrictionModel model = *side.friction.model;
  throw side.wrong(model == FrictionModel::rough      ? "correlation_length"
                   : model == FrictionModel::surface  ? "trace"
                   : model == FrictionModel::table    ? "file"
                   : !waves || waves->terms.empty()   ? "drift"
                   : model == FrictionModel::sinusoid ? "wavelength"
                                                      : "waves",
                   fmt::format("Friction changes with the length between the {} by up to {:.5g} times the limit of {}, "
                               "above which the point of contact would jump",
                               fibre.supports().radius > 0 ? "contacts" : "supports", steepest / limit,
                               readable(limit / scales.span(), kind_in(side.test, kind::inverse_length))),
                   less_steep(asked, steepest / limit));
}

// Refuses friction above max_friction of the fibre, or steeper than steepest_followed.
void require_covered(const Asked& asked) {
  const auto& [side, kinetic, fibre, scales, S_max] = asked;
  const double most = kinetic.max_up_to(S_max);
  const double limit = fibre.max_friction();
  if (most <= limit) return require_followed(asked);
  const std::string limit_in_words = friction_limit(fibre), found = fmt::format("{:g}", most);
  switch (*side.friction.model) {
    case FrictionModel::rough:
      throw side.wrong("mu0", fmt::format("Friction reaches {}, its roughness included, and {}", found, limit_in_words),
                       "write a smaller mu0 or rms");
    case FrictionModel::surface:
      throw side.wrong("mu0",
                       fmt::format("Friction reaches {} on the slopes of the trace, and {}", found, limit_in_words),
                       "write a smaller mu0, or a cutoff");
    case FrictionModel::table:
      throw side.wrong("file", fmt::format("Friction reaches {}, and {}", found, limit_in_words),
                       "check the column of friction");
    default:
      break;
  }
  const auto& waves = std::get<FrictionWaves>(kinetic.form());
  double without_drift = waves.mu0;
  for (const Sinusoid& term : waves.terms) without_drift += waves.mu0 * term.amplitude;
  if (!(without_drift <= limit))
    throw side.wrong("mu0",
                     fmt::format("Friction reaches {}, its waves and drift included, and {}", found, limit_in_words),
                     "write a smaller mu0");
  throw side.wrong(
      "drift",
      fmt::format("The drift of {} takes friction from {:g} at {} to {:g} at {}, and {}",
                  readable(waves.drift / scales.span(), kind_in(side.test, kind::inverse_length)), without_drift,
                  asked.length(waves.S_reference), most, asked.length(waves.drift > 0 ? S_max : 1), limit_in_words),
      waves.S_reference == 1 ? "check its unit, or bend less far" : "check its unit, and the unit of reference");
}

// [L] The range of lengths for the friction of one support, if the specimen slides in up to S_max
// [L]. Under a free nose, one of the two supports may slide alone.
double one_sided_reach(const Test& test, double S_max) {
  return test.other && test.rig->nose == Nose::free ? 1 + 2 * (S_max - 1) : S_max;
}

Friction friction_of(const Side& side, const Fibre& fibre, const Scales& scales, double S_max) {
  const double reach = one_sided_reach(side.test, S_max);
  const auto points = points_of(side);
  Friction friction = points                                        ? of_points(side, *points, scales)
                      : side.friction.model == FrictionModel::rough ? of_roughness(side, scales, reach)
                                                                    : of_waves(side, scales, reach);
  require_covered({side, friction, fibre, scales, reach});
  const auto pins = pin_limit_of(side.test);
  return pins ? capped(friction, *pins, reach) : friction;
}

// The friction of a surface on two equal edges, uphill on the way in and downhill on the way out.
// Fails:      InputError for two surfaces, rollers, an excess of static friction, or slopes on
//             which the specimen would slide out unaided.
Friction on_both_ways(const Test& test, const Friction& inwards, const Fibre& fibre, const Scales& scales) {
  const FrictionInput& friction = *test.friction;
  const auto refuse = [&](std::string_view key, const std::string& found) {
    throw wrong_value(test, key,
                      fmt::format("A surface needs two equal edges where the stage turns back; here stands {}", found),
                      "delete it, or let the stage only load: a surface has another friction on the way back");
  };
  if (test.other) refuse("friction.other", "another support");
  if (fibre.supports().radius > 0) refuse("rig.roller_radius", "rollers");
  if (friction.static_excess.value_or(0) > 0)
    refuse("friction.static_excess", fmt::format("{:g}", *friction.static_excess));
  if (friction.wear.value_or(1) < 1) refuse("friction.wear", fmt::format("{:g}", *friction.wear));
  if (const auto key = key_of_overshoot(test); !key.empty()) refuse(key, "\"overshoot\"");
  FrictionTable out = std::get<FrictionTable>(inwards.form());
  const double mu0 = *friction.mu0;
  for (std::size_t i = 0; i < out.mu.size(); ++i) {
    out.mu[i] = friction_on_the_way_back(out.mu[i], mu0);
    if (out.mu[i] > 0 && out.mu[i] <= fibre.max_friction()) continue;
    throw wrong_value(test, "friction.trace",
                      fmt::format("The stage turns back, and at the length {} the trace is steeper than a friction of "
                                  "{:g} allows in both directions",
                                  readable_length(test, scales.physical_length(out.S[i])), mu0),
                      "write a cutoff or an edge_radius, or let the stage only load");
  }
  return Friction::path_dependent(std::make_shared<const OnSlopes>(inwards, Friction::table(std::move(out))));
}

}  // namespace

std::string_view key_of_overshoot(const Test& test) {
  if (test.stage && test.stage->snaps) return test.stage->snaps == SnapRest::overshoot ? "stage.snaps" : "";
  return test.rig && test.rig->snaps == SnapRest::overshoot ? "rig.snaps" : "";
}

std::string_view name_of(StiffnessSource source) {
  return name_in_order<StiffnessSource::initial_slope>(source,
                                                       {"stated", "stated_without_uncertainty", "initial_slope"});
}

double span_of(const Test& test) {
  if (!test.rig) throw missing(test, "rig");
  if (!test.rig->span) throw missing(test, "rig.span");
  return *test.rig->span;
}

double load_train_stiffness_of(const Test& test) {
  if (!test.rig) throw missing(test, "rig");
  if (!test.rig->stiffness) throw missing(test, "rig.stiffness");
  return *test.rig->stiffness;
}

double support_compliance_of(const Test& test) {
  return test.rig && test.rig->support_stiffness ? 0.5 / *test.rig->support_stiffness : 0;
}

double rig_stiffness_of(const Test& test) {
  return with_supports(load_train_stiffness_of(test), support_compliance_of(test));
}

bool states_stiffness(const Test& test) { return stated_stiffness(test).has_value(); }

BendingStiffnessUsed bending_stiffness_of(const Test& test) {
  if (const auto stated = stated_stiffness(test)) return *stated;
  if (!test.specimen) throw missing(test, "specimen");
  throw missing(test, test.specimen->bending_stiffness ? "specimen.bending_stiffness" : "specimen.modulus");
}

BeamGeometry geometry_of(const Test& test) {
  BeamGeometry geometry{test.rig ? test.rig->span : std::nullopt, section_of(test)};
  const bool states_supports = test.reduced || (test.rig && test.rig->states_supports());
  if (states_supports) geometry.support_radius = test.rig->roller_radius.value_or(0);
  if (test.rig && test.rig->span) geometry.span_error = test.rig->span->relative_uncertainty().value_or(0);
  if (geometry.section && states_section_error(*test.specimen)) geometry.moment_error = section_error_of(test);
  return geometry;
}

BendingStiffnessUsed bending_stiffness_of(const Test& test, const Measurement& measurement) {
  if (const auto stated = stated_stiffness(test)) return *stated;
  const double span = span_of(test);
  if (const auto& straight = measurement.straight; measurement.straight_is_initial) {
    constexpr double of_one = 0.3;  // standard deviation of a friction that is uniform up to 1
    const double bend = of_one * max_steepening(geometry_of(test), straight->middle(measurement.first_curve.record));
    const double error = elementary::length(elementary::length(default_stiffness_error, bend),
                                            straight->slope.standard_error / straight->slope.value);
    return {beam_bending_stiffness(straight->slope.value, span), error, StiffnessSource::initial_slope};
  }
  const auto slope = stiffness_from_slope(measurement.first_curve.record, span);
  if (!slope.found)
    throw InputError({.file = measurement.file,
                      .problem = "The force must rise over at least 5 rows after contact so that the bending stiffness "
                                 "can be determined; it does not",
                      .remedy = "write the modulus or bending_stiffness into [specimen]"});
  // The slope belongs to a line through the contact. The errors of the contact and of the load train
  // are as small as the record determines them.
  const double by_contact = measurement.contact_error / slope.deflection;
  const double by_train = measurement.is_derived ? rig_errors_of(measurement).load_train *
                                                       beam_slope(slope.value, span) / rig_stiffness_of(test)
                                                 : 0;
  const double error = elementary::length(elementary::length(slope.relative_error, by_contact), by_train);
  return {slope.value, std::min(error, max_stiffness_error), StiffnessSource::initial_slope};
}
StageProgramme programme_of(const Test& test) {
  if (!test.stage) throw missing(test, "stage");
  return test.stage->file ? measured_programme(test) : stated_programme(test);
}

Scales scales_of(const Test& test, const BendingStiffnessUsed& stiffness) {
  const double span = span_of(test);
  require_slender(test);
  try {
    return {span, stiffness.value};
  } catch (const std::invalid_argument& error) {
    throw wrong_value(test, "specimen",
                      fmt::format("Bending stiffness and span exceed what a computer can hold: {}", error.what()));
  }
}

Scales scales_of(const Test& test) { return scales_of(test, bending_stiffness_of(test)); }

Supports supports_of(const Test& test, const Scales& scales) {
  const RigInput& rig = *test.rig;
  const auto section = section_of(test);
  const bool is_thick = section && rig.friction_at == FrictionAt::surface;
  const Supports supports{scales.reduced_length(rig.roller_radius.value_or(0)),
                          is_thick ? 0.5 * scales.reduced_length(depth(*section)) : 0};
  if (!(supports.radius + supports.half_depth < widest_supports))
    throw wrong_value(
        test, "rig.roller_radius",
        fmt::format("The roller radius of {:g} spans and half the thickness of {:g} spans add up to {:g} spans or more",
                    supports.radius, supports.half_depth, widest_supports),
        "check the units of both, and the span");
  constexpr double thinnest = 1e-6;  // [L] of thinner specimens, the outward sliding is lost in rounding
  if (is_thick && supports.half_depth < thinnest)
    throw wrong_value(
        test, "specimen",
        fmt::format("The specimen is {} thick, less than the limit of {}", readable_length(test, depth(*section)),
                    readable_length(test, 2 * scales.physical_length(thinnest))),
        fmt::format("check its unit, or {}", instruction_to_set(test, KeyChange{"rig", "friction_at", "\"axis\""})));
  return supports;
}

Fibre fibre_of(const Test& test, const Scales& scales) { return Fibre(supports_of(test, scales)); }

Rig rig_of(const Test& test, const Scales& scales) {
  return {scales.reduced_stiffness(rig_stiffness_of(test)), fibre_of(test, scales)};
}

RigErrors rig_errors_of(const Measurement& measurement) {
  const Test& test = measurement.test;
  RigErrors errors;
  if (measurement.begins_free) errors.preload = usual_bow;
  if (measurement.relaxation)
    errors.slow_force =
        std::min(elementary::length(errors.slow_force, measurement.relaxation->over_loading), max_uncertainty);
  const auto take = [](double& error, const std::optional<Known>& known, double times = 1) {
    if (known) error = times * known->relative_uncertainty().value_or(error);
  };
  if (test.rig) {
    take(errors.span, test.rig->span);
    take(errors.support_radius, test.rig->roller_radius);
    if (test.rig->stiffness)  // supports in series with it are exact
      take(errors.load_train, test.rig->stiffness,
           support_compliance_of(test) > 0 ? rig_stiffness_of(test) / *test.rig->stiffness : 1);
  }
  if (test.specimen) take(errors.thickness, test.specimen->height ? test.specimen->height : test.specimen->diameter);
  if (test.record) {
    errors.force_gain = test.record->gain_error.value_or(errors.force_gain);
    errors.slow_force = test.record->slow_force_error.value_or(errors.slow_force);
    if (test.record->preload_error) errors.preload = *test.record->preload_error / span_of(test);
    constexpr double most = 0.05;  // [L] beyond it, the start of the curve belongs to another test
    if (errors.preload > most)
      throw wrong_value(test, "record.preload_error",
                        fmt::format("The preload error is {:.3g} % of the span, more than 5 %", 100 * errors.preload),
                        "zero displacement and force before the contact");
  }
  return errors;
}

std::optional<double> pin_limit_of(const Test& test) {
  if (!test.rig || test.rig->rollers != Rollers::pinned) return std::nullopt;
  return friction_of_pins(*test.rig->pin_friction, *test.rig->pin_radius, *test.rig->roller_radius);
}

Friction friction_of(const Test& test, const Fibre& fibre, const Scales& scales, double S_max) {
  if (!test.friction) throw missing(test, "friction");
  const FrictionInput& friction = *test.friction;
  if (!friction.model) throw missing(test, "friction.model");
  if (friction.model == FrictionModel::roughness)
    throw wrong_value(test, "friction.model", "The model 'roughness' can only be fitted, not computed with",
                      "write a model to compute with, such as model = \"constant\", or \"rough\" with its parameters");
  if (!friction.has_parameters())
    throw missing(test, friction.model == FrictionModel::table ? "friction.file" : "friction.mu0");
  Friction first = friction_of({test, friction, "friction"}, fibre, scales, S_max);
  std::optional<Friction> other;
  if (test.other) other = friction_of({test, *test.other, "friction.other"}, fibre, scales, S_max);
  if (!other) return first;
  if (fibre.supports().radius > 0)
    throw wrong_value(
        test, "rig.roller_radius",
        "[friction.other] gives the supports different friction, which is computed on edges only, not on rollers",
        "delete it, or [friction.other]");
  const auto together = test.rig->nose == Nose::holds ? Friction::mean_of : Friction::on_two_supports;
  return together(std::move(first), *std::move(other), S_max);
}

Test with_files_read(Test test) {
  if (test.friction) test.friction->points = points_of({test, *test.friction, "friction"});
  if (test.other) test.other->points = points_of({test, *test.other, "friction.other"});
  return test;
}

BendingTest bending_test_of(const Test& test, const Scales& scales, double farthest) {
  if (!test.rig->pins_turn())
    throw ImpossibleTest(wrong_value(test, "rig.pin_friction",
                                     fmt::format("The friction of the pin is {:g}, not less than the ratio of the "
                                                 "radii of roller and pin, so no roller turns",
                                                 *test.rig->pin_friction)));
  const Rig rig = rig_of(test, scales);
  if (!(beam_deflection(farthest, rig.stiffness) >= min_stage))
    throw ImpossibleTest(
        wrong_value(test, "rig.stiffness",
                    fmt::format("A load train of {} does not bend the specimen by {:g} spans",
                                readable(load_train_stiffness_of(test), kind_in(test, kind::stiffness)), min_stage),
                    "check its unit"));
  const double S_max = longest_at_stage(farthest);
  Friction kinetic = friction_of(test, rig.fibre, scales, S_max);
  const bool climbs_surface = test.friction->trace || (test.other && test.other->trace);
  if (climbs_surface && turns_back(test)) kinetic = on_both_ways(test, kinetic, rig.fibre, scales);
  const double excess = test.friction->static_excess.value_or(0);
  const double most = kinetic.max_up_to(S_max) + excess;
  const auto refuse = [&](std::string_view key, std::string problem, std::string remedy) {
    throw wrong_value(test, key, std::move(problem), std::move(remedy));
  };
  if (excess > 0 && most > rig.fibre.max_friction())
    refuse("friction.static_excess",
           fmt::format("An excess of {:g} raises static friction to {:g}, and {}", excess, most,
                       friction_limit(rig.fibre)),
           "write a smaller one");
  if (excess > 0 && rig.fibre.supports().radius > 0)
    refuse("friction.static_excess",
           fmt::format("An excess of static friction ({:g}) is not computed on rollers", excess),
           "delete it, or roller_radius");
  const std::string_view overshoot = key_of_overshoot(test);
  if (kinetic.two_supports()) {
    const std::string one_slides = "as the two supports differ and the nose is free",
                      remedy = "delete it, or [rig] nose";
    if (excess > 0)
      refuse("friction.static_excess",
             fmt::format("An excess of static friction ({:g}) is not computed, {}", excess, one_slides), remedy);
    if (!overshoot.empty())
      refuse(overshoot, fmt::format("Snaps that overshoot are not computed, {}", one_slides), remedy);
  }
  const double wear = test.friction->wear.value_or(1);
  if (wear < 1 && test.stage && test.stage->file)
    refuse("friction.wear",
           fmt::format("Friction that wears ({:g}) needs a program of the stage: the noise of a measured path would "
                       "turn it again and again",
                       wear),
           "write a program into [stage] instead of its file");
  const SnapRest rest = overshoot.empty() ? SnapRest::nearest_stable : SnapRest::overshoot;
  return {{std::move(kinetic), Friction::constant(excess)}, rig, rest, wear};
}

double periods_up_to(const Friction& friction, double stage) {
  constexpr double scales_a_period = 4;
  const double drawn_in = 2.5 * stage * stage;  // S - 1, for a deflection equal to the stage
  return drawn_in / (scales_a_period * friction.smooth_scale());
}

std::optional<SurfaceStrain> surface_of(const Test& test, const Scales& scales) {
  const auto section = section_of(test);
  return section ? std::optional(SurfaceStrain(*section, scales)) : std::nullopt;
}

double breaking_curvature_of(const Test& test, const Scales& scales) {
  const auto surface = surface_of(test, scales);
  if (surface && test.specimen->strain_at_break) return surface->curvature_at_strain(*test.specimen->strain_at_break);
  if (surface && test.specimen->strength) return surface->curvature_at_stress(*test.specimen->strength);
  return infinity;
}

double nose_curvature_of(const Test& test, const Scales& scales) {
  if (!test.rig || !test.rig->nose_radius) return infinity;
  const auto section = section_of(test);
  return 1 / scales.reduced_length(*test.rig->nose_radius + (section ? 0.5 * depth(*section) : 0));
}

std::vector<Crack> cracks_of(const Test& test, const Scales& scales) {
  std::vector<Crack> cracks;
  for (const CrackInput& crack : test.specimen->cracks)
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
