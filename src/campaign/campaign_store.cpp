#include "campaign/campaign_store.h"

#include <system_error>
#include <utility>

#include "campaign/campaign_plan.h"
#include "fibre/limits.h"
#include "io/input_error.h"
#include "io/text_file.h"
#include "result/json.h"

namespace flexslip {
namespace {

namespace fs = std::filesystem;

constexpr int layout_of_store = 6;  // of the kept text: another one is computed anew
constexpr const char* kept_name = "result.json";

// JSON knows no NaN: null.
double number(const Json& json) { return json.is_null() ? not_a_number : json.get<double>(); }

std::vector<double> numbers(const Json& json) {
  std::vector<double> values;
  values.reserve(json.size());
  for (const auto& value : json) values.push_back(number(value));
  return values;
}

Json json_of(const Estimate& estimate) {
  return {estimate.value, estimate.standard_error, estimate.low, estimate.high};
}

Json json_of(const std::optional<Estimate>& estimate) { return estimate ? json_of(*estimate) : Json(nullptr); }

Estimate estimate_of(const Json& json) {
  return {number(json.at(0)), number(json.at(1)), number(json.at(2)), number(json.at(3))};
}

std::optional<Estimate> optional_estimate_of(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return estimate_of(json);
}

// JSON knows no infinity: null.
Json json_of(const Marginal& marginal) {
  Json parts = Json::array();
  for (const auto& part : marginal.posterior) parts.push_back({part.weight, part.mean, part.deviation});
  return {{"parts", parts}, {"prior", {marginal.prior_mean, marginal.prior_deviation}}};
}

Marginal marginal_from(const Json& json) {
  Marginal marginal{};
  for (const auto& part : json.at("parts"))
    marginal.posterior.push_back({number(part.at(0)), number(part.at(1)), number(part.at(2))});
  const Json& prior = json.at("prior");
  marginal.prior_mean = number(prior.at(0));
  marginal.prior_deviation = prior.at(1).is_null() ? infinity : prior.at(1).get<double>();
  return marginal;
}

Json json_of(const TestMarginals& known) {
  return {{"mu0", json_of(known.mu0)},
          {"log_roughness", json_of(known.log_roughness)},
          {"log_length", json_of(known.log_length)},
          {"log_stiffness", json_of(known.log_stiffness)},
          {"log_wavelength", json_of(known.log_wavelength)}};
}

TestMarginals marginals_from(const Json& json) {
  return {.mu0 = marginal_from(json.at("mu0")),
          .log_roughness = marginal_from(json.at("log_roughness")),
          .log_length = marginal_from(json.at("log_length")),
          .log_stiffness = marginal_from(json.at("log_stiffness")),
          .log_wavelength = marginal_from(json.at("log_wavelength"))};
}

FrictionRead friction_read_from(const Json& json) {
  return {.median = number(json.at(0)), .low80 = number(json.at(1)), .high80 = number(json.at(2))};
}

Json json_of(const TestSummary& summary) {
  return {{"category", summary.category},
          {"suspect", summary.suspect},
          {"standing", summary.standing},
          {"drops_verdict", summary.drops_verdict},
          {"model", summary.model},
          {"mu0", json_of(summary.mu0)},
          {"mu0_is_bound", summary.mu0_is_bound},
          {"friction_read", {summary.friction_read.median, summary.friction_read.low80, summary.friction_read.high80}},
          {"roughness", json_of(summary.roughness)},
          {"correlation_length", json_of(summary.correlation_length)},
          {"amplitude", json_of(summary.amplitude)},
          {"wavelength", json_of(summary.wavelength)},
          {"phase", json_of(summary.phase)},
          {"wave_claimed", summary.wave_claimed},
          {"log_evidence_of_wave", summary.log_evidence_of_wave},
          {"bending_stiffness", json_of(summary.bending_stiffness)},
          {"residual_rms", summary.residual_rms},
          {"drops", summary.drops},
          {"friction_share", summary.friction_share},
          {"work_of_fracture", summary.work_of_fracture},
          {"failed_checks", summary.failed_checks},
          {"known", json_of(summary.known)},
          {"surface_height", json_of(summary.surface_height)},
          {"surface_slope", json_of(summary.surface_slope)}};
}

TestSummary summary_from(const std::string& name, const Json& json) {
  return {.name = name,
          .category = json.at("category").get<SawtoothCategory>(),
          .suspect = json.at("suspect").get<bool>(),
          .standing = json.at("standing").get<Standing>(),
          .drops_verdict = json.at("drops_verdict").get<CrackVerdict>(),
          .model = json.at("model").get<ProfileModel>(),
          .mu0 = estimate_of(json.at("mu0")),
          .mu0_is_bound = json.at("mu0_is_bound").get<bool>(),
          .friction_read = friction_read_from(json.at("friction_read")),
          .roughness = estimate_of(json.at("roughness")),
          .correlation_length = estimate_of(json.at("correlation_length")),
          .amplitude = optional_estimate_of(json.at("amplitude")),
          .wavelength = optional_estimate_of(json.at("wavelength")),
          .phase = optional_estimate_of(json.at("phase")),
          .wave_claimed = json.at("wave_claimed").get<bool>(),
          .log_evidence_of_wave = number(json.at("log_evidence_of_wave")),
          .bending_stiffness = estimate_of(json.at("bending_stiffness")),
          .residual_rms = number(json.at("residual_rms")),
          .drops = json.at("drops").get<std::size_t>(),
          .friction_share = number(json.at("friction_share")),
          .work_of_fracture = number(json.at("work_of_fracture")),
          .failed_checks = json.at("failed_checks").get<std::vector<CheckKind>>(),
          .known = marginals_from(json.at("known")),
          .surface_height = optional_estimate_of(json.at("surface_height")),
          .surface_slope = optional_estimate_of(json.at("surface_slope"))};
}

Json json_of(const CampaignCurves& curves) {
  return {{"span", curves.span},
          {"bending_stiffness", curves.bending_stiffness},
          {"load_train_stiffness", curves.load_train_stiffness},  // null: infinite
          {"stage", curves.stage},
          {"deflection", curves.deflection},
          {"force", curves.force},
          {"model_deflection", curves.model_deflection},
          {"model_force", curves.model_force},
          {"drops", curves.drops}};
}

CampaignCurves curves_from(const Json& json) {
  const Json& stiffness = json.at("load_train_stiffness");
  return {.span = number(json.at("span")),
          .bending_stiffness = number(json.at("bending_stiffness")),
          .load_train_stiffness = stiffness.is_null() ? infinity : stiffness.get<double>(),
          .stage = numbers(json.at("stage")),
          .deflection = numbers(json.at("deflection")),
          .force = numbers(json.at("force")),
          .model_deflection = numbers(json.at("model_deflection")),
          .model_force = numbers(json.at("model_force")),
          .drops = json.at("drops").get<std::vector<std::size_t>>()};
}

Json json_of(const CampaignTest& test) {
  return {{"name", test.name},
          {"status", test.status},
          {"reason", test.reason},
          {"file", test.file},
          {"remarks", test.remarks},
          {"section_moment", test.section_moment ? Json(*test.section_moment) : Json(nullptr)},
          {"materials", test.materials ? Json{test.materials->specimen, test.materials->support} : Json(nullptr)},
          {"summary", test.summary ? json_of(*test.summary) : Json(nullptr)},
          {"curves", test.curves ? json_of(*test.curves) : Json(nullptr)}};
}

CampaignTest test_from(const Json& json) {
  CampaignTest test{.name = json.at("name").get<std::string>(),
                    .status = json.at("status").get<std::string>(),
                    .reason = json.at("reason").get<std::string>(),
                    .file = json.at("file").get<std::string>(),
                    .summary = {},
                    .curves = {},
                    .remarks = json.at("remarks").get<std::vector<std::string>>(),
                    .section_moment = {},
                    .materials = {}};
  if (const Json& moment = json.at("section_moment"); !moment.is_null()) test.section_moment = moment.get<double>();
  if (const Json& materials = json.at("materials"); !materials.is_null())
    test.materials = Materials{materials.at(0).get<std::string>(), materials.at(1).get<std::string>()};
  if (const Json& summary = json.at("summary"); !summary.is_null()) test.summary = summary_from(test.name, summary);
  if (const Json& curves = json.at("curves"); !curves.is_null()) test.curves = curves_from(curves);
  return test;
}

std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"; }

[[noreturn]] void refuse(const fs::path& path, const std::error_code& error) {
  throw InputError({.file = path.string(), .expected = "a folder that can be written to", .found = error.message()});
}

}  // namespace

std::string to_text(const CampaignTest& test) { return text_of(json_of(test)); }

std::optional<CampaignTest> campaign_test_from(const std::string& text) {
  try {
    return test_from(Json::parse(text));
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

CampaignStore::CampaignStore(fs::path folder) : folder_(std::move(folder)) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) refuse(folder_, error);
}

fs::path CampaignStore::emptied_folder(const std::string& test) const {
  fs::path folder = folder_ / folder_name(test);
  std::error_code error;
  fs::remove(folder / kept_name, error);  // first: from here on the test is not done
  if (!error) fs::remove_all(folder, error);
  if (!error) fs::create_directories(folder, error);
  if (error) refuse(folder, error);
  return folder;
}

std::optional<CampaignTest> CampaignStore::find(const std::string& test, const std::string& key) const {
  const std::string text = read_text((folder_ / folder_name(test) / kept_name).string()).value_or("");
  if (text.empty()) return std::nullopt;
  try {
    const Json json = Json::parse(text);
    if (json.at("layout") != layout_of_store || json.at("key") != key) return std::nullopt;
    return test_from(json.at("test"));
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

void CampaignStore::keep(const CampaignTest& test, const std::string& key) const {
  const fs::path path = folder_ / folder_name(test.name) / kept_name;
  write_text(path.string(), text_of({{"layout", layout_of_store}, {"key", key}, {"test", json_of(test)}}));
}

}  // namespace flexslip
