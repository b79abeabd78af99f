#include "inference/judgement.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "tests/inference/simulated_test.h"
#include "tests/refusal.h"

namespace flexslip {
namespace {

constexpr double soft = 60;

TestAnalysis analysed(const ReducedRecord& record) {
  return analyse(to_physical(record, scales), {.span = scales.span(),
                                               .load_train_stiffness = scales.physical_stiffness(soft),
                                               .bending_stiffness = scales.bending_stiffness()});
}

TestAnalysis slipping() {
  return analysed(simulated_record(
      {.friction = Friction::sinusoid(0.6, 0.25, 14.0 / 1278, 1.0), .stiffness = soft, .noise = 0.01, .seed = 5}));
}

// The same, loaded again with so much less stiffness, where the drops would need so much.
TestAnalysis reloaded(TestAnalysis analysis, double lost, double error, double needed) {
  PassesFit passes{};
  passes.status = PassesStatus::ok;
  passes.is_reloaded = passes.is_followed = true;
  passes.loss = normal_estimate(lost, error);
  passes.loss_needed = needed;
  analysis.passes = passes;
  return analysis;
}

}  // namespace

TEST_CASE("identity: a test that slips is told to slip, and one that cracks to have lost stiffness") {
  const auto slips = judge(slipping());
  CHECK(slips.conclusion == Conclusion::slips);
  CHECK(slips.determines_friction);
  const auto cracks = judge(
      analysed(simulated_record({.friction = Friction::constant(0.5), .stiffness = soft, .noise = 0.01}, six_cracks)));
  CHECK(cracks.conclusion == Conclusion::cracks);
  CHECK_FALSE(cracks.determines_friction);
  CHECK(cracks.if_lost.empty());
}

TEST_CASE("identity: a reload tells slips, cracks and both, and friction whatever was lost") {
  const auto analysis = slipping();
  const auto slips = judge(reloaded(analysis, 0, 0.01, 0.25));
  CHECK(slips.conclusion == Conclusion::slips);
  const auto both = judge(reloaded(analysis, 0.12, 0.01, 0.5));
  CHECK(both.conclusion == Conclusion::slips_and_damage);
  const auto cracking =
      analysed(simulated_record({.friction = Friction::constant(0.5), .stiffness = soft, .noise = 0.01}, six_cracks));
  const auto cracks = judge(reloaded(cracking, 0.39, 0.01, 0.4));
  CHECK(cracks.conclusion == Conclusion::cracks);
  for (const auto& judgement : {slips, both, cracks}) {
    const auto& [slip, crack, each] = judgement.causes;
    CHECK(std::abs(slip + crack + each - 1) < 1e-12);
    CHECK(judgement.if_lost.empty());
    CHECK(judgement.determines_friction);
  }
}

TEST_CASE("identity: what an earlier loading lost counts beside the slips of the one that is evaluated") {
  auto later = reloaded(slipping(), 0.12, 0.01, 0.25);
  later.passes->is_followed = false;
  const auto both = judge(later);
  CHECK(both.conclusion == Conclusion::slips_and_damage);
  CHECK(both.determines_friction);
  CHECK_FALSE(both.if_lost.empty());
  later.passes->loss = normal_estimate(0.04, 0.01);
  CHECK(judge(later).conclusion == Conclusion::slips);
}

TEST_CASE("limit: a loss without drops counts beyond three errors and what passes differ by, settling beside it") {
  auto analysis = slipping();
  analysis.drops.drops.clear();
  analysis.drop_features.drops = 0;
  CHECK(judge(reloaded(analysis, 0.05, 0.01, 0)).conclusion == Conclusion::no_drops);
  CHECK(judge(reloaded(analysis, 0.08, 0.01, 0)).conclusion == Conclusion::cracks);
  auto settled = reloaded(analysis, 0.01, 0.01, 0);
  settled.passes->settled = normal_estimate(0.01, 0.001);
  CHECK(judge(settled).conclusion == Conclusion::settled);
}

TEST_CASE("identity: no drops is never said of a specimen whose force fell below any friction") {
  auto analysis = slipping();
  analysis.drops.drops.clear();
  analysis.drop_features = {};
  CHECK(judge(analysis).conclusion == Conclusion::no_drops);
  analysis.drop_features.least_anywhere = -5;
  analysis.drop_features.fall_anywhere = 2;
  CHECK(judge(analysis).conclusion == Conclusion::cracks);
}

TEST_CASE("identity: where cracks only would need less friction than crests have, slips are not told from them") {
  auto analysis = slipping();
  analysis.drop_features.needed_at_end = 0.85;
  const Judgement judgement = judge(analysis);
  if (slips_at_all(judgement.causes)) CHECK(judgement.conclusion == Conclusion::undecided);
}

TEST_CASE("identity: friction that surely decreases by a third of its mean is said to") {
  auto analysis = slipping();
  CHECK(!judge(analysis).friction_falls);
  analysis.fit.drift.value = -0.5 * analysis.fit.mu0.value / (analysis.fit.S_end - analysis.fit.S_begin);
  analysis.fit.drift.high = 0.9 * analysis.fit.drift.value;
  CHECK(judge(analysis).friction_falls);
}

TEST_CASE("identity: with the stiffness that was lost given back, the friction of the fit is that of the specimen") {
  const auto friction = Friction::sinusoid(0.5, 0.15, 10.9 / 1278, 1.0);
  const std::vector<Crack> six{{0.117, 0.04}, {0.164, 0.04}, {0.211, 0.04}, {0.258, 0.04}, {0.313, 0.04}, {0.36, 0.04}};
  const double lost = 1 - std::pow(0.96, 6);
  const auto sound = analysed(simulated_record({.friction = friction, .stiffness = soft, .noise = 0.01}));
  const auto cracked = analysed(simulated_record({.friction = friction, .stiffness = soft, .noise = 0.01}, six));
  CHECK(friction_underestimate(cracked, 0) == 0);
  CHECK(friction_underestimate(cracked, 0.1) < friction_underestimate(cracked, 0.2));
  CHECK(cracked.fit.mu0.value < 0.42);  // told of it as it is
  const double hidden = friction_underestimate(cracked, lost);
  constexpr double at_other_stiffness =
      0.15;  // the fit moves the bending stiffness by some percent, and the losses did not come evenly
  CHECK(std::abs(cracked.fit.mu0.value + hidden - 0.5) < at_other_stiffness);
  CHECK(message_of([&] { friction_underestimate(cracked, 1); }).find("loss") != std::string::npos);

  const auto alone = judge(sound).if_lost;
  REQUIRE(alone.size() == 2);
  CHECK(alone[0].loss == 0.1);
  CHECK(alone[0].friction > sound.fit.mu0.value);
  CHECK(alone[1].friction > alone[0].friction);
  CHECK(judge(reloaded(sound, 0.01, 0.01, 0.2)).if_lost.empty());
}

TEST_CASE("limit: a test that no friction explains is judged by its drops, and tells no friction") {
  auto analysis = slipping();
  analysis.status = AnalysisStatus::not_explained;
  CHECK(judge(analysis).conclusion == Conclusion::slips);
  CHECK_FALSE(judge(analysis).determines_friction);
}

}  // namespace flexslip
