#include "cli/analysis_flags.h"

#include <algorithm>
#include <array>

namespace flexslip {
namespace {

constexpr std::array models{ProfileModel::constant, ProfileModel::drift, ProfileModel::sinusoid,
                            ProfileModel::sinusoids};

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
    case FrictionModel::table:
    case FrictionModel::rough:
      break;
  }
  throw wrong_value(input, "friction.model", "models to fit: constant, drift, sinusoid, sinusoids",
                    model == FrictionModel::table ? "'table'" : "'rough'");
}

}  // namespace

void add_analysis_options(CLI::App& command, AnalysisFlags& flags) {
  command.add_option("--model", flags.models, "Consider only this friction model; may be repeated")
      ->type_name("NAME")
      ->check(CLI::IsMember(model_names()));
  command
      .add_option("--false-alarms", flags.false_alarms, "Drops to be expected in a test of this length without slips")
      ->type_name("NUMBER")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--suspect-limit", flags.suspect_limit, "Friction above it is implausible")
      ->type_name("NUMBER")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command
      .add_option("--bootstrap", flags.bootstrap, "Refit so many records made of the fitted curve and its residuals")
      ->type_name("COUNT")
      ->check(CLI::Range(1, 100000));
}

AnalysisOptions options_for(const Case& input, const AnalysisFlags& flags) {
  AnalysisOptions options;
  options.drops.false_alarms_per_test = flags.false_alarms;
  options.suspect_limit = flags.suspect_limit;
  options.bootstrap.count = flags.bootstrap;
  std::vector<ProfileModel> wanted;
  const auto want = [&](ProfileModel model) {
    if (std::find(wanted.begin(), wanted.end(), model) == wanted.end()) wanted.push_back(model);
  };
  for (const auto& name : flags.models)
    for (const auto model : models)
      if (name_of(model) == name) want(model);
  if (wanted.empty() && input.friction && !input.friction->profile)
    for (const auto model : input.friction->models) want(fitted_model(input, model));
  if (!wanted.empty()) options.fit.models = std::move(wanted);
  return options;
}

}  // namespace flexslip
