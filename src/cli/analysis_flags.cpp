#include "cli/analysis_flags.h"

#include "cli/numbers.h"

namespace flexslip {

void add_analysis_options(CLI::App& command, AnalysisChoice& choice) {
  command.add_option("--model", choice.model, "Friction model to fit: roughness, the default, or one of the paper's")
      ->type_name("NAME")
      ->check(CLI::IsMember(model_names()));
  command
      .add_option("--false-alarms", choice.options.drops.false_alarms_per_test,
                  "Average number of drops expected in a test of this length without slips")
      ->type_name("NUMBER")
      ->check(number_between(1e-6, 1e3))
      ->capture_default_str();
  command.add_option("--suspect-limit", choice.options.suspect_limit, "Limit above which friction is implausible")
      ->type_name("NUMBER")
      ->check(number_between(0.01, 100))
      ->capture_default_str();
  command.add_flag("--check-stability", choice.options.check_stability,
                   "Fit again with the force changed in its ninth digit, and check that the answer stays the same");
}

}  // namespace flexslip
