#include "campaign/campaign_store.h"

#include <optional>
#include <system_error>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "campaign/campaign_plan.h"
#include "fibre/limits.h"
#include "io/input_error.h"
#include "io/text_file.h"
#include "result/json.h"

namespace flexslip {
namespace {

namespace fs = std::filesystem;

constexpr int layout_of_store = 7;  // of the kept text: another one is computed anew
constexpr const char* kept_name = "result.json";

// What a result is made of, for the way into the text and back.
template <class Row, class Member>
struct Part {
  const char* name;
  Member Row::*member;
};
template <class Row, class Member>
Part(const char*, Member Row::*) -> Part<Row, Member>;
template <class Row>
constexpr auto parts_of = nullptr;
template <class Row>
concept HasParts = !std::is_null_pointer_v<std::remove_const_t<decltype(parts_of<Row>)>>;

template <>
constexpr std::tuple parts_of<Estimate>{Part{"value", &Estimate::value}, Part{"error", &Estimate::standard_error},
                                        Part{"low", &Estimate::low}, Part{"high", &Estimate::high}};
template <>
constexpr std::tuple parts_of<NormalPart>{Part{"weight", &NormalPart::weight}, Part{"mean", &NormalPart::mean},
                                          Part{"deviation", &NormalPart::deviation}};
template <>
constexpr std::tuple parts_of<Marginal>{Part{"posterior", &Marginal::posterior},
                                        Part{"prior_mean", &Marginal::prior_mean},
                                        Part{"prior_deviation", &Marginal::prior_deviation}};
template <>
constexpr std::tuple parts_of<TestMarginals>{
    Part{"mu0", &TestMarginals::mu0}, Part{"log_roughness", &TestMarginals::log_roughness},
    Part{"log_length", &TestMarginals::log_length}, Part{"log_stiffness", &TestMarginals::log_stiffness},
    Part{"log_wavelength", &TestMarginals::log_wavelength}};
template <>
constexpr std::tuple parts_of<FrictionRead>{Part{"median", &FrictionRead::median}, Part{"low80", &FrictionRead::low80},
                                            Part{"high80", &FrictionRead::high80}};
template <>
constexpr std::tuple parts_of<TestSummary>{Part{"name", &TestSummary::name},
                                           Part{"category", &TestSummary::category},
                                           Part{"suspect", &TestSummary::suspect},
                                           Part{"standing", &TestSummary::standing},
                                           Part{"drops_verdict", &TestSummary::drops_verdict},
                                           Part{"model", &TestSummary::model},
                                           Part{"mu0", &TestSummary::mu0},
                                           Part{"mu0_is_bound", &TestSummary::mu0_is_bound},
                                           Part{"friction_read", &TestSummary::friction_read},
                                           Part{"roughness", &TestSummary::roughness},
                                           Part{"correlation_length", &TestSummary::correlation_length},
                                           Part{"amplitude", &TestSummary::amplitude},
                                           Part{"wavelength", &TestSummary::wavelength},
                                           Part{"phase", &TestSummary::phase},
                                           Part{"wave_claimed", &TestSummary::wave_claimed},
                                           Part{"log_evidence_of_wave", &TestSummary::log_evidence_of_wave},
                                           Part{"bending_stiffness", &TestSummary::bending_stiffness},
                                           Part{"residual_rms", &TestSummary::residual_rms},
                                           Part{"drops", &TestSummary::drops},
                                           Part{"spacing", &TestSummary::spacing},
                                           Part{"friction_share", &TestSummary::friction_share},
                                           Part{"work_of_fracture", &TestSummary::work_of_fracture},
                                           Part{"failed_checks", &TestSummary::failed_checks},
                                           Part{"known", &TestSummary::known},
                                           Part{"surface_height", &TestSummary::surface_height},
                                           Part{"surface_slope", &TestSummary::surface_slope}};
template <>
constexpr std::tuple parts_of<Supports>{Part{"radius", &Supports::radius}, Part{"half_depth", &Supports::half_depth}};
template <>
constexpr std::tuple parts_of<CampaignCurves>{Part{"span", &CampaignCurves::span},
                                              Part{"bending_stiffness", &CampaignCurves::bending_stiffness},
                                              Part{"load_train_stiffness", &CampaignCurves::load_train_stiffness},
                                              Part{"supports", &CampaignCurves::supports},
                                              Part{"stage", &CampaignCurves::stage},
                                              Part{"deflection", &CampaignCurves::deflection},
                                              Part{"force", &CampaignCurves::force},
                                              Part{"model_deflection", &CampaignCurves::model_deflection},
                                              Part{"model_force", &CampaignCurves::model_force},
                                              Part{"drops", &CampaignCurves::drops}};
template <>
constexpr std::tuple parts_of<Materials>{Part{"specimen", &Materials::specimen}, Part{"support", &Materials::support}};
template <>
constexpr std::tuple parts_of<CampaignTest>{Part{"name", &CampaignTest::name},
                                            Part{"status", &CampaignTest::status},
                                            Part{"reason", &CampaignTest::reason},
                                            Part{"file", &CampaignTest::file},
                                            Part{"verdict", &CampaignTest::verdict},
                                            Part{"summary", &CampaignTest::summary},
                                            Part{"curves", &CampaignTest::curves},
                                            Part{"remarks", &CampaignTest::remarks},
                                            Part{"section_moment", &CampaignTest::section_moment},
                                            Part{"materials", &CampaignTest::materials}};

template <class T>
constexpr bool is_optional = false;
template <class T>
constexpr bool is_optional<std::optional<T>> = true;
template <class T>
constexpr bool is_vector = false;
template <class T>
constexpr bool is_vector<std::vector<T>> = true;

constexpr const char* infinite = "infinite";  // JSON knows no infinity, and no NaN, which is null

template <class T>
Json kept(const T& value) {
  if constexpr (HasParts<T>) {
    Json json = Json::object();
    std::apply([&](const auto&... part) { ((json[part.name] = kept(value.*part.member)), ...); }, parts_of<T>);
    return json;
  } else if constexpr (is_optional<T>) {
    return value ? kept(*value) : Json(nullptr);
  } else if constexpr (is_vector<T>) {
    Json json = Json::array();
    for (const auto& each : value) json.push_back(kept(each));
    return json;
  } else if constexpr (std::is_floating_point_v<T>) {
    return value == infinity ? Json(infinite) : Json(value);
  } else {
    return Json(value);
  }
}

template <class T>
void find(const Json& json, T& value) {
  if constexpr (HasParts<T>) {
    std::apply([&](const auto&... part) { (find(json.at(part.name), value.*part.member), ...); }, parts_of<T>);
  } else if constexpr (is_optional<T>) {
    if (!json.is_null()) find(json, value.emplace());
  } else if constexpr (is_vector<T>) {
    value.clear();
    for (const Json& each : json.get_ref<const Json::array_t&>()) find(each, value.emplace_back());
  } else if constexpr (std::is_floating_point_v<T>) {
    value = json.is_null() ? not_a_number : json == infinite ? infinity : json.get<double>();
  } else {
    json.get_to(value);
  }
}

CampaignTest test_from(const Json& json) {
  CampaignTest test{};
  find(json, test);
  return test;
}

std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"; }

[[noreturn]] void refuse(const fs::path& path, const std::error_code& error) {
  throw unwritable(path.string(), error.message());
}

}  // namespace

std::string to_text(const CampaignTest& test) { return text_of(kept(test)); }

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
  write_text(path.string(), text_of({{"layout", layout_of_store}, {"key", key}, {"test", kept(test)}}));
}

}  // namespace flexslip
