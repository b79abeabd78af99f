#include "bending_test/sliding_piece.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "bending_test/interpolant.h"
#include "bending_test/polynomial.h"

namespace flexslip {
namespace {

constexpr std::size_t degree = SlidingPiece::degree;
using Polynomial = Interpolant<degree>;
using Values = SlidingPiece::Values;
constexpr double close = 0x1p-48;  // of a zero in [-1, 1]

// The map of values F and w at the nodes with which F' map w = ∫ F dw.
Polynomial::Matrix map_of_work() {
  const auto real = [](std::size_t i) { return static_cast<double>(i); };
  // ∫ T_a T_b' dx over [-1, 1]: T_b' = 2 b Σ T_c over the c < b of other parity than b, that of T_0 halved.
  Polynomial::Matrix product{};
  for (std::size_t a = 0; a <= degree; ++a)
    for (std::size_t b = 1; b <= degree; ++b)
      for (std::size_t c = (b + 1) % 2; c < b; c += 2) {
        if ((a + c) % 2 != 0) continue;
        const double sum = real(a + c);
        const double difference = real(a) - real(c);
        const double integral = 1 / (1 - sum * sum) + 1 / (1 - difference * difference);
        product[a][b] += (c == 0 ? 1.0 : 2.0) * real(b) * integral;
      }
  const auto& series = Polynomial::to_chebyshev();
  Polynomial::Matrix work{};
  for (std::size_t i = 0; i <= degree; ++i)
    for (std::size_t j = 0; j <= degree; ++j)
      for (std::size_t a = 0; a <= degree; ++a)
        for (std::size_t b = 1; b <= degree; ++b) work[i][j] += series[a][i] * product[a][b] * series[b][j];
  return work;
}

// The roots of a polynomial in Bernstein form: as many as its signs change, or fewer (Descartes); halved until they change
// at most once.
using Slope = std::array<double, degree>;

void add_roots(const Slope& b, double low, double high, int halvings, std::vector<double>& roots) {
  constexpr int most_halvings = 24;  // beyond it two roots are one point
  const int changes = sign_changes(b);
  if (changes == 0) return;
  if (halvings == most_halvings) {
    if (changes % 2 == 1) roots.push_back(0.5 * (low + high));
    return;
  }
  Slope left{};
  Slope right = b;
  if (changes == 1) {
    const auto value_at = [&](double t) { return bernstein_at(b, t); };
    roots.push_back(low + (high - low) * zero_between(value_at, 0.0, 1.0, 0.5, b.front() < 0, close));
    return;
  }
  for (std::size_t n = degree; n > 0; --n) {
    left[degree - n] = right[0];
    for (std::size_t i = 0; i + 1 < n; ++i) right[i] = 0.5 * (right[i] + right[i + 1]);
  }
  const double middle = 0.5 * (low + high);
  add_roots(left, low, middle, halvings + 1, roots);
  add_roots(right, middle, high, halvings + 1, roots);
}

}  // namespace

SlidingPiece::SlidingPiece(const Friction& friction, const Rig& rig, double S_from, double S_to) {
  if (!(S_from >= 1 && S_to > S_from))
    throw std::invalid_argument("no piece leads from S = " + std::to_string(S_from) + " to " + std::to_string(S_to));
  const double low = rig.fibre.way(S_from);
  const double high = rig.fibre.way(S_to);
  Values S{};
  Values q{};
  for (std::size_t j = 0; j <= degree; ++j) {
    const double sigma = 0.5 * (low + high) + 0.5 * (high - low) * Polynomial::node(j);
    S[j] = j == 0 ? S_from : j == degree ? S_to : rig.fibre.length_at(sigma);
    q[j] = friction.at(S[j]).mu;
  }
  const auto states = rig.fibre.tabulated_states(FibrePoints(S, q));
  double most = 0;
  for (std::size_t j = 0; j <= degree; ++j) {
    exists_ = exists_ && !std::isnan(states.F[j]);
    w_at_[j] = states.w[j];
    F_at_[j] = states.F[j];
    stage_at_[j] = states.w[j] + states.F[j] / rig.stiffness;
    most = std::max(most, states.F[j]);
  }
  if (!exists_) return;
  stage_ = Polynomial::chebyshev(stage_at_);
  F_ = Polynomial::chebyshev(F_at_);
  error_ = (std::abs(F_[degree]) + std::abs(F_[degree - 1])) / most;
}

double SlidingPiece::work() const {
  static const auto map = map_of_work();
  const Values weighted = Polynomial::apply(map, w_at_);
  double sum = 0;
  for (std::size_t i = 0; i <= degree; ++i) sum += F_at_[i] * weighted[i];
  return sum;
}

double SlidingPiece::force_at(double stage) const {
  const double share = (stage - stage_from()) / (stage_to() - stage_from());
  if (!(share > 0)) return force_from();
  if (!(share < 1)) return force_to();
  const auto miss = [&](double x) {
    const auto [value, slope] = series_slope_at(stage_, x);
    return ValueAndSlope{value - stage, slope};
  };
  return series_at(F_, zero_between(miss, -1.0, 1.0, 2 * share - 1, true, close));
}

std::vector<SlidingPiece::Turn> SlidingPiece::turns() const {
  const Values force = Polynomial::bernstein(F_at_);
  Slope slope{};
  for (std::size_t i = 0; i < degree; ++i) slope[i] = force[i + 1] - force[i];
  std::vector<double> roots;
  add_roots(slope, -1, 1, 0, roots);
  std::vector<Turn> turns;
  turns.reserve(roots.size());
  for (const double x : roots)
    turns.push_back({std::clamp(series_at(stage_, x), stage_from(), stage_to()), series_at(F_, x)});
  return turns;
}

}  // namespace flexslip
