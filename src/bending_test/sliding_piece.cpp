#include "bending_test/sliding_piece.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "bending_test/sliding_table.h"
#include "fibre/batch.h"
#include "numerics/polynomial.h"
#include "numerics/quadrature.h"
#include "numerics/root.h"

namespace flexslip {
namespace {

constexpr std::size_t degree = CurvePiece::degree;
using Polynomial = CurvePiece::Polynomial;
// of a zero in [-1, 1]; the error after a Newton step is its square
constexpr double close = 1e-7;

// The zeros of the slope of a polynomial. Their number is at most the number of sign changes of its
// Bernstein coefficients (Descartes). Intervals are halved until there is at most one change. The
// Chebyshev series then gives the zeros with fewer products.
struct SlopeOf {
  using Bernstein = std::array<double, degree>;
  std::array<double, degree> series;

  struct Zeros {
    std::array<double, degree> at;
    std::size_t count = 0;
    void add(double x) {
      if (count < at.size()) at[count++] = x;  // a polynomial has no more
    }
  };
  void add_zeros(const Bernstein& b, double low, double high, int halvings, Zeros& zeros) const {
    constexpr int max_halvings = 24;  // closer zeros count as one
    const int changes = sign_changes(b);
    if (changes == 0) return;
    if (halvings == max_halvings) {
      if (changes % 2 == 1) zeros.add(0.5 * (low + high));
      return;
    }
    if (changes == 1) {
      const auto at = [&](double x) { return series_slope_at(series, x); };
      const bool rises = b.front() < 0;
      zeros.add(zero_between(at, rises ? low : high, rises ? high : low, 0.5 * (low + high), close));
      return;
    }
    const auto [left, right] = bernstein_halves(b);
    const double middle = 0.5 * (low + high);
    add_zeros(left, low, middle, halvings + 1, zeros);
    add_zeros(right, middle, high, halvings + 1, zeros);
  }
};

}  // namespace

std::vector<CurvePiece> pieces_between(const Friction& friction, const Rig& rig, Sliding sliding,
                                       std::span<const double> x) {
  const double direction = direction_of(sliding), compliance = 1 / rig.stiffness;
  std::vector<CurvePiece> pieces(x.size() - 1);
  std::vector<double> S;
  S.reserve(degree * pieces.size() + 1);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    pieces[i].from = x[i];
    pieces[i].to = x[i + 1];
    S.push_back(rig.fibre.length_at(x[i]));
    for (std::size_t j = 1; j < degree; ++j) S.push_back(rig.fibre.length_at(pieces[i].coordinate_of(j)));
  }
  S.push_back(rig.fibre.length_at(x.back()));
  std::vector<double> q = friction.at(S).mu;
  for (double& value : q) value *= direction;
  const StateArrays states = rig.fibre.tabulated_states(FibrePoints(S, q));
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t j = 0; j <= degree; ++j) {
      const std::size_t k = degree * i + j;
      pieces[i].q[j] = q[k];
      pieces[i].F[j] = states.F[k];
      pieces[i].stage[j] = states.w[k] + compliance * states.F[k];
    }
  return pieces;
}

SlidingPiece::SlidingPiece(const CurvePiece& piece, const Rig& rig, double from, double to)
    : piece_(piece),
      begin_(from == piece.from ? -1 : piece.place_of(from)),
      end_(to == piece.to ? 1 : piece.place_of(to)),
      compliance_(1 / rig.stiffness),
      exists_(std::none_of(piece.F.begin(), piece.F.end(), [](double F) { return std::isnan(F); })) {
  if (!(piece.from <= from && from < to && to <= piece.to))
    throw std::invalid_argument("no part of a piece leads from x = " + std::to_string(from) + " to " +
                                std::to_string(to));
  if (!exists_) return;
  stage_ = Polynomial::chebyshev(piece.stage);
  F_ = Polynomial::chebyshev(piece.F);
  error_ = (std::abs(F_[degree]) + std::abs(F_[degree - 1])) / *std::max_element(piece.F.begin(), piece.F.end());
  const auto at = [](const CurvePiece::Values& values, const CurvePiece::Values& series, double t) {
    return t == -1 ? values.front() : t == 1 ? values.back() : series_at(series, t);
  };
  force_from_ = at(piece.F, F_, begin_);
  force_to_ = at(piece.F, F_, end_);
  stage_from_ = at(piece.stage, stage_, begin_);
  stage_to_ = at(piece.stage, stage_, end_);
}

double SlidingPiece::work() const {
  static_assert(degree <= gauss_12.node.size());  // then it is exact
  const double middle = 0.5 * (begin_ + end_), reach = 0.5 * (end_ - begin_);
  std::array<double, gauss_12.node.size()> t;
  for (std::size_t i = 0; i < t.size(); ++i) t[i] = middle + reach * gauss_12.node[i];
  const auto F = series_at(F_, t), rises = series_at(derivative(stage_), t);
  double of_stage = 0;
  for (std::size_t i = 0; i < t.size(); ++i) of_stage += gauss_12.weight[i] * F[i] * rises[i];
  return reach * of_stage - 0.5 * compliance_ * (force_to_ * force_to_ - force_from_ * force_from_);
}

double SlidingPiece::force_at(double stage) const {
  const double share = (stage - stage_from_) / (stage_to_ - stage_from_);
  if (!(share > 0)) return force_from_;
  if (!(share < 1)) return force_to_;
  const auto miss = [&](double t) {
    const auto [value, slope] = series_slope_at(stage_, t);
    return ValueAndSlope{value - stage, slope};
  };
  return series_at(F_, zero_between(miss, begin_, end_, begin_ + (end_ - begin_) * share, close));
}

SlidingPiece::Turns SlidingPiece::turns() const {
  const CurvePiece::Values force = Polynomial::bernstein(piece_.F);
  SlopeOf::Bernstein slope{};
  for (std::size_t i = 0; i < degree; ++i) slope[i] = force[i + 1] - force[i];
  SlopeOf::Zeros zeros;
  SlopeOf{derivative(F_)}.add_zeros(slope, -1, 1, 0, zeros);
  Turns turns{};
  for (const double t : std::span(zeros.at).first(zeros.count))
    if (begin_ < t && t < end_)
      turns.at[turns.count++] = {piece_.coordinate_at(t), std::clamp(series_at(stage_, t), stage_from_, stage_to_),
                                 series_at(F_, t)};
  return turns;
}

}  // namespace flexslip
