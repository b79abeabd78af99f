#include "campaign/campaign_run.h"

#include <exception>
#include <filesystem>
#include <mutex>
#include <optional>
#include <system_error>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "campaign/campaign_plan.h"
#include "case/fitted.h"
#include "io/input_error.h"
#include "io/parallel.h"
#include "io/sha256.h"
#include "io/text_file.h"
#include "numerics/effort.h"
#include "numerics/elementary.h"
#include "result/table.h"

namespace flexslip {
namespace {

namespace fs = std::filesystem;

constexpr int layout_of_store = 9;  // a stored text of another version is computed again
constexpr const char* kept_name = "result.json";

// One member of a result, for conversion to text and back.
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
constexpr std::tuple parts_of<Measured>{Part{"value", &Measured::value}, Part{"error", &Measured::standard_error}};
template <>
constexpr std::tuple parts_of<MeasuredFriction>{Part{"mu0", &MeasuredFriction::mu0},
                                                Part{"log_roughness", &MeasuredFriction::log_roughness},
                                                Part{"log_length", &MeasuredFriction::log_length}};
template <>
constexpr std::tuple parts_of<LostStiffness>{Part{"lost", &LostStiffness::lost}, Part{"error", &LostStiffness::error},
                                             Part{"needed", &LostStiffness::needed}};
template <>
constexpr std::tuple parts_of<TestSummary>{Part{"name", &TestSummary::name},
                                           Part{"category", &TestSummary::category},
                                           Part{"suspect", &TestSummary::suspect},
                                           Part{"on_assumed_edges", &TestSummary::on_assumed_edges},
                                           Part{"model", &TestSummary::model},
                                           Part{"mu0", &TestSummary::mu0},
                                           Part{"mu0_is_bound", &TestSummary::mu0_is_bound},
                                           Part{"mu0_by_load_train", &TestSummary::mu0_by_load_train},
                                           Part{"mu0_by_span", &TestSummary::mu0_by_span},
                                           Part{"mu0_by_gain", &TestSummary::mu0_by_gain},
                                           Part{"roughness", &TestSummary::roughness},
                                           Part{"correlation_length", &TestSummary::correlation_length},
                                           Part{"amplitude", &TestSummary::amplitude},
                                           Part{"wavelength", &TestSummary::wavelength},
                                           Part{"phase", &TestSummary::phase},
                                           Part{"wave_claimed", &TestSummary::wave_claimed},
                                           Part{"bending_stiffness", &TestSummary::bending_stiffness},
                                           Part{"residual_rms", &TestSummary::residual_rms},
                                           Part{"drops", &TestSummary::drops},
                                           Part{"spacing", &TestSummary::spacing},
                                           Part{"friction_share", &TestSummary::friction_share},
                                           Part{"friction_share_error", &TestSummary::friction_share_error},
                                           Part{"work_of_fracture", &TestSummary::work_of_fracture},
                                           Part{"measured", &TestSummary::measured},
                                           Part{"loss", &TestSummary::loss}};
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
constexpr std::tuple parts_of<ShareRange>{Part{"least", &ShareRange::least}, Part{"most", &ShareRange::most}};
template <>
constexpr std::tuple parts_of<FrictionGain>{
    Part{"friction", &FrictionGain::friction},   Part{"modulus", &FrictionGain::modulus},
    Part{"strength", &FrictionGain::strength},   Part{"work", &FrictionGain::work},
    Part{"is_stated", &FrictionGain::is_stated}, Part{"turns", &FrictionGain::turns}};
template <>
constexpr std::tuple parts_of<StandardSummary>{Part{"modulus", &StandardSummary::modulus},
                                               Part{"strength", &StandardSummary::strength},
                                               Part{"friction", &StandardSummary::friction}};
template <>
constexpr std::tuple parts_of<Causes>{Part{"slips", &Causes::slips}, Part{"cracks", &Causes::cracks},
                                      Part{"both", &Causes::both}};
template <>
constexpr std::tuple parts_of<CampaignTest>{
    Part{"name", &CampaignTest::name},        Part{"status", &CampaignTest::status},
    Part{"reason", &CampaignTest::reason},    Part{"file", &CampaignTest::file},
    Part{"verdict", &CampaignTest::verdict},  Part{"causes", &CampaignTest::causes},
    Part{"summary", &CampaignTest::summary},  Part{"curves", &CampaignTest::curves},
    Part{"remarks", &CampaignTest::remarks},  Part{"materials", &CampaignTest::materials},
    Part{"standard", &CampaignTest::standard}};

template <class T>
constexpr bool is_optional = false;
template <class T>
constexpr bool is_optional<std::optional<T>> = true;
template <class T>
constexpr bool is_vector = false;
template <class T>
constexpr bool is_vector<std::vector<T>> = true;

constexpr const char* infinite = "infinite";  // JSON has no infinity; NaN is null

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
  fs::remove(folder / kept_name, error);  // first, because the test is unfinished from here on
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

namespace {

// Everything on which the answer depends.
std::string key_of(const PlannedTest& planned, const Test& input, const AnalysisOptions& options,
                   const std::string& presented) {
  const std::string source = input.source.empty() ? "" : digest_of(*open_to_read(input.source)).sha256;
  return sha256_of(fmt::format("{}\n{}\n{}\n{}\n{}\npresented {}\n{}\n{}\n", FLEXSLIP_VERSION, source, planned.name,
                               planned.file, analysis_fields()(options, {}).dump(), presented, to_toml(input),
                               digest_of(*open_to_read(input.record.value().file)).sha256));
}

// Devices have no end, and standard input cannot be read twice.
void require_file(const std::string& file) {
  std::error_code missing;
  if (std::filesystem::exists(file, missing) && !std::filesystem::is_regular_file(file, missing))
    throw InputError({.file = file, .problem = "This is a folder or a device, not a file"});
}

class Runner {
 public:
  Runner(const std::vector<PlannedTest>& plan, const CampaignOptions& options)
      : plan_(plan), options_(options), tests_(plan.size()) {
    if (options.folder) store_.emplace(*options.folder);
  }

  CampaignRun run() {
    for_each_index(plan_.size(), options_.threads, [this](std::size_t i) {
      if (options_.stop && options_.stop->load()) return;
      const Stoppable stoppable(options_.stop);
      try {
        finish(i, computed(plan_[i]));
      } catch (const Stopped&) {  // the test counts as not started
      }
    });
    CampaignRun result{CampaignStatus::ok, {}, found_};
    std::vector<TestSummary> summaries;
    for (auto& test : tests_) {
      if (!test) {
        result.status = CampaignStatus::stopped;
        continue;
      }
      if (test->summary) summaries.push_back(*test->summary);
      result.campaign.tests.push_back(std::move(*test));
    }
    result.campaign.categories = summarise(summaries);
    std::vector<Causes> causes;
    for (const CampaignTest& test : result.campaign.tests) causes.push_back(test.causes);
    result.campaign.causes = cause_shares(causes);
    result.campaign.shared_error = shared_error_of(summaries);
    result.campaign.friction_share = mean_friction_share(summaries);
    return result;
  }

 private:
  struct Computed {
    CampaignTest test;
    bool found;
  };

  Computed computed(const PlannedTest& planned) const {
    std::string key;
    std::optional<FittedTest> test;
    try {
      if (const auto* error = std::get_if<InputError>(&planned.input)) throw InputError(*error);
      const Test& input = std::get<Test>(planned.input);
      const AnalysisOptions options = options_.analysis(input);
      require_file(input.record.value().file);
      if (store_) key = key_of(planned, input, options, options_.presented);
      if (store_)
        if (auto kept = store_->find(planned.name, key)) return {std::move(*kept), true};
      test = fit_test(input, options);
      test->name = planned.name;
    } catch (const std::exception& error) {
      if (store_) store_->emptied_folder(planned.name);
      return {failed_test(planned.name, planned.file, error.what()), false};
    }
    const CampaignTest line = campaign_test_of(*test, planned.file);
    if (!store_) return {line, false};
    const auto folder = store_->emptied_folder(planned.name);
    if (options_.present) options_.present(*test, folder.string());
    store_->keep(line, key);
    // identical to what a later run reads
    return {campaign_test_from(to_text(line)).value(), false};
  }

  void finish(std::size_t index, Computed computed) {
    const std::lock_guard lock(mutex_);
    tests_[index] = std::move(computed.test);
    found_ += computed.found;
    ++done_;
    if (options_.progress) options_.progress(done_, plan_.size());
  }

  const std::vector<PlannedTest>& plan_;
  const CampaignOptions& options_;
  std::optional<CampaignStore> store_;
  std::mutex mutex_;  // guards all members below
  std::vector<std::optional<CampaignTest>> tests_;
  std::size_t done_ = 0;
  std::size_t found_ = 0;
};

}  // namespace

CampaignRun run_campaign(const CampaignPlan& plan, const CampaignOptions& options) {
  CampaignRun run = Runner(plan.tests, options).run();
  run.campaign.notes = plan.notes;
  return run;
}

}  // namespace flexslip
