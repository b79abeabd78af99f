#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cases/design_answer.h"
#include "cases/design_map.h"
#include "cli/commands.h"
#include "cli/output.h"
#include "io/input_error.h"
#include "io/text_file.h"
#include "report/design_figures.h"
#include "report/design_json.h"
#include "report/design_words.h"

namespace flexslip {
namespace {

struct DesignRequest {
  std::string file;
  std::vector<std::string> over;
  std::string figure;
  Output output;
};

std::vector<MapAxis> axes_of(const DesignRequest& request, const DesignCase& input) {
  constexpr std::size_t points_of_curve = 101;
  constexpr std::size_t points_of_map = 41;
  if (request.over.size() > 2)
    throw InputError({.field = "--over",
                      .expected = "one parameter or two",
                      .found = std::to_string(request.over.size()),
                      .remedy = "flexslip sweep takes as many as you like"});
  std::vector<MapAxis> axes;
  for (const std::string& text : request.over) try {
      axes.push_back(map_axis(input, text, request.over.size() == 1 ? points_of_curve : points_of_map));
    } catch (const InputError& error) {
      throw located(error, "", 0, "--over");
    }
  if (axes.size() == 2 && axes[0].parameter == axes[1].parameter)
    throw InputError({.field = "--over", .expected = "two parameters", .found = "the same twice"});
  return axes;
}

struct OutcomeColumn {
  std::string_view name, unit;
  double (*value)(const MapPoint& point);
};

constexpr std::array outcome_columns{
    OutcomeColumn{"end", "m", [](const MapPoint& at) { return at.scales->physical_length(at.outcome->end); }},
    OutcomeColumn{"snaps", "", [](const MapPoint& at) { return static_cast<double>(at.outcome->snaps); }},
    OutcomeColumn{"first_snap_stage", "m",
                  [](const MapPoint& at) {
                    return at.outcome->first_snap ? at.scales->physical_length(at.outcome->first_snap->stage) : NAN;
                  }},
    OutcomeColumn{"first_snap_deflection", "m",
                  [](const MapPoint& at) {
                    return at.outcome->first_snap ? at.scales->physical_length(at.outcome->first_snap->w) : NAN;
                  }},
    OutcomeColumn{"drops", "", [](const MapPoint& at) { return static_cast<double>(at.outcome->drops); }},
    OutcomeColumn{"largest_drop", "N",
                  [](const MapPoint& at) { return at.scales->physical_force(at.outcome->largest_drop); }},
    OutcomeColumn{"mean_drop", "N",
                  [](const MapPoint& at) { return at.scales->physical_force(at.outcome->mean_drop); }},
    OutcomeColumn{"greatest_force", "N",
                  [](const MapPoint& at) { return at.scales->physical_force(at.outcome->greatest_force); }},
    OutcomeColumn{"work", "J", [](const MapPoint& at) { return at.scales->physical_energy(at.outcome->work); }},
    OutcomeColumn{"friction", "J", [](const MapPoint& at) { return at.scales->physical_energy(at.outcome->friction); }},
    OutcomeColumn{"released", "J", [](const MapPoint& at) { return at.scales->physical_energy(at.outcome->released); }},
    OutcomeColumn{"stiffness_margin", "", [](const MapPoint& at) { return at.margin; }},
};

std::string_view si_unit(const Kind& kind) {
  for (const auto& [known, unit] : {std::pair{&kind::length, "m"}, std::pair{&kind::stiffness, "N/m"},
                                    std::pair{&kind::pressure, "Pa"}, std::pair{&kind::angle, "rad"}})
    if (known->dimension == kind.dimension) return unit;
  return "";
}

std::string title_of(std::string_view name, std::string_view unit, bool reduced) {
  return unit.empty() ? std::string(name) : column_title(name, unit, reduced);
}

void write_map(const DesignRequest& request, const DesignCase& input, const std::vector<MapAxis>& axes,
               const std::vector<MapPoint>& points) {
  if (request.output.json) return write_json(request.output.path, design_map_json(input, axes, points));
  std::vector<std::vector<double>> values(axes.size() + outcome_columns.size());
  std::vector<std::string_view> status;
  for (const MapPoint& point : points) {
    for (std::size_t i = 0; i < axes.size(); ++i) values[i].push_back(point.values[i]);
    for (std::size_t i = 0; i < outcome_columns.size(); ++i)
      values[axes.size() + i].push_back(point.outcome ? outcome_columns[i].value(point) : NAN);
    const bool is_ok = point.outcome && point.outcome->status == DesignStatus::ok;
    status.emplace_back(is_ok ? "ok" : point.outcome ? "slipped_through" : "impossible");
  }
  std::vector<OutputColumn> columns;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const auto& [parameter, name, kind] = described(axes[i].parameter);
    columns.push_back({title_of(name, si_unit(kind), input.reduced()), values[i]});
  }
  columns.emplace_back(OutputColumn{"status", status});
  for (std::size_t i = 0; i < outcome_columns.size(); ++i)
    columns.push_back(
        {title_of(outcome_columns[i].name, outcome_columns[i].unit, input.reduced()), values[axes.size() + i]});
  write_table(request.output.path, columns);
}

void run_design(const DesignRequest& request) {
  const Case given = read_case(request.file);
  const DesignCase input(given);
  const auto axes = axes_of(request, input);
  if (!axes.empty()) {
    const auto points = design_map(input, axes);
    if (!request.figure.empty()) draw_for(request.output, design_map_figure(input, axes, points), request.figure);
    return write_map(request, input, axes, points);
  }
  const DesignAnswer answer = answer_of(input);
  if (!request.figure.empty()) draw_for(request.output, design_figure(answer), request.figure);
  if (request.output.json)
    write_json(request.output.path, design_json(answer));
  else
    write_text(request.output.path, design_text(answer));
}

}  // namespace

void add_design_command(CLI::App& app) {
  const auto request = std::make_shared<DesignRequest>();
  CLI::App* command =
      app.add_subcommand("design", "Before a test: will it show a sawtooth, and what must change for it not to?");
  command->add_option("case", request->file, "Case file; - is standard input")->type_name("CASE")->required();
  command
      ->add_option("--over", request->over,
                   "A parameter and its range, NAME=FROM:TO[:POINTS]: a table over it instead of the answer in words; "
                   "twice: a map "
                   "over two")
      ->type_name("RANGE");
  add_figure_option(*command, request->figure);
  add_output_options(*command, request->output);
  command->footer(
      "Says whether a fibre on this rig will snap, where first, what the record will show of it, how stiff the load "
      "train\n"
      "would have to be, and which single change would make it otherwise. The case is one for flexslip simulate: its "
      "farthest\n"
      "stage position is the travel of one loading, its step the distance between readings.\n"
      "With --over, a CSV of these answers over mu0, amplitude, wavelength, phase, span, diameter, modulus, "
      "stiffness,\n"
      "travel or step.\n\n"
      "Examples:\n"
      "  flexslip design case.toml --figure design.svg\n"
      "  flexslip design case.toml --over \"stiffness=10 N/m:1000 N/m\" --over mu0=0:1 --figure map.svg --output "
      "map.csv");
  command->callback([request] { run_design(*request); });
}

}  // namespace flexslip
