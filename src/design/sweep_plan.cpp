#include "design/sweep_plan.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "case/case_changes.h"
#include "case/keys.h"
#include "case/toml.h"
#include "design/design_result.h"
#include "io/sha256.h"
#include "io/text_file.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

constexpr std::uint64_t max_rows = 1'000'000'000'000;  // three days of a thousand cores; more is a slip of the pen
constexpr std::uint64_t max_axis_points = 1'000'000;   // of an axis; all its values stand in the file
constexpr std::uint64_t many_chunks = 512;             // enough for every core that a cluster gives one person
constexpr std::uint64_t min_chunk = 64;                // [rows] 20 ms of a core: a file for less would cost as much
constexpr std::uint64_t max_chunk = 1 << 16;           // [rows] 20 s of a core: what a kill may lose

enum class Method { grid, latin_hypercube };

constexpr std::string_view example_axis =
    R"(stiffness = { from = "10 N/m", to = "1 kN/m", points = 50, spacing = "log" })";

std::string axis_key(const DesignAxis& axis) { return fmt::format("sweep.axes.{}", axis.parameter.name); }

// A stiffness may be infinite, and a step continuous, in a list.
double listed_value(const Keys& keys, const toml::node& node, const std::string& key,
                    const DesignParameter& parameter) {
  if (parameter.name == "step" && node.value_exact<std::string_view>() == "continuous") return 0;
  const bool is_stiffness = parameter.name == "stiffness";
  return keys.value(node, key, parameter.kind(), is_stiffness ? Range::positive_or_infinite : Range::any);
}

AxisValues read_values(const Keys& axes, const toml::array& array, const DesignParameter& parameter) {
  if (array.empty()) axes.refuse(parameter.name, "at least one value", "an empty array");
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
  if (range.points > max_axis_points)
    keys.refuse("points", fmt::format("at most {} points", max_axis_points), std::to_string(range.points));
  if (range.from == range.to)
    keys.refuse("to", "a value other than from", kind_of_node(keys.need("to")), "leave the axis out, or write a list");
  if (range.spacing == Spacing::logarithmic && !(range.from > 0 && range.to > 0))
    keys.refuse(range.from > 0 ? "to" : "from", "a positive value, as the spacing is \"log\"",
                kind_of_node(keys.need(range.from > 0 ? "to" : "from")), "write spacing = \"linear\"");
  return range;
}

DesignAxis read_axis(const Keys& axes, const toml::node& node, Method method, const DesignParameter& parameter,
                     const Test& input) {
  if (const toml::table* range = node.as_table())
    return {parameter, read_range({*range, axes.key(parameter.name), input}, method, parameter)};
  const toml::array* values = node.as_array();
  if (!values || method == Method::latin_hypercube)
    axes.refuse(parameter.name,
                method == Method::grid ? "{ from = …, to = …, points = … } or a list of values"
                                       : "{ from = …, to = … } in a Latin hypercube",
                kind_of_node(node), fmt::format("write {}", example_axis));
  return {parameter, read_values(axes, *values, parameter)};
}

std::vector<DesignAxis> read_axes(const Keys& axes, Method method, const Test& input, const toml::table& unchanged) {
  std::vector<std::string> known;
  known.reserve(design_parameters().size());
  for (const auto& parameter : design_parameters()) known.emplace_back(parameter.name);
  axes.only(known);
  if (axes.size() == 0)
    throw wrong_value(input, "sweep.axes", "at least one axis", "none", fmt::format("add {}", example_axis));
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
  auto product = static_cast<double>(rows);  // which does not overflow
  if (!hypercube)
    for (const DesignAxis& axis : axes) {
      rows *= points_of(axis);
      product *= static_cast<double>(points_of(axis));
    }
  if (product > static_cast<double>(max_rows))
    sweep.refuse(hypercube ? "samples" : "axes", fmt::format("at most {:.0e} designs", static_cast<double>(max_rows)),
                 fmt::format("{:.3g}", product), hypercube ? "" : "take fewer points on an axis");
  return rows;
}

// A hash of 64 bits: splitmix64 (Steele, Lea & Flood 2014).
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

// Where a permutation of 0, ..., count - 1, chosen by the key, takes i.
std::uint64_t permuted(std::uint64_t i, std::uint64_t count, std::uint64_t key) {
  constexpr int rounds = 6;  // four make a pseudorandom permutation of a good hash (Luby & Rackoff 1988)
  const int half = std::max(1, (static_cast<int>(std::bit_width(count - 1)) + 1) / 2);
  const std::uint64_t mask = (std::uint64_t{1} << half) - 1;
  do {  // on average at most four times
    std::uint64_t left = i >> half;
    std::uint64_t right = i & mask;
    for (int round = 0; round < rounds; ++round)
      left = std::exchange(right, left ^ (mixed(right ^ mixed(key + static_cast<std::uint64_t>(round))) & mask));
    i = left << half | right;
  } while (i >= count);
  return i;
}

// Uniform in [0, 1), a multiple of 2^-53.
double fraction(std::uint64_t bits) { return std::ldexp(static_cast<double>(bits >> 11), -53); }

std::vector<double> inputs_of_sample(const SweepPlan& plan, const LatinHypercube& hypercube, std::uint64_t row) {
  std::vector<double> inputs;
  inputs.reserve(plan.axes.size());
  for (const DesignAxis& axis : plan.axes) {
    // By the parameter, not by the place of its axis: one that is added leaves the others as they were.
    const auto parameter = &design_parameter(axis.parameter.name) - design_parameters().data();
    const std::uint64_t key = mixed(hypercube.seed ^ mixed(static_cast<std::uint64_t>(parameter)));
    const std::uint64_t stratum = permuted(row, hypercube.samples, key);
    const double within_it = fraction(mixed(mixed(key) ^ row));
    const double t = (static_cast<double>(stratum) + within_it) / static_cast<double>(hypercube.samples);
    inputs.push_back(value_at(std::get<AxisRange>(axis.values), t));
  }
  return inputs;
}

// A refusal of a number, told as one of the axis that it stands in.
void set_from_axis(Test& design, const SweepPlan& plan, const DesignAxis& axis, const std::string& key, double value) {
  try {
    set(design, axis.parameter.name, value);
  } catch (const InputError& error) {
    throw wrong_value(plan.input, key, error.fault.expected, error.fault.found, error.fault.remedy);
  }
}

void check(const SweepPlan& plan) {
  Test design = one_loading_of(plan.input);
  for (const DesignAxis& axis : plan.axes) {
    const std::string key = axis_key(axis);
    if (!value_of(design, axis.parameter.name))
      throw wrong_value(plan.input, key, "a parameter that the case has", in_quotes(axis.parameter.name),
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
  SweepPlan plan{read_case(text, source, changes), std::string(text), changes, {}, {}, 0};
  const toml::table unchanged = parse_toml(text, source);
  const toml::table file = with_changes(unchanged, changes);
  const toml::node& section = Keys(file, "", plan.input).need("sweep");
  if (!section.is_table()) throw wrong_value(plan.input, "sweep", "a section [sweep]", kind_of_node(section));
  const Keys sweep(*section.as_table(), "sweep", plan.input);
  sweep.only({"method", "samples", "seed", "axes"});
  const auto method = static_cast<Method>(sweep.word("method", words_of(*case_key("sweep", "method"))));
  if (method == Method::latin_hypercube) {
    plan.method = LatinHypercube{sweep.whole_number("samples", 1), sweep.whole_number("seed", 0)};
  } else {
    for (const std::string_view other : {"samples", "seed"})
      if (sweep.has(other))
        sweep.refuse(other, "method = \"latin hypercube\" beside it", "\"grid\"", "delete it, or change method");
  }
  const toml::node& axes = sweep.need("axes");
  if (!axes.is_table()) sweep.refuse("axes", "a section [sweep.axes]", kind_of_node(axes));
  plan.axes = read_axes({*axes.as_table(), sweep.key("axes"), plan.input}, method, plan.input, unchanged);
  plan.rows = rows_of(sweep, plan.axes, plan.method);
  return plan;
}

SweepPlan read_sweep(const std::string& path, const std::vector<std::string>& changes) {
  SweepPlan plan = read_sweep(case_text(path), path == "-" ? "standard input" : path, changes);
  check(plan);
  return plan;
}

std::vector<std::uint64_t> shape_of(const SweepPlan& plan) {
  std::vector<std::uint64_t> shape;
  if (std::holds_alternative<LatinHypercube>(plan.method)) return shape;
  shape.reserve(plan.axes.size());
  for (const DesignAxis& axis : plan.axes) shape.push_back(points_of(axis));
  return shape;
}

std::vector<double> inputs_of(const SweepPlan& plan, std::uint64_t row) {
  if (row >= plan.rows) throw std::invalid_argument(fmt::format("inputs_of: no row {} of {}", row, plan.rows));
  const auto* hypercube = std::get_if<LatinHypercube>(&plan.method);
  return hypercube ? inputs_of_sample(plan, *hypercube, row) : grid_inputs(plan.axes, row);
}

std::uint64_t row_from_all_over(const SweepPlan& plan, std::uint64_t i) {
  const double place = static_cast<double>(i) * 0.6180339887498949;
  const auto row = static_cast<std::uint64_t>((place - std::floor(place)) * static_cast<double>(plan.rows));
  return std::min(row, plan.rows - 1);
}

std::uint64_t rows_in_chunk(const SweepPlan& plan) {
  return std::clamp(std::bit_ceil(plan.rows / many_chunks), min_chunk, max_chunk);
}

std::uint64_t chunks_of(const SweepPlan& plan) { return (plan.rows - 1) / rows_in_chunk(plan) + 1; }

RowSpan rows_of_chunk(const SweepPlan& plan, std::uint64_t chunk) {
  const std::uint64_t first = chunk * rows_in_chunk(plan);
  if (first >= plan.rows) throw std::invalid_argument(fmt::format("rows_of_chunk: no chunk {}", chunk));
  return {first, std::min(rows_in_chunk(plan), plan.rows - first)};
}

namespace {

StoredAs stored_as(Shape shape) { return shape == Shape::count ? StoredAs::uint32 : StoredAs::float64; }

double number_in(const Json& value, Shape shape) {
  if (!value.is_null()) return value.get<double>();
  return shape == Shape::count ? 0 : not_a_number;
}

}  // namespace

std::vector<SweepColumn> columns_of(const SweepPlan& plan) {
  const auto units = [&](const Kind& kind) { return std::string(unit_of(kind, plan.input.reduced)); };
  std::vector<SweepColumn> columns;
  for (const auto& [parameter, values] : plan.axes)
    columns.push_back({fmt::format("/inputs/{}", parameter.name), units(parameter.kind()),
                       std::string(parameter.description), StoredAs::float64});
  columns.push_back({"/outcomes/status", units(kind::number), "whether the design could be computed, and how it ended",
                     StoredAs::uint8});
  for (const Description& outcome : outcome_fields().descriptions())
    columns.push_back({fmt::format("/outcomes/{}", outcome.name), units(outcome.kind), std::string(outcome.meaning),
                       stored_as(outcome.shape)});
  return columns;
}

std::size_t status_column(const SweepPlan& plan) { return plan.axes.size(); }

RowComputer::RowComputer(const SweepPlan& plan) : loading_(one_loading_of(plan.input)) {
  parameters_.reserve(plan.axes.size());
  for (const DesignAxis& axis : plan.axes) parameters_.push_back(axis.parameter.name);
}

std::vector<double> RowComputer::operator()(std::span<const double> inputs) {
  for (std::size_t i = 0; i < inputs.size(); ++i) set(loading_, parameters_[i], inputs[i]);
  const DesignResult result = result_of(loading_);
  std::vector<double> values{static_cast<double>(result.status)};
  const Frame frame;  // outcomes are in the units of their own design
  for (const auto& outcome : outcome_fields())
    values.push_back(number_in(outcome_fields().of(outcome, result, frame), outcome.what.shape));
  return values;
}

namespace {

// In place of the name of a file, what is in it.
std::string content_digest(const std::string& file) { return digest_of(*open_to_read(file)).sha256; }

std::string text_of_case(Test input) {
  input.record.reset();
  for (std::string* file : files_of(input)) *file = content_digest(*file);
  return to_toml(input);
}

std::string text_of(const DesignAxis& axis) {
  if (const auto* values = std::get_if<AxisValues>(&axis.values))
    return fmt::format("{} {}", axis.parameter.name, *values);
  const auto& range = std::get<AxisRange>(axis.values);
  return fmt::format("{} {} {} {} {}", axis.parameter.name, range.from, range.to, range.points,
                     range.spacing == Spacing::linear ? "linear" : "log");
}

}  // namespace

std::string digest_of_sweep(const SweepPlan& plan) { return digest_of_sweep(plan, RowComputer(plan)); }

std::string digest_of_sweep(const SweepPlan& plan, const RowFunction& outcomes_of) {
  constexpr std::uint64_t answers = 8;
  std::string text = fmt::format("sweep of FlexSlip {}\n{}", FLEXSLIP_VERSION, text_of_case(plan.input));
  if (const auto* hypercube = std::get_if<LatinHypercube>(&plan.method))
    text += fmt::format("latin hypercube {} {}\n", hypercube->samples, hypercube->seed);
  for (const DesignAxis& axis : plan.axes) text += text_of(axis) + "\n";
  for (const SweepColumn& column : columns_of(plan)) text += column.path + "\n";
  for (std::uint64_t i = 0; i < answers; ++i)  // to the last bit
    text += fmt::format("{}\n", outcomes_of(inputs_of(plan, row_from_all_over(plan, i))));
  return sha256_of(text);
}

}  // namespace flexslip
