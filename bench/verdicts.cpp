// The features of the drops of simulated or measured tests, as flexslip fit takes them: a row of CSV for each case.
//
//   build/release/bench/verdicts FOLDER/*/case.toml
//
// tools/calibrate-verdict fits the probabilities of causes to them. Besides what the probabilities depend on (inference/causes.h) a row has the features
// themselves, what passes show of the loss of stiffness, and what was found of the record.
#include <array>
#include <cstdio>
#include <exception>
#include <string>

#include "case/case_file.h"
#include "case/fitted.h"
#include "case/measurement.h"
#include "inference/analysis.h"
#include "inference/causes.h"
#include "inference/judgement.h"

namespace flexslip {
namespace {

struct Named {
  const char* name;
  double DropFeatures::*feature;
};
constexpr std::array features{Named{"follows_drops", &DropFeatures::follows_drops},
                              Named{"follows_drops_error", &DropFeatures::follows_drops_error},
                              Named{"greatest_steepness", &DropFeatures::max_steepness},
                              Named{"recovery_near", &DropFeatures::recovery_near},
                              Named{"recovery_far", &DropFeatures::recovery_far},
                              Named{"given_back", &DropFeatures::stiffness_recovery},
                              Named{"least_after_drop", &DropFeatures::least_after_drop},
                              Named{"needed_at_end", &DropFeatures::needed_at_end},
                              Named{"roughness", &DropFeatures::roughness},
                              Named{"drawn_in", &DropFeatures::slid_in},
                              Named{"loss_needed", &DropFeatures::loss_needed},
                              Named{"loss_recovered", &DropFeatures::loss_recovered},
                              Named{"least_anywhere", &DropFeatures::least_anywhere},
                              Named{"fall_anywhere", &DropFeatures::fall_anywhere}};

void print(const std::string& file) {
  const Test test = read_case(file);
  const Measurement measurement = read_measurement(test, {.points = min_fitted_points, .span = true});
  const DescribedTest described = describe(measurement);
  const TestAnalysis analysis = analyse_drops(measurement.record, described.description, described.options);
  const DropFeatures& found = analysis.drop_features;
  std::printf("%s,%.6g,%zu,%.4f,%zu,%.6g", file.c_str(), analysis.rig.stiffness, measurement.record.force.size(),
              analysis.reduced.deflection.back(), found.drops, analysis.stiffness_to_slope_ratio);
  for (const Named& each : features) std::printf(",%.6g", found.*each.feature);
  const bool has_drops = found.drops > 0;
  const CauseInputs inputs = has_drops ? inputs_of(found, analysis.rig.stiffness) : CauseInputs{};
  for (const double each : inputs) std::printf(",%.6g", each);
  const bool is_reloaded = flexslip::is_reloaded(analysis);
  const PassesFit none;
  const PassesFit& passes = is_reloaded ? *analysis.passes : none;
  std::printf(",%d,%d,%.6g,%.6g,%.6g,%zu,%.6g,%.6g\n", is_reloaded ? 1 : 0, static_cast<int>(passes.status),
              passes.loss.value, passes.loss.standard_error, passes.loss_needed, passes.drops_again,
              passes.settled.value, passes.settled.standard_error);
}

int run(int count, char** files) {
  std::printf("case,load_train,rows,deepest,drops,stiffness_over_slope");
  for (const Named& each : features) std::printf(",%s", each.name);
  for (const char* name : cause_input_names) std::printf(",in_%s", name);
  std::printf(",reloaded,passes_status,loss,loss_error,passes_need,drops_again,settled,settled_error\n");
  for (int i = 1; i < count; ++i) {
    try {
      print(files[i]);
    } catch (const std::exception& refusal) {
      std::fprintf(stderr, "%s: %s\n", files[i], refusal.what());
    }
  }
  return 0;
}

}  // namespace
}  // namespace flexslip

int main(int count, char** arguments) { return flexslip::run(count, arguments); }
