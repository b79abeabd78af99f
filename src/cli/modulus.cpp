#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "answers/standard_fields.h"
#include "case/studies.h"
#include "cli/case_flags.h"
#include "cli/commands.h"
#include "cli/output.h"
#include "io/input_error.h"
#include "io/text_file.h"
#include "report/plain_text.h"
#include "report/preparation_words.h"
#include "report/small_deflection_words.h"

namespace flexslip {
namespace {

struct ModulusRequest {
  CaseRequest test;
  std::vector<std::string> window;
  Output output;
};

std::string text_of(const StandardTest& test) {
  std::string text = laid_out(small_deflection_table(test));
  text += '\n';
  for (const auto& words : small_deflection_in_words(test)) text += wrapped(words, "");
  text += "\nFrom the file to the record:\n";
  for (const auto& words : preparation_in_words(test.measurement.preparation)) text += wrapped(words, "   ", " - ");
  return text;
}

void run_modulus(const ModulusRequest& request) {
  const auto window = window_of(request.window);
  const ModulusStudy study = [&] {
    try {
      return study_modulus(case_of(request.test), window);
    } catch (const InputError& error) {
      throw in_words_of_call(request.test, error);
    }
  }();
  const StandardTest test = told_of(study);
  if (request.output.json) {
    write_json(request.output.path, modulus_fields()(test, frame_of(test)));
  } else {
    write_text(request.output.path, text_of(test));
  }
  if (study.numbers.status != SmallDeflectionStatus::ok)
    throw CalculationFailed(fmt::format("{}: {}", study.measurement.file, small_deflection_in_words(test).front()));
}

}  // namespace

void add_modulus_command(CLI::App& app) {
  const auto request = std::make_shared<ModulusRequest>();
  CLI::App* command =
      app.add_subcommand("modulus", "Stiffness and flexural modulus as defined by the bending standards");
  add_case_options(*command, request->test);
  command
      ->add_option(
          "--window", request->window,
          "Straight part of the curve, in shares of the greatest force at deflections below a tenth of the span; "
          "without it, the steepest quarter")
      ->type_name("SHARE")
      ->expected(2);
  add_output_options(*command, request->output);
  command->get_option("--json")->description("Write JSON instead of text");
  command->footer(
      "Gives numbers to compare with other laboratories, also for specimens too thick for fit. The numbers assume "
      "small\n"
      "deflections, no friction and no shear. A modulus needs a span and a section; without a span there is only a\n"
      "stiffness. Crosshead displacement is corrected for the stiffness of the load train. Modulus and stress have\n"
      "three significant digits, as ISO 178 asks; --json has all. The exit code is 1 if the record has no straight\n"
      "rising part.\n\n"
      "Examples:\n"
      "  flexslip modulus examples/simulated/case.toml\n"
      "  flexslip modulus export.csv --displacement crosshead --stiffness \"2 kN/mm\" --span \"64 mm\" \\\n"
      "    --width \"10 mm\" --height \"4 mm\"");
  command->callback([request] { run_modulus(*request); });
}

}  // namespace flexslip
