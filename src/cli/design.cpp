#include <algorithm>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "answers/design_fields.h"
#include "case/mechanics.h"
#include "cli/case_flags.h"
#include "cli/commands.h"
#include "cli/output.h"
#include "design/design_answer.h"
#include "design/design_result.h"
#include "io/input_error.h"
#include "io/text_file.h"
#include "report/design_document.h"
#include "report/figures.h"

namespace flexslip {
namespace {

struct DesignRequest {
  std::string file;
  std::vector<std::string> changes;
  std::vector<std::string> over;
  std::string figure;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  Output output;
};

void write_map(const DesignRequest& request, const Test& input, const std::vector<DesignAxis>& axes,
               const std::vector<MapPoint>& points) {
  const Frame frame{Scales(1, 1), input.reduced};
  if (request.output.json)
    write_json(request.output.path, design_map_fields(axes)({points}, frame));
  else
    write_csv(request.output.path, map_fields(axes), points, frame);
}

void run_design(const DesignRequest& request) {
  const Test input = one_loading_of(read_case(request.file, request.changes));
  const auto axes = map_axes(input, request.over);
  if (!axes.empty()) {
    const auto points = design_map(input, axes, request.threads);
    if (!request.figure.empty()) draw_for(request.output, design_map_figure(input, axes, points), request.figure);
    return write_map(request, input, axes, points);
  }
  constexpr double many = 1e5;
  const Design planned = design_of(input).design;
  if (const double periods = periods_up_to(planned.friction, planned.travel); periods > many)
    note(request.output,
         fmt::format("friction goes through about {:.0e} periods on the way: the answer may take minutes", periods));
  const DesignAnswer answer = answer_of(input);
  if (!request.figure.empty()) draw_for(request.output, design_figure(answer), request.figure);
  if (request.output.json)
    write_json(request.output.path, design_fields()({answer, design_in_short(answer), changes_in_words(answer)},
                                                    {answer.scales, input.reduced}));
  else
    write_text(request.output.path, in_text(document_of(answer)));
}

}  // namespace

void add_design_command(CLI::App& app) {
  const auto request = std::make_shared<DesignRequest>();
  CLI::App* command =
      app.add_subcommand("design", "Before a test: whether it will show a sawtooth, and what would change that");
  command->add_option("case", request->file, "Case file; - is standard input")->type_name("CASE")->required();
  add_set_option(*command, request->changes);
  command
      ->add_option("--over", request->over,
                   "Write a table over a parameter and its range, NAME=FROM:TO[:POINTS], instead of the answer in "
                   "words; given twice, a map over both")
      ->type_name("RANGE");
  command->add_option("-j,--threads", request->threads, "With --over, number of designs computed at the same time")
      ->type_name("NUMBER")
      ->check(CLI::Range(1U, 1024U))
      ->default_str("the number of cores");
  add_figure_option(*command, request->figure);
  add_output_options(*command, request->output);
  command->get_option("--json")->description("Write JSON instead of text, or of CSV with --over");
  command->footer(
      "Says whether a specimen on this rig will snap and where first, what the record will show, how stiff the load\n"
      "train would have to be for no snap, and which single changes would reverse the answer. The case is one for\n"
      "flexslip simulate: its farthest stage position is the travel of one loading, and its step is the distance\n"
      "between readings.\n"
      "With --over, writes a CSV of these answers over mu0, amplitude, wavelength, phase, span, diameter, height, "
      "width,\n"
      "modulus, stiffness, travel, step, reference or pin_friction.\n\n"
      "Examples:\n"
      "  flexslip design case.toml --figure design.svg\n"
      "  flexslip design case.toml --over \"stiffness=10 N/m:1000 N/m\" --over mu0=0:1 --figure map.svg --output "
      "map.csv");
  command->callback([request] { run_design(*request); });
}

}  // namespace flexslip
