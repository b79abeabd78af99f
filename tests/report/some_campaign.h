// A small campaign whose every number is known, with names that no format takes as they are.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bending_test/equilibrium.h"
#include "campaign/campaign.h"
#include "data/scales.h"

namespace flexslip {

inline const std::string awkward_name = "A <b> & 50%_ü \"x\"";

inline CampaignTest some_test(const std::string& name, SawtoothCategory category, double mu0,
                              std::optional<double> wavelength) {
  const Scales scales(1278e-6, 2.13e-9);
  CampaignTest test{.name = name,
                    .status = "ok",
                    .reason = "",
                    .file = "cases/" + name + ".toml",
                    .verdict = wavelength ? "SLIP" : "NO DROPS",
                    .causes = {.slips = 0.9, .cracks = 0.02, .both = 0.08},
                    .summary = TestSummary{.name = name,
                                           .category = category,
                                           .suspect = mu0 > 1,
                                           .model = ProfileModel::roughness,
                                           .mu0 = {mu0, 0.0123, mu0 - 0.0241, mu0 + 0.0241},
                                           .mu0_is_bound = false,
                                           .roughness = {0.1, 0.02, 0.07, 0.15},
                                           .correlation_length = {4.2e-6, 0.6e-6, 3.1e-6, 5.5e-6},
                                           .amplitude = {},
                                           .wavelength = {},
                                           .phase = {},
                                           .wave_claimed = wavelength.has_value(),
                                           .bending_stiffness = {2.13e-9, 6.4e-11, 2.0e-9, 2.26e-9},
                                           .residual_rms = 1.5e-4,
                                           .drops = wavelength ? 7U : 0U,
                                           .spacing = wavelength ? 8e-6 : std::numeric_limits<double>::quiet_NaN(),
                                           .friction_share = 0.25,
                                           .friction_share_error = 0.03,
                                           .work_of_fracture = 3.4e-6,
                                           .measured = {{{mu0, 0.0123}}, {{-2.2, 0.2}}, {{-12.4, 0.3}}}},
                    .curves = CampaignCurves{.span = scales.span(),
                                             .bending_stiffness = scales.bending_stiffness(),
                                             .load_train_stiffness = 90.6,
                                             .supports = {0, 0},
                                             .stage = {},
                                             .deflection = {},
                                             .force = {},
                                             .model_deflection = {},
                                             .model_force = {},
                                             .drops = {}},
                    .remarks = {"fails after row 267"},
                    .materials = Materials{"glass", "steel"}};
  if (wavelength) {
    test.summary->amplitude = Estimate{0.15, 0.02, 0.11, 0.19};
    test.summary->wavelength = Estimate{*wavelength, 0.2e-6, *wavelength - 0.4e-6, *wavelength + 0.4e-6};
    test.summary->phase = Estimate{1, 0.5, 0, 2};
    test.curves->drops = {30, 40};
  }
  auto& curves = *test.curves;
  for (const auto& point : equilibrium_curve(Friction::constant(mu0), Sliding::in, 1.2, 60).points) {
    curves.deflection.push_back(scales.physical_length(point.w));
    curves.force.push_back(scales.physical_force(point.F));
    curves.stage.push_back(curves.deflection.back() + curves.force.back() / curves.load_train_stiffness);
  }
  curves.model_deflection = curves.deflection;
  curves.model_force = curves.force;
  return test;
}

inline Campaign campaign_of(std::vector<CampaignTest> tests) {
  std::vector<TestSummary> summaries;
  for (const auto& test : tests)
    if (test.summary) summaries.push_back(*test.summary);
  return {.tests = std::move(tests),
          .categories = summarise(summaries),
          .friction_share = mean_friction_share(summaries),
          .notes = {}};
}

inline Campaign no_tests() { return campaign_of({}); }

inline Campaign only_failures() {
  return campaign_of({failed_test("SS1", "a.csv", "a.csv:17: column 'F_N': '12,5' is not a number."),
                      failed_test(awkward_name, "b & c.csv", "b & c.csv: <no> numbers_ in 100 %")});
}

inline Campaign some_campaign() {
  return campaign_of({some_test(awkward_name, SawtoothCategory::clear, 0.6, 10.9e-6),
                      some_test("SS4", SawtoothCategory::clear, 0.4, 5.5e-6),
                      some_test("SS5", SawtoothCategory::nominal, 0.75, 44.67e-6),
                      some_test("SS13", SawtoothCategory::none, 0.3, {}),
                      some_test("SS8", SawtoothCategory::clear, 1.25, 20e-6),
                      failed_test("SS99", "99.csv", "99.csv: <nothing> & \"nothing\" is not a number.")});
}

}  // namespace flexslip
