// Where the contacts are along the specimen.
#include <cmath>

#include <doctest/doctest.h>

#include "fibre/fibre.h"
#include "tests/approximately.h"

namespace flexslip {

TEST_CASE("contact_travel, definition: it is the length between the contacts, mirrored while these roll back") {
  for (const auto& supports : {Supports{.02, 0}, Supports{.08, 0}, Supports{.08, .027}, Supports{.15, .06}}) {
    const Fibre fibre(supports);
    constexpr double q = .4, least = 1.02, most = 1.5;
    const ContactPath along(fibre, q, least, most);
    double before = -INFINITY, shortest = INFINITY;
    for (double S = least; S <= most; S += .001) shortest = std::min(shortest, fibre.contact(S, q).length);
    for (double S = least; S <= most; S += .01) {
      CAPTURE(S);
      const auto contact = fibre.contact(S, q);
      const double travel = along.at(S);
      CHECK(travel > before);
      CHECK(along.length_at(travel) == to(1e-9, contact.length));
      CHECK(std::abs(along.slope(S) - std::abs(contact.length_S)) < 1e-7);
      CHECK(along.contact_moves_outward_at(travel) == (contact.length_S < 0));
      if (contact.length_S > 0.05) CHECK(travel >= shortest);
      CHECK(along.sliding_length_at(travel) == to(1e-9, S));
      before = travel;
    }
    CHECK(along.sliding_length_at(along.at(most + .01)) == to(1e-9, most + .01));  // linear beyond
    CHECK(along.slope(most + .01) > 0);
  }
}

TEST_CASE("contact_travel: on edges, for any thickness, it is the sliding length, bit for bit") {
  for (const Fibre& fibre : {Fibre(), Fibre(Supports{0, .02})}) {
    const ContactPath along(fibre, .4, 1.02, 1.5);
    CHECK(along.at(1.2345) == 1.2345);
    CHECK(along.sliding_length_at(1.2345) == 1.2345);
    CHECK(along.length_at(1.2345) == 1.2345);
    CHECK(along.slope(1.2345) == 1);
    CHECK(!along.contact_moves_outward_at(1.01));
  }
}

TEST_CASE("contact_travel: another friction moves the point that touches by what theory.md says (0.0005 of the span)") {
  const Fibre fibre(Supports{.08, 0});
  const double S = 1 + state_on_supports(.3, .3, {.08, 0}).slid;
  CHECK(fibre.contact(S, .5).length - fibre.contact(S, .3).length == doctest::Approx(.0005).epsilon(.1));
}

}  // namespace flexslip
