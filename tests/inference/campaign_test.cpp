#include "inference/campaign.h"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "tests/inference/simulated_test.h"
#include "tests/refusal.h"

namespace flexslip {
namespace {

TestSummary some_test(SawtoothCategory category, double mu0, std::optional<double> wavelength, bool suspect) {
  TestSummary test{};
  test.category = category;
  test.suspect = suspect;
  test.mu0.value = mu0;
  if (wavelength) {
    test.wavelength = Estimate{.value = *wavelength, .standard_error = 0, .low = 0, .high = 0};
    test.amplitude = Estimate{.value = 0.1 * mu0, .standard_error = 0, .low = 0, .high = 0};
  }
  return test;
}

TEST_CASE("causes: shares of specimens by hand, and jointly surer than any test") {
  CHECK(cause_shares({}).tests == 0);
  CHECK(cause_shares(std::vector<Causes>(3)).tests == 0);
  // Of one that surely slipped the share has the density 6 s (1 - s), of which half lie below a half.
  const auto one = cause_shares(std::vector<Causes>{{.slips = 1, .cracks = 0, .both = 0}, {}});
  CHECK(one.tests == 1);
  CHECK(one.slips.median == doctest::Approx(0.5).epsilon(0.03));
  CHECK(one.cracks.median == doctest::Approx(one.both.median).epsilon(0.01));
  const auto even = cause_shares(std::vector<Causes>(4, {.slips = 1.0 / 3, .cracks = 1.0 / 3, .both = 1.0 / 3}));
  CHECK(even.slips.median == doctest::Approx(1 - std::sqrt(0.5)).epsilon(0.05));
  CHECK(even.slips.median == doctest::Approx(even.both.median).epsilon(0.05));
  const auto many = cause_shares(std::vector<Causes>(40, {.slips = 0.02, .cracks = 0.9, .both = 0.08}));
  CHECK(many.cracks.low > 0.7);
  CHECK(many.slips.high < 0.15);
}

TEST_CASE("shared error: more tests on a rig do not average its errors away") {
  TestSummary one{};
  one.mu0.value = 0.5;
  one.mu0_by_load_train = 0.03;
  one.mu0_by_span = -0.04;
  CHECK(shared_error_of(std::vector(1, one)) == doctest::Approx(0.05));
  CHECK(shared_error_of(std::vector(30, one)) == doctest::Approx(0.05));
  TestSummary other = one;
  other.mu0_by_span = 0.04;
  CHECK(shared_error_of(std::vector{one, other}) == doctest::Approx(0.03));
  CHECK(shared_error_of({}) == 0);
}

TEST_CASE(
    "mean share of the work: the scatter of specimens and the error of the rig, which more of them do not average "
    "away") {
  TestSummary low{}, high{};
  low.friction_share = 0.2;
  high.friction_share = 0.3;
  low.friction_share_error = high.friction_share_error = 0.03;
  const Estimate one = mean_friction_share(std::vector{low}), two = mean_friction_share(std::vector{low, high});
  CHECK(one.standard_error == doctest::Approx(0.03));
  CHECK(two.value == doctest::Approx(0.25));
  CHECK(two.standard_error == doctest::Approx(std::hypot(0.05, 0.03)));
  CHECK(mean_friction_share(std::vector(100, low)).standard_error == doctest::Approx(0.03));
  high.suspect = true;
  CHECK(mean_friction_share(std::vector{low, high}).value == 0.2);
  CHECK(std::isnan(mean_friction_share({}).value));
}

TEST_CASE("table: mean, least and greatest of each category, with and without suspects") {
  using enum SawtoothCategory;
  const std::vector<TestSummary> tests{some_test(clear, 0.5, 10e-6, false), some_test(clear, 0.75, 20e-6, false),
                                       some_test(clear, 1.25, 30e-6, true), some_test(none, 0.25, 5e-6, false)};
  const auto summaries = summarise(tests);
  REQUIRE(summaries.size() == 4);
  const auto& clear_tests = summaries[0];
  CHECK(clear_tests.category == clear);
  CHECK(clear_tests.without_suspects.tests == 2);
  CHECK(clear_tests.without_suspects.mu0.mean == 0.625);  // exact in binary, as all means of mu0 here
  CHECK(clear_tests.without_suspects.mu0.max == 0.75);
  CHECK(clear_tests.with_suspects.tests == 3);
  CHECK(clear_tests.with_suspects.mu0.max == 1.25);
  CHECK(clear_tests.with_suspects.wavelength.max == 30e-6);
  CHECK(clear_tests.without_suspects.amplitude.min == 0.05);
  CHECK(summaries[1].category == nominal);
  CHECK(summaries[1].with_suspects.tests == 0);
  CHECK(summaries[1].with_suspects.mu0.count == 0);
  CHECK(summaries[2].with_suspects.mu0.mean == 0.25);
  CHECK(summaries[2].with_suspects.wavelength.count == 0);  // no sawtooth, no wavelength
  CHECK(summaries[3].category == std::nullopt);
  CHECK(summaries[3].without_suspects.tests == 3);
  CHECK(summaries[3].without_suspects.mu0.mean == 0.5);
  CHECK(summaries[3].without_suspects.wavelength.count == 2);
}

TEST_CASE("identity: a test that tells only a limit, or nothing, moves no mean") {
  using enum SawtoothCategory;
  std::vector<TestSummary> tests{some_test(clear, 0.5, 10e-6, false), some_test(clear, 0.02, {}, false),
                                 some_test(clear, 1.75, 30e-6, true)};
  tests[0].wave_claimed = true;
  tests[1].mu0_is_bound = true;
  tests[1].mu0.high = 0.05;
  tests[2].mu0.value =
      std::numeric_limits<double>::quiet_NaN();  // as summary_of leaves a test that is not to be trusted
  const CategorySpread all = summarise(tests)[0].with_suspects;
  CHECK(all.tests == 3);
  CHECK(all.mu0.count == 1);
  CHECK(all.mu0.mean == 0.5);
  CHECK(all.mu0_limit.count == 1);
  CHECK(all.mu0_limit.max == 0.05);
  CHECK(all.wavelength.count == 1);
  CHECK(all.waves_claimed == 1);
}

TEST_CASE(
    "identity: what specimens have in common is the population of their category, suspects and records that tell "
    "nothing left out") {
  using enum SawtoothCategory;
  std::vector<TestSummary> tests;
  std::vector<Measured> clear_ones;
  for (const double mu0 : {0.4, 0.5, 0.65, 0.7}) {
    tests.push_back(some_test(mu0 < 0.7 ? clear : none, mu0, {}, false));
    tests.back().measured.mu0 = {mu0, 0.05};
    if (mu0 < 0.7) clear_ones.push_back({mu0, 0.05});
  }
  tests.push_back(some_test(clear, 1.5, {}, true));
  tests.back().measured.mu0 = {1.5, 0.05};
  tests.push_back(some_test(clear, 0.5, {}, false));
  const auto summaries = summarise(tests);
  REQUIRE(summaries[0].mu0);
  const auto population = population_of(clear_ones);
  CHECK(summaries[0].mu0->tests == 3);
  CHECK(summaries[0].mu0->typical.value == population.typical.value);
  CHECK(summaries[0].mu0->max_spread == population.max_spread);
  CHECK(!summaries[2].mu0);  // one specimen
  CHECK(summaries[3].mu0->tests == 4);
  CHECK(!summaries[3].log_roughness);
}

TEST_CASE("limit: no friction typical of specimens is below 0") {
  const auto of_all = [](double mu0) {
    std::vector<TestSummary> tests(3, some_test(SawtoothCategory::none, mu0, {}, false));
    for (auto& test : tests) test.measured = {{{mu0, 0.03}}, {{-3, 0.1}}, {}};
    return summarise(tests).back();
  };
  const auto hardly = of_all(-0.01);
  REQUIRE(hardly.mu0);
  CHECK(hardly.mu0->typical.value == 0);
  CHECK(hardly.mu0->typical.low == 0);
  CHECK(hardly.mu0->typical.high > 0);
  CHECK(hardly.log_roughness->typical.low < 0);  // of a logarithm
  CHECK(!of_all(-1).mu0);
}

TEST_CASE("identity: the summary of a simulated test is that of its fits, in SI") {
  const SimulatedTruth truth{
      .friction = Friction::sinusoid(0.6, 0.3, 14.0 / 1278, 1.0), .stiffness = 90, .noise = 0.01};
  const TestDescription description{.span = scales.span(),
                                    .load_train_stiffness = scales.physical_stiffness(truth.stiffness),
                                    .bending_stiffness = scales.bending_stiffness()};
  const Record record = to_physical(simulated_record(truth), scales);
  const auto analysis = analyse(record, description);
  const auto summary = summary_of("simulated", analysis);
  CHECK(summary.category == SawtoothCategory::clear);
  CHECK(summary.wave_claimed);
  CHECK(!summary.mu0_is_bound);
  CHECK(summary.mu0.low < 0.6);
  CHECK(summary.mu0.high > 0.6);
  CHECK(summary.wavelength.value().value == doctest::Approx(14e-6).scale(0).epsilon(0.02));  // resolution of the record
  CHECK(summary.amplitude.value().value == doctest::Approx(0.3).scale(0).epsilon(0.2));      // likewise
  CHECK(summary.bending_stiffness.value ==
        doctest::Approx(scales.bending_stiffness()).scale(0).epsilon(0.05));  // within its prior
  double work = 0;
  for (std::size_t i = 1; i < record.force.size(); ++i)
    work += 0.5 * (record.force[i] + record.force[i - 1]) * (record.deflection[i] - record.deflection[i - 1]);
  CHECK(summary.work_of_fracture == doctest::Approx(work).scale(0).epsilon(1e-12));  // rounding of a sum of 300

  const auto of_cracked = without_friction(summary);
  CHECK(std::isnan(of_cracked.mu0.value));
  CHECK(std::isnan(of_cracked.spacing));
  CHECK(summary.spacing > 5e-6);
  CHECK(!of_cracked.wavelength);
  CHECK(of_cracked.work_of_fracture == summary.work_of_fracture);

  auto without = analysis;
  without.status = AnalysisStatus::deflection_too_small;
  CHECK(message_of([&] { summary_of("simulated", without); }) == "a test without a fit has no summary");
}

}  // namespace
}  // namespace flexslip
