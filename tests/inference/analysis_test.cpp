#include "inference/analysis.h"

#include <cmath>

#include <doctest/doctest.h>

#include "inference/rig_error_effects.h"
#include "tests/inference/simulated_test.h"
#include "tests/refusal.h"

namespace flexslip {
namespace {

TestDescription description_of(const SimulatedTruth& truth) {
  return {.span = scales.span(),
          .load_train_stiffness = scales.physical_stiffness(truth.stiffness),
          .bending_stiffness = scales.bending_stiffness(),
          .rig_errors = none_off};
}

SimulatedTruth toothed() {
  return {.friction = Friction::sinusoid(0.6, 0.3, 14.0 / 1278, 1.0), .stiffness = 90, .noise = 0.01};
}

TEST_CASE("identity: a simulated sawtooth is analysed end to end") {
  const auto truth = toothed();
  const auto analysis = analyse(to_physical(simulated_record(truth), scales), description_of(truth));
  REQUIRE(analysis.status == AnalysisStatus::ok);
  CHECK(analysis.category == SawtoothCategory::clear);
  CHECK(!analysis.suspects.suspect);
  CHECK(analysis.force_noise ==
        doctest::Approx(0.01).scale(0).epsilon(0.4));  // a robust estimate from its quietest tenth
  const auto exact = follow_in_steps({truth.friction, {truth.stiffness}}, analysis.reduced.stage);
  // The mean of the fit has the teeth of the truth, but for those about which the record says least.
  CHECK(analysis.model.snaps.size() + 3 >= exact.snaps.size());
  CHECK(analysis.model.snaps.size() <= exact.snaps.size() + 3);
  for (const auto& check : analysis.checks) {
    CAPTURE(name_of(check.kind));
    CHECK(check.outcome == CheckOutcome::passed);
  }
  CHECK(analysis.pointwise_friction.low80 < analysis.pointwise_friction.median);
  CHECK(analysis.pointwise_friction.median < analysis.pointwise_friction.high80);
  for (const auto& snap : exact.snaps) {
    bool found = false;
    for (const auto& drop : analysis.drops.drops)
      found = found ||
              (analysis.reduced.stage[drop.before] <= snap.stage && snap.stage <= analysis.reduced.stage[drop.after]);
    CHECK(found);
  }
  // Just before a fold the force may fall while the fibre is stable, which no one can tell from a small snap.
  CHECK(analysis.drops.drops.size() <= exact.snaps.size() + 3);
  CHECK(analysis.slip_summary.median_spacing == doctest::Approx(14.0 / 1278).scale(0).epsilon(0.1));
  for (const auto& drop : analysis.drops.drops)
    CHECK(analysis.replay.force[drop.after] < analysis.replay.force[drop.before]);
  double squares = 0;
  std::size_t replayed = 0;
  for (std::size_t i = 0; i < analysis.replay.force.size(); ++i) {
    if (!std::isfinite(analysis.replay.force[i])) continue;
    squares += std::pow(analysis.replay.force[i] - analysis.reduced.force[i], 2);
    ++replayed;
  }
  REQUIRE(replayed > 0);
  CHECK(std::sqrt(squares / static_cast<double>(replayed)) < 1e-3);
}

TEST_CASE("identity: the measured energies close, and agree with those of the model that made the test") {
  auto truth = toothed();
  truth.noise = 1e-4;
  const auto analysis = analyse(to_physical(simulated_record(truth), scales), description_of(truth));
  const auto& measured = analysis.energy.account;
  // Trapezoids over the points of a test: a few per mille of the work.
  const double parts = measured.bending + measured.load_train + measured.friction + measured.snaps;
  CHECK(std::abs(measured.stage_work - parts) < 5e-3 * measured.stage_work);
  const auto exact = follow_in_steps({truth.friction, {truth.stiffness}}, analysis.reduced.stage).energy;
  CHECK(measured.stage_work == doctest::Approx(exact.stage_work).scale(0).epsilon(5e-3));
  CHECK(measured.bending == doctest::Approx(exact.bending).scale(0).epsilon(5e-3));
  CHECK(measured.friction + measured.snaps == doctest::Approx(exact.friction + exact.snaps).scale(0).epsilon(2e-2));
}

TEST_CASE("identity: the share of the work moves with what is stated as its sensitivities say") {
  const SimulatedTruth truth{.friction = Friction::constant(0.5), .noise = 0.01};
  const Record record = to_physical(simulated_record(truth), scales);
  const TestDescription description = description_of(truth);
  const auto usual = analyse(record, description);
  REQUIRE(usual.work_share_sensitivities);
  constexpr double more = 0.003;
  // The record and what is stated of its rig, as a user would change either.
  const auto share_with = [&](StatedQuantity quantity) {
    Record read = record;
    TestDescription stated = description;
    const double length = more * scales.span();
    switch (quantity) {
      case StatedQuantity::bending_stiffness:
        stated.bending_stiffness *= 1 + more;
        break;
      case StatedQuantity::load_train:
        stated.load_train_stiffness *= 1 + more;
        break;
      case StatedQuantity::span:
        stated.span *= 1 + more;
        break;
      case StatedQuantity::force_gain:
        for (double& each : read.force) each *= 1 + more;
        break;
      case StatedQuantity::contact:
        for (double& each : read.stage) each -= length;
        break;
      case StatedQuantity::preload: {
        const double load = 48 * scales.physical_force(more);
        for (double& each : read.force) each += load;
        for (double& each : read.stage) each += length + load / stated.load_train_stiffness;
        break;
      }
      case StatedQuantity::thickness:
        stated.fibre = Fibre({.radius = 0, .half_depth = 0.5 * more});
        break;
      case StatedQuantity::support_radius:
        stated.fibre = Fibre({.radius = more, .half_depth = 0});
        break;
    }
    for (std::size_t i = 0; i < read.force.size(); ++i)
      read.deflection[i] = read.stage[i] - read.force[i] / stated.load_train_stiffness;
    return analyse(read, stated).energy.friction_share;
  };
  for (const StatedQuantity quantity : stated_quantities) {
    CAPTURE(static_cast<int>(quantity));
    constexpr double first_order = 0.2, hardly = 2e-4;  // [1] of the share: readings come in or go out
    const double told = more * (*usual.work_share_sensitivities)[quantity];
    CHECK(std::abs(share_with(quantity) - usual.energy.friction_share - told) < first_order * std::abs(told) + hardly);
  }
}

TEST_CASE("interval: the share of the work has the error of all that is stated, and ends at 0 and 1") {
  const auto told = analyse(to_physical(simulated_record(toothed()), scales), description_of(toothed()));
  REQUIRE(told.work_share_sensitivities);
  const PerQuantity<double> deviations = prior_deviations(told.errors, told.rig_errors, told.rig.fibre.supports());
  double squares = 0;
  for (const StatedQuantity quantity : stated_quantities)
    squares += std::pow((*told.work_share_sensitivities)[quantity] * deviations[quantity], 2);
  const MeasuredEnergy& energy = told.energy;
  CHECK(energy.friction_share_error == doctest::Approx(std::sqrt(squares)));
  CHECK(energy.share().low ==
        doctest::Approx(energy.friction_share - 1.96 * energy.friction_share_error).epsilon(1e-4));
  CHECK(energy.least_share() > energy.share().low);
  MeasuredEnergy wide = energy;
  wide.friction_share_error = 1;
  CHECK(wide.share().low == 0);
  CHECK(wide.share().high == 1);
  CHECK(wide.least_share() == 0);
}

TEST_CASE("limit: friction that is only a limit, or cannot be, tells no share of the work") {
  const SimulatedTruth slippery{.friction = Friction::constant(0.01), .noise = 0.02};
  const auto limit = analyse(to_physical(simulated_record(slippery), scales), description_of(slippery));
  REQUIRE(limit.fit.mu0_is_bound);
  CHECK(std::isnan(limit.energy.friction_share));
  CHECK(!limit.work_share_sensitivities);
  const auto record = to_physical(simulated_record(toothed()), scales);
  const auto told = analyse(record, description_of(toothed()));
  CHECK(!is_friction_implausible(told));
  CHECK(told.energy.friction_share > 0.1);
  AnalysisOptions on_pins;
  on_pins.max_friction = 0.1;
  const auto turning = analyse(record, description_of(toothed()), on_pins);
  CHECK(is_friction_implausible(turning));
  CHECK(std::isnan(turning.energy.friction_share));
}

TEST_CASE("identity: the profile and the fit know the same errors, and the contact's moves the profile as they say") {
  auto description = description_of(toothed());
  description.contact_error = 0.577e-6;
  const auto analysis = analyse(to_physical(simulated_record(toothed()), scales), description);
  CHECK(analysis.errors.contact == scales.reduced_length(0.577e-6));
  const auto again = measure_friction(analysis.reduced, analysis.rig, analysis.errors);
  REQUIRE(again.points.size() == analysis.profile.points.size());
  for (std::size_t i = 0; i < again.points.size(); ++i)
    CHECK(again.points[i].from_contact == analysis.profile.points[i].from_contact);
  auto moved = analysis.reduced;
  for (double& w : moved.deflection) w += analysis.errors.contact;
  for (double& stage : moved.stage) stage += analysis.errors.contact;
  const auto shifted = measure_friction(moved, analysis.rig, analysis.errors);
  const auto& point = analysis.profile.points.back();
  CHECK(std::abs(shifted.points.back().mu - point.mu) == doctest::Approx(point.from_contact).epsilon(0.01));
}

TEST_CASE("limit: constant friction has no sawtooth, no drops and no snaps") {
  const SimulatedTruth truth{.friction = Friction::constant(0.5), .noise = 0.01};
  const auto analysis = analyse(to_physical(simulated_record(truth), scales), description_of(truth));
  CHECK(analysis.category == SawtoothCategory::none);
  CHECK(analysis.drops.drops.empty());
  CHECK(analysis.model.snaps.empty());
}

TEST_CASE("limit: the drops of a bar bent too little to tell friction are judged by their features") {
  const SimulatedTruth truth{.friction = Friction::constant(0.3),
                             .stiffness = 900,
                             .noise = 1e-4,
                             .step = 2e-4,
                             .deflection = 0.05,
                             .fibre = Fibre({.radius = 0, .half_depth = 0.04})};
  ReducedRecord reduced = simulated_record(truth);
  for (std::size_t i = reduced.force.size() / 2; i < reduced.force.size(); ++i) {
    reduced.force[i] *= 0.6;
    reduced.deflection[i] = reduced.stage[i] - reduced.force[i] / truth.stiffness;
  }
  auto description = description_of(truth);
  description.fibre = truth.fibre;
  const auto analysis = analyse(to_physical(reduced, scales), description);
  REQUIRE(analysis.status == AnalysisStatus::deflection_too_small);
  CHECK(analysis.drop_features.drops == 1);
  CHECK(analysis.drop_features.least_after_drop < -4);
  CHECK(analysis.drop_features.loss_needed == doctest::Approx(0.4).epsilon(0.1));
  for (const Slip& slip : analysis.slips) CHECK(std::isnan(slip.mu_before));
}

TEST_CASE("bad input: a record too short for its noise") {
  const Record record = first_points(to_physical(simulated_record(toothed()), scales), 20);
  CHECK(message_of([&] { analyse(record, description_of(toothed())); }) == "a record of 20 points tells no drops");
}

TEST_CASE("limit: a record more than twice as stiff as stated is explained by no friction, and says so") {
  auto record = to_physical(simulated_record(toothed()), scales);
  auto description = description_of(toothed());
  description.bending_stiffness = 0.4 * scales.bending_stiffness();
  const auto analysis = analyse(record, description);
  CHECK(analysis.status == AnalysisStatus::not_explained);
  CHECK(analysis.stiffness_implausible);
}

TEST_CASE(
    "limit: a force below that without friction is no sliding, and told by how much; within the error of the stiffness "
    "it "
    "is sliding") {
  const SimulatedTruth truth{.friction = Friction::constant(0.02), .noise = 0.01};
  const auto record = to_physical(simulated_record(truth), scales);
  const auto with = [&](double stiffening) {
    auto description = description_of(truth);
    description.bending_stiffness = stiffening * scales.bending_stiffness();
    return analyse(record, description);
  };
  const auto within = with(1.05), beyond = with(1.25);
  CHECK(within.status == AnalysisStatus::ok);
  CHECK(!within.model_implausible);
  CHECK(within.fit.mu0.value < 0.1);
  CHECK(within.frictionless_force_ratio.median ==
        doctest::Approx(1 / 1.05).epsilon(0.02));  // with that little friction
  CHECK((beyond.status == AnalysisStatus::not_explained || beyond.model_implausible));
  CHECK(beyond.frictionless_force_ratio.median == doctest::Approx(1 / 1.25).epsilon(0.02));
}

}  // namespace
}  // namespace flexslip
