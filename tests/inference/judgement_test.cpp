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

// Loaded twice, the second time so much softer.
ReloadChange reloaded(double ratio, double error) {
  LoadingStiffness first{};
  first.status = LoadingStatus::ok;
  first.ratio.value = 1;
  LoadingStiffness second = first;
  second.ratio.value = ratio;
  second.ratio.standard_error = error;
  return reload_change({first, second}, 0);
}

}  // namespace

TEST_CASE("identity: a test that slips was not made by cracks alone, and one that cracks has lost stiffness") {
  const auto slips = judge(slipping());
  CHECK(slips.drops == CrackVerdict::not_by_cracks_alone);
  CHECK(slips.impossible == 0);
  CHECK(!slips.lost_stiffness);
  const auto cracks = judge(
      analysed(simulated_record({.friction = Friction::constant(0.5), .stiffness = soft, .noise = 0.01}, six_cracks)));
  CHECK(cracks.drops_are_cracks);
  CHECK(cracks.lost_stiffness);
}

TEST_CASE("identity: a softer reload comes first, whatever the rises say; a stiff one clears what they leave open") {
  auto analysis = slipping();
  const auto softer = reloaded(0.74, 0.02);
  const auto judgement = judge(analysis, softer);
  CHECK(judgement.lost_stiffness);
  CHECK(!judgement.drops_are_cracks);
  CHECK(judgement.drops == CrackVerdict::cracks);
  CHECK(!judge(analysis, reloaded(0.93, 0.01)).lost_stiffness);  // as friction that ran in makes it, too
  CHECK(!judge(analysis, reloaded(1.5, 0.02)).lost_stiffness);

  analysis.slip_or_crack.cracks_alone = 0.3;
  CHECK(judge(analysis).drops == CrackVerdict::cannot_be_told);
  const auto as_stiff = reloaded(0.99, 0.01);
  CHECK(judge(analysis, as_stiff).drops == CrackVerdict::not_by_cracks_alone);
  analysis.slip_or_crack.cracks.left = 0.99;  // cracks would need no more than was lost
  CHECK(judge(analysis, as_stiff).drops == CrackVerdict::cannot_be_told);
}

TEST_CASE(
    "identity: two drops that cracks would have to pay for with a tenth are no cracks where a reload lost a fiftieth") {
  auto analysis = slipping();
  analysis.drops.drops.resize(2);
  analysis.slip_or_crack = {};
  double left = 1;  // if friction did not matter, and the deflection hardly changed
  for (const Drop& drop : analysis.drops.drops)
    left *= analysis.record.force[drop.after] / analysis.record.force[drop.before];
  REQUIRE(left < 0.95);
  CHECK(judge(analysis).drops == CrackVerdict::cannot_be_told);
  const auto as_stiff = reloaded(0.99, 0.01), as_soft = reloaded(left, 0.05);
  CHECK(judge(analysis, as_stiff).drops == CrackVerdict::not_by_cracks_alone);
  CHECK(judge(analysis, as_soft).drops == CrackVerdict::cannot_be_told);
}

TEST_CASE("limit: a reload clears no drop below the forces that it compares, and none that cannot be a slip") {
  auto analysis = slipping();
  analysis.drops.drops.resize(2);
  analysis.slips.resize(2);
  analysis.slip_or_crack = {};
  const auto as_stiff = reloaded(0.99, 0.01);
  REQUIRE(judge(analysis, as_stiff).drops == CrackVerdict::not_by_cracks_alone);
  auto impossible = analysis;
  impossible.slips.front().verdict = SlipVerdict::unexplained;
  CHECK(judge(impossible, as_stiff).drops == CrackVerdict::cannot_be_told);
  auto early = analysis;
  early.record.force.push_back(100 * *std::max_element(early.record.force.begin(), early.record.force.end()));
  CHECK(judge(early, as_stiff).loss_needed == 0);
  CHECK(judge(early, as_stiff).drops == CrackVerdict::cannot_be_told);
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
  CHECK(std::isnan(judge(analysis).cracks_alone));
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
    CHECK(std::isnan(judge(analysis).cracks_alone));
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
  const auto reload = reloaded(0.99, 0.01);
  const auto bounded = judge(sound, reload).if_lost;
  REQUIRE(bounded.size() == 1);
  CHECK(bounded[0].loss == doctest::Approx(0.01 + 1.645 * 0.01));
  CHECK(bounded[0].friction < alone[0].friction);
}

TEST_CASE("limit: a test without an answer is not judged") {
  auto analysis = slipping();
  analysis.status = AnalysisStatus::not_explained;
  CHECK(message_of([&] { judge(analysis); }).find("without an answer") != std::string::npos);
}

}  // namespace flexslip
