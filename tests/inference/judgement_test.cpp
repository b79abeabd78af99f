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

TEST_CASE("identity: a test that slips was not made by cracks alone, and one that cracks has lost stiffness") {
  const auto slips = judge(slipping());
  CHECK(slips.drops == CrackVerdict::not_by_cracks_alone);
  CHECK(slips.impossible == 0);
  CHECK(!slips.friction_undetermined);
  const auto cracks = judge(
      analysed(simulated_record({.friction = Friction::constant(0.5), .stiffness = soft, .noise = 0.01}, six_cracks)));
  CHECK(cracks.drops_are_cracks);
  CHECK(cracks.friction_undetermined);
}

TEST_CASE("identity: a reload tells slips, cracks and both, and friction whatever was lost") {
  const auto analysis = slipping();
  const auto slips = judge(reloaded(analysis, 0, 0.01, 0.25));
  CHECK(slips.drops == CrackVerdict::not_by_cracks_alone);
  CHECK(slips.damage == Damage::not_told);
  auto like_cracks = analysis;
  like_cracks.slip_or_crack.cracks_alone = 0.9;
  const auto cracks = judge(reloaded(like_cracks, 0.25, 0.01, 0.25));
  CHECK(cracks.causes.slips < 0.05);
  CHECK(cracks.causes.cracks > cracks.causes.both);
  CHECK(cracks.damage == Damage::lost);
  CHECK(!cracks.friction_undetermined);
  const auto both = judge(reloaded(analysis, 0.12, 0.01, 0.5));
  CHECK(both.drops == CrackVerdict::not_by_cracks_alone);
  CHECK(both.damage == Damage::lost);
  for (const auto& judgement : {slips, cracks, both}) {
    const auto& [slip, crack, each] = judgement.causes;
    CHECK(std::abs(slip + crack + each - 1) < 1e-12);
    CHECK(judgement.if_lost.empty());
  }
}

TEST_CASE("limit: a reload that knows nothing decides nothing, and one loading tells no slips from both") {
  auto analysis = slipping();
  analysis.slip_or_crack.cracks_alone = NAN;
  const auto open = judge(reloaded(analysis, 0.1, 0.3, 0.25));
  CHECK(open.drops == CrackVerdict::cannot_be_told);
  CHECK(open.damage == Damage::not_told);
  CHECK(std::isnan(judge(analysis).causes.slips));
  CHECK(std::isnan(judge(analysis).causes.both));
}

TEST_CASE("limit: the chances of the true cause are few below three errors, and certain far beyond") {
  for (const double error : {0.02, 0.05, 0.1}) {
    CAPTURE(error);
    double before = 0;
    for (const double errors : {1.0, 2.0, 3.0, 4.0, 5.0}) {
      const double cracks = chances_of_causes(errors * error, error, 0.02).cracks;
      CHECK(cracks > before);
      before = cracks;
    }
    CHECK(chances_of_causes(3 * error, error, 0.02).least() < 0.95);
  }
  CHECK(chances_of_causes(0.4, 0.02, 0.02).least() > 0.99);
  // What one loading tells of slips counts.
  CHECK(chances_of_causes(0.4, 0.02, 0.02).slips > chances_of_causes(0.4, 0.02, NAN).slips);
}

TEST_CASE("limit: a loss without drops counts beyond three errors and what passes differ by, settling beside it") {
  auto analysis = slipping();
  analysis.drops.drops.clear();
  CHECK(judge(reloaded(analysis, 0.05, 0.01, 0)).damage == Damage::not_told);
  CHECK(judge(reloaded(analysis, 0.08, 0.01, 0)).damage == Damage::lost);
  auto settled = reloaded(analysis, 0.01, 0.01, 0);
  settled.passes->settled = normal_estimate(0.01, 0.001);
  CHECK(judge(settled).damage == Damage::settled);
}

TEST_CASE("identity: friction that surely decreases by a third of its mean is said to") {
  auto analysis = slipping();
  CHECK(!judge(analysis).friction_falls);
  analysis.fit.drift.value = -0.5 * analysis.fit.mu0.value / (analysis.fit.S_end - analysis.fit.S_begin);
  analysis.fit.drift.high = 0.9 * analysis.fit.drift.value;
  CHECK(judge(analysis).friction_falls);
}

TEST_CASE("identity: where half of the drops cannot be slips there is no probability, but for one of cracks") {
  auto analysis = slipping();
  for (Slip& slip : analysis.slips) slip.verdict = SlipVerdict::unexplained;
  CHECK(std::isnan(judge(analysis).cracks_alone()));
  CHECK(judge(analysis).drops == CrackVerdict::cannot_be_told);
  analysis.slip_or_crack.cracks_alone = 0.97;
  CHECK(judge(analysis).drops == CrackVerdict::cracks);
}

TEST_CASE("identity: where a record contradicts the bending stiffness there is no probability, but for one of cracks") {
  auto analysis = slipping();
  analysis.fit.bending_stiffness.standard_error = 0.8 * analysis.bending_stiffness_error;
  const double error = 0.6 * analysis.bending_stiffness_error;  // of how far what is told and what is stated lie apart
  for (const double errors : {-1.9, 1.9}) {
    analysis.fit.bending_stiffness.value = std::exp(errors * error);
    CHECK(judge(analysis).drops == CrackVerdict::not_by_cracks_alone);
  }
  for (const double errors : {-2.1, 2.1}) {
    analysis.fit.bending_stiffness.value = std::exp(errors * error);
    CHECK(std::isnan(judge(analysis).cracks_alone()));
    CHECK(judge(analysis).drops == CrackVerdict::cannot_be_told);
  }
  analysis.slip_or_crack.cracks_alone = 0.97;
  CHECK(judge(analysis).drops == CrackVerdict::cracks);
}

TEST_CASE("identity: with the stiffness that was lost given back, the friction of the fit is that of the specimen") {
  const auto friction = Friction::sinusoid(0.5, 0.15, 10.9 / 1278, 1.0);
  const std::vector<Crack> six{{0.117, 0.04}, {0.164, 0.04}, {0.211, 0.04}, {0.258, 0.04}, {0.313, 0.04}, {0.36, 0.04}};
  const double lost = 1 - std::pow(0.96, 6);
  const auto sound = analysed(simulated_record({.friction = friction, .stiffness = soft, .noise = 0.01}));
  const auto cracked = analysed(simulated_record({.friction = friction, .stiffness = soft, .noise = 0.01}, six));
  CHECK(friction_hidden_by(cracked, 0) == 0);
  CHECK(friction_hidden_by(cracked, 0.1) < friction_hidden_by(cracked, 0.2));
  CHECK(cracked.fit.mu0.value < 0.42);  // told of it as it is
  const double hidden = friction_hidden_by(cracked, lost);
  constexpr double at_other_stiffness =
      0.15;  // the fit moves the bending stiffness by some percent, and the losses did not come evenly
  CHECK(std::abs(cracked.fit.mu0.value + hidden - 0.5) < at_other_stiffness);
  CHECK(message_of([&] { friction_hidden_by(cracked, 1); }).find("loss") != std::string::npos);

  const auto alone = judge(sound).if_lost;
  REQUIRE(alone.size() == 2);
  CHECK(alone[0].loss == 0.1);
  CHECK(alone[0].friction > sound.fit.mu0.value);
  CHECK(alone[1].friction > alone[0].friction);
  CHECK(judge(reloaded(sound, 0.01, 0.01, 0.2)).if_lost.empty());
}

TEST_CASE("limit: a test without an answer is not judged") {
  auto analysis = slipping();
  analysis.status = AnalysisStatus::not_explained;
  CHECK(message_of([&] { judge(analysis); }).find("without an answer") != std::string::npos);
}

}  // namespace flexslip
