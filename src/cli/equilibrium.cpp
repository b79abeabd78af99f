#include <string>

#include <fmt/format.h>

#include "answers/state_fields.h"
#include "case/studies.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "io/quantity.h"
#include "report/figures.h"

namespace flexslip {
namespace {

struct EquilibriumRequest {
  CaseRequest test;
  EquilibriumChoice choice;
  std::string figure;
  Output output;
};

void run_equilibrium(const EquilibriumRequest& request) {
  const EquilibriumStudy study = study_equilibria(request.test.read(), request.choice);
  if (study.status == EquilibriumStatus::branch_ended)
    note(request.output, fmt::format("the curve ends at the length {}, where the force has fallen to zero",
                                     readable(study.scales.physical_length(study.points.back().S),
                                              study.reduced     ? kind::number
                                              : study.in_inches ? in_inches(kind::length)
                                                                : kind::length)));
  const EquilibriumColumns columns = columns_of(study);
  write_rows(request.output, equilibria_fields(columns), study, equilibrium_fields(columns), points_of(study),
             {study.scales, study.reduced});
  if (!request.figure.empty()) draw_for(request.output, equilibrium_figure(study), request.figure);
}

}  // namespace

void add_equilibrium_command(CLI::App& app) {
  const auto [command, request] = add_command(
      app, "equilibrium", "The equilibrium curve or region of a specimen, independent of the rig", run_equilibrium);
  add_case(command, request.test);
  command.add_flag("--region", request.choice.region,
                   "Write all equilibria, |q| <= mu, instead of only the loading curve, q = mu");
  add_option(command, "--points N", request.choice.points,
             "Number of points along S; without it, as many as the roughness needs")
      ->check(count_between(2, max_equilibria));
  add_option(command, "--levels N", request.choice.levels, "With --region, number of values of q from -mu to mu")
      ->check(count_between(2, max_levels))
      ->capture_default_str();
  add_option(command, "--longest LENGTH", request.choice.longest,
             "Length between the supports up to which to compute; without it, 1.5 spans");
  add_figure_option(command, request.figure);
  add_output_options(command, request.output, "CSV");
  add_csv_option(command, request.output);
  command.footer(
      "Writes S,mu,w,F along the curve, or S,q,w,F over the region, in SI, or reduced if the case is. For a thick\n"
      "specimen, or on rollers, it also writes drawn_in, the length pulled in. The surface of a thick specimen slides\n"
      "out at first: the curve begins where the point that first touched is back, and simulate shows the path "
      "there.\n\n"
      "Examples:\n"
      "  flexslip equilibrium case.toml --longest \"1500 um\"\n"
      "  flexslip equilibrium case.toml --region --output region.csv");
}

}  // namespace flexslip
