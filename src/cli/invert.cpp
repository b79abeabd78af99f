#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cases/problem.h"
#include "cli/case_flags.h"
#include "cli/commands.h"
#include "cli/output.h"
#include "data/section.h"
#include "fibre/elastica.h"
#include "fibre/supported_state.h"
#include "inference/profile.h"
#include "io/input_error.h"
#include "io/quantity.h"

namespace flexslip {
namespace {

struct InvertRequest {
  std::string file;
  std::vector<std::string> changes;
  bool is_case = false;
  std::optional<std::string> radius, thickness;  // of rollers, and of the specimen on them
  Output output;

  bool on_supports() const { return radius || thickness; }
};

// A length in spans, of a flag.
double spans_of(const std::string& text, const char* flag, const Kind& kind, const Scales& scales) {
  try {
    return scales.reduced_length(parse_quantity(text, kind, Range::non_negative));
  } catch (const InputError& error) {
    throw located(error, "", 0, flag);
  }
}

// The supports that the flags state; of a specimen whose section is known, with its thickness.
Supports supports_of(const InvertRequest& request, const Kind& kind, const Scales& scales,
                     const std::optional<Section>& section) {
  Supports supports{0, section ? 0.5 * scales.reduced_length(depth(*section)) : 0};
  if (request.radius) supports.radius = spans_of(*request.radius, "--roller-radius", kind, scales);
  if (request.thickness) supports.half_depth = 0.5 * spans_of(*request.thickness, "--thickness", kind, scales);
  if (supports.radius + supports.half_depth < widest_supports) return supports;
  throw InputError(
      {.field = request.radius ? "--roller-radius" : "--thickness",
       .expected = fmt::format("a radius, and half of a thickness, of less than {:g} spans together", widest_supports),
       .found = fmt::format("{:g} and {:g}", supports.radius, supports.half_depth),
       .remedy = "check their units, and the span"});
}

constexpr std::size_t least_points = 12;  // a noise, and a profile that is more than a handful of points

void require_domain(const Table& table) {
  for (std::size_t row = 0; row < table.rows(); ++row)
    for (const Column& column : table.columns)
      if (!(column.values[row] >= 0))
        throw InputError({.file = table.source,
                          .line = table.line_of(row),
                          .field = fmt::format("column '{}'", column.name),
                          .expected = "a number of at least 0",
                          .found = fmt::format("{}", column.values[row])});
}

void invert_states(const InvertRequest& request) {
  const Table table = read_table(request.file, {{"w", kind::number}, {"F", kind::number}});
  require_domain(table);
  const std::vector<double>& w = table.columns[0].values;
  const std::vector<double>& F = table.columns[1].values;
  std::vector<double> S(w.size(), std::numeric_limits<double>::quiet_NaN());
  std::vector<double> q = S;
  std::vector<std::size_t> unexplained;
  const Supports supports = supports_of(request, kind::number, Scales(1, 1), std::nullopt);
  for (std::size_t row = 0; row < w.size(); ++row) {
    bool is_told = false;
    if (!request.on_supports()) {
      const FibreState state = fibre_state_from_force(w[row], F[row]);
      is_told = state.status == FibreStatus::ok;
      if (is_told) S[row] = state.S, q[row] = state.q;
    } else if (w[row] > 0 && w[row] <= deepest_on_supports) {
      const SupportedState state = state_on_supports_from_force(w[row], F[row], supports);
      is_told = state.status == FibreStatus::ok;
      if (is_told) S[row] = state.length, q[row] = state.q;
    }
    if (!is_told) unexplained.push_back(row);
  }
  const std::vector<OutputColumn> columns{{"w", w}, {"F", F}, {"S", S}, {"q", q}};
  if (request.output.json)
    write_json(request.output.path,
               {{"status", unexplained.empty() ? "ok" : "no_friction"}, {"states", rows_json(columns)}});
  else
    write_table(request.output.path, columns);
  if (unexplained.empty()) return;
  const std::size_t row = unexplained.front();
  const double most = request.on_supports() ? largest_q_on_supports : largest_q;
  throw CalculationFailed(fmt::format(
      "{}:{}: no friction from {:g} to {:g} explains w = {}, F = {}{}", table.source, table.line_of(row), -most, most,
      w[row], F[row],
      unexplained.size() == 1 ? "" : fmt::format("; likewise {} more rows, written as nan", unexplained.size() - 1)));
}

std::string_view name_of(StiffnessSource source) {
  switch (source) {
    case StiffnessSource::stated:
      return "stated";
    case StiffnessSource::assumed_error:
      return "stated_without_uncertainty";
    case StiffnessSource::initial_slope:
      return "initial_slope";
    case StiffnessSource::mirror:
      return "mirror_symmetry";
  }
  throw std::invalid_argument("no such source of the bending stiffness");
}

void note_assumptions(const Output& output, const BendingStiffnessUsed& stiffness) {
  const std::string_view remedy = R"(state it in the case: modulus = { value = "29.6 GPa", uncertainty = "1.5 GPa" })";
  if (stiffness.source == StiffnessSource::assumed_error)
    note(output, fmt::format("the bending stiffness is taken to be uncertain by {:g} %; {}",
                             100 * stiffness.relative_error, remedy));
  if (stiffness.source == StiffnessSource::initial_slope)
    note(output, fmt::format("the bending stiffness is that of the initial slope, uncertain by {:.2g} %; {}",
                             100 * stiffness.relative_error, remedy));
}

void invert_case(const InvertRequest& request) {
  const Measurement measurement = read_measurement(read_case(request.file, request.changes), least_points);
  const Case& input = measurement.test;
  const BendingStiffnessUsed stiffness = bending_stiffness_of(input, measurement);
  const Scales scales = scales_of(input, stiffness);
  const ReducedRecord record = to_reduced(measurement.record, scales);
  Rig rig = rig_of(input, scales);
  if (request.on_supports())
    rig.fibre = Fibre(supports_of(request, kind_in(input, kind::length), scales,
                                  input.specimen ? input.specimen->section : std::nullopt));
  const MeasurementErrors errors = errors_of(measurement, stiffness, scales);
  const FrictionProfile profile = measure_friction(record, rig, errors);
  const Supports& supports = rig.fibre.supports();
  const bool is_thick = least_half_depths * supports.half_depth > hardly_bent;
  const double most = rig.fibre.most_friction();
  note_assumptions(request.output, stiffness);
  if (!profile.unexplained.empty())
    note(request.output,
         fmt::format("no friction from {:g} to {:g} explains {} readings, left out; the first is row {}", -most, most,
                     profile.unexplained.size(), file_row(measurement, profile.unexplained.front())));

  std::vector<double> row, stage, deflection, force, length, drawn_in, imaged, position, mu, error, from_force,
      from_stiffness, from_contact;
  for (const ProfilePoint& point : profile.points) {
    row.push_back(static_cast<double>(file_row(measurement, point.index)));
    stage.push_back(measurement.record.stage[point.index]);
    deflection.push_back(measurement.record.deflection[point.index]);
    force.push_back(measurement.record.force[point.index]);
    length.push_back(scales.physical_length(point.length));
    drawn_in.push_back(scales.physical_length(point.S - 1));
    imaged.push_back(scales.physical_length(point.imaged));
    position.push_back(scales.physical_length(0.5 * point.length));
    mu.push_back(point.mu);
    error.push_back(standard_error(point));
    from_force.push_back(point.from_force);
    from_stiffness.push_back(point.from_bending_stiffness);
    from_contact.push_back(point.from_contact);
  }
  const bool json = request.output.json;
  const auto title = [&](std::string_view name, std::string_view unit) {
    return json ? std::string(name) : column_title(name, unit, input.reduced);
  };
  const std::vector<OutputColumn> columns{{"row", row},
                                          {title(json ? "stage" : "w_s", "m"), stage},
                                          {title(json ? "deflection" : "w", "m"), deflection},
                                          {title(json ? "force" : "F", "N"), force},
                                          {title(json ? "length" : "S", "m"), length},
                                          {title("drawn_in", "m"), drawn_in},
                                          {title("imaged", "m"), imaged},
                                          {title("position", "m"), position},
                                          {"mu", mu},
                                          {"mu_error", error},
                                          {"mu_error_force", from_force},
                                          {"mu_error_bending_stiffness", from_stiffness},
                                          {"mu_error_contact", from_contact}};
  if (json) {
    Json unexplained = Json::array();
    for (const std::size_t index : profile.unexplained) unexplained.push_back(file_row(measurement, index));
    write_json(request.output.path, {{"status", profile.points.empty() ? "nothing_explained" : "ok"},
                                     {"units", units_json(input.reduced)},
                                     {"bending_stiffness",
                                      {{"value", stiffness.value},
                                       {"relative_error", stiffness.relative_error},
                                       {"source", name_of(stiffness.source)}}},
                                     {"contact_offset", measurement.contact_offset},
                                     {"force_noise", measurement.force_noise},
                                     {"last_row", last_file_row(measurement, measurement.record.force.size() - 1)},
                                     {"profile", rows_json(columns)},
                                     {"unexplained", unexplained}});
  } else {
    write_table(request.output.path, columns);
  }
  if (profile.points.empty())
    throw CalculationFailed(fmt::format(
        "{}: no reading tells a friction: all deflections are below {}, or no friction explains them; "
        "check the units",
        measurement.file,
        is_thick ? "twice the thickness of the specimen, up to where its surface hardly slides" : "0.02 spans"));
}

void run_invert(const InvertRequest& request) {
  if (request.is_case || request.file.ends_with(".toml"))
    invert_case(request);
  else if (request.changes.empty())
    invert_states(request);
  else
    throw InputError({.file = request.file,
                      .field = "--set",
                      .expected = "a case file (.toml) beside it",
                      .found = "deflections and forces",
                      .remedy = "leave it out, or pass --case if the file is one"});
}

}  // namespace

void add_invert_command(CLI::App& app) {
  const auto request = std::make_shared<InvertRequest>();
  CLI::App* command = app.add_subcommand("invert", "Friction from deflection and force, point by point");
  command->add_option("file", request->file, "Case file (.toml), or CSV with the columns w,F; - is standard input")
      ->type_name("FILE")
      ->required();
  add_set_option(*command, request->changes);
  command->add_flag("--case", request->is_case, "The file is a case, whatever its name");
  command
      ->add_option("--roller-radius", request->radius,
                   "Of fixed rollers as supports, such as \"5 mm\"; without a case, in spans")
      ->type_name("LENGTH");
  command
      ->add_option(
          "--thickness", request->thickness,
          "Of the specimen, at whose surface friction acts; with --roller-radius, that of the case unless it is given")
      ->type_name("LENGTH");
  add_output_options(*command, request->output);
  command->footer(
      "From CSV: reduced variables, w in spans and F in EI/L^2; writes w,F,S,q. A point that no friction\n"
      "explains is written as nan, and the exit code is 1.\n"
      "From a case: the friction along the specimen in its test up to failure, in SI. drawn_in is S - L on edges;\n"
      "imaged is the axis between the verticals through the supports, as a camera sees it.\n"
      "position is that of the support, counted along the specimen from midspan. mu_error is the standard\n"
      "error; its parts stem from the noise of the force, the bending stiffness and the contact point, the\n"
      "last two of which move all points together.\n"
      "Supports are knife edges, and friction acts at the axis of the specimen, unless the case or flags say more: "
      "then S is\n"
      "the axis between the contacts, drawn_in what has slid, the arc over the roller included, and nothing is\n"
      "told below a deflection of twice the thickness.\n\n"
      "Examples:\n"
      "  flexslip invert bar.toml --roller-radius \"5 mm\"\n"
      "  flexslip invert examples/simulated/case.toml --output profile.csv\n"
      "  flexslip invert points.csv");
  command->callback([request] { run_invert(*request); });
}

}  // namespace flexslip
