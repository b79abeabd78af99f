#include "bending_test/sliding_piece.h"

#include <array>
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "bending_test/sliding_table.h"
#include "fibre/elastica.h"
#include "tests/approximately.h"
#include "tests/refusal.h"

namespace flexslip {
namespace {

// Three quarters of a period, as long as pieces are taken.
const Friction friction = Friction::sinusoid(0.6, 0.4, 0.02 * std::numbers::pi, 0);
const Rig stiff{200};  // on which the stage rises all along
constexpr double S_from = 1.2;
constexpr double S_to = S_from + 0.75 * 0.04 * std::numbers::pi;

SlidingPiece piece_of(const Friction& along, double from, double to) {
  const Fibre fibre;
  return {pieces_between(along, stiff, Sliding::in,
                         std::array{fibre.sliding_coordinate(from), fibre.sliding_coordinate(to)})
              .front(),
          stiff};
}

FibreState state_at(double S) { return fibre_state(S, friction.at(S).mu); }

}  // namespace

TEST_CASE("sliding piece, oracle: forces at stage positions agree with the states") {
  const SlidingPiece piece = piece_of(friction, S_from, S_to);
  for (int i = 0; i <= 50; ++i) {
    const auto state = state_at(S_from + (S_to - S_from) * i / 50);
    // The last coefficients are below 1e-6 of the force; what follows them is a tenth of that.
    CHECK(piece.force_at(state.w + state.F / stiff.stiffness) == to(1e-7, state.F));
  }
  CHECK(piece.error() < 1e-6);
}

TEST_CASE("sliding piece, oracle: its work is the bending energy gained and what sliding took") {
  const SlidingPiece piece = piece_of(friction, S_from, S_to);
  SlidingTable table(friction, stiff, Sliding::in);
  const double gained = state_at(S_to).U - state_at(S_from).U;
  CHECK(piece.work() == to(1e-7, gained + table.work(S_from, S_to).friction));  // as above
}

TEST_CASE("sliding piece, identity: at its turns the force is level, and it turns as often as a dense sample") {
  const SlidingPiece piece = piece_of(friction, S_from, S_to);
  int turns = 0;
  bool rising = state_at(S_from + 1e-6).F > state_at(S_from).F;
  double last = state_at(S_from).F;
  for (int i = 1; i <= 2000; ++i) {
    const double F = state_at(S_from + (S_to - S_from) * i / 2000).F;
    turns += (F > last) != rising;
    rising = F > last;
    last = F;
  }
  REQUIRE(piece.turns().size() == static_cast<std::size_t>(turns));
  for (const auto& turn : piece.turns())
    // 1e-6 of the stage aside the force has not changed to the first order: 1e-12 times a curvature below 1e4
    CHECK(std::abs(piece.force_at(turn.stage + 1e-6) - turn.F) < 1e-8);
}

TEST_CASE("sliding piece, limit: where the branch has ended there is none") {
  const Friction none = Friction::constant(0);
  CHECK_FALSE(piece_of(none, 1.5, 3).exists());
  CHECK(piece_of(none, 1, 1.1).exists());
}

TEST_CASE("sliding piece, identity: parts of a piece agree with the whole, and add up to it") {
  const Fibre fibre;
  const CurvePiece nodes = pieces_between(friction, stiff, Sliding::in,
                                          std::array{fibre.sliding_coordinate(S_from), fibre.sliding_coordinate(S_to)})
                               .front();
  const SlidingPiece whole(nodes, stiff);
  const double between = 0.3 * nodes.from + 0.7 * nodes.to;
  const SlidingPiece first(nodes, stiff, nodes.from, between), second(nodes, stiff, between, nodes.to);
  constexpr double rounding = 1e-13;  // of a sum of 13 terms, and twice of work
  CHECK(first.work() + second.work() == to(rounding, whole.work()));
  CHECK(first.force_to() == second.force_from());
  CHECK(first.turns().size() + second.turns().size() == whole.turns().size());
  for (int i = 0; i <= 20; ++i) {
    const auto state = state_at(S_from + (S_to - S_from) * i / 20);
    const double stage = state.w + state.F / stiff.stiffness;
    const SlidingPiece& part = stage < first.stage_to() ? first : second;
    CHECK(part.force_at(stage) == to(rounding, whole.force_at(stage)));
  }
}

TEST_CASE("sliding piece, contract: a part that leads back, or out of its piece, is refused") {
  const CurvePiece nodes = pieces_between(friction, stiff, Sliding::in, std::array{0.5, 0.6}).front();
  CHECK(message_of([&] { SlidingPiece(nodes, stiff, 0.58, 0.52); }).find("0.58") != std::string::npos);
  CHECK(message_of([&] { SlidingPiece(nodes, stiff, 0.5, 0.7); }).find("0.7") != std::string::npos);
}

}  // namespace flexslip
