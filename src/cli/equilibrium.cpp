#include "bending_test/equilibrium.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "answers/equilibrium_fields.h"
#include "case/problem.h"
#include "cli/case_flags.h"
#include "cli/commands.h"
#include "cli/output.h"
#include "io/input_error.h"
#include "report/model_figures.h"

namespace flexslip {
namespace {

struct EquilibriumRequest {
  std::string file;
  std::vector<std::string> changes;
  bool region = false;
  int points = 0;  // 0: as many as the roughness needs
  int levels = 41;
  std::string longest;
  std::string figure;
  Output output;
};

constexpr double longest_by_default = 1.5;  // [L] about where a real test ends: deflections to half the span
constexpr double most_points = 1e6;

// The length up to which to compute.
double longest_of(const EquilibriumRequest& request, const Case& input, const Scales& scales) {
  if (request.longest.empty()) return longest_by_default;
  try {
    const double length = parse_quantity(request.longest, kind_in(input, kind::length), Range::positive);
    const double S_max = scales.reduced_length(length);
    if (!(S_max > 1))
      throw InputError({.expected = "a length greater than the span", .found = in_quotes(request.longest)});
    return S_max;
  } catch (const InputError& error) {
    throw located(error, "", 0, "--longest");
  }
}

// Enough points that no period or piece of the friction goes unseen: spaced evenly in √(S - 1), the last are the farthest
// apart, 2 (S_max - 1)/n.
int points_for(const Friction& friction, double S_max) {
  const double for_waves = 8 * (S_max - 1) / friction.smooth_scale();
  const double for_knots = 4 * static_cast<double>(friction.knots().size());
  return static_cast<int>(std::clamp(std::max(for_waves, for_knots), 500.0, most_points));
}

void run_equilibrium(const EquilibriumRequest& request) {
  const Case input = read_case(request.file, request.changes);
  const Scales scales = scales_of(input, bending_stiffness_of(input));
  const double S_max = longest_of(request, input, scales);
  const Fibre fibre = fibre_of(input, scales);
  const Friction friction = friction_of(input, fibre, scales, S_max);
  const int n = request.points > 0 ? request.points : request.region ? 100 : points_for(friction, S_max);
  EquilibriumStatus status = EquilibriumStatus::ok;
  std::vector<EquilibriumPoint> points;
  if (request.region) {
    points = equilibrium_region(friction, S_max, n, request.levels, fibre);
  } else {
    auto curve = equilibrium_curve(friction, Sliding::in, S_max, n, fibre);
    status = curve.status;
    points = std::move(curve.points);
  }
  if (status == EquilibriumStatus::branch_ended)
    note(request.output, fmt::format("the curve ends at the length {}, where the force has fallen to zero",
                                     readable(scales.physical_length(points.back().S), kind_in(input, kind::length))));

  Equilibria told{status == EquilibriumStatus::ok ? "ok" : "branch_ended", {}};
  for (const EquilibriumPoint& point : points)
    told.points.push_back(
        {point, fibre.on_edges() ? point.S : fibre.length_between_contacts(fibre.bent(point.w, point.q).state)});
  if (!request.figure.empty()) {
    const DrawnIn units{scales, input.reduced, is_in_inches(input)};
    draw_for(request.output,
             request.region ? region_figure(friction, fibre, S_max, units)
                            : equilibrium_figure(friction, fibre, S_max, units),
             request.figure);
  }
  const EquilibriumColumns columns{request.region, !fibre.on_edges()};
  const Frame frame{scales, input.reduced};
  if (request.output.json)
    write_json(request.output.path, equilibria_fields(columns)(told, frame));
  else
    write_csv(request.output.path, equilibrium_fields(columns), told.points, frame);
}

}  // namespace

void add_equilibrium_command(CLI::App& app) {
  const auto request = std::make_shared<EquilibriumRequest>();
  CLI::App* command =
      app.add_subcommand("equilibrium", "The equilibrium curve or region of a specimen, whatever the rig");
  command->add_option("case", request->file, "Case file; - is standard input")->type_name("CASE")->required();
  add_set_option(*command, request->changes);
  command->add_flag("--region", request->region,
                    "All equilibria, |q| <= mu, instead of only the loading curve, q = mu");
  command->add_option("--points", request->points, "Points along S; without it, as many as the roughness needs")
      ->type_name("N")
      ->check(CLI::Range(2, static_cast<int>(most_points)).description(""));
  command->add_option("--levels", request->levels, "With --region, values of q from -mu to mu")
      ->type_name("N")
      ->check(CLI::Range(2, 10000).description(""))
      ->capture_default_str();
  command
      ->add_option("--longest", request->longest,
                   "Compute up to this length between the supports; without it, 1.5 spans")
      ->type_name("LENGTH");
  add_figure_option(*command, request->figure);
  add_output_options(*command, request->output);
  command->footer(
      "Writes S,mu,w,F along the curve, or S,q,w,F over the region, in SI, or reduced if the case is. For a thick\n"
      "specimen, or on rollers, it also writes drawn_in. The surface of a thick specimen slides out at first: the\n"
      "curve begins where the surface has come back to the point that touched, and simulate shows the way there.\n\n"
      "Examples:\n"
      "  flexslip equilibrium case.toml --longest \"1500 um\"\n"
      "  flexslip equilibrium case.toml --region --output region.csv");
  command->callback([request] { run_equilibrium(*request); });
}

}  // namespace flexslip
