#include "bending_test/motion.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <boost/math/tools/minima.hpp>
#include <doctest/doctest.h>

#include "fibre/elastica.h"
#include "numerics/elementary.h"
#include "tests/approximately.h"
#include "tests/bending_test/some_programme.h"
#include "tests/generators.h"
#include "tests/refusal.h"

namespace flexslip {
namespace {

// The oracle knows energies only, no forces and no curves. At each of many small steps of the stage the fibre may slide, a
// little at a time on a grid of lengths, as long as its elastic energy falls by more than friction takes; the elastic
// energy at a length is the minimum over all q, found by brute force.
class EnergyMinimiser {
 public:
  EnergyMinimiser(const Friction& friction, double k, double step) : friction_(friction), k_(k), step_(step) {}

  double length() const { return 1 + step_ * cell_; }
  bool lost_contact() const { return lost_contact_; }

  void move_to(double stage) {
    if (lost_contact_ && stage <= w_lost_) return;
    for (const int direction : {1, -1})
      while (cell_ + direction >= 1 && gain(direction, stage) > 0) cell_ += direction;
    // The energy is smallest without force: the nose lifts off, until it returns to where the fibre has stayed.
    lost_contact_ = cell_ > 0 && least_energy(length(), stage).F <= 1e-5;
    w_lost_ = stage;
    if (lost_contact_)
      for (double far = stage + 1, near = stage; far - near > 1e-12;) {
        const double middle = 0.5 * (far + near);
        (least_energy(length(), middle).F <= 1e-5 ? near : far) = middle;
        w_lost_ = near;
      }
  }

 private:
  // What a slide by one cell sets free beyond friction.
  double gain(int direction, double stage) const {
    if (cell_ == 0) return 1;  // the straight fibre resists with no force
    const double from = length();
    const double to = from + direction * step_;
    const Least here = least_energy(from, stage);
    const Least there = least_energy(to, stage);
    const double mu = 0.5 * (friction_.at(from).mu + friction_.at(to).mu);
    return here.energy - there.energy - mu * 0.5 * (here.Pn + there.Pn) * step_;
  }

  struct Least {
    double energy, Pn, F;
  };
  Least least_energy(double S, double stage) const {
    const auto energy = [&](double q) {
      const auto state = fibre_state(S, q);
      if (state.status != FibreStatus::ok) return infinity;
      const double pushed = std::max(stage - state.w, 0.0);  // the wedge cannot pull
      return state.U + 0.5 * k_ * pushed * pushed;
    };
    const auto [q, least] = boost::math::tools::brent_find_minima(energy, -3.0, 3.0, 30);
    const auto state = fibre_state(S, q);
    return {least, state.Pn, state.F};
  }

  const Friction& friction_;
  double k_;
  double step_;
  int cell_ = 0;
  double w_lost_ = 0;
  bool lost_contact_ = false;
};

// All stretches on the way to a stage position.
std::vector<Stretch> stretches_to(MovingFibre& fibre, double stage) {
  std::vector<Stretch> stretches;
  while (const auto stretch = fibre.advance_towards(stage)) stretches.push_back(*stretch);
  return stretches;
}

double stage_of(const FibreState& state, const Rig& rig) { return state.w + state.F / rig.stiffness; }

// The first length beyond S at which the kinetic curve asks for a stage position, on a fine grid and by bisection.
double first_length(const FrictionLaw& law, const Rig& rig, int direction, double S, double stage) {
  const auto missing = [&](double at) {  // what the stage lacks of holding the fibre there
    return direction * (stage_of(fibre_state(at, direction * law.kinetic.at(at).mu), rig) - stage);
  };
  const double step = 1e-5 * direction;
  double low = S;
  while (missing(low + step) < 0) low += step;
  double high = low + step;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (missing(middle) < 0 ? low : high) = middle;
  }
  return high;
}

// Smooth supports with static friction, and rough ones.
BendingTest some_stick_slip_test() {
  const double mu = *between(0.1, 0.6);
  const Friction kinetic = *whole(0, 1) ? Friction::constant(mu) : Friction::sinusoid(mu, *between(0, 0.3), 0.03, 1);
  const Friction excess =
      *whole(0, 1) ? Friction::constant(*between(0.03, 0.3)) : Friction::sinusoid(*between(0.05, 0.3), 0.8, 0.07, 2);
  return {{kinetic, excess}, {*between(20, 300)}};
}

}  // namespace

namespace {

struct Comparison {
  bool agrees;
  int steps, snaps;
  bool lost_contact;
};

// One programme with both, in steps; they agree to a cell, in which both slide, and meet the same end.
Comparison compare(const SomeProgramme& programme, double cell) {
  const auto& [test, turning_points, roughness] = programme;
  MovingFibre fibre(test, *std::max_element(turning_points.begin(), turning_points.end()));
  EnergyMinimiser oracle(test.friction.kinetic, test.rig.stiffness, cell);
  Comparison result{true, 0, 0, false};
  double from = 0;
  for (const double point : turning_points) {
    constexpr int n = 12;
    for (int j = 1; j <= n && fibre.end() == HistoryStatus::ok; ++j) {
      const double stage = j == n ? point : from + (point - from) * j / n;
      while (const auto stretch = fibre.advance_towards(stage)) result.snaps += stretch->to.motion == Motion::snap;
      oracle.move_to(stage);
      const bool is_apart = fibre.state().S > 1 && fibre.state().F == 0;
      if (is_apart) result.lost_contact = true;
      result.agrees =
          result.agrees && oracle.lost_contact() == is_apart && std::abs(fibre.state().S - oracle.length()) <= cell;
      ++result.steps;
    }
    from = point;
  }
  return result;
}

}  // namespace

TEST_CASE("motion: 1,000 random programmes (oracle: energies minimised by brute force in small steps)") {
  std::mt19937_64 random(20210829);
  int agree = 0, steps = 0, snaps = 0, ends = 0;
  for (int i = 0; i < 1000; ++i) {
    SomeProgramme programme = some_programme(random, 0.4, 0.02);
    programme.test.rig.stiffness = std::min(programme.test.rig.stiffness, 1e4);  // the oracle's energies need a spring
    // Where friction is nearly lost or the curve nearly folds, a coarse grid holds a fibre that a finer one does not.
    Comparison comparison{};
    for (const double cells : {60, 240, 960}) {
      comparison = compare(programme, programme.roughness / cells);
      if (comparison.agrees) break;
    }
    INFO("programme ", i);
    CHECK(comparison.agrees);
    agree += comparison.agrees;
    steps += comparison.steps;
    snaps += comparison.snaps;
    ends += comparison.lost_contact;
  }
  MESSAGE("agreed in ", agree, " programmes, ", steps, " steps, ", snaps, " snaps; ", ends,
          " times the contact was lost");
  CHECK(snaps > 100);  // there was something to agree on
  CHECK(ends > 10);
}

TEST_CASE("motion: a reversal sticks until q has run from one limit to the other (identity)") {
  CHECK(rc::check("random tests", [] {
    const Friction friction = Friction::sinusoid(*between(0.1, 0.8), *between(0, 0.3), *between(0.02, 0.1), 1);
    const Rig rig{*between(20, 500)};
    const double farthest = *between(0.1, 0.3);
    MovingFibre fibre({friction, rig}, farthest);
    stretches_to(fibre, farthest);
    const PathPoint turned = fibre.state();
    const auto back = stretches_to(fibre, 0.5 * farthest);
    RC_ASSERT(back.front().to.motion == Motion::stick);
    RC_ASSERT(back.front().from.q == friction.at(turned.S).mu && back.front().to.q == -friction.at(turned.S).mu);
    RC_ASSERT(back.front().to.S == turned.S);
    RC_ASSERT(back.front().to.stage == stage_of(fibre_state(turned.S, -friction.at(turned.S).mu), rig));
    RC_ASSERT(back.size() >= 2u && back[1].to.motion != Motion::stick && back[1].to.S < turned.S);
  }));
}

TEST_CASE("motion: what a programme leads to does not depend on its steps (identity)") {
  CHECK(rc::check("random programmes with static friction", [] {
    const BendingTest test = some_stick_slip_test();
    const std::vector<double> points{*between(0.15, 0.3), *between(0.05, 0.15), *between(0.1, 0.3)};
    MovingFibre whole_way(test, 0.3);
    MovingFibre in_steps(test, 0.3);
    double from = 0;
    for (const double point : points) {
      stretches_to(whole_way, point);
      const int n = *whole(1, 40);
      for (int j = 1; j <= n; ++j) stretches_to(in_steps, j == n ? point : from + (point - from) * j / n);
      from = point;
      // A tooth begins where the one before ended: the rounding of S grows from one to the next.
      RC_ASSERT(std::abs(whole_way.state().S - in_steps.state().S) <= 1e-9);
    }
  }));
}

TEST_CASE(
    "motion: static friction makes teeth, each from the static to the next kinetic state (oracle: bisection on a "
    "grid)") {
  int teeth = 0;
  CHECK(rc::check("random programmes", [&] {
    const BendingTest test = some_stick_slip_test();
    const auto& law = test.friction;
    MovingFibre fibre(test, 0.3);
    stretches_to(fibre, 0.1);  // before, the teeth are too many
    for (const double stage : {0.3, 0.15}) {
      const int direction = stage > fibre.state().stage ? 1 : -1;
      for (const auto& [from, to, work] : stretches_to(fibre, stage)) {
        if (to.motion == Motion::stick) continue;
        if (std::abs(to.S - from.S) <= 2 * min_slip) continue;  // runs on into the next
        RC_ASSERT(to.motion == Motion::snap);
        RC_ASSERT(from.q == direction * static_friction(law, from.S));
        RC_ASSERT(to.q == direction * law.kinetic.at(to.S).mu);
        RC_ASSERT(from.stage == to.stage);
        const double oracle = first_length(law, test.rig, direction, from.S, from.stage);
        RC_ASSERT(std::abs(to.S - oracle) <= 1e-9);  // both to the rounding of G, which is flat near a fold
        RC_ASSERT(work.released > 0 && work.friction >= 0);
        ++teeth;
      }
    }
  }));
  CHECK(teeth > 500);
}

TEST_CASE("motion: without an excess static friction is Coulomb's (limit)") {
  const Friction friction = Friction::sinusoid(0.5, 0.2, 0.03, 1);
  MovingFibre one({friction, {50}}, 0.3), two({{friction, Friction::constant(0)}, {50}}, 0.3),
      three({{friction, Friction::constant(1e-7)}, {50}}, 0.3);
  for (const double stage : {0.1, 0.3, 0.05, 0.2}) {
    stretches_to(one, stage);
    stretches_to(two, stage);
    stretches_to(three, stage);
    CHECK(one.state().S == two.state().S);
    CHECK(std::abs(one.state().S - three.state().S) <= 2 * min_slip);  // that far it may stand behind
  }
}

TEST_CASE(
    "motion: without kinetic friction nothing ends an overshoot, and it rests at the nearest stable state (limit)") {
  const FrictionLaw law{Friction::constant(0), Friction::constant(0.05)};
  const BendingTest nearest{law, {5}}, overshooting{law, {5}, SnapRest::overshoot};
  MovingFibre one(nearest, 0.4), other(overshooting, 0.4);
  for (const double stage : {0.3, 0.01}) {
    stretches_to(one, stage);
    stretches_to(other, stage);
    CHECK(one.state().S == other.state().S);
    CHECK(one.state().F == other.state().F);
  }
}

TEST_CASE("motion: where static friction is no higher the fibre glides on, until the stage halts (identity)") {
  // The excess vanishes over some lengths; once sliding, the fibre does not notice that it returns.
  const FrictionLaw law{Friction::constant(0.3), Friction::table({{1.0, 1.1, 1.12, 1.4}, {0, 0, 0.2, 0.2}})};
  MovingFibre gliding({law, {100}}, 0.4), halting({law, {100}}, 0.4);
  stretches_to(gliding, 0.38);
  stretches_to(halting, 0.38);
  CHECK(gliding.state().S > 1.12);
  CHECK(gliding.state().q == 0.3);
  halting.halt();
  const double S = halting.state().S;
  CHECK(stretches_to(gliding, 0.381).back().to.motion == Motion::slip_in);
  CHECK(stretches_to(halting, 0.381).back().to.motion == Motion::stick);
  CHECK(halting.state().S == S);
}

TEST_CASE("motion: an overshoot spends all it sets free on friction and rests within static friction (identity)") {
  int snaps = 0;
  CHECK(rc::check("random tests", [&] {
    BendingTest nearest{Friction::sinusoid(*between(0.4, 0.9), *between(0.3, 0.6), *between(0.02, 0.06), 1),
                        {*between(10, 40)}};
    BendingTest carried = nearest;
    carried.rest = SnapRest::overshoot;
    MovingFibre one(nearest, 0.7), two(carried, 0.7);
    while (const auto stretch = one.advance_towards(0.7)) {
      if (stretch->to.motion != Motion::snap) continue;
      // The same snap, the first of both, with the other rule.
      std::optional<Stretch> other;
      do other = two.advance_towards(0.7);
      while (other && other->to.motion != Motion::snap);
      if (!other) return;  // carried out of contact
      const auto elastic = [&](const PathPoint& point) {
        return fibre_state(point.S, point.q).U + 0.5 * point.F * point.F / nearest.rig.stiffness;
      };
      RC_ASSERT(other->from.S == stretch->from.S);
      RC_ASSERT(other->jump.released == 0);
      const double lost = elastic(other->from) - elastic(other->to);
      RC_ASSERT(std::abs(other->jump.friction - lost) <=
                1e-10 * elastic(other->from));  // the quadrature's, over some swings
      RC_ASSERT(std::abs(other->to.q) <= nearest.friction.kinetic.at(other->to.S).mu);
      RC_ASSERT(stage_of(fibre_state(other->to.S, other->to.q), nearest.rig) == to(1e-14, other->to.stage));
      RC_ASSERT(other->to.S >= stretch->to.S || other->to.q > 0);  // beyond the stable state, unless it swung back
      ++snaps;
      return;
    }
  }));
  CHECK(snaps > 30);
}

TEST_CASE(
    "motion: a fibre that friction holds without a force stays where it is, and the nose finds it there (oracle: the "
    "end of the branch)") {
  MovingFibre fibre({Friction::constant(1.2), {100}}, 0.5);
  stretches_to(fibre, 0.5);
  const PathPoint loaded = fibre.state();
  const auto out = stretches_to(fibre, 0.1);
  REQUIRE(out.size() == 2);
  const PathPoint left = out[0].to;
  CHECK(left.motion == Motion::stick);
  CHECK(left.S == loaded.S);
  CHECK(left.F == 0);
  CHECK(left.stage == left.w);
  CHECK(fibre_branch_end(left.q).S == to(1e-13, loaded.S));
  CHECK(fibre_branch_end(left.q).w == to(1e-12, left.w));
  CHECK(out[1].to.motion == Motion::apart);
  CHECK(out[1].to.stage == 0.1);
  CHECK(out[1].to.w == left.w);
  CHECK(fibre.work_of(out[1]).stage == 0);
  for (const Stretch& part : fibre.parts_of(out[1], 5)) CHECK(part.to.w == left.w);
  stretches_to(fibre, 0.3);
  CHECK(fibre.state().stage == 0.3);
  CHECK(fibre.state().F == 0);
  const auto in = stretches_to(fibre, 0.5);
  REQUIRE(in.size() == 2);
  CHECK(in[0].to.stage == left.w);
  CHECK(in[1].to.motion == Motion::stick);
  CHECK(fibre.state().F == to(1e-13, loaded.F));
  CHECK(fibre.state().q == to(1e-12, loaded.q));
  CHECK(fibre.end() == HistoryStatus::ok);
}

TEST_CASE("motion: a fibre that slides in by a hundred spans slips through, as no specimen is as long (limit)") {
  MovingFibre fibre({Friction::constant(1), {90}}, 60);
  stretches_to(fibre, 60);
  CHECK(fibre.end() == HistoryStatus::slipped_through);
  CHECK(fibre.state().S == longest_sliding);
  CHECK(fibre.state().stage < 60);
}

TEST_CASE("motion: a stage position that the fibre was not made for is refused (contract)") {
  MovingFibre fibre({Friction::constant(0.3), {30}}, 0.2);
  CHECK(message_of([&] { fibre.advance_towards(0.3); }).find("0.3") != std::string::npos);
  CHECK(message_of([&] { fibre.advance_towards(-0.1); }).find("-0.1") != std::string::npos);
  CHECK(message_of([] { MovingFibre({Friction::constant(0.3), {1e-9}}, 0.2); }).find("too soft") != std::string::npos);
  CHECK(message_of([] { MovingFibre({Friction::constant(0.3), {0}}, 0.2); }).find("stiffness") != std::string::npos);
}

}  // namespace flexslip
