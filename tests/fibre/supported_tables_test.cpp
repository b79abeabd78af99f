#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <doctest/doctest.h>

#include "fibre/fibre.h"
#include "fibre/state_table.h"
#include "numerics/progress.h"
#include "tests/approximately.h"
#include "tests/generators.h"

namespace flexslip {

TEST_CASE(
    "tables on supports, oracle: by length, from where polynomials are trusted on, they give what the iteration on "
    "deflections gives") {
  for (const double tau : {0.001, 0.005, 0.0157, 0.031, 0.05, 0.08})
    for (const double radius : {0.0, 0.02}) {
      const Supports supports{radius, tau};
      const SupportedTables& tables = *SupportedTables::of(supports);
      const Fibre fibre(supports);
      for (const double beyond : {1e-9, 1e-4, 1e-3, 3e-3, 1e-2})
        for (double q = -0.8; q <= 2; q += 0.0937) {
          const double S = tables.smooth_from + beyond;
          const double w = tables.deflection(S, q);
          if (std::isnan(w)) continue;  // such friction may leave no force
          const auto at = tables.sliding(w, q);
          if (!(at[1] > 0)) continue;
          INFO("half depth ", tau, ", radius ", radius, ", S ", S, ", q ", q);
          const SlopeArrays by_length = fibre.tabulated_states_slopes({std::vector{S}, std::vector{q}});
          CHECK(by_length.w[0] == to(2e-12, w));
          CHECK(by_length.F[0] == to(4e-12 * (1 + q * q), at[1]));
          CHECK(by_length.w_S[0] == to(1e-9, 1 / at[2]));
          CHECK(std::abs(by_length.w_q[0] + at[3] / at[2]) <= 1e-9 * w);
        }
    }
}

TEST_CASE(
    "tables on supports, identity: what was stopped while a cell was solved is solved when it is asked for once more") {
  int stopped = 0;
  for (std::uint64_t after = 50; after <= 2000; after += 150) {  // states, of the cell's own
    const Supports supports{0.011, 0.01 + 1e-7 * static_cast<double>(after)};
    const SupportedTables tables(supports);
    std::atomic<bool> stop = false;
    try {
      const Stoppable stoppable(&stop);
      const Watch watch([&](const Reached&) { stop = true; });
      effort_spent += Watch::every - after;
      tables.sliding(0.2, 0.5);
    } catch (const Stopped&) {
      ++stopped;
    }
    CHECK(tables.sliding(0.2, 0.5)[0] == SupportedTables(supports).sliding(0.2, 0.5)[0]);
  }
  CHECK(stopped > 5);
}

TEST_CASE("tables on supports: those asked for again and again stay, however many others are asked for once") {
  const Supports lasting{0.0123, 0.01};
  const auto tables = SupportedTables::of(lasting);
  for (int i = 1; i <= 40; ++i) {
    SupportedTables::of({0.0123, 0.01 + 1e-4 * i});
    CHECK(SupportedTables::of(lasting) == tables);
  }
}

TEST_CASE("tables on supports: friction q reduces the smallest length by 6 q τ³, to first order") {
  constexpr double tau = 0.002;
  const auto least = [&](double q) {  // of a parabola through three states about it
    const auto slid = [&](double share) { return extrapolated_state(share * tau, q, {0, tau}).slid; };
    const double a = slid(1.15), b = slid(1.25), c = slid(1.35);
    return b - (c - a) * (c - a) / (8 * (a - 2 * b + c));
  };
  for (const double q : {-1.0, 1.0, 2.0})
    CHECK((least(q) - least(0)) / (tau * tau * tau) == doctest::Approx(-6 * q).epsilon(0.05));
}

TEST_CASE("tables on supports: a deflection is found from any guess (property)") {
  CHECK(rc::check([] {
    const Supports supports{0.008, 0.0157};
    const SupportedTables& tables = *SupportedTables::of(supports);
    const double w = *between(4 * supports.half_depth, 0.35), q = *between(0, 2);
    const std::vector<double> S{1 + tables.sliding(w, q)[0]};
    const std::vector<double> frictions{q};
    for (const double guess :
         {std::numeric_limits<double>::quiet_NaN(), -1.0, 1.2 * tables.least_w(), 0.5 * w, w, 1.5 * w, 5.0})
      RC_ASSERT(tables.deflections(S, frictions, {guess})[0] == to(1e-11, w));
  }));
}

TEST_CASE("tables on supports, identity: the more friction, the farther the branch goes, in deflection and in length") {
  for (const Supports supports :
       {Supports{0, 0.0136}, Supports{0, 0.03}, Supports{0.01, 0}, Supports{0.05, 0.0136}, Supports{0.1, 0.03}}) {
    double w_last = 0, slid_last = 0;
    for (double q = -3; q <= 4; q += 0.0625) {
      double exists = 1.25 * supports.half_depth + 1e-3, none = deepest_on_supports;
      const auto at = [&](double w) { return state_on_supports(w, q, supports); };
      if (at(none).status == FibreStatus::ok) break;
      while (none - exists > 1e-9) {
        const double middle = 0.5 * (exists + none);
        (at(middle).status == FibreStatus::ok ? exists : none) = middle;
      }
      INFO("radius ", supports.radius, ", half depth ", supports.half_depth, ", q ", q);
      const double slid = at(exists).slid;
      CHECK(exists > w_last);
      CHECK(slid > slid_last);
      // And so nothing that is there is taken for nothing, at frictions where no end is kept, too.
      const double S = 1 + 0.999 * slid;
      CHECK(SupportedTables::of(supports)->deflection(S, q) == to(1e-9, [&] {
              double low = 0.5 * exists, high = exists;
              for (int i = 0; i < 60; ++i) {
                const double middle = 0.5 * (low + high);
                (at(middle).slid < S - 1 ? low : high) = middle;
              }
              return low;
            }()));
      w_last = exists;
      slid_last = slid;
    }
  }
}

TEST_CASE("tables on supports: up to the end of the branch they are what is computed singly (property)") {
  CHECK(rc::check([] {
    const Supports supports = *rc::gen::element(Supports{0, 0.0136}, Supports{0, 0.0767}, Supports{0.1, 0.03});
    const double q = *between(-2, 1.5);
    const auto at = [&](double w) { return state_on_supports(w, q, supports); };
    double exists = 1.25 * supports.half_depth + 1e-3, none = deepest_on_supports;
    RC_PRE(at(none).status != FibreStatus::ok);
    while (none - exists > 1e-7) {
      const double middle = 0.5 * (exists + none);
      (at(middle).status == FibreStatus::ok ? exists : none) = middle;
    }
    const double w = exists - 0.05 * *between(0, 1) * (exists - 1.25 * supports.half_depth);
    const SupportedState state = at(w);
    RC_PRE(state.status == FibreStatus::ok);
    const auto tabulated = SupportedTables::of(supports)->sliding(w, q);
    RC_ASSERT(std::abs(tabulated[0] - state.slid) < 1e-11);
    RC_ASSERT(std::abs(tabulated[1] - state.F) < 1e-9);
    // Just beyond the end it is extrapolated, with a negative force.
    const SupportedState led = extrapolated_state(none + 1e-3, q, supports);
    RC_PRE(led.status == FibreStatus::ok);
    const auto beyond = SupportedTables::of(supports)->sliding(none + 1e-3, q);
    RC_ASSERT(beyond[1] < 0);
    RC_ASSERT(std::abs(beyond[1] - led.F) < 1e-9);
    RC_ASSERT(std::abs(SupportedTables::of(supports)->forces(std::vector{w}, std::vector{q})[0] - state.F) < 1e-9);
  }));
}

TEST_CASE("tables on supports, limit: lengths that no state has, too short and too long, have no deflection") {
  for (const Supports supports : {Supports{0, 0.05}, Supports{0.1, 0.03}, Supports{0.05, 0}})
    for (const double q : {-2.0, -1.0, 0.0, 1.0}) {
      INFO("radius ", supports.radius, ", half depth ", supports.half_depth, ", q ", q);
      const SupportedTables& tables = *SupportedTables::of(supports);
      double least = 1;  // [L] at small deflection
      for (double w = 1e-3; w < 0.3; w += 1e-3) {
        const SupportedState at = extrapolated_state(w, q, supports);
        if (at.status == FibreStatus::ok) least = std::min(least, 1 + at.slid);
      }
      CHECK(std::isnan(tables.deflection(least - 1e-3, q)));
      CHECK(std::isnan(tables.deflection(12, q)));
      CHECK(std::isnan(tables.deflections(std::vector{least - 1e-3}, std::vector{q})[0]));
    }
}

}  // namespace flexslip
