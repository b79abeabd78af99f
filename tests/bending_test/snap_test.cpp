#include "bending_test/snap.h"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "bending_test/motion.h"
#include "bending_test/trace.h"
#include "numerics/elementary.h"
#include "tests/approximately.h"
#include "tests/generators.h"

namespace flexslip {
namespace {

double elastic_energy(const FibreState& state, const Rig& rig) {
  return state.U + 0.5 * state.F * state.F / rig.stiffness;
}

// The energy left beyond friction, summed in small steps from one length on; where it first comes back to zero.
double fine_step_end(const Friction& friction, const Rig& rig, double stage, double S, double S_landing) {
  const double direction = S_landing > S ? 1 : -1;
  const double step = 2e-4 * std::abs(S_landing - S);
  double left = 0;
  double q = direction * friction.at(S).mu;
  while (true) {
    const double middle = S + 0.5 * direction * step;
    const HeldState held = held_at(middle, stage, rig, q);
    if (held.holding != Holding::held) return std::numeric_limits<double>::quiet_NaN();
    q = held.state.q;
    left += (direction * q - friction.at(middle).mu) * held.state.Pn * step;
    S += direction * step;
    if (left <= 0 && direction * (S - S_landing) > 0) return S;
  }
}

}  // namespace

TEST_CASE("snap: the state held at a length has the stage position (identity)") {
  CHECK(rc::check("random lengths", [] {
    const Rig rig{*whole(0, 4) ? *between(5, 500) : infinity};
    const double S = 1 + *between(1e-4, 0.4);
    const auto free = fibre_state(S, 0.0);
    const double stage = (free.w + free.F / rig.stiffness) * *between(0.7, 1.2);
    const HeldState held = held_at(S, stage, rig, *between(-1, 1));
    const double stands = held.state.w + held.state.F / rig.stiffness;
    if (held.holding == Holding::beyond_friction) {
      RC_ASSERT(held.state.q >= 19.999999 && stands < stage);
      return;
    }
    if (held.holding == Holding::held)
      RC_ASSERT(std::abs(stands - stage) <= 8 * 0x1p-52 * stage);
    else
      RC_ASSERT(stands > stage && (held.state.F <= 1e-9 || held.state.q <= -19.999999));
  }));
}

TEST_CASE("snap: friction and what is set free are what the elastic energy falls by (identity)") {
  CHECK(rc::check("random lengths and roughness", [] {
    const Friction friction = Friction::sinusoid(*between(0.1, 0.8), *between(0, 0.5), *between(0.005, 0.1), 1);
    const Rig rig{*between(10, 500)};
    const double from = 1 + *between(0.01, 0.2), to = from + *between(0.001, 0.05);
    const double mu = friction.at(from).mu;
    const auto before = fibre_state(from, mu);
    const double stage = before.w + before.F / rig.stiffness;
    const HeldState after = held_at(to, stage, rig, mu);
    const auto work = snap_work(friction, rig, stage, from, to);
    if (after.holding != Holding::held) {
      RC_ASSERT(!work);
      return;
    }
    const double fall = elastic_energy(before, rig) - elastic_energy(after.state, rig);
    RC_ASSERT(std::abs(work->friction + work->released - fall) <= 1e-11 * elastic_energy(before, rig));
  }));
}

TEST_CASE("snap: an overshoot ends where its energy is spent, with static friction too (oracle: small steps)") {
  int ends = 0;
  for (const double stiffness : {30.0, 200.0, 1e4})
    for (const double excess : {0.05, 0.1, 0.3})
      for (const double amplitude : {0.0, 0.2}) {
        const Friction kinetic = Friction::sinusoid(0.3, amplitude, 0.02, 1);
        const BendingTest test{{kinetic, Friction::constant(excess)}, {stiffness}, SnapRest::overshoot};
        MovingFibre fibre(test, 0.2);
        int snaps = 0;
        while (const auto stretch = fibre.advance_towards(0.2)) {
          if (stretch->to.motion != Motion::snap || ++snaps > 20) continue;
          const auto landing =
              landing_after(trace_loading_curve(kinetic, test.rig, 1.2), stretch->from.S, stretch->from.stage);
          REQUIRE(landing);
          const auto end = overshoot_of(kinetic, test.rig, stretch->from.stage, stretch->from.S, landing->S);
          REQUIRE(end.end == Holding::held);
          const double fine = fine_step_end(kinetic, test.rig, stretch->from.stage, stretch->from.S, landing->S);
          CHECK(std::abs(end.S - fine) <= 1e-3 * (landing->S - stretch->from.S));  // a few of its steps
          ++ends;
        }
        CHECK(fibre.end() == HistoryStatus::ok);
        CHECK(snaps > 3);
      }
  CHECK(ends > 100);
}

TEST_CASE("snap: without friction an overshoot that never ends rests at the nearest stable state (limit)") {
  for (const double mu : {0.0, 1e-5}) {
    const FrictionLaw law{Friction::constant(mu), Friction::constant(0.2)};
    MovingFibre carried({law, {100}, SnapRest::overshoot}, 0.1);
    int stretches = 0;
    while (carried.advance_towards(0.05) && stretches < 100000) ++stretches;
    CHECK(stretches < 100000);
    CHECK((carried.end() != HistoryStatus::ok || carried.state().stage == 0.05));
  }
}

}  // namespace flexslip
