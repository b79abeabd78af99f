#include "campaign/campaign_run.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "tests/inference/simulated_test.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

namespace flexslip {
namespace {

constexpr int tests = 5;

constexpr double span = 1e-3;        // [m]
constexpr double force_unit = 1e-3;  // [N] EI/L^2, of EI = 1e-9 N m^2

std::string case_of(const std::string& file) {
  return fmt::format(
      "[specimen]\nbending_stiffness = \"1e-9 N m^2\"\n[rig]\nspan = \"1 mm\"\nstiffness = \"90 N/m\"\n"
      "[record]\nfile = \"{}\"\nstage = \"stage [m]\"\nforce = \"force [N]\"\n",
      file);
}

// Four tests made by the model itself, and one file that is none.
void write_campaign(const TemporaryFolder& folder) {
  for (int i = 1; i < tests; ++i) {
    const auto record = simulated_record({.friction = Friction::sinusoid(0.5, 0.2, 0.01 + 0.002 * i, 1.0),
                                          .noise = 0.01,
                                          .seed = static_cast<std::uint64_t>(i)});
    std::string csv = "stage [m],force [N]\n";
    for (std::size_t row = 0; row < record.stage.size(); ++row)
      csv += fmt::format("{},{}\n", span * record.stage[row], force_unit * record.force[row]);
    folder.file(fmt::format("{}.csv", i), csv);
    folder.file(fmt::format("{}.toml", i), case_of(fmt::format("{}.csv", i)));
  }
  folder.file("broken.csv", "stage [m],force [N]\n1,what\n");
  folder.file("broken.toml", case_of("broken.csv"));
}

CampaignOptions options(unsigned threads, const std::optional<std::string>& folder = {}) {
  const auto quick = [](const Test&) {
    AnalysisOptions analysis;
    analysis.fit.model = ProfileModel::constant;
    return analysis;
  };
  return {.analysis = quick, .threads = threads, .folder = folder};
}

std::string text_of(const Campaign& campaign) {
  std::string text;
  for (const auto& test : campaign.tests) text += to_text(test);
  return text;
}

TEST_CASE("identity: answers have the same bytes for any number of threads, stored or not") {
  const TemporaryFolder folder;
  write_campaign(folder);
  const auto plan = plan_campaign(folder.path().string(), std::nullopt);
  const auto alone = run_campaign(plan, options(1));
  REQUIRE(alone.status == CampaignStatus::ok);
  REQUIRE(alone.campaign.tests.size() == tests);
  CHECK(alone.campaign.categories.back().with_suspects.tests == tests - 1);
  const std::string text = text_of(alone.campaign);
  CHECK(text_of(run_campaign(plan, options(3)).campaign) == text);
  const auto kept = options(3, (folder.path() / "kept").string());
  CHECK(text_of(run_campaign(plan, kept).campaign) == text);
  const auto again = run_campaign(plan, kept);
  CHECK(again.found == tests - 1);  // what failed is tried again
  CHECK(text_of(again.campaign) == text);
}

TEST_CASE("identity: a test that fails is listed with its reason, and the others do not change") {
  const TemporaryFolder folder;
  write_campaign(folder);
  const auto campaign = run_campaign(plan_campaign(folder.path().string(), std::nullopt), options(2)).campaign;
  const auto& broken = campaign.tests.back();
  CHECK(broken.name == "broken");
  CHECK(broken.status == "failed");
  CHECK(broken.reason.find("broken.csv: column 'force [N]': The column 'force' holds words") != std::string::npos);
  CHECK(!broken.summary);
  for (std::size_t i = 0; i + 1 < campaign.tests.size(); ++i) CHECK(campaign.tests[i].status == "ok");
}

TEST_CASE(
    "identity: a campaign that is stopped keeps the tests that are done, gives up that under way, and goes on where it "
    "was") {
  const TemporaryFolder folder;
  write_campaign(folder);
  const auto plan = plan_campaign(folder.path().string(), std::nullopt);
  const std::string text = text_of(run_campaign(plan, options(1)).campaign);

  auto stopping = options(1, (folder.path() / "kept").string());
  std::atomic<bool> stop = false;
  stopping.stop = &stop;
  stopping.analysis = [&, begun = 0, analysis = stopping.analysis](const Test& test) mutable {
    stop = ++begun == 3;
    return analysis(test);
  };
  const auto part = run_campaign(plan, stopping);
  CHECK(part.status == CampaignStatus::stopped);
  CHECK(part.campaign.tests.size() == 2);

  const auto whole = run_campaign(plan, options(2, (folder.path() / "kept").string()));
  CHECK(whole.status == CampaignStatus::ok);
  CHECK(whole.found == 2);
  CHECK(text_of(whole.campaign) == text);
}

TEST_CASE("identity: another setting, or another byte in a data file, is computed again") {
  const TemporaryFolder folder;
  write_campaign(folder);
  const auto plan = plan_campaign(folder.path().string(), std::nullopt);
  auto kept = options(2, (folder.path() / "kept").string());
  run_campaign(plan, kept);
  kept.analysis = [quick = kept.analysis](const Test& input) {
    auto analysis = quick(input);
    analysis.suspect_limit = 0.3;
    return analysis;
  };
  const auto stricter = run_campaign(plan, kept);
  CHECK(stricter.found == 0);
  CHECK(stricter.campaign.tests.front().summary.value().suspect);
  std::ofstream(folder.path() / "1.csv", std::ios::app) << "\n";
  CHECK(run_campaign(plan, kept).found == tests - 2);
}

TEST_CASE("identity: the files of a test exist before it counts as done, and a failure to write ends the run") {
  const TemporaryFolder folder;
  write_campaign(folder);
  const auto plan = plan_campaign(folder.path().string(), std::nullopt);
  auto presenting = options(2, (folder.path() / "kept").string());
  presenting.present = [](const FittedTest& test, const std::string& into) {
    std::ofstream(into + "/name.txt") << test.name;
  };
  run_campaign(plan, presenting);
  CHECK(std::filesystem::exists(folder.path() / "kept" / "1" / "name.txt"));

  presenting.folder = (folder.path() / "other").string();
  presenting.present = [](const FittedTest&, const std::string& into) {
    throw InputError({.file = into, .problem = "The file cannot be written: no space left"});
  };
  CHECK(message_of([&] { run_campaign(plan, presenting); }).find("no space left") != std::string::npos);
}

}  // namespace
}  // namespace flexslip
