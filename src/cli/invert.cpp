#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "answers/profile_fields.h"
#include "answers/state_fields.h"
#include "case/mechanics.h"
#include "case/studies.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "data/section.h"
#include "fibre/elastica.h"
#include "fibre/supported_state.h"
#include "inference/profile.h"
#include "io/input_error.h"
#include "io/quantity.h"

namespace flexslip {
namespace {

struct InvertRequest {
  CaseRequest test;
  bool is_case = false;
  std::optional<std::string> radius, thickness;  // of rollers; of the specimen on them
  Output output;

  bool on_supports() const { return radius || thickness; }
};

// The length of a flag, in spans.
double spans_of(const std::string& text, const char* flag, const Kind& kind, const Scales& scales) {
  return scales.reduced_length(quantity_of_flag(flag, text, kind, Range::non_negative));
}

// The supports from the flags, with the thickness of a specimen of known section.
Supports supports_of(const InvertRequest& request, const Kind& kind, const Scales& scales,
                     const std::optional<Section>& section) {
  Supports supports{0, section ? 0.5 * scales.reduced_length(depth(*section)) : 0};
  if (request.radius) supports.radius = spans_of(*request.radius, "--roller-radius", kind, scales);
  if (request.thickness) supports.half_depth = 0.5 * spans_of(*request.thickness, "--thickness", kind, scales);
  return within_limits(supports);
}

void require_none_negative(const Table& table) {
  for (std::size_t row = 0; row < table.rows(); ++row)
    for (const Column& column : table.columns)
      if (!(column.values[row] >= 0))
        throw wrong_cell(table, row, column,
                         fmt::format("The value {} is not a number of at least 0", column.values[row]));
}

void invert_states(const InvertRequest& request) {
  const Table table = read_table(request.test.file, {{"w", kind::number}, {"F", kind::number}});
  require_none_negative(table);
  const std::vector<double>& w = table.columns[0].values;
  const std::vector<double>& F = table.columns[1].values;
  std::vector<InvertedState> states;
  std::vector<std::size_t> unexplained;
  const Supports supports = supports_of(request, kind::number, Scales(1, 1), std::nullopt);
  for (std::size_t row = 0; row < w.size(); ++row) {
    states.push_back({.w = w[row], .F = F[row]});
    const auto tell = [&](double S, double q) { states.back().S = S, states.back().q = q; };
    if (!request.on_supports()) {
      const FibreState state = fibre_state_from_force(w[row], F[row]);
      if (state.status == FibreStatus::ok) tell(state.S, state.q);
    } else if (w[row] > 0 && w[row] <= deepest_on_supports) {
      const SupportedState state = state_on_supports_from_force(w[row], F[row], supports);
      if (state.status == FibreStatus::ok) tell(state.length, state.q);
    }
    if (!states.back().q) unexplained.push_back(row);
  }
  write_rows(request.output, states_fields(no_friction, inverted_fields()),
             {unexplained.empty() ? "ok" : "no_friction", states}, inverted_fields(), states, {Scales(1, 1), true});
  if (unexplained.empty()) return;
  const std::size_t row = unexplained.front();
  const double most = request.on_supports() ? largest_q_on_supports : largest_q;
  throw CalculationFailed(fmt::format(
      "{}:{}: no friction between {:g} and {:g} explains w = {}, F = {}{}{}", table.source, table.lines[row], -most,
      most, w[row], F[row],
      w[row] < least_half_depths * supports.half_depth
          ? "; friction cannot be determined at deflections below twice the thickness"
          : "",
      unexplained.size() == 1 ? ""
                              : fmt::format("; nor {} more rows, which are written as nan", unexplained.size() - 1)));
}

void invert_case(const InvertRequest& request) {
  const auto stated = [&](const Test& input, const Scales& scales) -> std::optional<Supports> {
    if (!request.on_supports()) return std::nullopt;
    return supports_of(request, kind_in(input, kind::length), scales, section_of(input));
  };
  const InvertedTest test = invert_test(request.test.read(), stated);
  for (const std::string& remark : test.remarks) note(request.output, remark);
  write_rows(request.output, inverted_test_fields(), test, profile_fields(),
             points_of(test.measurement.record, test.profile), frame_of(test));
  if (!test.why_no_answer.empty()) throw CalculationFailed(test.why_no_answer);
}

void run_invert(const InvertRequest& request) {
  if (request.is_case || request.test.file.ends_with(".toml"))
    invert_case(request);
  else if (request.test.changes.empty())
    invert_states(request);
  else
    throw InputError({.file = request.test.file,
                      .field = "--set",
                      .problem = "The file holds deflections and forces, not a case to change",
                      .remedy = "leave it out, or pass --case if the file is one"});
}

}  // namespace

void add_invert_command(CLI::App& app) {
  const auto [command, request] =
      add_command(app, "invert", "Friction from deflection and force, point by point", run_invert);
  add_option(command, "file FILE", request.test.file,
             "Case file (.toml), or CSV with the columns w,F; - is standard input")
      ->required();
  add_set_option(command, request.test.changes);
  command.add_flag("--case", request.is_case, "Read the file as a case, with any name");
  add_option(command, "--roller-radius LENGTH", request.radius,
             "Radius of fixed rollers as supports, such as \"5 mm\"; without a case, in spans");
  add_option(command, "--thickness LENGTH", request.thickness,
             "Thickness of the specimen, as friction acts at its surface; with --roller-radius, by default that "
             "of the case");
  add_output_options(command, request.output, "CSV");
  add_csv_option(command, request.output);
  command.footer(
      "From CSV, in reduced variables (w in spans, F in EI/L^2), it writes w,F,S,q. A point that no friction explains "
      "is\n"
      "written as nan, and the exit code is 1.\n"
      "From a case, it writes friction along the specimen up to failure, in SI. drawn_in is the sliding length, on\n"
      "edges S - L. imaged is the length of the axis between the vertical planes through the supports, as in an "
      "image.\n"
      "position is the position of the support along the specimen, from midspan. mu_error is the standard error. Its\n"
      "parts come from the noise of the force, the bending stiffness and the contact point; the last two move all\n"
      "points together.\n"
      "Supports are knife edges and friction acts at the axis of the specimen, unless case or flags say otherwise.\n"
      "Then S is the length of the axis between the contacts, drawn_in includes the arc over the roller, and friction\n"
      "cannot be determined at deflections below twice the thickness.\n\n"
      "Examples:\n"
      "  flexslip invert bar.toml --roller-radius \"5 mm\"\n"
      "  flexslip invert examples/simulated/case.toml --output profile.csv\n"
      "  flexslip invert points.csv");
}

}  // namespace flexslip
