#include "design/design_result.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "io/input_error.h"
#include "io/parallel.h"
#include "io/quantity.h"
#include "io/text.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

constexpr double max_readings = 1e9;  // limit for counting

// Refuses anything beyond one loading to the farthest position of the programme.
void require_one_loading(const Test& input) {
  if (!input.stage) throw missing(input, "stage");
  if (input.stage->file)
    throw wrong_value(input, "stage.file",
                      "One loading is planned, which needs a program of turning points, not a measured one",
                      R"(write program = ["0 um", "900 um"]; flexslip simulate shows what a measured programme does)");
  const auto& positions = input.stage->program;
  const auto farthest = std::max_element(positions.begin(), positions.end());
  const auto shown = [&](double position) { return readable(position, kind_in(input, kind::length)); };
  if (positions.front() != 0)
    throw wrong_value(input, "stage.program[1]",
                      fmt::format("One loading is planned, which begins at 0, the straight specimen, not at {}",
                                  shown(positions.front())));
  if (const auto turn = std::is_sorted_until(positions.begin(), farthest + 1); turn <= farthest)
    throw wrong_value(
        input, fmt::format("stage.program[{}]", turn - positions.begin() + 1),
        fmt::format(
            "One loading is planned, up to the farthest position of {}, but the stage goes back to {} before it",
            shown(*farthest), shown(*turn)),
        "leave out the positions before; flexslip simulate shows what the whole programme does");
  if (const auto key = key_of_overshoot(input); !key.empty())
    throw wrong_value(input, key,
                      "One loading is planned, with snaps that rest at the nearest stable state and do not overshoot",
                      "leave it out; flexslip simulate shows what overshooting does");
  if (input.friction && input.friction->static_excess.value_or(0) > 0)
    throw wrong_value(input, "friction.static_excess",
                      fmt::format("One loading is planned, without an excess of static friction ({:g})",
                                  *input.friction->static_excess),
                      "leave it out; flexslip simulate shows what it does");
  if (input.friction && input.friction->wear.value_or(1) < 1)
    throw wrong_value(
        input, "friction.wear",
        fmt::format("One loading is planned, with friction that does not wear ({:g})", *input.friction->wear),
        "leave it out; flexslip simulate shows what it does");
  if (!input.specimen->cracks.empty())
    throw wrong_value(input, "specimen.cracks",
                      fmt::format("One loading is planned, of a specimen without cracks, and this one has {} of them",
                                  input.specimen->cracks.size()),
                      "leave them out; flexslip simulate shows what they do");
}

constexpr double no_number = not_a_number;
constexpr FirstSnap no_snap{no_number, no_number, no_number, no_number};

using O = const DesignOutcome&;
using U = const DesignUnits&;

template <class Get>
auto of_outcome(Get get) {
  return [get](const DesignResult& result) {
    return result.outcome ? std::optional(get(*result.outcome, *result.units)) : std::nullopt;
  };
}

Fields<DesignResult> fields_of_outcomes() {
  return Fields<DesignResult>()
      .own("stage_reached", kind::length, "stage position at the end of the loading",
           of_outcome([](O o, U u) { return u.scales.physical_length(o.stage_reached); }))
      .own("deflection_reached", kind::length, "deflection at that stage position",
           of_outcome([](O o, U u) { return u.scales.physical_length(o.w_reached); }))
      .count("snaps", "number of snaps of the specimen, however small", of_outcome([](O o, U) { return o.snaps; }))
      .own("first_snap_stage", kind::length, "stage position of the first snap; null without a snap",
           of_outcome([](O o, U u) { return u.scales.physical_length(o.first_snap.value_or(no_snap).stage); }))
      .own("first_snap_deflection", kind::length, "deflection before the first snap; null without a snap",
           of_outcome([](O o, U u) { return u.scales.physical_length(o.first_snap.value_or(no_snap).w); }))
      .own("first_snap_force_before", kind::force, "force before the first snap; null without a snap",
           of_outcome([](O o, U u) { return u.scales.physical_force(o.first_snap.value_or(no_snap).F_before); }))
      .own("first_snap_force_after", kind::force, "force after the first snap; null without a snap",
           of_outcome([](O o, U u) { return u.scales.physical_force(o.first_snap.value_or(no_snap).F_after); }))
      .count("drops", "number of force drops in the record; consecutive decreases count as one",
             of_outcome([](O o, U) { return o.drops; }))
      .own("largest_drop", kind::force, "largest force drop; 0 without drops",
           of_outcome([](O o, U u) { return u.scales.physical_force(o.largest_drop); }))
      .own("mean_drop", kind::force, "mean force drop; 0 without drops",
           of_outcome([](O o, U u) { return u.scales.physical_force(o.mean_drop); }))
      .own("greatest_force", kind::force, "maximum force",
           of_outcome([](O o, U u) { return u.scales.physical_force(o.greatest_force); }))
      .number("greatest_strain", "maximum bending strain of the surface at midspan; null without a section",
              of_outcome([](O o, U u) { return u.surface ? u.surface->strain(o.greatest_curvature) : no_number; }))
      .own("greatest_stress", kind::pressure,
           "maximum bending stress of the surface at midspan; null without a section",
           of_outcome([](O o, U u) { return u.surface ? u.surface->stress(o.greatest_curvature) : no_number; }))
      .own("work", kind::energy, "work on the specimen",
           of_outcome([](O o, U u) { return u.scales.physical_energy(o.work); }))
      .own("friction_heat", kind::energy, "heat of friction at the supports, part of the work",
           of_outcome([](O o, U u) { return u.scales.physical_energy(o.friction_heat); }))
      .own("released", kind::energy, "energy released by snaps in excess of friction, part of the work",
           of_outcome([](O o, U u) { return u.scales.physical_energy(o.released); }));
}

}  // namespace

Test one_loading_of(const Test& given) {
  const Scales scales = scales_of(given);
  require_one_loading(given);
  const double travel = programme_of(given).farthest;
  bending_test_of(given, scales, scales.reduced_length(travel));
  Test test = with_files_read(given);
  test.stage->program = {0, travel};
  test.stage->cycles = 1;
  test.stage->step = test.stage->step.value_or(0);
  FrictionInput& friction = *test.friction;
  if (friction.waves.size() == 1) {
    friction.model = FrictionModel::sinusoid;
    friction.amplitude = friction.waves.front().amplitude;
    friction.wavelength = friction.waves.front().wavelength;
    friction.phase = friction.waves.front().phase;
    friction.waves.clear();
  }
  if (friction.model == FrictionModel::sinusoid) friction.phase = friction.phase.value_or(0);
  return test;
}

PlannedDesign design_of(const Test& loading) {
  const Scales scales = scales_of(loading);
  const double travel = scales.reduced_length(loading.stage->program.back());
  if (!(travel <= max_stage && travel >= min_stage))
    throw wrong_value(loading, "stage.program",
                      fmt::format("The stage moves to {}, which is not between {:g} and {:g} spans of {}",
                                  readable_length(loading, loading.stage->program.back()), min_stage, max_stage,
                                  readable_length(loading, scales.span())));
  const double step = scales.reduced_length(*loading.stage->step);
  if (!std::isfinite(step) || (step > 0 && travel / step > max_readings))
    throw wrong_value(
        loading, "stage.step",
        fmt::format("The step of {} is neither 0 nor at least {:g} of the travel, as many as a computer can hold",
                    readable_length(loading, *loading.stage->step), 1 / max_readings));
  BendingTest test = bending_test_of(loading, scales, travel);
  Design design{std::move(test.friction.kinetic), std::move(test.rig), travel, step,
                breaking_curvature_of(loading, scales)};
  return {std::move(design), {scales, surface_of(loading, scales)}};
}

std::string_view word_of(ResultStatus status) { return result_status_words.at(static_cast<std::size_t>(status)); }

ResultStatus status_of(const DesignOutcome& outcome) {
  switch (outcome.status) {
    case DesignStatus::ok:
      return ResultStatus::ok;
    case DesignStatus::breaks:
      return ResultStatus::breaks;
    case DesignStatus::slipped_through:
      return ResultStatus::slipped_through;
  }
  throw std::invalid_argument("no such status");
}

DesignResult result_of(const Test& loading) try {
  const auto [design, units] = design_of(loading);
  const DesignOutcome outcome = outcome_of(design);
  return {status_of(outcome), units, outcome};
} catch (const ImpossibleTest&) {
  return {ResultStatus::impossible, {}, {}};
} catch (const InputError&) {
  return {ResultStatus::not_computable, {}, {}};
} catch (const std::invalid_argument&) {
  return {ResultStatus::not_computable, {}, {}};
}

const Fields<DesignResult>& outcome_fields() {
  static const Fields<DesignResult> fields = fields_of_outcomes();
  return fields;
}

namespace {

constexpr std::uint64_t max_points = 10000;  // per axis

std::vector<std::string> names_of(const Test& input) {
  std::vector<std::string> names;
  for (const auto& known : design_parameters())
    if (value_of(input, known.name)) names.emplace_back(known.name);
  return names;
}

const DesignParameter& parameter_named(const Test& input, std::string_view name) {
  for (const auto& known : design_parameters())
    if (known.name == name && value_of(input, known.name)) return known;
  const auto names = names_of(input);
  throw InputError(
      {.problem = fmt::format("{} is not a number of this case, one of {}", in_quotes(name), listed(names)),
       .remedy = did_you_mean(name, names)});
}

std::uint64_t points_from(std::string_view text) {
  std::uint64_t points = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), points);
  if (error == std::errc() && end == text.data() + text.size() && points >= 2 && points <= max_points) return points;
  throw InputError({.problem = fmt::format("{} is not a number of points from 2 to {}", in_quotes(text), max_points)});
}

}  // namespace

DesignAxis map_axis(const Test& input, std::string_view text, std::uint64_t usual_points) {
  const auto cut = [&](std::string_view& rest, char at) {
    const std::size_t end = std::min(rest.find(at), rest.size());
    const std::string_view part = trimmed(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return part;
  };
  std::string_view rest = text;
  const std::string_view name = cut(rest, '=');
  const std::string_view first = cut(rest, ':');
  const std::string_view last = cut(rest, ':');
  if (first.empty() || last.empty())
    throw InputError({.problem = fmt::format("{} is not a name and its range", in_quotes(text)),
                      .remedy = "write it as \"stiffness=10 N/m:1000 N/m\""});
  const DesignParameter& parameter = parameter_named(input, name);
  const bool is_plain = input.reduced && parameter.kind().dimension != kind::angle.dimension;
  const Kind& as = is_plain ? kind::number : parameter.kind();
  const double from = parse_quantity(first, as);
  const double to = parse_quantity(last, as);
  if (!(from != to && std::isfinite(from) && std::isfinite(to)))
    throw InputError({.problem = fmt::format("{} is not a range with two different, finite ends", in_quotes(text))});
  const std::uint64_t points = rest.empty() ? usual_points : points_from(trimmed(rest));
  Test trial = input;
  for (const double end : {from, to}) set(trial, parameter.name, end);

  constexpr double decade = 10;
  const bool is_logarithmic = from > 0 && to > 0 && std::max(from / to, to / from) >= decade;
  return {parameter, AxisRange{from, to, is_logarithmic ? Spacing::logarithmic : Spacing::linear, points}};
}

std::vector<DesignAxis> map_axes(const Test& input, const std::vector<std::string>& texts) {
  constexpr std::uint64_t points_of_curve = 101;
  constexpr std::uint64_t points_of_map = 41;
  constexpr std::uint64_t max_designs = 1'000'000;  // all are held in memory
  if (texts.size() > 2)
    throw InputError({.field = "--over",
                      .problem = fmt::format("One parameter or two can be varied, not {}", texts.size()),
                      .remedy = "use flexslip sweep, which takes any number"});
  std::vector<DesignAxis> axes;
  for (const std::string& text : texts) try {
      axes.push_back(map_axis(input, text, texts.size() == 1 ? points_of_curve : points_of_map));
    } catch (const InputError& error) {
      throw located(error, "", 0, "--over");
    }
  if (axes.size() == 2 && axes[0].parameter.name == axes[1].parameter.name)
    throw InputError({.field = "--over", .problem = "The same parameter is given twice"});
  std::uint64_t designs = 1;
  for (const DesignAxis& axis : axes) designs *= points_of(axis);
  if (designs > max_designs)
    throw InputError({.field = "--over",
                      .problem = fmt::format("The map has {} designs, more than the limit of {}", designs, max_designs),
                      .remedy = "take fewer points, or flexslip sweep, which takes as many as the disk holds"});
  return axes;
}

std::vector<MapPoint> design_map(const Test& input, const std::vector<DesignAxis>& axes, unsigned threads) {
  std::uint64_t count = 1;
  for (const DesignAxis& axis : axes) count *= points_of(axis);
  std::vector<MapPoint> points(count);
  for_each_index(count, threads, [&](std::size_t i) {
    MapPoint& point = points[i];
    point.values = grid_inputs(axes, i);
    const Test there = with_values(input, axes, point.values);
    point.result = result_of(there);
    point.margin =
        point.result.outcome ? stiffness_margin(design_of(there).design, *point.result.outcome) : not_a_number;
  });
  return points;
}

std::vector<BorderPiece> border_of_snapping(const std::vector<DesignAxis>& axes, const std::vector<MapPoint>& points) {
  const std::size_t columns = points_of(axes.at(1)), rows = points.size() / columns;
  const auto at = [&](std::size_t i, std::size_t j) { return &points[i * columns + j]; };
  std::vector<BorderPiece> border;
  for (std::size_t i = 0; i + 1 < rows; ++i)
    for (std::size_t j = 0; j + 1 < columns; ++j) {
      const std::array corners{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), at(i, j)};
      std::vector<std::array<double, 2>> crossings;
      for (std::size_t c = 0; c < 4; ++c) {
        const MapPoint &a = *corners[c], &b = *corners[c + 1];
        if (std::isnan(a.margin) || std::isnan(b.margin) || (a.margin > 0) == (b.margin > 0)) continue;
        const double share = a.margin / (a.margin - b.margin);
        auto& crossing = crossings.emplace_back();
        for (std::size_t k = 0; k < 2; ++k) {
          const AxisRange& range = std::get<AxisRange>(axes[k].values);
          crossing[k] = range.spacing == Spacing::logarithmic ? a.values[k] * std::pow(b.values[k] / a.values[k], share)
                                                              : std::lerp(a.values[k], b.values[k], share);
        }
      }
      for (std::size_t c = 0; c + 1 < crossings.size(); c += 2) border.push_back({crossings[c], crossings[c + 1]});
    }
  return border;
}

}  // namespace flexslip
