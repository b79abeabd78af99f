#include "inference/sliding_piece.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "fibre/state_table.h"

namespace flexslip {
namespace {

constexpr std::size_t degree = SlidingPiece::degree;
using Values = SlidingPiece::Values;
using Matrix = std::array<Values, degree + 1>;

double real(std::size_t i) { return static_cast<double>(i); }

double binomial(std::size_t n, std::size_t r) {
  double value = 1;
  for (std::size_t i = 1; i <= r; ++i) value = value * real(n - r + i) / real(i);
  return value;
}

// Linear maps of the values at the nodes -cos(π j/n), n = degree.
struct Maps {
  Values node{};
  Matrix chebyshev{};  // coefficients
  Matrix bernstein{};  // coefficients on [-1, 1]
  Matrix work{};       // of values F and w: F' work w = ∫ F dw

  Maps() {
    const double pi = std::numbers::pi;
    const auto half_at_end = [](std::size_t i) { return i == 0 || i == degree ? 0.5 : 1.0; };
    for (std::size_t j = 0; j <= degree; ++j) node[j] = -std::cos(pi * real(j) / real(degree));
    for (std::size_t k = 0; k <= degree; ++k)
      for (std::size_t j = 0; j <= degree; ++j)
        chebyshev[k][j] = (k % 2 == 0 ? 2.0 : -2.0) / real(degree) * half_at_end(j) * half_at_end(k) *
                          std::cos(pi * real(k * j) / real(degree));
    // T_k = Σ_i (-1)^(k-i) C(2k, 2i)/C(k, i) B_i^k, raised from degree k to the full one.
    for (std::size_t i = 0; i <= degree; ++i)
      for (std::size_t k = 0; k <= degree; ++k) {
        double from_k = 0;
        for (std::size_t r = i + k > degree ? i + k - degree : 0; r <= std::min(i, k); ++r)
          from_k += ((k - r) % 2 == 0 ? 1.0 : -1.0) * binomial(2 * k, 2 * r) * binomial(degree - k, i - r);
        for (std::size_t j = 0; j <= degree; ++j) bernstein[i][j] += from_k / binomial(degree, i) * chebyshev[k][j];
      }
    // ∫ T_a T_b' dx over [-1, 1]: T_b' = 2 b Σ T_c over the c < b of other parity than b, that of T_0 halved.
    Matrix product{};
    for (std::size_t a = 0; a <= degree; ++a)
      for (std::size_t b = 1; b <= degree; ++b)
        for (std::size_t c = (b + 1) % 2; c < b; c += 2) {
          if ((a + c) % 2 != 0) continue;
          const double sum = real(a + c);
          const double difference = real(a) - real(c);
          const double integral = 1 / (1 - sum * sum) + 1 / (1 - difference * difference);
          product[a][b] += (c == 0 ? 1.0 : 2.0) * real(b) * integral;
        }
    for (std::size_t i = 0; i <= degree; ++i)
      for (std::size_t j = 0; j <= degree; ++j)
        for (std::size_t a = 0; a <= degree; ++a)
          for (std::size_t b = 1; b <= degree; ++b) work[i][j] += chebyshev[a][i] * product[a][b] * chebyshev[b][j];
  }
};

const Maps& maps() {
  static const Maps value;
  return value;
}

Values apply(const Matrix& map, const Values& values) {
  Values result{};
  for (std::size_t i = 0; i <= degree; ++i)
    for (std::size_t j = 0; j <= degree; ++j) result[i] += map[i][j] * values[j];
  return result;
}

struct ValueAndSlope {
  double value, slope;
};

// Clenshaw's recurrence, and its derivative.
ValueAndSlope at(const Values& series, double x) {
  double b1 = 0, b2 = 0, d1 = 0, d2 = 0;
  for (std::size_t k = degree; k > 0; --k) {
    const double d0 = 2 * b1 + 2 * x * d1 - d2;
    d2 = d1;
    d1 = d0;
    const double b0 = series[k] + 2 * x * b1 - b2;
    b2 = b1;
    b1 = b0;
  }
  return {series[0] + x * b1 - b2, b1 + x * d1 - d2};
}

// A root of f, which has one sign at `low` and the other at `high`, by Newton's iteration kept between them.
template <class Function>
double root_between(Function f, double low, double high, double x, bool rising) {
  constexpr double close = 0x1p-48;  // of x, which is in [-1, 1]
  for (int iteration = 0; iteration < 60; ++iteration) {
    const auto [value, slope] = f(x);
    if (value == 0) return x;
    ((value < 0) == rising ? low : high) = x;
    double next = x - value / slope;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const double step = std::abs(next - x);
    x = next;
    if (step <= close) break;
  }
  return x;
}

// The roots of a polynomial in Bernstein form: as many as its signs change, or fewer (Descartes); halved until they change
// at most once.
using Slope = std::array<double, degree>;

void add_roots(const Slope& b, double low, double high, int halvings, std::vector<double>& roots) {
  constexpr int most_halvings = 24;  // beyond it two roots are one point
  int changes = 0;
  for (std::size_t i = 0; i + 1 < degree; ++i) changes += (b[i] < 0) != (b[i + 1] < 0);
  if (changes == 0) return;
  if (halvings == most_halvings) {
    if (changes % 2 == 1) roots.push_back(0.5 * (low + high));
    return;
  }
  Slope left{};
  Slope right = b;
  if (changes == 1) {
    const auto value_at = [&](double t) {
      Slope c = b;
      double slope = 0;
      for (std::size_t n = degree - 1; n > 0; --n) {
        if (n == 1) slope = real(degree - 1) * (c[1] - c[0]);
        for (std::size_t i = 0; i < n; ++i) c[i] += t * (c[i + 1] - c[i]);
      }
      return ValueAndSlope{c[0], slope};
    };
    roots.push_back(low + (high - low) * root_between(value_at, 0.0, 1.0, 0.5, b.front() < 0));
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
  const double low = std::sqrt(S_from - 1);
  const double high = std::sqrt(S_to - 1);
  Values S{};
  Values q{};
  for (std::size_t j = 0; j <= degree; ++j) {
    const double sigma = 0.5 * (low + high) + 0.5 * (high - low) * maps().node[j];
    S[j] = j == 0 ? S_from : j == degree ? S_to : 1 + sigma * sigma;
    q[j] = friction.at(S[j]).mu;
  }
  const auto states = tabulated_states(FibrePoints(S, q));
  double most = 0;
  for (std::size_t j = 0; j <= degree; ++j) {
    exists_ = exists_ && !std::isnan(states.F[j]);
    w_at_[j] = states.w[j];
    F_at_[j] = states.F[j];
    stage_at_[j] = states.w[j] + states.F[j] / rig.stiffness;
    most = std::max(most, states.F[j]);
  }
  if (!exists_) return;
  stage_ = apply(maps().chebyshev, stage_at_);
  F_ = apply(maps().chebyshev, F_at_);
  error_ = (std::abs(F_[degree]) + std::abs(F_[degree - 1])) / most;
}

double SlidingPiece::work() const {
  const Values weighted = apply(maps().work, w_at_);
  double sum = 0;
  for (std::size_t i = 0; i <= degree; ++i) sum += F_at_[i] * weighted[i];
  return sum;
}

double SlidingPiece::force_at(double stage) const {
  const double share = (stage - stage_from()) / (stage_to() - stage_from());
  const auto miss = [&](double x) {
    const auto [value, slope] = at(stage_, x);
    return ValueAndSlope{value - stage, slope};
  };
  return at(F_, root_between(miss, -1.0, 1.0, 2 * share - 1, true)).value;
}

std::vector<SlidingPiece::Turn> SlidingPiece::turns() const {
  const Values force = apply(maps().bernstein, F_at_);
  Slope slope{};
  for (std::size_t i = 0; i < degree; ++i) slope[i] = force[i + 1] - force[i];
  std::vector<double> roots;
  add_roots(slope, -1, 1, 0, roots);
  std::vector<Turn> turns;
  turns.reserve(roots.size());
  for (const double x : roots)
    turns.push_back({std::clamp(at(stage_, x).value, stage_from(), stage_to()), at(F_, x).value});
  return turns;
}

}  // namespace flexslip
