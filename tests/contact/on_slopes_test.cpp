#include <memory>

#include <doctest/doctest.h>

#include "bending_test/history.h"
#include "contact/over_rollers.h"
#include "contact/two_supports.h"
#include "tests/has.h"
#include "tests/refusal.h"

namespace flexslip {

TEST_CASE("on slopes: in on the one profile, out on the other, and back (identity)") {
  const Friction in = Friction::table({{1, 1.5, 2}, {0.4, 0.6, 0.5}}),
                 out = Friction::table({{1, 1.5, 2}, {0.6, 0.4, 0.5}});
  const Friction both = Friction::path_dependent(std::make_shared<const OnSlopes>(in, out));
  CHECK(both.is_path_dependent());
  CHECK(both.continues(1.2, 1));
  CHECK_FALSE(both.continues(1.2, -1));
  const Friction back = both.from(1.5, -0.4, -1), again = back.from(1.2, 0.3, 1);
  for (const double S : {1.0, 1.3, 1.5, 2.0}) {
    CHECK(both.at(S).mu == in.at(S).mu);
    CHECK(back.at(S).mu == out.at(S).mu);
    CHECK(again.at(S).mu == in.at(S).mu);
  }
  CHECK(both.max_up_to(2) == in.max_up_to(2));
  CHECK(has(message_of([&] { OnSlopes(both, in); }), "two ways by itself"));
}

TEST_CASE("on slopes: a bending test slides out along minus the other profile (oracle: this profile alone)") {
  const Friction in = Friction::table({{1, 1.1, 1.2, 1.6}, {0.5, 0.6, 0.5, 0.5}}),
                 out = Friction::table({{1, 1.1, 1.2, 1.6}, {0.5, 0.4, 0.5, 0.5}});
  const Rig rig{200};
  const std::vector<double> programme{0.45, 0.2, 0.45};
  const auto path =
      follow_continuously({Friction::path_dependent(std::make_shared<const OnSlopes>(in, out)), rig}, programme, 200)
          .path;
  int outwards = 0, inwards = 0;
  for (const auto& point : path) {
    if (point.motion == Motion::slip_out) {
      CHECK(point.q == doctest::Approx(-out.at(point.S).mu).epsilon(1e-9));
      ++outwards;
    }
    if (point.motion == Motion::slip_in) {
      CHECK(point.q == doctest::Approx(in.at(point.S).mu).epsilon(1e-9));
      ++inwards;
    }
  }
  CHECK(outwards > 50);
  CHECK(inwards > 50);
}

}  // namespace flexslip
