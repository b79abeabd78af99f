#include "bending_test/trace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bending_test/sliding_piece.h"
#include "bending_test/sliding_table.h"
#include "contact/over_rollers.h"
#include "numerics/elementary.h"
#include "numerics/interpolant.h"
#include "numerics/polynomial.h"
#include "numerics/root.h"

namespace flexslip {
namespace {

// Periods of friction in one trace, limited to a few seconds.
constexpr double max_periods = 1e6;

void require_traceable(const Friction& friction, const Rig& rig, double S_max) {
  if (!(rig.stiffness > 0))
    throw std::invalid_argument("rig stiffness must be positive, not " + std::to_string(rig.stiffness));
  if (!(S_max > 1 && S_max < infinity))
    throw std::invalid_argument("S_max must be above 1 and finite, not " + std::to_string(S_max));
  constexpr double finest = 1e-9;  // [L] shorter periods are lost in the rounding of S
  if (4 * friction.smooth_scale() < finest)
    throw std::invalid_argument("a period of the roughness of " + std::to_string(4e9 * friction.smooth_scale()) +
                                "e-9 spans is finer than 1e-9 spans, the finest that is traced");
  const double periods = (S_max - 1) / (4 * friction.smooth_scale());
  if (periods > max_periods)
    throw std::invalid_argument("the roughness has " + std::to_string(periods) +
                                " periods on this length; at most 1e6 are traced");
}

constexpr std::size_t cell_degree = 8;
using CellPolynomial = Interpolant<cell_degree>;
using CellValues = CellPolynomial::Values;

// Halvings of a cell, to 1e-6 of the period of friction; two folds closer than this are ignored.
constexpr int max_halvings = 20;
// The relative error of G' that interpolation cannot improve, and within which no fold can be
// found.
constexpr double exact_error = 64 * std::numeric_limits<double>::epsilon();

// An interval in which G' changes sign once.
struct FoldBracket {
  double low, high;  // in x
  double x;          // a guess
  double bend;       // dG'/dx there
  bool rising;       // G' < 0 at low
};

// Samples at the nodes between two values of x.
using Nodes = std::span<const CurveSample, cell_degree + 1>;
struct Cell {
  double a, b;
  bool ends_at_corner = false;
};

// A corner of friction: points just before and after it, between which the slope of the curve
// jumps.
struct Corner {
  double before, behind;
  std::optional<FoldBracket> fold;  // if the slope changes its sign there
};

double node_in(const Cell& cell, std::size_t j) {
  return j == 0 ? cell.a : j == cell_degree ? cell.b : cell.a + 0.5 * (cell.b - cell.a) * (1 + CellPolynomial::node(j));
}

// dG/dt of a piece, t in [-1, 1].
constexpr std::size_t piece_degree = CurvePiece::degree;
struct PieceSlope {
  using Bernstein = std::array<double, piece_degree>;
  const CurvePiece& piece;
  std::array<double, piece_degree> series;  // Chebyshev coefficients
  double error;
};

// Follows a sliding curve and collects its folds.
class FoldSearch {
 public:
  FoldSearch(const Friction& friction, const Rig& rig, Sliding sliding)
      : friction_(friction), rig_(rig), sliding_(sliding) {}

  SlidingCurve along(double S_from, double S_to) {
    const CurveSample first = sample(coordinate_at(rig_.fibre, sliding_, S_from));
    if (!first.exists)
      throw std::invalid_argument("no fibre of the length S = " + std::to_string(S_from) + " slides out under a force");
    double S = S_from;
    double x = coordinate_at(rig_.fibre, sliding_, S_from), edge = x;
    std::optional<double> ended;  // a point beyond the end of the branch
    while (S != S_to && !ended) {
      std::vector<Cell> cells;
      while (cells.size() < cells_at_once && S != S_to) {
        S = end_of_stretch(friction_, rig_.fibre, S, S_to, CurvePiece::longest);
        cells.push_back({edge, coordinate_at(rig_.fibre, sliding_, S), S != S_to && friction_.has_corner_at(S)});
        edge = cells.back().b;
      }
      ended = search(cells, x);
    }
    CurveEnd reason = CurveEnd::reached;
    while (ended) {
      // repeats the last cell up to the end of the branch, without the folds found in it before
      reason = CurveEnd::branch_ended;
      const double end = last_existing(x, *ended);
      std::erase_if(brackets_, [&](const FoldBracket& bracket) { return bracket.low >= x; });
      ended = std::nullopt;
      if (end > x) ended = isolate_in({x, end}, 0);
      if (!ended) x = end;
    }
    std::vector<Fold> folds = polished_folds();
    // Between the nodes of a cell an interval may have no states; the branch then ends at one of
    // its ends.
    const auto lost =
        std::find_if(folds.begin(), folds.end(), [](const Fold& fold) { return std::isnan(fold.point.stage); });
    if (lost != folds.end()) {
      x = last_existing(brackets_[static_cast<std::size_t>(lost - folds.begin())].low,
                        coordinate_at(rig_.fibre, sliding_, lost->point.S));
      reason = CurveEnd::branch_ended;
      folds.erase(lost, folds.end());
    }
    return {friction_,       rig_,   sliding_,   first.point,       std::move(folds),
            sample(x).point, reason, looked_at_, std::move(pieces_)};
  }

 private:
  static constexpr std::size_t cells_at_once = 64;
  static constexpr std::size_t max_pieces = 1 << 16;  // 20 MB
  // of its slopes: the neglected coefficients are a third of the last ones
  static constexpr double resolved_piece = 1e-5;
  static constexpr double accuracy = 1e-6;      // of interpolated slopes
  static constexpr double close = 1e-7;         // of their zeros: below the error of an interpolant
  static constexpr double value_error = 1e-12;  // of tabulated stage positions

  CurveSample sample(double x) const { return sample_at(friction_, rig_, sliding_, x); }

  double last_existing(double exists, double ended) const {
    return halved(200, {exists, ended}, [&](double x) { return !sample(x).exists; }).low;
  }

  std::optional<Corner> corner_at_end(const Cell& cell) const {
    constexpr double hair = 1e-9;  // of the cell: above the error of a knot on rollers
    constexpr double jump = 1e-6;  // of the slope relative to its scale: less needs no corner
    if (!cell.ends_at_corner) return std::nullopt;
    const double before = cell.b - hair * (cell.b - cell.a), behind = cell.b + hair * (cell.b - cell.a);
    const auto samples_beside = samples_at(friction_, rig_, sliding_, std::array{before, behind});
    const auto& [low, high] = std::pair(samples_beside[0], samples_beside[1]);
    if (!low.exists || !high.exists || std::abs(high.slope - low.slope) <= jump * std::max(low.scale, high.scale))
      return std::nullopt;
    Corner corner{before, behind, std::nullopt};
    if ((low.slope < 0) != (high.slope < 0))
      corner.fold = {before, behind, cell.b, (high.slope - low.slope) / (behind - before), low.slope < 0};
    return corner;
  }

  // Searches adjacent cells. x follows to the end of the last cell wholly on the branch.
  std::optional<double> search(const std::vector<Cell>& cells, double& x) {
    std::vector<double> ends{cells.front().a};
    ends.reserve(cells.size() + 1);
    for (const Cell& cell : cells) ends.push_back(cell.b);
    const std::vector<CurvePiece> pieces = pieces_between(friction_, rig_, sliding_, ends);
    looked_at_ += pieces.size() * CurvePiece::degree;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto corner = corner_at_end(cells[i]);
      const auto ended =
          corner || x != cells[i].a ? isolate_in({x, corner ? corner->before : cells[i].b}, 0) : isolate(pieces[i]);
      if (ended) return ended;
      if (corner && corner->fold) brackets_.push_back(*corner->fold);
      x = corner ? corner->behind : cells[i].b;
      if (pieces_.size() < max_pieces) pieces_.push_back(pieces[i]);
    }
    return std::nullopt;
  }

  // Brackets the folds of a piece, or returns a point beyond the end of the branch. If the
  // polynomial is inconclusive, slopes are computed.
  std::optional<double> isolate(const CurvePiece& piece) {
    double max_stage = 0;
    for (std::size_t j = 0; j <= piece_degree; ++j) {
      if (std::isnan(piece.F[j])) return piece.coordinate_of(j);
      max_stage = std::max(max_stage, std::abs(piece.stage[j]));
    }
    const CurvePiece::Values stage = CurvePiece::Polynomial::bernstein(piece.stage);
    PieceSlope slope{piece, derivative(CurvePiece::Polynomial::chebyshev(piece.stage)), 0};
    PieceSlope::Bernstein bernstein;
    double greatest = 0;
    for (std::size_t j = 0; j < piece_degree; ++j) {
      bernstein[j] = 0.5 * piece_degree * (stage[j + 1] - stage[j]);
      greatest = std::max(greatest, std::abs(bernstein[j]));
    }
    const double tail = std::abs(slope.series[piece_degree - 1]) + std::abs(slope.series[piece_degree - 2]);
    // from the error of values to the error of slopes
    constexpr double amplified = piece_degree * piece_degree;
    slope.error = std::max(4 * tail, amplified * value_error * max_stage);
    const bool is_smooth = !friction_.may_reach_zero() || !may_have_kink({piece.from, piece.to});
    if (!is_smooth || tail > resolved_piece * greatest) return isolate_in({piece.from, piece.to}, 0);
    return isolate(slope, bernstein, -1, 1, 0);
  }

  // The part of a piece from low to high, by the Bernstein coefficients of its slope.
  std::optional<double> isolate(const PieceSlope& slope, const PieceSlope::Bernstein& bernstein, double low,
                                double high, int halvings) {
    constexpr int max_halvings_of_values = 6;  // beyond it, sampling is as fast
    const auto [least, greatest] = std::minmax_element(bernstein.begin(), bernstein.end());
    if (*least > slope.error || *greatest < -slope.error) return std::nullopt;
    const Cell cell{slope.piece.coordinate_at(low), slope.piece.coordinate_at(high)};
    const bool rising = bernstein.front() < 0;
    if (sign_changes(bernstein) == 1 &&
        std::min(std::abs(bernstein.front()), std::abs(bernstein.back())) > slope.error) {
      const auto at = [&](double t) { return series_slope_at(slope.series, t); };
      const double t = zero_between(at, rising ? low : high, rising ? high : low, 0.5 * (low + high), close);
      const double by_t = 0.5 * (slope.piece.to - slope.piece.from);
      brackets_.push_back({cell.a, cell.b, slope.piece.coordinate_at(t), at(t).slope / (by_t * by_t), rising});
      return std::nullopt;
    }
    if (halvings == max_halvings_of_values) return isolate_in(cell, 0);
    const auto [left, right] = bernstein_halves(bernstein);
    const double middle = 0.5 * (low + high);
    if (const auto ended = isolate(slope, left, low, middle, halvings + 1)) return ended;
    return isolate(slope, right, middle, high, halvings + 1);
  }

  // The error of slopes relative to their scale. On rollers or with a thickness all states come
  // from tables.
  double slope_error() const { return rig_.fibre.on_edges() ? exact_error : tabulated_error; }

  std::optional<double> isolate_in(const Cell& cell, int halvings) {
    std::array<double, cell_degree + 1> at;
    for (std::size_t j = 0; j <= cell_degree; ++j) at[j] = node_in(cell, j);
    const auto samples = samples_at(friction_, rig_, sliding_, at);
    looked_at_ += at.size();
    return isolate(cell, Nodes(samples), halvings);
  }

  // Brackets the folds of a cell by slopes, halving it until they decide.
  std::optional<double> isolate(const Cell& cell, Nodes samples, int halvings) {
    CellValues values;
    double scale = 0;
    for (std::size_t j = 0; j <= cell_degree; ++j) {
      if (!samples[j].exists) return node_in(cell, j);
      values[j] = samples[j].slope;
      scale = std::max(scale, samples[j].scale);
    }
    const CellValues coefficients = CellPolynomial::chebyshev(values);
    const double tail = std::abs(coefficients[cell_degree]) + std::abs(coefficients[cell_degree - 1]);
    const CellValues bernstein = CellPolynomial::bernstein(values);
    const auto [least, greatest] = std::minmax_element(bernstein.begin(), bernstein.end());

    const double at_a = values.front();
    const double at_b = values.back();
    const bool changes_sign = (at_a < 0) != (at_b < 0);
    const bool smooth = !friction_.may_reach_zero() || !may_have_kink(cell);
    const bool resolved =
        // S itself is rounded
        smooth && tail <= (accuracy + exact_error / friction_.smooth_scale()) * scale;
    const double min_error = slope_error() * scale;
    const double error = std::max(4 * tail, min_error);
    if (resolved && !changes_sign && (*least > error || *greatest < -error)) return std::nullopt;
    const bool single = resolved && sign_changes(bernstein) == 1 && std::min(std::abs(at_a), std::abs(at_b)) > error;
    // Along a load line G is constant; bisection would only confirm that G' is zero within its
    // error.
    const bool level = resolved && std::max(-*least, *greatest) <= min_error;
    const bool smallest = halvings == max_halvings || level;
    if (changes_sign && (single || smallest)) {
      add_bracket(cell, at_a < 0, bernstein);
    } else if (!smallest) {
      const double middle = 0.5 * (cell.a + cell.b);
      if (const auto ended = isolate_in({cell.a, middle}, halvings + 1)) return ended;
      return isolate_in({middle, cell.b}, halvings + 1);
    }
    return std::nullopt;
  }

  // True if friction may begin or cease to be limited at zero in a cell.
  bool may_have_kink(const Cell& cell) const {
    CellValues mu;
    for (std::size_t j = 0; j <= cell_degree; ++j) {
      const double x = node_in(cell, j);
      mu[j] = friction_.without_limit(rig_.fibre.length_at(x));
    }
    const CellValues bernstein = CellPolynomial::bernstein(mu);
    const auto [least, greatest] = std::minmax_element(bernstein.begin(), bernstein.end());
    return *least <= 0 && *greatest >= 0;
  }

  void add_bracket(const Cell& cell, bool rising, const CellValues& bernstein) {
    const auto slope_at = [&](double t) { return bernstein_at(bernstein, t); };
    const double t = zero_between(slope_at, rising ? 0.0 : 1.0, rising ? 1.0 : 0.0, 0.5, close);
    const double length = cell.b - cell.a;
    brackets_.push_back({cell.a, cell.b, cell.a + t * length, bernstein_at(bernstein, t).slope / length, rising});
  }

  // The folds, by Newton's iteration within all brackets at once.
  std::vector<Fold> polished_folds() const {
    std::vector<FoldBracket> brackets = brackets_;
    std::vector<Fold> folds(brackets.size());
    std::vector<std::size_t> active(brackets.size());
    for (std::size_t i = 0; i < active.size(); ++i) active[i] = i;
    for (int iteration = 0; iteration < 100 && !active.empty(); ++iteration) {
      std::vector<double> at;
      at.reserve(active.size());
      for (const std::size_t i : active) at.push_back(brackets[i].x);
      const auto samples = samples_at(friction_, rig_, sliding_, at);
      std::size_t left = 0;
      for (std::size_t j = 0; j < active.size(); ++j) {
        FoldBracket& bracket = brackets[active[j]];
        const CurveSample& there = samples[j];
        folds[active[j]] = {there.point, !bracket.rising};
        ((there.slope < 0) == bracket.rising ? bracket.low : bracket.high) = bracket.x;
        double next = bracket.x - there.slope / bracket.bend;
        // Smooth folds converge in three steps. At a corner of friction the second derivative
        // jumps.
        const bool creeps = iteration > 4 && iteration % 2 == 0;
        if (creeps || !(next > bracket.low && next < bracket.high)) next = 0.5 * (bracket.low + bracket.high);
        const bool done = std::abs(there.slope) <= exact_error * there.scale ||
                          std::abs(next - bracket.x) <= 0x1p-51 * std::abs(next) ||
                          !(next > bracket.low && next < bracket.high);
        bracket.x = next;
        if (!done) active[left++] = active[j];
      }
      active.resize(left);
    }
    return folds;
  }

  const Friction& friction_;
  const Rig& rig_;
  Sliding sliding_;
  std::vector<FoldBracket> brackets_;
  std::vector<CurvePiece> pieces_;
  std::size_t looked_at_ = 0;
};

}  // namespace

SlidingCurve trace_loading_curve(const Friction& friction, const Rig& rig, double S_max) {
  require_traceable(friction, rig, S_max);
  return FoldSearch(met(friction, rig.fibre, 1, S_max), rig, Sliding::in).along(1, S_max);
}

SlidingCurve trace_unloading_curve(const Friction& friction, const Rig& rig, double S_from) {
  require_traceable(friction, rig, S_from);
  return FoldSearch(met(friction, rig.fibre, -1, S_from), rig, Sliding::out).along(S_from, 1);
}

}  // namespace flexslip
