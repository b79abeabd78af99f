#include "campaign/shared_parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "data/names.h"
#include "fibre/elementary.h"
#include "fibre/limits.h"
#include "inference/shared_parameter.h"

namespace flexslip {
namespace {

constexpr std::array shareables{Shareable::modulus,   Shareable::bending_stiffness,  Shareable::wavelength,
                                Shareable::roughness, Shareable::correlation_length, Shareable::mu0};

std::string unit_of(Shareable parameter) {
  switch (parameter) {
    case Shareable::modulus:
      return "Pa";
    case Shareable::bending_stiffness:
      return "N m^2";
    case Shareable::wavelength:
    case Shareable::correlation_length:
      return "m";
    case Shareable::roughness:
    case Shareable::mu0:
      break;
  }
  return "1";
}

// What a test says of a parameter [SI], or of its logarithm.
std::optional<Marginal> marginal_of(const CampaignTest& test, Shareable parameter) {
  if (!test.summary || test.summary->suspect) return std::nullopt;
  const TestMarginals& known = test.summary->known;
  switch (parameter) {
    case Shareable::modulus:
      if (!test.section_moment) return std::nullopt;
      return shifted(known.log_stiffness, -elementary::log(*test.section_moment));
    case Shareable::bending_stiffness:
      return known.log_stiffness;
    case Shareable::wavelength:
      return known.log_wavelength;
    case Shareable::roughness:
      return known.log_roughness;
    case Shareable::correlation_length:
      return known.log_length;
    case Shareable::mu0:
      break;
  }
  return known.mu0;
}

SharedParameter shared_by(std::span<const CampaignTest> tests, Shareable parameter) {
  std::vector<Marginal> marginals;
  for (const auto& test : tests)
    if (const auto marginal = marginal_of(test, parameter); marginal && tells(*marginal))
      marginals.push_back(*marginal);
  if (marginals.size() < 2) {
    constexpr double untold = not_a_number;
    return {name_of(parameter), unit_of(parameter), {untold, untold, untold, untold}, marginals.size(), untold, untold};
  }
  const SharedValue shared = share(marginals, prior_told_to(marginals));
  return {name_of(parameter),
          unit_of(parameter),
          parameter == Shareable::mu0 ? shared.estimate : exponential(shared.estimate),
          shared.telling,
          shared.chi_squared,
          shared.agreement};
}

}  // namespace

std::vector<std::string> shareable_names() {
  std::vector<std::string> names;
  names.reserve(shareables.size());
  for (const auto parameter : shareables) names.push_back(name_of(parameter));
  return names;
}

std::vector<Shareable> shareables_named(const std::vector<std::string>& names) {
  std::vector<Shareable> found;
  for (const auto& name : names)
    for (const auto parameter : shareables)
      if (name_of(parameter) == name) found.push_back(parameter);
  return found;
}

std::string_view needed_for(Shareable parameter) {
  if (parameter == Shareable::modulus) return "state the section of each";
  if (parameter == Shareable::wavelength) return "only waves that the evidence claims can be shared";
  return "the others say less than was known beforehand";
}

std::string name_of(Shareable parameter) {
  return std::string(name_in_order<Shareable::mu0>(
      parameter, {"modulus", "bending_stiffness", "wavelength", "roughness", "correlation_length", "mu0"}));
}

std::vector<SharedParameter> share_parameters(std::span<const CampaignTest> tests,
                                              const std::vector<Shareable>& parameters) {
  std::vector<SharedParameter> shared;
  for (const Shareable parameter : parameters) {
    if (std::count(parameters.begin(), parameters.end(), parameter) > 1)
      throw std::invalid_argument("--share " + name_of(parameter) + ": once is enough");
    shared.push_back(shared_by(tests, parameter));
  }
  return shared;
}

}  // namespace flexslip
