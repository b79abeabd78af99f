#include <string>
#include <vector>

#include <fmt/format.h>

#include "answers/standard_fields.h"
#include "case/studies.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "report/answer_documents.h"

namespace flexslip {
namespace {

struct ModulusRequest {
  TestRequest test;
  std::vector<std::string> window;
  std::vector<std::string> friction;
  Output output;
};

void run_modulus(const ModulusRequest& request) {
  const auto window = window_of(request.window);
  const auto friction = friction_range_of(request.friction);
  const ModulusStudy study =
      with_test(request.test, [&](const Test& input) { return study_modulus(input, window, friction); });
  const StandardTest test = standard_test(study);
  write_words(
      request.output, [&] { return modulus_fields()(test, frame_of(test)); },
      [&] { return in_text(document_of(test)); });
  if (study.numbers.status != SmallDeflectionStatus::ok)
    throw CalculationFailed(fmt::format("{}: {}", study.measurement.file, small_deflection_in_words(test).front()));
}

}  // namespace

void add_modulus_command(CLI::App& app) {
  const auto [command, request] =
      add_command(app, "modulus", "Stiffness and flexural modulus as defined by the bending standards", run_modulus);
  add_test(command, request.test);
  add_option(command, "--window SHARE", request.window,
             "Linear region, in shares of the maximum force at deflections below a tenth of the span; "
             "default: the steepest part that the noise allows, of a quarter or more")
      ->expected(2);
  add_option(command, "--friction NUMBER", request.friction,
             "Friction at the supports, or its range; its effect on modulus, strength and work is reported; "
             "default: the friction of the case, or 0.1 to 0.5")
      ->expected(1, 2);
  add_output_options(command, request.output);
  command.footer(
      "Gives numbers to compare with other laboratories, also for specimens too thick for fit. The numbers assume "
      "small\n"
      "deflections, no friction and no shear. A modulus needs a span and a section; without a span there is only a\n"
      "stiffness. Crosshead displacement is corrected for the stiffness of the load train. Modulus and stress have\n"
      "three significant digits, as ISO 178 asks; --json has all. The exit code is 1 if the record has no straight\n"
      "rising part, or if the modulus cannot be determined.\n\n"
      "Examples:\n"
      "  flexslip modulus examples/simulated/case.toml\n"
      "  flexslip modulus export.csv --displacement crosshead --stiffness \"2 kN/mm\" --span \"64 mm\" \\\n"
      "    --width \"10 mm\" --height \"4 mm\"");
}

}  // namespace flexslip
