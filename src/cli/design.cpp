#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "answers/design_fields.h"
#include "case/mechanics.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "design/design_answer.h"
#include "design/design_result.h"
#include "design/open_study.h"
#include "design/planned_case.h"
#include "report/answer_documents.h"
#include "report/figures.h"

namespace flexslip {
namespace {

struct DesignRequest {
  CaseRequest test;
  std::vector<std::string> over;
  bool decide = false;
  std::string noise;
  std::string figure;
  unsigned threads = 1;
  Output output;
};

ReloadOptions reload_options(const DesignRequest& request, const Test& input) {
  ReloadOptions options{.threads = request.threads};
  if (!request.noise.empty())
    options.noise = quantity_of_flag("--noise", request.noise, kind_in(input, kind::force), Range::positive);
  return options;
}

void require_one_answer(const DesignRequest& request) {
  if (!request.decide || request.over.empty()) return;
  throw InputError({.field = "--decide",
                    .problem = "One planned test is decided on, but --over gives a range of them",
                    .remedy = "leave out one of the two, or pass a value of the range with --set"});
}

void run_design(const DesignRequest& request) {
  require_one_answer(request);
  const PlannedCase planned_case = read_planned_case(request.test.file, request.test.changes);
  const Test& input = planned_case.loading;
  const auto axes = map_axes(input, request.over);
  if (!axes.empty()) {
    for (const std::string& sentence : values_taken_for(planned_case, axes)) note(request.output, sentence);
    const auto points = design_map(input, axes, request.threads);
    write_rows(request.output, design_map_fields(axes), points, map_fields(axes), points,
               {Scales(1, 1), input.reduced});
    if (!request.figure.empty()) draw_for(request.output, design_map_figure(input, axes, points), request.figure);
    return;
  }
  constexpr double many = 1e5;
  const Design planned = design_of(input).design;
  if (const double periods = periods_up_to(planned.friction, planned.travel); periods > many)
    note(request.output,
         fmt::format("friction goes through about {:.0e} periods on the way: the answer may take minutes", periods));
  DesignAnswer answer = answer_of(planned_case, request.threads);
  if (request.decide) answer.reload = reload_study(input, reload_options(request, input));
  if (!answer.open && !request.figure.empty()) answer.open = open_study(input, {}, request.threads);
  write_words(
      request.output,
      [&] {
        return design_fields()({answer, design_in_short(answer), changes_in_words(answer)},
                               {answer.scales, input.reduced});
      },
      [&] { return in_text(document_of(answer)); });
  if (!request.figure.empty()) draw_for(request.output, design_figure(answer), request.figure);
}

}  // namespace

void add_design_command(CLI::App& app) {
  const auto [command, request] = add_command(
      app, "design", "Before a test: whether it will show a sawtooth, and what would change that", run_design);
  add_case(command, request.test);
  add_repeated(command, "--over RANGE", request.over,
               "Write a table over a parameter and its range, NAME=FROM:TO[:POINTS], instead of the answer in "
               "words; given twice, a map over both");
  CLI::Option* decide =
      command.add_flag("--decide", request.decide,
                       "Also say how far to load and unload so that a second loading distinguishes slips from cracks");
  add_option(command, "--noise FORCE", request.noise,
             "With --decide, standard deviation of the force readings; default: 0.1 % of the maximum force")
      ->needs(decide);
  add_threads_option(command, "-j,--threads NUMBER", request.threads, "Number of tests computed at the same time");
  add_figure_option(command, request.figure);
  add_output_options(command, request.output, "text, or of CSV with --over");
  add_csv_option(command, request.output);
  command.footer(
      "Says whether a specimen on this rig will snap and where first, what the record will show, how stiff the load\n"
      "train would have to be for no snap, and which single changes would reverse the answer. The case is one for\n"
      "flexslip simulate: its farthest stage position is the travel of one loading, and its step is the distance\n"
      "between readings. If it does not state friction, the answer covers a range that fits the specimen.\n"
      "With --over, writes a CSV of these answers over mu0, amplitude, wavelength, phase, span, diameter, height, "
      "width,\n"
      "modulus, stiffness, travel, step, reference or pin_friction.\n"
      "With --decide, simulates an unloading and a second loading, for eight travels and five depths of unloading, "
      "and\n"
      "says which of them distinguish slips from cracks.\n\n"
      "Examples:\n"
      "  flexslip design case.toml --figure design.svg\n"
      "  flexslip design case.toml --decide --noise \"20 uN\"\n"
      "  flexslip design case.toml --over \"stiffness=10 N/m:1000 N/m\" --over mu0=0:1 --figure map.svg --output "
      "map.csv");
}

}  // namespace flexslip
