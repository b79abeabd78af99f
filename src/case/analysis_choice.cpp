#include "case/analysis_choice.h"

#include <array>
#include <optional>

#include "case/support_frictions.h"

namespace flexslip {
namespace {

constexpr std::array models{ProfileModel::roughness, ProfileModel::constant, ProfileModel::drift,
                            ProfileModel::sinusoid, ProfileModel::sinusoids};

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

std::vector<std::string> model_names() {
  std::vector<std::string> names;
  names.reserve(models.size());
  for (const auto model : models) names.emplace_back(name_of(model));
  return names;
}

AnalysisOptions options_for(const Case& input, const AnalysisChoice& choice) {
  AnalysisOptions options = choice.options;
  if (const auto limit = input.rig ? pin_limit_of(*input.rig) : std::nullopt) options.most_friction = *limit;
  for (const auto model : models)
    if (name_of(model) == choice.model) options.fit.model = model;
  if (choice.model.empty() && input.friction && input.friction->model && !input.friction->profile)
    options.fit.model = fitted_model(input, *input.friction->model);
  return options;
}

}  // namespace flexslip
