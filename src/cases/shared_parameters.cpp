#include "cases/shared_parameters.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "cases/parallel.h"
#include "inference/likelihood_profile.h"
#include "inference/shared_parameter.h"

namespace flexslip {
namespace {

// A test as it takes part in the estimate of one parameter.
struct Part {
  std::string name;
  FitProblem problem;
  ModelFit model;
  double unit;   // of the shared parameter, over that of the fit's: a modulus over a relative stiffness
  double own;    // the test's own estimate, in the unit of the fit
  double error;  // its standard error
  bool stated;   // the bending stiffness is stated by the case, not read off the record
};

const ModelFit* one_wave(const FrictionFit& fit) {
  for (const auto& model : fit.models)
    if (model.model == ProfileModel::sinusoid && model.status != FitStatus::not_found) return &model;
  return nullptr;
}

bool is_of_a_wave(Shareable parameter) {
  return parameter == Shareable::amplitude || parameter == Shareable::wavelength;
}

FitParameter fitted_parameter(Shareable parameter) {
  switch (parameter) {
    case Shareable::amplitude:
      return FitParameter::amplitude;
    case Shareable::wavelength:
      return FitParameter::wavelength;
    case Shareable::modulus:
    case Shareable::bending_stiffness:
      break;
  }
  return FitParameter::bending_stiffness;
}

std::string unit_of(Shareable parameter) {
  switch (parameter) {
    case Shareable::modulus:
      return "Pa";
    case Shareable::bending_stiffness:
      return "N m^2";
    case Shareable::amplitude:
      return "1";
    case Shareable::wavelength:
      break;
  }
  return "m";
}

// The value in SI of 1 in the fit.
std::optional<double> unit_in(const FittedTest& test, Shareable parameter) {
  const Scales& scales = test.analysis.scales;
  switch (parameter) {
    case Shareable::modulus:
      if (!test.section_moment) return std::nullopt;
      return scales.bending_stiffness() / *test.section_moment;
    case Shareable::bending_stiffness:
      return scales.bending_stiffness();
    case Shareable::amplitude:
      return 1;
    case Shareable::wavelength:
      break;
  }
  return scales.span();
}

std::optional<Part> part_of(const FittedTest& test, const std::string& name, Shareable parameter) {
  const TestAnalysis& analysis = test.analysis;
  if (analysis.status != AnalysisStatus::ok) return std::nullopt;
  const bool wave = is_of_a_wave(parameter);
  if (wave && analysis.category == SawtoothCategory::none) return std::nullopt;
  const ModelFit* model = wave ? one_wave(analysis.fit) : &analysis.fit.models[analysis.fit.chosen];
  const auto unit = unit_in(test, parameter);
  if (!model || model->status == FitStatus::not_found || !unit) return std::nullopt;
  const ParameterEstimate& own = parameter == Shareable::amplitude    ? model->waves.front().amplitude
                                 : parameter == Shareable::wavelength ? model->waves.front().wavelength
                                                                      : model->bending_stiffness;
  const bool stated = test.stiffness == StiffnessSource::stated || test.stiffness == StiffnessSource::assumed_error;
  return Part{name,  {analysis.reduced, analysis.rig, analysis.errors}, *model, *unit, own.value, own.standard_error,
              stated};
}

// Where to look, in SI: where the tests' own estimates lie, and five standard errors beyond; a wave of another length is another
// maximum, so the values of a wavelength lie as close as an eighth of the resolution of the longest record.
SharedRange range_of(const std::vector<Part>& parts, Shareable parameter) {
  SharedRange range{std::numeric_limits<double>::infinity(), 0, 17};
  constexpr double reach = 5;
  constexpr double least_share = 0.2;  // of a value: the least to look at
  for (const Part& part : parts) {
    const double margin = reach * (std::isfinite(part.error) ? part.error : 0.2 * part.own);
    range.low = std::min(range.low, part.unit * std::max(part.own - margin, least_share * part.own));
    range.high = std::max(range.high, part.unit * (part.own + margin));
  }
  if (parameter != Shareable::wavelength) return range;
  for (const Part& part : parts) {
    const double drawn_in =
        part.unit * 2.4 * std::pow(part.problem.record.deflection.back(), 2);  // S - 1 of a deflection
    constexpr double steps_per_turn = 8;
    const double turns = 0.5 * drawn_in * (1 / range.low - 1 / range.high);
    range.points = std::max(range.points, static_cast<std::size_t>(std::min(steps_per_turn * turns, 1000.0)));
  }
  return range;
}

// Half the square of a stated stiffness's deviation from what was stated.
double stated_deviation(const Part& part, double factor) {
  const double error = part.problem.errors.bending_stiffness;
  return error > 0 ? 0.5 * std::pow((factor - 1) / error, 2) : 0;
}

JointLikelihood joint_likelihood(const std::vector<Part>& parts, Shareable parameter, unsigned threads) {
  return [&parts, parameter, threads](std::span<const double> values) {
    std::vector<std::vector<double>> each(parts.size());
    for_each_index(parts.size(), threads, [&](std::size_t i) {
      std::vector<double> own;
      own.reserve(values.size());
      for (const double value : values) own.push_back(value / parts[i].unit);
      each[i] = likelihood_along(parts[i].problem, parts[i].model, fitted_parameter(parameter), own);
    });
    std::vector<double> sums(values.size(), 0);
    for (std::size_t k = 0; k < values.size(); ++k) {
      double stated = 0;
      std::size_t statements = 0;
      for (std::size_t i = 0; i < parts.size(); ++i) {
        sums[k] += each[i][k];
        if (is_of_a_wave(parameter) || !parts[i].stated) continue;
        stated += stated_deviation(parts[i], values[k] / parts[i].unit);
        ++statements;
      }
      // One statement, made of every test: its mean counts, not its sum.
      if (statements > 0) sums[k] += stated - stated / static_cast<double>(statements);
    }
    return sums;
  };
}

void hold(HeldValues& held, Shareable parameter, double value) {
  switch (parameter) {
    case Shareable::modulus:
    case Shareable::bending_stiffness:
      held.bending_stiffness = value;
      break;
    case Shareable::amplitude:
      held.amplitude = value;
      break;
    case Shareable::wavelength:
      held.wavelength = value;
      break;
  }
}

}  // namespace

std::string name_of(Shareable parameter) {
  switch (parameter) {
    case Shareable::modulus:
      return "modulus";
    case Shareable::bending_stiffness:
      return "bending_stiffness";
    case Shareable::amplitude:
      return "amplitude";
    case Shareable::wavelength:
      break;
  }
  return "wavelength";
}

SharedFits share_parameters(const std::vector<PlannedTest>& plan,
                            const std::function<AnalysisOptions(const Case&)>& analysis,
                            const std::vector<Shareable>& parameters, unsigned threads) {
  SharedFits fits;
  for (const Shareable parameter : parameters) {
    std::vector<std::optional<Part>> found(plan.size());
    for_each_index(plan.size(), threads, [&](std::size_t i) {
      const auto* input = std::get_if<Case>(&plan[i].input);
      if (!input) return;
      try {
        AnalysisOptions options = analysis(*input);
        if (const auto held = fits.held.find(plan[i].name); held != fits.held.end()) options.fit.held = held->second;
        found[i] = part_of(fit_test(*input, options), plan[i].name, parameter);
      } catch (const std::exception&) {
        // The run of the campaign lists it with its reason.
      }
    });
    std::vector<Part> parts;
    for (auto& part : found)
      if (part) parts.push_back(std::move(*part));
    if (parts.size() < 2)
      throw InputError({.field = "--share " + name_of(parameter),
                        .expected = "at least two tests that have this parameter",
                        .found = fmt::format("{}", parts.size()),
                        .remedy = parameter == Shareable::modulus ? "state the section of each" : ""});
    const auto shared = estimate_shared(range_of(parts, parameter), joint_likelihood(parts, parameter, threads));
    fits.parameters.push_back({name_of(parameter), unit_of(parameter), shared.estimate, parts.size()});
    for (const Part& part : parts) hold(fits.held[part.name], parameter, shared.estimate.value / part.unit);
  }
  return fits;
}

}  // namespace flexslip
