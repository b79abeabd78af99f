#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/output.h"
#include "fibre/elastica.h"
#include "io/input_error.h"

namespace flexslip {
namespace {

struct StateRequest {
  std::string file;
  std::optional<double> S;
  std::optional<double> q;
  bool slopes = false;
  Output output;
};

struct Input {
  std::string source;  // empty: the command line
  std::vector<double> S, q;
  std::vector<std::size_t> lines;
};

Input read_input(const StateRequest& request) {
  if (request.S.has_value() != request.q.has_value())
    throw InputError(
        {.field = "state", .expected = "both --S and --q", .found = request.S ? "--S alone" : "--q alone"});
  if (request.S.has_value() == !request.file.empty())
    throw InputError({.field = "state",
                      .expected = "either a file or --S and --q",
                      .found = request.S ? "both" : "neither",
                      .remedy = request.S ? "" : "write - for standard input, or see flexslip state --help"});
  if (request.S) return {"", {*request.S}, {*request.q}, {0}};
  const Table table = read_table(request.file, {{"S", kind::number}, {"q", kind::number}});
  Input input{table.source, table.columns[0].values, table.columns[1].values, {}};
  for (std::size_t row = 0; row < table.rows(); ++row) input.lines.push_back(table.line_of(row));
  return input;
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
  for (std::size_t row = 0; row < input.S.size(); ++row) {
    const double S = input.S[row];
    const double q = input.q[row];
    if (!(S >= 1 && std::isfinite(S))) refuse(row, "S", "a length of at least 1, in spans", S);
    if (!(std::abs(q) <= largest_q))
      refuse(row, "q", fmt::format("mobilised friction from {:g} to {:g}", -largest_q, largest_q), q);
  }
}

constexpr std::array<std::string_view, 6> result_names{"w", "F", "theta0", "Pn", "U", "curvature"};
constexpr std::array<std::string_view, 8> slope_names{"w_S", "w_q", "F_S", "F_q", "Pn_S", "Pn_q", "U_S", "U_q"};

void run_state(const StateRequest& request) {
  const Input input = read_input(request);
  require_domain(input);
  const std::size_t n = input.S.size();
  const double none = std::numeric_limits<double>::quiet_NaN();

  std::array<std::vector<double>, result_names.size()> results;
  std::array<std::vector<double>, slope_names.size()> slopes;
  for (auto& column : results) column.assign(n, none);
  for (auto& column : slopes) column.assign(request.slopes ? n : 0, none);
  std::vector<std::size_t> missing;
  for (std::size_t row = 0; row < n; ++row) {
    const FibreState state = fibre_state(input.S[row], input.q[row]);
    if (state.status != FibreStatus::ok) {
      missing.push_back(row);
      continue;
    }
    const std::array values{state.w, state.F, state.theta0, state.Pn, state.U, curvature_at_midspan(state)};
    for (std::size_t i = 0; i < values.size(); ++i) results[i][row] = values[i];
    if (!request.slopes || input.S[row] == 1) continue;
    const FibreSlopes at = fibre_state_slopes(input.S[row], input.q[row]).slopes;
    const std::array derivatives{at.w_S, at.w_q, at.F_S, at.F_q, at.Pn_S, at.Pn_q, at.U_S, at.U_q};
    for (std::size_t i = 0; i < derivatives.size(); ++i) slopes[i][row] = derivatives[i];
  }

  std::vector<OutputColumn> columns{{"S", input.S}, {"q", input.q}};
  for (std::size_t i = 0; i < results.size(); ++i) columns.push_back({std::string(result_names[i]), results[i]});
  if (request.slopes)
    for (std::size_t i = 0; i < slopes.size(); ++i) columns.push_back({std::string(slope_names[i]), slopes[i]});
  if (request.output.json)
    write_json(request.output.path,
               {{"status", missing.empty() ? "ok" : "beyond_branch"}, {"states", rows_json(columns)}});
  else
    write_table(request.output.path, columns);
  if (missing.empty()) return;

  const std::size_t row = missing.front();
  const std::string place = input.source.empty() ? "" : fmt::format("{}:{}: ", input.source, input.lines[row]);
  throw CalculationFailed(fmt::format(
      "{}no state at S = {}, q = {}: there the force has fallen to zero, at S = {:.6g}{}", place, input.S[row],
      input.q[row], fibre_branch_end(input.q[row]).S,
      missing.size() == 1 ? "" : fmt::format("; likewise {} more rows, written as nan", missing.size() - 1)));
}

}  // namespace

void add_state_command(CLI::App& app) {
  const auto request = std::make_shared<StateRequest>();
  CLI::App* command = app.add_subcommand("state", "Deflection, force, slope and energy of states (S, q) of the fibre");
  command->add_option("file", request->file, "CSV with the columns S,q; - is standard input")->type_name("FILE");
  command->add_option("--S", request->S, "Length between the supports, in spans")->type_name("NUMBER");
  command->add_option("--q", request->q, "Mobilised friction, tangential over normal support force")
      ->type_name("NUMBER");
  command->add_flag("--slopes", request->slopes, "The partial derivatives with respect to S and q as well");
  add_output_options(*command, request->output);
  command->footer(
      "Reads and writes reduced variables: lengths in spans L, forces in EI/L^2, energies in EI/L.\n"
      "Writes S,q,w,F,theta0,Pn,U,curvature: deflection, force, support slope, normal force at one support,\n"
      "bending energy, curvature at midspan: half the depth of the specimen times it is the bending strain. A state "
      "that does not exist is written as nan, and the exit code is 1.\n\n"
      "Examples:\n"
      "  flexslip state --S 1.2 --q 0.3\n"
      "  flexslip state states.csv --output results.csv");
  command->callback([request] { run_state(*request); });
}

}  // namespace flexslip
