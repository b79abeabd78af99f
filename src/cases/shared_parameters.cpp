#include "cases/shared_parameters.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "cases/parallel.h"
#include "inference/shared_parameter.h"

namespace flexslip {
namespace {

// What a test says of a parameter [SI], and what it was told beforehand.
struct Part {
  std::size_t test;  // of the plan
  OwnEstimate fitted;
  std::optional<OwnEstimate> stated;
};

std::string unit_of(Shareable parameter) { return parameter == Shareable::modulus ? "Pa" : "N m^2"; }

std::optional<Part> part_of(const FittedTest& test, std::size_t index, Shareable parameter) {
  const auto& analysis = test.analysis;
  if (analysis.status != AnalysisStatus::ok || analysis.model_implausible) return std::nullopt;
  double unit = analysis.scales.bending_stiffness();
  if (parameter == Shareable::modulus) {
    if (!test.section_moment) return std::nullopt;
    unit /= *test.section_moment;
  }
  const ParameterEstimate& fitted = analysis.fit.bending_stiffness;
  if (!(fitted.standard_error > 0)) return std::nullopt;
  return Part{index,
              {unit * fitted.value, unit * fitted.standard_error},
              OwnEstimate{unit, unit * analysis.errors.bending_stiffness}};
}

SharedEstimate estimate_of(const std::vector<Part>& parts) {
  std::vector<OwnEstimate> own;
  OwnEstimate stated{0, 0};
  std::size_t statements = 0;
  for (const Part& part : parts) {
    if (!part.stated) {
      own.push_back(part.fitted);
      continue;
    }
    if (const auto record = of_the_record(part.fitted, *part.stated)) own.push_back(*record);
    stated.value += part.stated->value;
    stated.error += part.stated->error;
    ++statements;
  }
  if (statements == 0) return estimate_shared(own, std::nullopt);
  const auto n = static_cast<double>(statements);
  return estimate_shared(own, OwnEstimate{stated.value / n, stated.error / n});
}

// The case of a test that is told a stiffness.
void tell(Case& input, Shareable parameter, const ParameterEstimate& shared) {
  const Known known{shared.value, shared.standard_error};
  if (!input.specimen) input.specimen = SpecimenInput{{}, BendingStiffness{known}};
  if (parameter == Shareable::modulus)
    input.specimen->rigidity = Modulus{known};
  else
    input.specimen->rigidity = BendingStiffness{known};
}

void require_different(const std::vector<Shareable>& parameters) {
  const auto asked = [&](Shareable parameter) { return std::count(parameters.begin(), parameters.end(), parameter); };
  for (const Shareable parameter : parameters)
    if (asked(parameter) > 1) throw std::invalid_argument("--share " + name_of(parameter) + ": once is enough");
  if (asked(Shareable::modulus) > 0 && asked(Shareable::bending_stiffness) > 0)
    throw std::invalid_argument("--share: either modulus or bending_stiffness, not both");
}

}  // namespace

std::string name_of(Shareable parameter) { return parameter == Shareable::modulus ? "modulus" : "bending_stiffness"; }

SharedFits share_parameters(std::vector<PlannedTest> plan, const std::function<AnalysisOptions(const Case&)>& analysis,
                            const std::vector<Shareable>& parameters, unsigned threads, const std::atomic<bool>* stop) {
  require_different(parameters);
  SharedFits fits{{}, std::move(plan)};
  for (const Shareable parameter : parameters) {
    std::vector<std::optional<Part>> found(fits.plan.size());
    for_each_index(fits.plan.size(), threads, [&](std::size_t i) {
      const auto* input = std::get_if<Case>(&fits.plan[i].input);
      if (!input || (stop && stop->load())) return;
      try {
        found[i] = part_of(fit_test(*input, analysis(*input)), i, parameter);
      } catch (const std::exception&) {
        // The run of the campaign lists it with its reason.
      }
    });
    if (stop && stop->load()) return fits;
    std::vector<Part> parts;
    for (const auto& part : found)
      if (part) parts.push_back(*part);
    if (parts.size() < 2)
      throw InputError({.field = "--share " + name_of(parameter),
                        .expected = "at least two tests that tell this parameter",
                        .found = fmt::format("{}", parts.size()),
                        .remedy = parameter == Shareable::modulus ? "state the section of each" : ""});
    const auto shared = estimate_of(parts);
    fits.parameters.push_back({name_of(parameter), unit_of(parameter), shared.estimate, parts.size(), shared.scatter});
    for (const Part& part : parts) tell(std::get<Case>(fits.plan[part.test].input), parameter, shared.estimate);
  }
  return fits;
}

}  // namespace flexslip
