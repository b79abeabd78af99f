#include "inference/passes.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include <Eigen/Core>
#include <doctest/doctest.h>

#include "bending_test/history.h"
#include "inference/loading_forces.h"
#include "inference/pass_rows.h"
#include "inference/pass_unknowns.h"
#include "inference/prior_draws.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

using Eigen::VectorXd;

VectorXd three(double a, double b, double c) { return Eigen::Vector3d(a, b, c); }

// [EI/L^2] At deflections on one friction.
VectorXd forces(const VectorXd& w, double q) {
  const VectorXd guess = 48 * w;
  return forces_modelled(w, VectorXd::Constant(w.size(), q), states_read(w, guess, Fibre()), Fibre()).F;
}

void check_near(const VectorXd& found, const VectorXd& expected, double tolerance) {
  for (Eigen::Index i = 0; i < found.size(); ++i)
    CHECK(std::abs(found[i] - expected[i]) < tolerance * std::abs(expected[i]));
}

struct Programme {
  double friction = 0.5, wear = 1, k = 60, bottom = 0.1;
  double noise = 0.002;  // [maximum force]
  std::vector<Crack> cracks{};
  std::vector<double> toes{0, 0, 0};  // [L] by which a pass gives way under the first forces
};

// Loaded, unloaded and loaded again, with noise that alternates and drifts.
PassesProblem simulated(const Programme& programme) {
  std::vector<double> stages;
  const auto go = [&](double from, double to) {
    constexpr int rows = 160;
    for (int i = 1; i <= rows; ++i) stages.push_back(from + (to - from) * i / rows);
  };
  go(0, 0.38);
  go(0.38, programme.bottom);
  go(programme.bottom, 0.38);
  const Rig rig{programme.k, Fibre()};
  const History history =
      follow_in_steps({.friction = Friction::constant(programme.friction), .rig = rig, .wear = programme.wear}, stages,
                      programme.cracks);
  PassesProblem problem{.record = {}, .rig = rig, .errors = {0, 0.03, 0.0005}, .first = 0, .last = 160, .drops = {}};
  double greatest = 0;
  for (const PathPoint& point : history.path) greatest = std::max(greatest, point.F);
  NormalSource normal(7);
  for (const PathPoint& point : history.path) {
    const double F = point.F + programme.noise * greatest * normal();
    const double toe = programme.toes[problem.record.stage.size() / 160];
    const double stage = point.stage + toe * (1 - elementary::exp(-point.F / (0.05 * greatest)));
    problem.record.stage.push_back(stage);
    problem.record.force.push_back(F);
    problem.record.deflection.push_back(stage - F / programme.k);
  }
  const ReducedRecord& all = problem.record;
  const auto loading = [&](const std::vector<double>& column) {
    return std::vector(column.begin(), column.begin() + 160);
  };
  problem.drops = find_drops({loading(all.stage), loading(all.deflection), loading(all.force)}).drops;
  return problem;
}

bool holds(const Estimate& estimate, double truth) {
  return std::abs(estimate.value - truth) < 2.5 * estimate.standard_error;
}

}  // namespace

TEST_CASE("table: forces of both branches of a worn, cracked and settled specimen") {
  const VectorXd w = three(.10, .15, .20);
  constexpr double digits = 2e-8;
  check_near(.94 * forces(w, .5), three(4.56548416, 6.40283782, 7.66865298), digits);
  check_near(.94 * forces(w, -.5), three(3.55783112, 4.32294469, 4.37065472), digits);
  check_near(forces(w, .5), three(4.85689804, 6.81152960, 8.15814147), digits);
  check_near(.94 * forces(w, -.475), three(3.58463570, 4.38003373, 4.46406123), digits);
  check_near(.94 * forces(w, .30), three(4.37374005, 6.01654137, 7.07042408), digits);
  const VectorXd less = w.array() - .01;
  check_near(forces(less, .5), three(4.40644855, 6.46566249, 7.94095781), digits);
  check_near(forces(less, -.475), three(3.54964438, 4.55355978, 4.78611587), digits);
  check_near(forces(less, .30), three(4.23815740, 6.09881304, 7.34936613), digits);
}

TEST_CASE("identity: friction read in and out at the right stiffness is equal and opposite, at another it is not") {
  const VectorXd w = three(.10, .15, .20), in = .94 * forces(w, .5), out = .94 * forces(w, -.5);
  const auto sum = [&](double e) -> VectorXd {
    return states_read(w, in / e, Fibre()).q + states_read(w, out / e, Fibre()).q;
  };
  CHECK(sum(.94).cwiseAbs().maxCoeff() < 1e-6);
  CHECK(sum(.93).minCoeff() > 0.01);
}

TEST_CASE("table: what each error of the rig does to the force of the model") {
  const PassesProblem problem = simulated({});
  const std::vector<Leg> legs = find_legs(problem.record.stage);
  struct Column {
    double q, F, stage, F_q, span, train, gain, contact, bow, zero;
  };
  for (const Column& expected :
       {Column{.5, 8.15814147, .33596902, 3.114796, -20.39938, 2.77588, 10.93402, 20.4155, -27.5845, -1.34026},
        Column{-.5, 4.64963269, .27749388, 3.989467, -8.14418, -.44756, 4.20207, -5.77541, -53.77541, -.90374}}) {
    PassRows rows;
    const VectorXd w = VectorXd::Constant(1, .2), F = forces(w, expected.q);
    ReducedRecord one{{w[0] + F[0] / 60}, {w[0]}, {F[0]}};
    rows.add(one, {{0, 1, expected.q > 0 ? Direction::loading : Direction::unloading}}, 0, {0});
    const PassStates read = states_read(w, F, Fibre());
    const PassUnknowns unknowns(problem, legs, {}, rows, read);
    CHECK(std::abs(F[0] - expected.F) < 1e-8);
    CHECK(std::abs(one.stage[0] - expected.stage) < 1e-8);
    CHECK(std::abs(read.F_q[0] - expected.F_q) < 1e-5);
    // Errors are those of what is stated here, and of what is read there.
    const auto column = [&](StatedQuantity quantity) {
      const auto j = unknowns.of(quantity);
      return (unknowns.G(0, j) - read.F_w[0] * unknowns.W(0, j)) / unknowns.deviations[quantity];
    };
    constexpr double digits = 2e-5;
    CHECK(std::abs(-column(StatedQuantity::span) - expected.span) < digits);
    CHECK(std::abs(-column(StatedQuantity::load_train) - expected.train) < digits);
    CHECK(std::abs(column(StatedQuantity::force_gain) - expected.gain) < digits);
    CHECK(std::abs(column(StatedQuantity::contact) - expected.contact) < 1e-4);
    CHECK(std::abs(-column(StatedQuantity::preload) - expected.bow) < 1e-4);
  }
}

TEST_CASE("oracle: friction, stiffness and loss of a simulated test, whether it cracks, wears or neither") {
  for (const Programme& programme :
       {Programme{}, Programme{.wear = 0.88}, Programme{.wear = 0.88, .cracks = {{0.15, 0.06}}},
        Programme{.friction = 0.3, .cracks = {{0.15, 0.12}}}}) {
    CAPTURE(programme.wear);
    const PassesFit fit = fit_passes(simulated(programme));
    REQUIRE(fit.status == PassesStatus::ok);
    CHECK(fit.is_reloaded);
    CHECK(holds(fit.mean_friction, programme.friction));
    CHECK(fit.mean_friction.standard_error < 0.06);
    CHECK(holds(fit.log_stiffness, 0));
    double left = 1;
    for (const Crack& crack : programme.cracks) left *= 1 - crack.loss;
    CHECK(holds(fit.loss, 1 - left));
    CHECK(fit.loss.standard_error < 0.03);
    REQUIRE(fit.passes.size() == 3);
    CHECK(holds(fit.passes[1].friction, programme.friction * programme.wear));
    CHECK(holds(fit.passes[2].friction, programme.friction * programme.wear * programme.wear));
  }
}

TEST_CASE(
    "limit: of a sound specimen that beds down, in each pass by another length, no stiffness is told to be lost or "
    "gained") {
  for (const double toe : {0.0, 0.005, 0.01}) {
    CAPTURE(toe);
    const PassesFit fit = fit_passes(simulated({.noise = 0.0005, .toes = {toe, 2 * toe, toe}}));
    REQUIRE(fit.status == PassesStatus::ok);
    CHECK(holds(fit.loss, 0));
    CHECK(holds(fit.mean_friction, 0.5));
    CHECK(holds(fit.log_stiffness, 0));
  }
}

TEST_CASE("limit: a specimen that is hardly unloaded only sticks, and its passes are not compared") {
  const PassesFit fit = fit_passes(simulated({.friction = 0.8, .k = 20, .bottom = 0.36}));
  CHECK(fit.status == PassesStatus::not_sliding_out);
  const Fibre fibre;
  CHECK(sliding_out_force(fibre, 1.1, 0.5) < sliding_out_force(fibre, 1.1, 0.2));
}

TEST_CASE("oracle: the loss by the forces of two loadings, whether the specimen cracks, wears or neither") {
  for (const Programme& programme :
       {Programme{}, Programme{.wear = 0.8}, Programme{.cracks = {{0.12, 0.1}}},
        Programme{.wear = 0.9, .cracks = {{0.1, 0.1}, {0.2, 0.15}}}, Programme{.k = 2000, .cracks = {{0.15, 0.25}}}}) {
    CAPTURE(programme.wear);
    CAPTURE(programme.cracks.size());
    const PassesProblem problem = simulated(programme);
    const std::vector<char> left_out(problem.record.force.size(), 0);
    const auto forces = compare_loading_forces(problem, find_legs(problem.record.stage), left_out);
    REQUIRE(forces);
    CHECK(forces->is_followed);
    double left = 1;
    for (const Crack& crack : programme.cracks) left *= 1 - crack.loss;
    CHECK(holds(forces->loss, 1 - left));
    CHECK(forces->loss.standard_error < 0.15);
    CHECK((forces->loss_needed > 0) == !programme.cracks.empty());
  }
  PassesProblem once = simulated({});
  const std::vector<Leg> legs = find_legs(once.record.stage);
  const std::vector<char> left_out(once.record.force.size(), 0);
  CHECK_FALSE(compare_loading_forces(once, {legs[0], legs[1]}, left_out));
}

TEST_CASE("identity: a drop comes again in a later loading that has not yet gone farther") {
  PassesProblem problem = simulated({});
  const auto at = [](std::size_t row) { return Drop{row, row + 1, 0.1, 0, 9}; };
  problem.drops = {at(100), at(400), at(479)};
  problem.record.deflection[479] += 0.01;
  CHECK(fit_passes(problem).drops_again == 1);
}

TEST_CASE("contract: a record of one pass, and a rig without stiffness, are refused") {
  PassesProblem problem = simulated({});
  problem.record.stage.resize(160);
  problem.record.deflection.resize(160);
  problem.record.force.resize(160);
  CHECK_THROWS_AS(fit_passes(problem), std::invalid_argument);
  problem = simulated({});
  problem.rig.stiffness = 0;
  CHECK_THROWS_AS(fit_passes(problem), std::invalid_argument);
}

TEST_CASE("limit: a crack too small for the force to fall is a break of the course, and noise is none") {
  const PassesProblem sound = simulated({});
  CHECK(with_breaks({}, sound.record, find_legs(sound.record.stage)).empty());
  const PassesProblem cracked = simulated({.noise = 0.0005, .cracks = {{0.2, 0.01}}});
  const auto breaks = with_breaks({}, cracked.record, find_legs(cracked.record.stage));
  REQUIRE(breaks.size() == 1);
  CHECK(cracked.record.deflection[breaks[0].before] == doctest::Approx(0.2).epsilon(0.02));
  CHECK(breaks[0].after == breaks[0].before + 1);
  CHECK(with_breaks(breaks, cracked.record, find_legs(cracked.record.stage)).size() == 1);  // known already
}

TEST_CASE("limit: a specimen of little friction that lost a third of its stiffness still slides out") {
  const PassesFit fit = fit_passes(simulated({.friction = 0.2, .k = 20, .cracks = {{0.1, 0.3}}}));
  REQUIRE(fit.status == PassesStatus::ok);
  CHECK(fit.loss.low < 0.3);
  CHECK(fit.loss.high > 0.3);
  CHECK(fit.mean_friction.low < 0.2);
  CHECK(fit.mean_friction.high > 0.2);
}

}  // namespace flexslip
