#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "answers/equilibrium_fields.h"
#include "case/studies.h"
#include "cli/case_flags.h"
#include "cli/commands.h"
#include "cli/output.h"
#include "io/quantity.h"
#include "report/model_figures.h"

namespace flexslip {
namespace {

struct EquilibriumRequest {
  std::string file;
  std::vector<std::string> changes;
  EquilibriumChoice choice;
  std::string figure;
  Output output;
};

void run_equilibrium(const EquilibriumRequest& request) {
  const EquilibriumStudy study = study_equilibria(read_case(request.file, request.changes), request.choice);
  if (study.status == EquilibriumStatus::branch_ended)
    note(request.output, fmt::format("the curve ends at the length {}, where the force has fallen to zero",
                                     readable(study.scales.physical_length(study.points.back().S),
                                              study.reduced     ? kind::number
                                              : study.in_inches ? in_inches(kind::length)
                                                                : kind::length)));
  if (!request.figure.empty()) draw_for(request.output, equilibrium_figure(study), request.figure);
  const Equilibria told = told_of(study);
  const EquilibriumColumns columns = columns_of(study);
  const Frame frame{study.scales, study.reduced};
  if (request.output.json)
    write_json(request.output.path, equilibria_fields(columns)(told, frame));
  else
    write_csv(request.output.path, equilibrium_fields(columns), told.points, frame);
}

}  // namespace

void add_equilibrium_command(CLI::App& app) {
  const auto request = std::make_shared<EquilibriumRequest>();
  CLI::App* command =
      app.add_subcommand("equilibrium", "The equilibrium curve or region of a specimen, independent of the rig");
  command->add_option("case", request->file, "Case file; - is standard input")->type_name("CASE")->required();
  add_set_option(*command, request->changes);
  command->add_flag("--region", request->choice.region,
                    "Write all equilibria, |q| <= mu, instead of only the loading curve, q = mu");
  command
      ->add_option("--points", request->choice.points,
                   "Number of points along S; without it, as many as the roughness needs")
      ->type_name("N")
      ->check(CLI::Range(2, most_equilibria).description(""));
  command->add_option("--levels", request->choice.levels, "With --region, number of values of q from -mu to mu")
      ->type_name("N")
      ->check(CLI::Range(2, most_levels).description(""))
      ->capture_default_str();
  command
      ->add_option("--longest", request->choice.longest,
                   "Length between the supports up to which to compute; without it, 1.5 spans")
      ->type_name("LENGTH");
  add_figure_option(*command, request->figure);
  add_output_options(*command, request->output);
  command->footer(
      "Writes S,mu,w,F along the curve, or S,q,w,F over the region, in SI, or reduced if the case is. For a thick\n"
      "specimen, or on rollers, it also writes drawn_in, the length pulled in. The surface of a thick specimen slides\n"
      "out at first: the curve begins where the point that first touched is back, and simulate shows the path "
      "there.\n\n"
      "Examples:\n"
      "  flexslip equilibrium case.toml --longest \"1500 um\"\n"
      "  flexslip equilibrium case.toml --region --output region.csv");
  command->callback([request] { run_equilibrium(*request); });
}

}  // namespace flexslip
