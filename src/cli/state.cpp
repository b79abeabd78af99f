#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "answers/state_fields.h"
#include "cli/case_flags.h"
#include "cli/commands.h"
#include "cli/output.h"
#include "fibre/elastica.h"
#include "fibre/supported_state.h"
#include "io/input_error.h"

namespace flexslip {
namespace {

struct StateRequest {
  std::string file;
  std::optional<double> S, w, q;
  std::optional<double> radius, thickness;  // of rollers, and of the specimen on them
  bool slopes = false;
  Output output;

  bool on_supports() const { return radius || thickness; }
};

// States by their length, on edges, or by their deflection, on rollers.
struct Input {
  std::string source;  // empty: the command line
  std::string first;   // "S" or "w"
  std::vector<double> values, q;
  std::vector<std::size_t> lines;
};

Input read_input(const StateRequest& request) {
  const std::string first = request.on_supports() ? "w" : "S";
  const auto& value = request.on_supports() ? request.w : request.S;
  if (request.on_supports() && request.S)
    throw InputError({.field = "--S",
                      .expected = "a deflection, as the supports are rollers",
                      .found = "a length",
                      .remedy = "write --w, or leave out --roller-radius and --thickness"});
  if (!request.on_supports() && request.w)
    throw InputError({.field = "--w",
                      .expected = "a length, as the supports are edges",
                      .found = "a deflection",
                      .remedy = "write --S, or add --roller-radius or --thickness"});
  if (value.has_value() != request.q.has_value())
    throw InputError({.field = "state",
                      .expected = fmt::format("both --{} and --q", first),
                      .found = value ? fmt::format("--{} alone", first) : "--q alone"});
  if (value.has_value() == !request.file.empty())
    throw InputError({.field = "state",
                      .expected = fmt::format("either a file or --{} and --q", first),
                      .found = value ? "both" : "neither",
                      .remedy = value ? "" : "write - for standard input, or see flexslip state --help"});
  if (value) return {"", first, {*value}, {*request.q}, {0}};
  const Table table = read_table(request.file, {{first, kind::number}, {"q", kind::number}});
  return {table.source, first, table.columns[0].values, table.columns[1].values, table.lines};
}

void require_domain(const Input& input) {
  const auto refuse = [&](std::size_t row, std::string_view name, std::string expected, double found) {
    const bool has_file = !input.source.empty();
    throw InputError({.file = input.source,
                      .line = input.lines[row],
                      .field = has_file ? fmt::format("column '{}'", name) : fmt::format("--{}", name),
                      .expected = std::move(expected),
                      .found = fmt::format("{}", found)});
  };
  for (std::size_t row = 0; row < input.q.size(); ++row) {
    const double value = input.values[row];
    const double q = input.q[row];
    if (input.first == "S" && !(value >= 1 && std::isfinite(value)))
      refuse(row, "S", "a length of at least 1, in spans", value);
    if (input.first == "w" && !(value > 0 && value <= deepest_on_supports))
      refuse(row, "w", "a deflection of 0 to 2 spans", value);
    if (!(std::abs(q) <= largest_q))
      refuse(row, "q", fmt::format("mobilised friction from {:g} to {:g}", -largest_q, largest_q), q);
  }
}

// What was calculated; the rows without a state are nan.
template <class State>
void write_states(const StateRequest& request, const Fields<State>& fields, const std::vector<State>& states,
                  bool all_exist) {
  const Frame frame{Scales(1, 1), true};
  if (request.output.json)
    write_json(request.output.path,
               states_fields(no_state, fields)({all_exist ? "ok" : "beyond_branch", states}, frame));
  else
    write_csv(request.output.path, fields, states, frame);
}

std::string place_of(const Input& input, std::size_t row) {
  return input.source.empty() ? "" : fmt::format("{}:{}: ", input.source, input.lines[row]);
}

std::string likewise(const std::vector<std::size_t>& missing) {
  return missing.size() == 1 ? "" : fmt::format("; nor for {} more rows, which are written as nan", missing.size() - 1);
}

void run_states_on_supports(const StateRequest& request, const Input& input) {
  const Supports supports = within_limits({request.radius.value_or(0), 0.5 * request.thickness.value_or(0)});
  if (request.slopes)
    throw InputError({.field = "--slopes", .expected = "edges as supports", .found = "rollers or a thickness"});
  std::vector<RollerState> states;
  std::vector<std::size_t> missing;
  for (std::size_t row = 0; row < input.q.size(); ++row) {
    const SupportedState state = state_on_supports(input.values[row], input.q[row], supports);
    states.push_back({.w = input.values[row]});
    if (state.status == FibreStatus::ok)
      states.back().state = state;
    else
      missing.push_back(row);
  }
  write_states(request, roller_state_fields(), states, missing.empty());
  if (missing.empty()) return;
  const std::size_t row = missing.front();
  throw CalculationFailed(fmt::format("{}no state with a force exists at w = {}, q = {} on these supports{}",
                                      place_of(input, row), input.values[row], input.q[row], likewise(missing)));
}

void run_state(const StateRequest& request) {
  const Input input = read_input(request);
  require_domain(input);
  if (request.on_supports()) return run_states_on_supports(request, input);
  std::vector<EdgeState> states;
  std::vector<std::size_t> missing;
  for (std::size_t row = 0; row < input.q.size(); ++row) {
    states.push_back({.S = input.values[row], .q = input.q[row]});
    const FibreState state = fibre_state(input.values[row], input.q[row]);
    if (state.status != FibreStatus::ok) {
      missing.push_back(row);
      continue;
    }
    states.back().state = state;
    if (request.slopes && input.values[row] != 1)
      states.back().slopes = fibre_state_slopes(input.values[row], input.q[row]).slopes;
  }
  write_states(request, edge_state_fields(request.slopes), states, missing.empty());
  if (missing.empty()) return;

  const std::size_t row = missing.front();
  throw CalculationFailed(fmt::format("{}no state exists at S = {}, q = {}, as the force falls to zero at S = {:.6g}{}",
                                      place_of(input, row), input.values[row], input.q[row],
                                      fibre_branch_end(input.q[row]).S, likewise(missing)));
}

}  // namespace

void add_state_command(CLI::App& app) {
  const auto request = std::make_shared<StateRequest>();
  CLI::App* command = app.add_subcommand(
      "state", "Deflection, force, slope and energy of single states of a specimen, in reduced variables");
  command->add_option("file", request->file, "CSV with the columns S,q (on rollers w,q); - is standard input")
      ->type_name("FILE");
  command->add_option("--S", request->S, "Length between the supports, in spans")->type_name("NUMBER");
  command->add_option("--q", request->q, "Mobilised friction: tangential over normal force at a support")
      ->type_name("NUMBER");
  command->add_option("--w", request->w, "Deflection at midspan, in spans; on rollers, instead of --S")
      ->type_name("NUMBER");
  command->add_option("--roller-radius", request->radius, "Radius of fixed rollers as supports, in spans")
      ->type_name("NUMBER");
  command
      ->add_option("--thickness", request->thickness,
                   "Thickness of the specimen, in spans; friction acts at its surface")
      ->type_name("NUMBER");
  command->add_flag("--slopes", request->slopes, "Also write the partial derivatives with respect to S and q");
  add_output_options(*command, request->output);
  command->footer(
      "Reads and writes reduced variables: lengths in spans L, forces in EI/L^2, energies in EI/L.\n"
      "Writes S,q,w,F,theta0,Pn,U,curvature: deflection, force, support slope, normal force at one support,\n"
      "bending energy and curvature at midspan. The curvature times half the depth of the specimen is the bending\n"
      "strain. A state that does not exist is written as nan, and the exit code is 1.\n"
      "\n"
      "With --roller-radius or --thickness, a state is given by its deflection w, and the columns are w,q,F,theta0,\n"
      "Pn,U,curvature,length,slid,imaged. The last three are lengths, and equal on edges: length is that of the axis\n"
      "between the contacts, slid is what has slid past the contacts along the surface, and imaged is that of the\n"
      "axis between the verticals through the supports.\n\n"
      "Examples:\n"
      "  flexslip state --S 1.2 --q 0.3\n"
      "  flexslip state --w 0.1 --q 0 --roller-radius 0.078 --thickness 0.0625\n"
      "  flexslip state states.csv --output results.csv");
  command->callback([request] { run_state(*request); });
}

}  // namespace flexslip
