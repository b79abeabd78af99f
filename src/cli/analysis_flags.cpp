#include "cli/analysis_flags.h"

#include <array>

namespace flexslip {
namespace {

constexpr std::array models{ProfileModel::roughness, ProfileModel::constant, ProfileModel::drift,
                            ProfileModel::sinusoid, ProfileModel::sinusoids};

std::vector<std::string> model_names() {
  std::vector<std::string> names;
  names.reserve(models.size());
  for (const auto model : models) names.emplace_back(name_of(model));
  return names;
}

ProfileModel fitted_model(const Case& input, FrictionModel model) {
  switch (model) {
    case FrictionModel::constant:
      return ProfileModel::constant;
    case FrictionModel::drift:
      return ProfileModel::drift;
    case FrictionModel::sinusoid:
      return ProfileModel::sinusoid;
    case FrictionModel::sinusoids:
      return ProfileModel::sinusoids;
    case FrictionModel::roughness:
      return ProfileModel::roughness;
    case FrictionModel::table:
    case FrictionModel::rough:
    case FrictionModel::surface:
      break;
  }
  throw wrong_value(input, "friction.model", "a model to fit: roughness, constant, drift, sinusoid or sinusoids",
                    model == FrictionModel::table     ? "'table'"
                    : model == FrictionModel::surface ? "'surface'"
                                                      : "'rough'");
}

}  // namespace

void add_analysis_options(CLI::App& command, AnalysisFlags& flags) {
  command.add_option("--model", flags.model, "Friction model to fit: roughness, the default, or one of the paper's")
      ->type_name("NAME")
      ->check(CLI::IsMember(model_names()));
  command
      .add_option("--false-alarms", flags.options.drops.false_alarms_per_test,
                  "Drops expected on average in a test of this length without slips")
      ->type_name("NUMBER")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--suspect-limit", flags.options.suspect_limit, "Friction above this is implausible")
      ->type_name("NUMBER")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_flag("--check-stability", flags.options.check_stability,
                   "Fit again with the force changed in its ninth digit, and check that the answer stays");
}

AnalysisOptions options_for(const Case& input, const AnalysisFlags& flags) {
  AnalysisOptions options = flags.options;
  for (const auto model : models)
    if (name_of(model) == flags.model) options.fit.model = model;
  if (flags.model.empty() && input.friction && input.friction->model && !input.friction->profile)
    options.fit.model = fitted_model(input, *input.friction->model);
  return options;
}

}  // namespace flexslip
