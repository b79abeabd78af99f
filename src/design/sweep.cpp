#include "design/sweep.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "case/case_changes.h"
#include "case/keys.h"
#include "case/toml.h"
#include "design/design_result.h"
#include "io/parallel.h"
#include "numerics/effort.h"

namespace flexslip {
namespace {

// three days on a thousand cores; more is a typing error
constexpr std::uint64_t max_rows = 1'000'000'000'000;

enum class Method { grid, latin_hypercube };

constexpr std::string_view example_axis =
    R"(stiffness = { from = "10 N/m", to = "1 kN/m", points = 50, spacing = "log" })";

std::string axis_key(const DesignAxis& axis) { return fmt::format("sweep.axes.{}", axis.parameter.name); }

// A value in a list. A stiffness may be infinite and a step continuous.
double listed_value(const Keys& keys, const toml::node& node, const std::string& key,
                    const DesignParameter& parameter) {
  if (parameter.name == "step" && node.value_exact<std::string_view>() == "continuous") return 0;
  const bool is_stiffness = parameter.name == "stiffness";
  return keys.value(node, key, parameter.kind(), is_stiffness ? Range::positive_or_infinite : Range::any);
}

AxisValues read_values(const Keys& axes, const toml::array& array, const DesignParameter& parameter) {
  if (array.empty()) axes.refuse(parameter.name, "The list of values is empty");
  AxisValues values;
  values.reserve(array.size());
  for (std::size_t i = 0; i < array.size(); ++i)
    values.push_back(listed_value(axes, array[i], fmt::format("{}[{}]", axes.key(parameter.name), i + 1), parameter));
  return values;
}

AxisRange read_range(const Keys& keys, Method method, const DesignParameter& parameter) {
  const bool is_grid = method == Method::grid;
  keys.only(is_grid ? std::vector<std::string>{"from", "to", "points", "spacing"}
                    : std::vector<std::string>{"from", "to", "spacing"});
  AxisRange range{keys.quantity("from", parameter.kind(), Range::any),
                  keys.quantity("to", parameter.kind(), Range::any),
                  keys.has("spacing") ? static_cast<Spacing>(keys.word("spacing", {"linear", "log"})) : Spacing::linear,
                  is_grid ? keys.whole_number("points", 2) : 0};
  if (range.from == range.to)
    keys.refuse("to", fmt::format("Both ends of the range are {}", kind_of_node(keys.need("to"))),
                "leave the axis out, or write a list");
  if (range.spacing == Spacing::logarithmic && !(range.from > 0 && range.to > 0))
    keys.refuse(range.from > 0 ? "to" : "from",
                fmt::format("The spacing is \"log\", which needs positive values, not {}",
                            kind_of_node(keys.need(range.from > 0 ? "to" : "from"))),
                "write spacing = \"linear\"");
  return range;
}

DesignAxis read_axis(const Keys& axes, const toml::node& node, Method method, const DesignParameter& parameter,
                     const Test& input) {
  if (const toml::table* range = node.as_table())
    return {parameter, read_range({*range, axes.key(parameter.name), input}, method, parameter)};
  const toml::array* values = node.as_array();
  if (!values || method == Method::latin_hypercube)
    axes.refuse(parameter.name,
                fmt::format("{} is not {}", kind_of_node(node),
                            method == Method::grid ? "{ from = …, to = …, points = … } or a list of values"
                                                   : "{ from = …, to = … } in a Latin hypercube"),
                fmt::format("write {}", example_axis));
  return {parameter, read_values(axes, *values, parameter)};
}

std::vector<DesignAxis> read_axes(const Keys& axes, Method method, const Test& input, const toml::table& unchanged) {
  std::vector<std::string> known;
  known.reserve(design_parameters().size());
  for (const auto& parameter : design_parameters()) known.emplace_back(parameter.name);
  axes.only(known);
  if (axes.size() == 0)
    throw wrong_value(input, "sweep.axes", "The sweep has no axis", fmt::format("add {}", example_axis));
  std::vector<std::pair<toml::source_position, DesignAxis>> placed;
  for (const auto& parameter : design_parameters())
    if (const toml::node* node = axes.find(parameter.name)) {
      constexpr auto last = std::numeric_limits<toml::source_index>::max();
      const auto before = unchanged["sweep"]["axes"][parameter.name];
      placed.emplace_back(before ? before.node()->source().begin : toml::source_position{last, last},
                          read_axis(axes, *node, method, parameter, input));
    }
  std::stable_sort(placed.begin(), placed.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<DesignAxis> in_order;
  in_order.reserve(placed.size());
  for (auto& [position, axis] : placed) in_order.push_back(std::move(axis));
  return in_order;
}

std::uint64_t rows_of(const Keys& sweep, const std::vector<DesignAxis>& axes,
                      const std::variant<Grid, LatinHypercube>& method) {
  const auto* hypercube = std::get_if<LatinHypercube>(&method);
  std::uint64_t rows = hypercube ? hypercube->samples : 1;
  auto product = static_cast<double>(rows);  // cannot overflow
  if (!hypercube)
    for (const DesignAxis& axis : axes) {
      rows *= points_of(axis);
      product *= static_cast<double>(points_of(axis));
    }
  if (product > static_cast<double>(max_rows))
    sweep.refuse(hypercube ? "samples" : "axes",
                 fmt::format("The sweep has {:.3g} designs, more than the limit of {:.0e}", product,
                             static_cast<double>(max_rows)),
                 hypercube ? "" : "take fewer points on an axis");
  return rows;
}

// A hash of 64 bits: splitmix64 (Steele, Lea & Flood 2014).
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

// The image of i under a permutation of 0, ..., count - 1, selected by the key.
std::uint64_t permuted(std::uint64_t i, std::uint64_t count, std::uint64_t key) {
  // four give a pseudorandom permutation with a good hash (Luby & Rackoff 1988)
  constexpr int rounds = 6;
  const int half = std::max(1, (static_cast<int>(std::bit_width(count - 1)) + 1) / 2);
  const std::uint64_t mask = (std::uint64_t{1} << half) - 1;
  do {  // at most four times on average
    std::uint64_t left = i >> half;
    std::uint64_t right = i & mask;
    for (int round = 0; round < rounds; ++round)
      left = std::exchange(right, left ^ (mixed(right ^ mixed(key + static_cast<std::uint64_t>(round))) & mask));
    i = left << half | right;
  } while (i >= count);
  return i;
}

// A uniform number in [0, 1), a multiple of 2^-53.
double fraction(std::uint64_t bits) { return std::ldexp(static_cast<double>(bits >> 11), -53); }

std::vector<double> inputs_of_sample(const SweepPlan& plan, const LatinHypercube& hypercube, std::uint64_t row) {
  std::vector<double> inputs;
  inputs.reserve(plan.axes.size());
  for (const DesignAxis& axis : plan.axes) {
    // The stratum depends on the parameter, not on the position of its axis, so a new axis does not
    // change the others.
    const auto parameter = &design_parameter(axis.parameter.name) - design_parameters().data();
    const std::uint64_t key = mixed(hypercube.seed ^ mixed(static_cast<std::uint64_t>(parameter)));
    const std::uint64_t stratum = permuted(row, hypercube.samples, key);
    const double within_it = fraction(mixed(mixed(key) ^ row));
    const double t = (static_cast<double>(stratum) + within_it) / static_cast<double>(hypercube.samples);
    inputs.push_back(value_at(std::get<AxisRange>(axis.values), t));
  }
  return inputs;
}

// Sets a value; a refusal names the axis.
void set_from_axis(Test& design, const SweepPlan& plan, const DesignAxis& axis, const std::string& key, double value) {
  try {
    set(design, axis.parameter.name, value);
  } catch (const InputError& error) {
    throw wrong_value(plan.loading, key, error.fault.problem, error.fault.remedy);
  }
}

void check(const SweepPlan& plan) {
  Test design = plan.loading;
  for (const DesignAxis& axis : plan.axes) {
    const std::string key = axis_key(axis);
    if (!value_of(design, axis.parameter.name))
      throw wrong_value(plan.loading, key, fmt::format("The case has no parameter {}", in_quotes(axis.parameter.name)),
                        "choose another axis, or another kind of case");
    if (const auto* range = std::get_if<AxisRange>(&axis.values)) {
      set_from_axis(design, plan, axis, key + ".from", range->from);
      set_from_axis(design, plan, axis, key + ".to", range->to);
    } else {
      const auto& values = std::get<AxisValues>(axis.values);
      for (std::size_t i = 0; i < values.size(); ++i)
        set_from_axis(design, plan, axis, fmt::format("{}[{}]", key, i + 1), values[i]);
    }
  }
}

}  // namespace

SweepPlan read_sweep(std::string_view text, const std::string& source, const std::vector<std::string>& changes) {
  const Test input = read_case(text, source, changes);
  const toml::table unchanged = parse_toml(text, source);
  const toml::table file = with_changes(unchanged, changes);
  const toml::node& section = Keys(file, "", input).need("sweep");
  if (!section.is_table())
    throw wrong_value(input, "sweep", fmt::format("The case needs a section [sweep], not {}", kind_of_node(section)));
  const Keys sweep(*section.as_table(), "sweep", input);
  sweep.only({"method", "samples", "seed", "axes"});
  const auto method = static_cast<Method>(sweep.word("method", words_of(*case_key("sweep", "method"))));
  SweepPlan plan;
  if (method == Method::latin_hypercube) {
    plan.method = LatinHypercube{sweep.whole_number("samples", 1), sweep.whole_number("seed", 0)};
  } else {
    for (const std::string_view other : {"samples", "seed"})
      if (sweep.has(other))
        sweep.refuse(other, "This key belongs to method = \"latin hypercube\", and the method is \"grid\"",
                     "delete it, or change method");
  }
  const toml::node& axes = sweep.need("axes");
  if (!axes.is_table())
    sweep.refuse("axes", fmt::format("The sweep needs a section [sweep.axes], not {}", kind_of_node(axes)));
  plan.axes = read_axes({*axes.as_table(), sweep.key("axes"), input}, method, input, unchanged);
  plan.rows = rows_of(sweep, plan.axes, plan.method);
  plan.loading = one_loading_of(input);
  check(plan);
  return plan;
}

SweepPlan read_sweep(const std::string& path, const std::vector<std::string>& changes) {
  return read_sweep(case_text(path), path == "-" ? "standard input" : path, changes);
}

std::vector<double> inputs_of(const SweepPlan& plan, std::uint64_t row) {
  if (row >= plan.rows) throw std::invalid_argument(fmt::format("inputs_of: no row {} of {}", row, plan.rows));
  const auto* hypercube = std::get_if<LatinHypercube>(&plan.method);
  return hypercube ? inputs_of_sample(plan, *hypercube, row) : grid_inputs(plan.axes, row);
}

std::vector<DesignPoint> points_of(const SweepPlan& plan, RowSpan rows, unsigned threads) {
  std::vector<DesignPoint> points(rows.count);
  for_each_index(points.size(), threads, [&](std::size_t i) {
    effort_spent += 1;  // lets designs that are refused at once be stopped, too
    points[i].values = inputs_of(plan, rows.first + i);
    points[i].result = result_of(with_values(plan.loading, plan.axes, points[i].values));
  });
  return points;
}

}  // namespace flexslip
