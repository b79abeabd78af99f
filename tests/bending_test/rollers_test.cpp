// A test on rollers, or of a specimen with a thickness: the first part of its way (shallow.h), folds, energies.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "bending_test/history.h"
#include "bending_test/rig.h"
#include "bending_test/shallow.h"
#include "bending_test/trace.h"
#include "contact/over_rollers.h"
#include "tests/approximately.h"
#include "tests/generators.h"
#include "tests/refusal.h"

namespace flexslip {
namespace {

const Friction waves = Friction::sinusoid(.6, .4, .02 * std::numbers::pi, 0);

struct SomeTest {
  BendingTest test;
  std::vector<double> programme;
};
SomeTest some_test() {
  static const std::vector<Fibre> fibres{Fibre({0, .0157}), Fibre({.004, .02}), Fibre({.03, .008}), Fibre({.06, .03})};
  const double mu0 = *between(0.05, 0.7), wavelength = *between(0.02, 0.2);
  const Friction friction = *rc::gen::arbitrary<bool>()
                                ? Friction::sinusoid(mu0, *between(0, 0.5), wavelength, *between(0, 6))
                                : Friction::rough(mu0, *between(0, 0.3), 0.5 * wavelength, 7, 2);
  SomeTest some{{friction, {std::pow(10, *between(1, 3)), fibres[*rc::gen::inRange<std::size_t>(0, fibres.size())]}},
                {}};
  const double most = 0.4 * (1 + 30 / some.test.rig.stiffness);
  some.programme.push_back(*between(0.2, 1) * most);
  for (int i = 0; i < 4; ++i) some.programme.push_back(*between(0, 1) * (*whole(0, 3) == 0 ? 0.1 : 1) * most);
  some.programme.push_back(0);
  return some;
}

// The force at a stage position, by small steps of it: the state moves at constant sliding length while friction holds, otherwise along
// q = ±μ(S), to the nearest deflection that fits.
class Stepped {
 public:
  Stepped(const Friction& friction, const Supports& supports, double k)
      : friction_(friction), supports_(supports), k_(k) {
    mu_ = friction.at(1).mu;
    q_ = -mu_;
  }

  double force_at(double stage) {
    while (stage_ != stage) {
      const double step = std::clamp(stage - stage_, -1e-3, 1e-3);
      stage_ += step;
      if (std::abs(stage - stage_) < 1e-12) stage_ = stage;
      move(step > 0 ? 1 : -1);
    }
    return at(w_, q_).F;
  }

 private:
  SupportedState at(double w, double q) const { return state_on_supports(w, q, supports_); }
  double mu_of(const SupportedState& state) const { return friction_.at(state.length).mu; }

  // The deflection nearest in the direction at which a stage position is reached with q(w).
  template <class Law>
  double reach(double direction, const Law& q_of) const {
    double near = w_, far = w_;
    const auto passed = [&](double w) {
      const auto state = at(w, q_of(w));
      return direction * (state.w + state.F / k_ - stage_) >= 0;
    };
    for (int i = 0; i < 100000 && !passed(far); ++i) {
      near = far;
      far = std::max(far + direction * 2e-4, 1e-9);
    }
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (near + far);
      (passed(middle) ? far : near) = middle;
    }
    return far;
  }

  void move(double direction) {
    if (w_ == 0) {
      w_ = 1e-6;
      slid_ = at(w_, q_).slid;
    }
    // At rest: the friction that keeps what has slid.
    const auto held = [&](double w) {
      double low = -1.9, high = 1.9;
      const double sign = at(w, 0.1).slid > at(w, -0.1).slid ? 1 : -1;
      for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (low + high);
        (sign * (at(w, middle).slid - slid_) < 0 ? low : high) = middle;
      }
      return 0.5 * (low + high);
    };
    const double w = reach(direction, held), q = held(w);
    if (std::abs(q) <= mu_of(at(w, q))) {
      w_ = w, q_ = q;
      return;
    }
    const double sign = q > 0 ? 1 : -1;
    const auto sliding = [&](double x) {
      double mu = mu_of(at(x, sign * 0.5));
      for (int i = 0; i < 40; ++i) {
        const double before = mu;
        mu = mu_of(at(x, sign * mu));
        if (mu == before) break;
      }
      return sign * mu;
    };
    w_ = reach(direction, sliding);
    q_ = sliding(w_);
    slid_ = at(w_, q_).slid;
  }

  const Friction& friction_;
  Supports supports_;
  double k_, mu_, q_;
  double stage_ = 0, w_ = 0, slid_ = 0;
};

}  // namespace

TEST_CASE("rollers: folds on rollers, with a thickness, and both, to 9 digits (40-digit values)") {
  struct Case {
    Supports supports;
    std::array<std::array<double, 3>, 3> folds;  // Σ, S, stage position
  };
  for (const Case& check :
       {Case{{.0157, 0},
             {{{1.16869, 1.14530, .630623385}, {1.21375, 1.18763, .600307696}, {1.29098, 1.26148, .731356158}}}},
        Case{{.109375, 0},
             {{{1.20099, 1.02029, .787519312}, {1.27208, 1.06455, .731736009}, {1.36543, 1.13321, .900587405}}}},
        Case{{0, .0157},
             {{{1.14710, 1.14710, .618766517}, {1.18697, 1.18697, .595294138}, {1.26212, 1.26212, .718772314}}}},
        Case{{.005, .0157},
             {{{1.15372, 1.14602, .632314505}, {1.19607, 1.18756, .605135232}, {1.27140, 1.26177, .729247304}}}},
        Case{{.078125, .03125},
             {{{1.15608, 1.02234, .759216735}, {1.21382, 1.06394, .718992730}, {1.30367, 1.13390, .867063803}}}}}) {
    const Rig rig{30, Fibre(check.supports)};
    const SlidingCurve curve = trace_loading_curve(waves, rig, 1.4);
    CAPTURE(check.supports.radius);
    REQUIRE(curve.folds.size() >= 3);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& [point, is_maximum] = curve.folds[i];
      CHECK(is_maximum == (i % 2 == 0));
      CHECK(std::abs(point.S - check.folds[i][0]) < 6e-6);
      CHECK(std::abs(rig.fibre.length_between_contacts(rig.fibre.state(point.S, point.q)) - check.folds[i][1]) < 6e-6);
      CHECK(std::abs(point.stage - check.folds[i][2]) < 6e-10);
    }
  }
}

TEST_CASE("rollers: a thick specimen slides out, sticks and slides in (published values of the derivation)") {
  const BendingTest test{Friction::constant(.6), {100, Fibre({0, .0157})}};
  MovingFibre fibre(test, .3);
  const auto out = fibre.advance_towards(.3), rest = fibre.advance_towards(.3), in = fibre.advance_towards(.3);
  REQUIRE(in);
  CHECK(out->to.motion == Motion::slip_out);
  CHECK(std::abs(out->to.w - .019502) < 6e-7);
  CHECK(std::abs(out->to.F - .936487) < 6e-7);
  CHECK(rest->to.motion == Motion::stick);
  CHECK(std::abs(rest->to.w - .0231) < 6e-5);
  CHECK(std::abs(rest->to.F - 1.113519) < 6e-7);
  CHECK(in->to.motion == Motion::slip_in);
  CHECK(in->to.S == 1);
}

TEST_CASE("rollers, oracle: forces through a programme equal those of small steps") {
  const std::vector<double> stages{.03, .07, .2, .24, .2, .1, .06, .03, .01, .05, .15, .04};
  // The other is a bar of ISO 178 whose friction changes faster along it than its surface slides: sticking and sliding take turns.
  for (const auto& [supports, friction] : {std::pair{Supports{.004, .02}, Friction::sinusoid(.4, .2, .1, 1)},
                                           {Supports{.078, .031}, Friction::sinusoid(.3, .3, .01, 1)}}) {
    const History history = follow_in_steps({friction, {60, Fibre(supports)}}, stages);
    REQUIRE(history.status == HistoryStatus::ok);
    Stepped stepped(friction, supports, 60);
    for (std::size_t i = 0; i < stages.size(); ++i) {
      CAPTURE(stages[i]);
      CHECK(std::abs(history.path[i].F - stepped.force_at(stages[i])) < 2e-3);
    }
  }
}

TEST_CASE("rollers, oracle: before the surface slides in, the steepest friction followed agrees with a dense sample") {
  for (const Supports& supports : {Supports{0, .002}, {0, .0136}, {0, .05}, {.02, .031}, {.078, .031}}) {
    const Fibre fibre(supports);
    constexpr double most = .9;
    std::vector<double> w, q;
    for (int i = 1; i <= 60; ++i)
      for (int j = -6; j <= 6; ++j) {
        w.push_back(3 * supports.half_depth * i / 60);
        q.push_back(most * j / 6);
      }
    double moved = 0;
    for (const double each : fibre.length_friction_derivatives(w, q)) moved = std::max(moved, std::abs(each));
    const double steepest = steepest_followed(fibre, most, 1.1);
    CHECK(steepest <= (1 + 1e-12) / moved);  // possibly less on rollers, whose contacts move as it slides in
    if (supports.radius == 0) CHECK(steepest == to(1e-12, 1 / moved));
  }
}

TEST_CASE("rollers, definition: no friction is exceeded where it changes as fast as it may") {
  const Fibre fibre({.078, .031});
  const double steepest = steepest_followed(fibre, .4, 1.1);
  const Friction friction = Friction::sinusoid(.3, .3, .3 * .3 * std::numbers::pi / (.9 * steepest), 1);
  CHECK(friction.steepest() == to(1e-9, .9 * steepest));
  std::vector<double> stages;
  for (int i = 1; i <= 400; ++i) stages.push_back(std::abs(.1 * std::sin(.01 * i) + .02 * std::sin(.1 * i)));
  const History history = follow_in_steps({friction, {60, fibre}}, stages);
  REQUIRE(history.status == HistoryStatus::ok);
  REQUIRE(history.path.size() == stages.size());
  for (const PathPoint& point : history.path)
    CHECK(std::abs(point.q) <
          friction.at(fibre.length_between_contacts(fibre.at_deflection(point.w, point.q).state)).mu + 1e-9);
}

TEST_CASE("rollers, identity: the energy account closes through any programme, cracks among it") {
  CHECK(rc::check([] {
    const auto [test, programme] = some_test();
    std::vector<Crack> cracks;
    if (*whole(0, 3) == 0) cracks.push_back({*between(0.02, 0.3), *between(0.05, 0.4)});
    const History history = follow_continuously(test, programme, 4, cracks);
    double most = 1e-3;
    for (const EnergyAccount& energy : history.energy_at) most = std::max(most, energy.stage_work);
    for (const EnergyAccount& energy : history.energy_at) RC_ASSERT(std::abs(energy.imbalance) <= 1e-10 * most);
    RC_ASSERT(history.energy.friction >= -1e-10);
    if (history.status == HistoryStatus::ok && history.path.back().stage == 0) RC_ASSERT(history.path.back().F == 0);
  }));
}

TEST_CASE(
    "rollers, definition: a thick specimen that reloads from a small deflection rests no longer than friction holds "
    "it") {
  for (const double low : {.004, .008, .0157, .02}) {
    CAPTURE(low);
    const History history =
        follow_continuously({Friction::constant(.2), {92, Fibre({0, .0157})}}, std::vector{.1, low, .044, 0.}, 4);
    REQUIRE(history.status == HistoryStatus::ok);
    for (const PathPoint& point : history.path) CHECK(std::abs(point.q) <= .2 + 1e-9);
    for (const EnergyAccount& energy : history.energy_at) CHECK(std::abs(energy.imbalance) < 1e-11);
  }
}

TEST_CASE("rollers, definition: friction on a path is the friction of the point between the contacts") {
  const Fibre fibre({.05, .01});
  const Friction rough = Friction::rough(.4, .2, .02, 3, 1.5);
  for (const Friction& along : {waves, rough})
    for (const double direction : {1., -1.}) {
      const Friction over = met(along, fibre, direction, 1.4);
      for (double S = 1.001; S < 1.4; S += .0007) {
        const auto [mu, slope] = over.at(S);
        const FibreState state = fibre.state(S, direction * mu);
        if (state.status != FibreStatus::ok) break;
        CHECK(mu == to(1e-11, along.at(fibre.length_between_contacts(state)).mu));
        constexpr double h = 1e-6;
        const double difference = (over.at(S + h).mu - over.at(S - h).mu) / (2 * h);
        CHECK(std::abs(slope - difference) < 1e-3 * (1 + std::abs(slope)));
      }
      CHECK(over.knots().empty() == along.knots().empty());
    }
}

TEST_CASE("rollers, limit: friction above the limit for input, as a fit may find, sticks and slides as well") {
  const Fibre fibre({0, .0136});
  for (const double mu : {1.9, 2.1, 2.35, 3.}) {
    CAPTURE(mu);
    std::vector<double> stages;
    for (int i = 1; i <= 60; ++i) stages.push_back(.0015 * i);
    const History history = follow_in_steps({Friction::constant(mu), {76, fibre}}, stages);
    REQUIRE(history.path.size() > 50);
    bool slides_in = false;
    for (const PathPoint& point : history.path) {
      CHECK(std::abs(point.q) <= mu * (1 + 1e-9));
      slides_in = slides_in || point.q > mu - 1e-9;
    }
    CHECK(slides_in);
    CHECK(std::abs(history.energy.imbalance) < 1e-9 * history.energy.stage_work);
  }
}

TEST_CASE(
    "thickness, identity: the energy account closes where static friction lets the specimen stick at its first "
    "length") {
  const Rig rig{53, Fibre(Supports{0, 0.0136})};
  const BendingTest test{{Friction::constant(0.4), Friction::constant(0.1)}, rig};
  const History history = follow_continuously(test, std::vector<double>{0, 0.5, 0.3, 0.4}, 20);
  CHECK(std::abs(history.energy.imbalance) < 1e-10 * history.energy.stage_work);
  CHECK(history.path.back().stage == 0.4);
}

TEST_CASE(
    "rollers, identity: where friction barely changes the sliding length, a test continues and its energies close") {
  const Rig rig{119.66, Fibre(Supports{20.0 / 1278, 3.5 / 1278})};
  const BendingTest test{Friction::sinusoid(0.5, 0.15, 10.9 / 1278, 1), rig};
  const History history = follow_continuously(test, std::vector<double>{0, 0.1, 0.05, 0.2}, 3);
  CHECK(history.path.size() < 20000);
  CHECK(history.path.back().stage == 0.2);
  CHECK(std::abs(history.energy.imbalance) < 1e-10 * history.energy.stage_work);
}

TEST_CASE("rollers, bad input: static friction above the kinetic, two supports that are not alike") {
  const Rig rig{50, Fibre({.02, .01})};
  CHECK(message_of([&] {
          MovingFibre({{Friction::constant(.3), Friction::constant(.1)}, rig}, .2);
        }).find("static") != std::string::npos);
  const Friction two = Friction::on_two_supports(Friction::constant(.3), Friction::constant(.2), 1.5);
  CHECK(message_of([&] { MovingFibre({two, rig}, .2); }).find("rollers") != std::string::npos);
}

}  // namespace flexslip
