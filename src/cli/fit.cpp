#include <string>

#include <fmt/format.h>

#include "answers/fit_fields.h"
#include "answers/profile_fields.h"
#include "case/fitted.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "finding/answer.h"
#include "io/text.h"
#include "report/answer_documents.h"
#include "report/page.h"
#include "report/report.h"
#include "report/workbook.h"

namespace flexslip {
namespace {

struct FitRequest {
  TestRequest test;
  AnalysisChoice analysis;
  std::string profile, curves, draws, workbook, report;
  double figure_width = 17;  // [cm]
  bool full = false;
  Output output;
};

void run_fit(const FitRequest& request) {
  auto shown = shown_stages("Fitting", request.output);
  const FittedTest test = with_test(request.test, [&](const Test& input) {
    if (request.analysis.model.empty() && input.friction && input.friction->has_parameters())
      note(request.output, "the parameters in [friction] are for simulating and are not used by the fit");
    return fit_test(input, options_for(input, request.analysis));
  });
  shown.reset();

  if (!request.profile.empty()) write_profile(request.profile, test, request.output.csv);
  if (!request.curves.empty()) write_curves(request.curves, test, request.output.csv);
  if (!request.draws.empty() && is_fitted(test)) write_draws(request.draws, test, request.output.csv);
  if (!request.draws.empty() && !is_fitted(test))
    note(request.output, fmt::format("{} is not written: there is no fit to draw profiles from", request.draws));
  if (!request.workbook.empty())
    write_workbook(request.workbook, test.name + ": friction in a bending test", sheets_of(test));
  if (!request.report.empty()) make_folder(request.report);
  write_words(
      request.output, [&] { return fit_json(test); },
      [&] {
        return (request.full ? fit_text(test) : fit_screen(test.name, answer_of(test), screen_style(request.output))) +
               (request.report.empty() ? "" : fmt::format("\nThe report: {}/report.html\n", printable(request.report)));
      });
  if (!request.report.empty())
    note_pictures(request.output, write_report_with_studio(request.report, test, 10 * request.figure_width));
  if (const auto code = answer_of(test).verdict.code; !is_answered(code))
    throw CalculationFailed(fmt::format("{}: {}; the answer says why", test.measurement.file, word_of(code)));
}

}  // namespace

void add_fit_command(CLI::App& app) {
  const auto [command, request] =
      add_command(app, "fit", "Friction that a measured test shows along the specimen, and how certain it is", run_fit);
  add_test(command, request.test);
  add_analysis_options(command, request.analysis);
  add_output_file(command, "--profile", request.profile, "Write the friction along the specimen to this CSV file");
  add_output_file(command, "--curves", request.curves,
                  "Write measured, fitted and replayed force, point by point, to this CSV file");
  add_output_file(
      command, "--draws", request.draws,
      "Write the fitted friction and 20 profiles drawn from it to this CSV file, for [friction] model = \"table\"");
  add_output_file(command, "--xlsx", request.workbook,
                  "Write the answer, the parameters, and the readings with the fitted curve to this workbook");
  add_csv_option(command, request.output);
  add_report_option(command, request.report, "Write report.html and figures/ into this folder", announce_report);
  add_figure_width_option(command, request.figure_width);
  command.add_flag("--full", request.full, "Print every table and remark, not only what fits on one screen");
  add_output_options(command, request.output);
  command.footer(
      "Writes the answer on one screen. With --full it writes everything in the report except the figures: parameters\n"
      "with their intervals, every slip and snap, the energy account, what was assumed, and the files. Rows are those\n"
      "of the file, counted from 1 without its header.\n"
      "Without gnuplot the report holds the scripts and data of the figures but no pictures, and the exit code is 0.\n"
      "The exit code is 0 if the question about the drops is answered (SLIP, UNDECIDED, CRACK, NO DROPS), 1 if not\n"
      "(CHECK INPUT, NO ANSWER); in --json it is verdict.code.\n\n"
      "Examples:\n"
      "  flexslip fit examples/simulated/case.toml --report report\n"
      "  flexslip fit test.csv --span \"1278 um\" --stiffness \"90.6 N/m\" --diameter \"34.8 um\" \\\n"
      "    --modulus \"29.6 GPa\" --stage \"w_s [um]\" --force \"F [mN]\" --json");
}

}  // namespace flexslip
