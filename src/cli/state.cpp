#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "answers/state_fields.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "fibre/elastica.h"
#include "fibre/supported_state.h"
#include "io/input_error.h"

namespace flexslip {
namespace {

struct StateRequest {
  std::string file;
  std::optional<double> S, w, q;
  std::optional<double> radius, thickness;  // of rollers; of the specimen on them
  bool slopes = false;
  Output output;

  bool on_supports() const { return radius || thickness; }
};

// States by length S (edges) or deflection w (rollers), and q. Without a source if the command line
// gives the state.
Table read_input(const StateRequest& request) {
  const std::string first = request.on_supports() ? "w" : "S";
  const auto& value = request.on_supports() ? request.w : request.S;
  if (request.on_supports() && request.S)
    throw InputError({.field = "--S",
                      .problem = "A state on rollers, or of a thick specimen, has a deflection, not a length",
                      .remedy = "write --w, or leave out --roller-radius and --thickness"});
  if (!request.on_supports() && request.w)
    throw InputError({.field = "--w",
                      .problem = "A state on edges has a length, not a deflection",
                      .remedy = "write --S, or add --roller-radius or --thickness"});
  if (value.has_value() != request.q.has_value())
    throw InputError({.field = "state",
                      .problem = fmt::format("Only {} is given; a state needs both --{} and --q",
                                             value ? fmt::format("--{}", first) : "--q", first)});
  if (value.has_value() == !request.file.empty())
    throw InputError({.field = "state",
                      .problem = fmt::format("Either a file or --{} and --q are needed, and {} given", first,
                                             value ? "both are" : "neither is"),
                      .remedy = value ? "" : "write - for standard input, or see flexslip state --help"});
  if (value) return {"", {{first, {*value}}, {"q", {*request.q}}}, {0}};
  return read_table(request.file, {{first, kind::number}, {"q", kind::number}});
}

void require_domain(const Table& input) {
  const auto refuse = [&](std::size_t row, const Column& column, std::string expected) {
    InputFault fault =
        wrong_cell(input, row, column, fmt::format("The value {} is not {}", column.values[row], expected)).fault;
    if (input.source.empty()) fault.field = fmt::format("--{}", column.name);
    throw InputError(std::move(fault));
  };
  const Column &first = input.columns[0], &q = input.columns[1];
  for (std::size_t row = 0; row < input.rows(); ++row) {
    const double value = first.values[row];
    if (first.name == "S" && !(value >= 1 && std::isfinite(value)))
      refuse(row, first, "a length of at least 1, in spans");
    if (first.name == "w" && !(value > 0 && value <= deepest_on_supports))
      refuse(row, first, "a deflection of 0 to 2 spans");
    if (!(std::abs(q.values[row]) <= largest_q))
      refuse(row, q, fmt::format("mobilised friction from {:g} to {:g}", -largest_q, largest_q));
  }
}

// Writes the states of all rows. The error names the first row without a state, and the reason.
template <class State, class Compute, class Why>
void run_rows(const StateRequest& request, const Table& input, const Fields<State>& fields, Compute compute, Why why) {
  std::vector<State> states;
  std::vector<std::size_t> missing;
  const std::vector<double>&values = input.columns[0].values, &q = input.columns[1].values;
  for (std::size_t row = 0; row < input.rows(); ++row) {
    states.push_back(compute(values[row], q[row]));
    if (!states.back().state) missing.push_back(row);
  }
  write_rows(request.output, states_fields(no_state, fields), {missing.empty() ? "ok" : "beyond_branch", states},
             fields, states, {Scales(1, 1), true});
  if (missing.empty()) return;
  const std::size_t row = missing.front();
  throw CalculationFailed(fmt::format(
      "{}{}{}", input.source.empty() ? "" : fmt::format("{}:{}: ", input.source, input.lines[row]),
      why(values[row], q[row]),
      missing.size() == 1 ? "" : fmt::format("; nor for {} more rows, which are written as nan", missing.size() - 1)));
}

void run_on_supports(const StateRequest& request, const Table& input) {
  const Supports supports = within_limits({request.radius.value_or(0), 0.5 * request.thickness.value_or(0)});
  if (request.slopes)
    throw InputError(
        {.field = "--slopes", .problem = "Slopes are written for edges only, not for rollers or a thickness"});
  run_rows(
      request, input, roller_state_fields(),
      [&](double w, double q) {
        const SupportedState state = state_on_supports(w, q, supports);
        return RollerState{w, state.status == FibreStatus::ok ? std::optional(state) : std::nullopt};
      },
      [](double w, double q) {
        return fmt::format("no state with a force exists at w = {}, q = {} on these supports", w, q);
      });
}

void run_state(const StateRequest& request) {
  const Table input = read_input(request);
  require_domain(input);
  if (request.on_supports()) return run_on_supports(request, input);
  run_rows(
      request, input, edge_state_fields(request.slopes),
      [&](double S, double q) {
        EdgeState row{.S = S, .q = q};
        const FibreState state = fibre_state(S, q);
        if (state.status == FibreStatus::ok) row.state = state;
        if (row.state && request.slopes && S != 1) row.slopes = fibre_state_slopes(S, q).slopes;
        return row;
      },
      [](double S, double q) {
        return fmt::format("no state exists at S = {}, q = {}, as the force falls to zero at S = {:.6g}", S, q,
                           fibre_branch_end(q).S);
      });
}

}  // namespace

void add_state_command(CLI::App& app) {
  const auto [command, request] = add_command(
      app, "state", "Deflection, force, slope and energy of single states of a specimen, in reduced variables",
      run_state);
  add_option(command, "file FILE", request.file, "CSV with the columns S,q (on rollers w,q); - is standard input");
  add_option(command, "--S NUMBER", request.S, "Length between the supports, in spans");
  add_option(command, "--q NUMBER", request.q, "Mobilised friction: tangential over normal force at a support");
  add_option(command, "--w NUMBER", request.w, "Deflection at midspan, in spans; on rollers, instead of --S");
  add_option(command, "--roller-radius NUMBER", request.radius, "Radius of fixed rollers as supports, in spans");
  add_option(command, "--thickness NUMBER", request.thickness,
             "Thickness of the specimen, in spans; friction acts at its surface");
  command.add_flag("--slopes", request.slopes, "Also write the partial derivatives with respect to S and q");
  add_output_options(command, request.output, "CSV");
  add_csv_option(command, request.output);
  command.footer(
      "Reads and writes reduced variables: lengths in spans L, forces in EI/L^2, energies in EI/L.\n"
      "Writes S,q,w,F,theta0,Pn,U,curvature: deflection, force, support slope, normal force at one support,\n"
      "bending energy and curvature at midspan. The curvature times half the depth of the specimen is the bending\n"
      "strain. A state that does not exist is written as nan, and the exit code is 1.\n"
      "\n"
      "With --roller-radius or --thickness, a state is given by its deflection w, and the columns are w,q,F,theta0,\n"
      "Pn,U,curvature,length,slid,imaged. The last three are lengths, and equal on edges: length is the length of the\n"
      "axis between the contacts, slid is the length of surface that has slid past the contacts, and imaged is the\n"
      "length of the axis between the vertical planes through the supports.\n\n"
      "Examples:\n"
      "  flexslip state --S 1.2 --q 0.3\n"
      "  flexslip state --w 0.1 --q 0 --roller-radius 0.078 --thickness 0.0625\n"
      "  flexslip state states.csv --output results.csv");
}

}  // namespace flexslip
