#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "campaign/campaign_run.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

namespace flexslip {
namespace {

CampaignTest some_test() {
  CampaignTest test{.name = "SS14",
                    .status = "ok",
                    .reason = "",
                    .file = "ss14.toml",
                    .verdict = "CHECK INPUT",
                    .causes = {.slips = 0.9, .cracks = 0.02, .both = 0.08},
                    .summary = {},
                    .curves = {},
                    .remarks = {"one", "tw\"o"},
                    .materials = Materials{"glass", "steel"}};
  test.summary = TestSummary{
      .name = "SS14",
      .category = SawtoothCategory::nominal,
      .suspect = true,
      .model = ProfileModel::sinusoid,
      .mu0 = {.value = 0.1, .standard_error = 1.0 / 3, .low = -1e-300, .high = 5e-324},
      .mu0_is_bound = true,
      .roughness = {.value = 0.1, .standard_error = 0.02, .low = 0.07, .high = 0.15},
      .correlation_length = {.value = 4e-6, .standard_error = 1e-6, .low = 2e-6, .high = 6e-6},
      .amplitude = {},
      .wavelength =
          Estimate{.value = 1e-5, .standard_error = std::numeric_limits<double>::quiet_NaN(), .low = 0, .high = 1},
      .phase = {},
      .wave_claimed = true,
      .bending_stiffness = {},
      .residual_rms = 0.3,
      .drops = 7,
      .spacing = 8e-6,
      .friction_share = 0.25,
      .work_of_fracture = 2e-9,
      .measured = {.mu0 = {{1.0 / 3, 1.0 / 7}}, .log_roughness = {}, .log_length = {{-10.8, 0.01}}}};
  test.curves = CampaignCurves{.span = 1278e-6,
                               .bending_stiffness = 2e-12,
                               .load_train_stiffness = std::numeric_limits<double>::infinity(),
                               .supports = {0.08, 0.0125},
                               .stage = {0, 0.1, 0.2},
                               .deflection = {0, 0.1, 0.15},
                               .force = {0, 1, 2},
                               .model_deflection = {0, 0.1},
                               .model_force = {0, 1},
                               .drops = {1}};
  return test;
}

TEST_CASE("identity: a stored test restores every bit, and its text every byte") {
  const std::string text = to_text(some_test());
  const auto back = campaign_test_from(text);
  REQUIRE(back);
  CHECK(to_text(*back) == text);
  CHECK(back->summary->mu0.standard_error == 1.0 / 3);
  CHECK(back->summary->mu0.high == 5e-324);
  CHECK(std::isnan(back->summary->wavelength->standard_error));
  CHECK(!back->summary->amplitude);
  CHECK(back->summary->category == SawtoothCategory::nominal);
  CHECK(std::isinf(back->curves->load_train_stiffness));
  CHECK(back->curves->supports.radius == 0.08);
  CHECK(back->curves->supports.half_depth == 0.0125);
  CHECK(back->curves->force == some_test().curves->force);
  CHECK(back->remarks == some_test().remarks);
  CHECK(back->verdict == "CHECK INPUT");
  CHECK(back->summary->spacing == 8e-6);
  CHECK(back->materials == some_test().materials);
  const auto& measured = back->summary->measured;
  REQUIRE(measured.mu0);
  CHECK(measured.mu0->value == 1.0 / 3);
  CHECK(measured.mu0->standard_error == 1.0 / 7);
  CHECK(!measured.log_roughness);
}

TEST_CASE("table: a stored test is found only under its key; a damaged or foreign file is not found") {
  const TemporaryFolder folder;
  const CampaignStore store(folder.path() / "tests");
  CHECK(!store.find("SS14", "key"));
  folder.file("tests/SS14/old.csv", "of another run");
  store.emptied_folder("SS14");
  CHECK(!std::filesystem::exists(folder.path() / "tests" / "SS14" / "old.csv"));
  store.keep(some_test(), "key");
  CHECK(to_text(store.find("SS14", "key").value()) == to_text(some_test()));
  CHECK(!store.find("SS14", "another"));
  folder.file("tests/SS14/result.json", "{\"layout\":1,\"key\":\"key\",\"te");
  CHECK(!store.find("SS14", "key"));
  folder.file("tests/SS14/result.json", "[]");
  CHECK(!store.find("SS14", "key"));
}

TEST_CASE("table: a folder that cannot be created is refused") {
  const TemporaryFolder folder;
  const auto file = folder.file("tests", "a file");
  CHECK(message_of([&] { CampaignStore store(file); }).find("cannot be written") != std::string::npos);
}

}  // namespace
}  // namespace flexslip
