#include "surface/placement.h"

#include <cmath>

#include <doctest/doctest.h>

#include "tests/has.h"
#include "tests/refusal.h"
#include "tests/surface/simulated_surface.h"

namespace flexslip {
namespace {

std::vector<double> slopes(SimulatedSurface& surface, std::size_t n) {
  const auto z = surface.gaussian(n + 1, 0.1, 0.06, 1);
  std::vector<double> out;
  for (std::size_t i = 0; i < n; ++i) out.push_back((z[i + 1] - z[i]) / 0.1);
  return out;
}

// Every place, sums as they are written.
double greatest_correlation(const std::vector<double>& shorter, const std::vector<double>& longer) {
  double best = -2;
  const double n = static_cast<double>(shorter.size());
  for (const bool turned : {false, true})
    for (std::size_t at = 0; at + shorter.size() <= longer.size(); ++at) {
      double a = 0, b = 0, aa = 0, bb = 0, ab = 0;
      for (std::size_t i = 0; i < shorter.size(); ++i) {
        const double x = turned ? -shorter[shorter.size() - 1 - i] : shorter[i], y = longer[at + i];
        a += x, b += y, aa += x * x, bb += y * y, ab += x * y;
      }
      best = std::max(best, (ab - a * b / n) / std::sqrt((aa - a * a / n) * (bb - b * b / n)));
    }
  return best;
}

}  // namespace

TEST_CASE(
    "placement: a piece of a trace is found where it was cut, either way round, whichever is the shorter (identity)") {
  SimulatedSurface surface(1);
  const Slopes trace{50, 0.1, slopes(surface, 1000)};
  Slopes piece{7, 0.1, {trace.value.begin() + 300, trace.value.begin() + 500}};
  const Placement there = placed(piece, trace, {.surrogates = 99});
  CHECK_FALSE(there.turned);
  CHECK(there.correlation == doctest::Approx(1).epsilon(1e-9));
  CHECK(there.offset + piece.begin == doctest::Approx(50 + 30).epsilon(1e-12));
  CHECK(there.p_value == 0.01);
  Slopes mirrored = piece;
  for (std::size_t i = 0; i < 200; ++i) mirrored.value[i] = -piece.value[199 - i];
  const Placement back = placed(mirrored, trace, {.surrogates = 99});
  CHECK(back.turned);
  CHECK(back.offset - mirrored.begin == doctest::Approx(50 + 30 + 19.9).epsilon(1e-12));
  const Placement within = placed({7, 0.1, trace.value}, {50, 0.1, piece.value}, {.surrogates = 99});
  CHECK(within.offset + 7 + 30 == doctest::Approx(50).epsilon(1e-12));  // its 300th slope is the first of the piece
}

TEST_CASE("placement: the correlation as it is written, at every place (oracle)") {
  SimulatedSurface surface(2);
  const auto a = slopes(surface, 60), b = slopes(surface, 300);
  CHECK(placed({0, 0.1, a}, {0, 0.1, b}, {.surrogates = 1}).correlation ==
        doctest::Approx(greatest_correlation(a, b)).epsilon(1e-10));
}

TEST_CASE(
    "placement: what has nothing to do with a trace has a p value below 0.1 in a tenth of the cases (oracle: 300 "
    "pairs)") {
  SimulatedSurface surface(3);
  int low = 0;
  constexpr int pairs = 300;
  for (int pair = 0; pair < pairs; ++pair)
    low += placed({0, 0.1, slopes(surface, 100)}, {0, 0.1, slopes(surface, 400)}, {.surrogates = 99}).p_value <= 0.1;
  CHECK(std::abs(low / double{pairs} - 0.1) < 3 * std::sqrt(0.09 / pairs));
}

TEST_CASE("placement: two waves of one length have no place, however well they fit (limit)") {
  SimulatedSurface surface(5);
  Slopes wave{0, 0.1, {}}, trace{0, 0.1, {}};
  for (int i = 0; i < 500; ++i) wave.value.push_back(std::cos(0.2 * i) + 0.05 * surface.normal());
  const auto rest = slopes(surface, 2000);
  for (int i = 0; i < 2000; ++i) trace.value.push_back(std::cos(0.2 * i + 1) + rest[static_cast<std::size_t>(i)]);
  const Placement nowhere = placed(wave, trace, {.surrogates = 199});
  CHECK(nowhere.correlation > 0.9);
  CHECK(nowhere.p_value > 0.05);
}

TEST_CASE("placement: the same at every call, and half drowned in noise still found (identity, limit)") {
  SimulatedSurface surface(4);
  const Slopes trace{0, 0.1, slopes(surface, 1500)};
  Slopes piece{0, 0.1, {trace.value.begin() + 700, trace.value.begin() + 1100}};
  for (double& each : piece.value) each += 0.085 * surface.normal();
  const Placement one = placed(piece, trace), other = placed(piece, trace);
  CHECK(one.p_value == other.p_value);
  CHECK(one.p_value <= 0.002);
  CHECK(std::abs(one.offset - 70) < 0.3);
}

TEST_CASE("placement: averages over a coarser step keep the heights, and bad input is refused (identity, limit)") {
  const Slopes coarse = averaged({1, 0.1, {1, 3, 5, 7, 9}}, 0.2);
  CHECK(coarse.begin == doctest::Approx(1.05).epsilon(1e-15));
  REQUIRE(coarse.value.size() == 2);
  CHECK(coarse.value[0] == doctest::Approx(2).epsilon(1e-14));
  CHECK(coarse.value[1] == doctest::Approx(6).epsilon(1e-14));
  CHECK(has(message_of([] { averaged({0, 0.1, {1, 2}}, 0.05); }), "averaged over"));
  CHECK(has(message_of([] { placed({0, 0.1, {1, 2}}, {0, 0.1, {1, 2, 3}}); }), "2 places"));
  CHECK(has(message_of([] {
              placed({0, 0.1, std::vector<double>(9, 1.0)}, {0, 0.1, std::vector<double>(20, 1.0)});
            }),
            "all alike"));
}

}  // namespace flexslip
