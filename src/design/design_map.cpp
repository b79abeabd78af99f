#include "design/design_map.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "io/input_error.h"
#include "io/parallel.h"
#include "io/text.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

constexpr std::uint64_t most_points = 10000;  // of an axis

std::vector<std::string> names_of(const DesignCase& input) {
  std::vector<std::string> names;
  for (const auto& known : design_parameters())
    if (input.has(known.parameter)) names.emplace_back(known.name);
  return names;
}

const DesignParameterName& parameter_named(const DesignCase& input, std::string_view name) {
  for (const auto& known : design_parameters())
    if (known.name == name && input.has(known.parameter)) return described(known.parameter);
  const auto names = names_of(input);
  const std::string meant = nearest(name, names);
  throw InputError({.expected = "a number of this case, one of " + listed(names),
                    .found = in_quotes(name),
                    .remedy = meant.empty() ? "" : fmt::format("did you mean {}?", in_quotes(meant))});
}

std::uint64_t points_from(std::string_view text) {
  std::uint64_t points = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), points);
  if (error == std::errc() && end == text.data() + text.size() && points >= 2 && points <= most_points) return points;
  throw InputError({.expected = fmt::format("2 to {} points", most_points), .found = in_quotes(text)});
}

}  // namespace

DesignAxis map_axis(const DesignCase& input, std::string_view text, std::uint64_t usual_points) {
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
    throw InputError({.expected = "a name and its range",
                      .found = in_quotes(text),
                      .remedy = "write it as \"stiffness=10 N/m:1000 N/m\""});
  const DesignParameterName& parameter = parameter_named(input, name);
  const bool is_plain = input.reduced() && parameter.kind.dimension != kind::angle.dimension;
  const Kind& as = is_plain ? kind::number : parameter.kind;
  const double from = parse_quantity(first, as);
  const double to = parse_quantity(last, as);
  if (!(from != to && std::isfinite(from) && std::isfinite(to)))
    throw InputError({.expected = "a range with two ends", .found = in_quotes(text)});
  const std::uint64_t points = rest.empty() ? usual_points : points_from(trimmed(rest));
  DesignCase trial = input;
  for (const double end : {from, to}) trial.set(parameter.parameter, end);

  constexpr double decade = 10;
  const bool is_logarithmic = from > 0 && to > 0 && std::max(from / to, to / from) >= decade;
  return {parameter, AxisRange{from, to, is_logarithmic ? Spacing::logarithmic : Spacing::linear, points}};
}

std::vector<DesignAxis> map_axes(const DesignCase& input, const std::vector<std::string>& texts) {
  constexpr std::uint64_t points_of_curve = 101;
  constexpr std::uint64_t points_of_map = 41;
  constexpr std::uint64_t most_designs = 1'000'000;  // all are held in memory
  if (texts.size() > 2)
    throw InputError({.field = "--over",
                      .expected = "one parameter or two",
                      .found = std::to_string(texts.size()),
                      .remedy = "flexslip sweep takes as many as you like"});
  std::vector<DesignAxis> axes;
  for (const std::string& text : texts) try {
      axes.push_back(map_axis(input, text, texts.size() == 1 ? points_of_curve : points_of_map));
    } catch (const InputError& error) {
      throw located(error, "", 0, "--over");
    }
  if (axes.size() == 2 && axes[0].parameter.parameter == axes[1].parameter.parameter)
    throw InputError({.field = "--over", .expected = "two parameters", .found = "the same twice"});
  std::uint64_t designs = 1;
  for (const DesignAxis& axis : axes) designs *= points_of(axis);
  if (designs > most_designs)
    throw InputError({.field = "--over",
                      .expected = fmt::format("at most {} designs", most_designs),
                      .found = std::to_string(designs),
                      .remedy = "take fewer points, or flexslip sweep, which takes as many as the disk"});
  return axes;
}

std::vector<MapPoint> design_map(const DesignCase& input, const std::vector<DesignAxis>& axes, unsigned threads,
                                 const std::atomic<bool>* stop) {
  std::uint64_t count = 1;
  for (const DesignAxis& axis : axes) count *= points_of(axis);
  std::vector<MapPoint> points(count);
  for_each_index(count, threads, [&](std::size_t i) {
    if (stop && *stop) return;
    MapPoint& point = points[i];
    DesignCase there = input;
    point.values = grid_inputs(axes, i);
    for (std::size_t k = 0; k < axes.size(); ++k) there.set(axes[k].parameter.parameter, point.values[k]);
    point.result = result_of(there);
    point.margin =
        point.result.outcome ? stiffness_margin(there.planned().design, *point.result.outcome) : not_a_number;
  });
  if (stop && *stop) return {};
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
