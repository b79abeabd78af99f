#include "report/campaign_json.h"

#include <optional>
#include <string>

#include "fibre/elementary.h"
#include "report/campaign_table.h"

namespace flexslip {
namespace {

Json parameter(const ParameterEstimate& estimate, const std::string& unit) {
  return {{"value", estimate.value},
          {"standard_error", estimate.standard_error},
          {"interval95", {estimate.low, estimate.high}},
          {"unit", unit}};
}

Json parameters_json(const TestSummary& test) {
  Json out = {{"mu0", parameter(test.mu0, "1")}};
  out["mu0"]["bound"] = test.mu0_is_bound;
  const auto add = [&](const char* name, const std::optional<ParameterEstimate>& estimate, const char* unit) {
    out[name] = estimate ? parameter(*estimate, unit) : Json();
  };
  const auto only_rough = [&](const ParameterEstimate& estimate) {
    return test.model == ProfileModel::roughness ? std::optional(estimate) : std::nullopt;
  };
  add("roughness", only_rough(test.roughness), "1");
  add("correlation_length", only_rough(test.correlation_length), "m");
  add("amplitude", test.amplitude, "1");
  add("wavelength", test.wavelength, "m");
  add("phase", test.phase, "rad");
  add("bending_stiffness", test.bending_stiffness, "N m^2");
  return out;
}

Json failed_checks_json(const TestSummary& test) {
  Json out = Json::array();
  for (const auto kind : test.failed_checks) out.push_back(name_of(kind));
  return out;
}

Json test_json(const CampaignTest& test) {
  const TestSummary& summary = test.summary.value();
  return {{"name", test.name},
          {"status", test.status},
          {"category", name_of(summary.category)},
          {"suspect", summary.suspect},
          {"standing", name_of(summary.standing)},
          {"drops_verdict", summary.drops > 0 ? Json(name_of(summary.drops_verdict)) : Json()},
          {"model", name_of(summary.model)},
          {"parameters", parameters_json(summary)},
          {"wave", {{"claimed", summary.wave_claimed}, {"log_evidence", summary.log_evidence_of_wave}}},
          {"friction_read",
           {{"median", summary.friction_read.median},
            {"low80", summary.friction_read.low80},
            {"high80", summary.friction_read.high80}}},
          {"failed_checks", failed_checks_json(summary)},
          {"residual_rms", summary.residual_rms},
          {"drops", summary.drops},
          {"work_of_fracture", summary.work_of_fracture},
          {"friction_share", summary.friction_share},
          {"reason", test.reason.empty() ? Json() : Json(test.reason)},
          {"remarks", test.remarks},
          {"file", test.file}};
}

Json spread_json(const Spread& spread) {
  if (spread.count == 0) return {{"mean", nullptr}, {"min", nullptr}, {"max", nullptr}, {"n", 0}};
  return {{"mean", spread.mean}, {"min", spread.min}, {"max", spread.max}, {"n", spread.count}};
}

Json spreads_json(const CategorySpread& spreads) {
  return {{"tests", spreads.tests},
          {"mu0", spread_json(spreads.mu0)},
          {"amplitude", spread_json(spreads.amplitude)},
          {"wavelength", spread_json(spreads.wavelength)}};
}

Json between_specimens_json(const SpecimenLine& line) {
  const auto& [tests, population] = *line.between;
  Json out = {{"tests", tests.size()},
              {"typical", parameter(line.typical, line.unit)},
              {"differ_by", line.by_factors ? "factor" : "standard deviation"},
              {"spread", parameter(line.spread, line.by_factors ? "1" : line.unit)}};
  out["spread"]["bound"] = population.spread_is_bound;
  Json specimens = Json::array();
  for (std::size_t i = 0; i < tests.size(); ++i) {
    const auto& [own, error] = population.specimens[i];
    const double value = line.by_factors ? elementary::exp(own) : own;
    specimens.push_back(
        {{"test", tests[i]}, {"value", value}, {"standard_error", line.by_factors ? value * error : error}});
  }
  out["specimens"] = specimens;
  return out;
}

}  // namespace

Json campaign_json(const Campaign& campaign) {
  Json tests = Json::array();
  Json failures = Json::array();
  for (const auto& test : campaign.tests)
    if (test.summary)
      tests.push_back(test_json(test));
    else
      failures.push_back({{"name", test.name}, {"status", test.status}, {"reason", test.reason}, {"file", test.file}});
  Json categories = Json::object();
  for (const auto& category : campaign.categories) {
    Json spreads = spreads_json(category.without_suspects);
    spreads["with_suspects"] = spreads_json(category.with_suspects);
    spreads["between_specimens"] = Json::object();
    categories[key_of(category)] = spreads;
  }
  for (const auto& line : specimen_lines(campaign))
    categories[line.category]["between_specimens"][line.parameter] = between_specimens_json(line);
  Json shared = Json::array();
  for (const auto& one : campaign.shared) {
    Json estimate = parameter(one.estimate, one.unit);
    estimate["name"] = one.name;
    estimate["tests"] = one.tests;
    estimate["chi_squared"] = one.chi_squared;
    estimate["agreement"] = one.agreement;
    shared.push_back(estimate);
  }
  return {{"tests", tests},
          {"categories", categories},
          {"failures", failures},
          {"shared", shared},
          {"units", units_json(false)}};
}

}  // namespace flexslip
