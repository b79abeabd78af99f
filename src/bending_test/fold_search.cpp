#include "bending_test/fold_search.h"

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

#include "bending_test/curve_samples.h"
#include "bending_test/interpolant.h"
#include "bending_test/polynomial.h"

namespace flexslip {
namespace {

constexpr std::size_t degree = 8;
using Polynomial = Interpolant<degree>;
using Values = Polynomial::Values;

// Halvings of a cell, after which two folds in one piece are taken for none: 1e-6 of the roughness's period.
constexpr int most_halvings = 20;
// How well G' is known, relative to its terms: what interpolation cannot better, and within which no fold is to be found.
constexpr double exact_error = 64 * std::numeric_limits<double>::epsilon();

// Where G' changes sign once.
struct Bracket {
  double low, high;  // of x
  double x;          // a guess
  double bend;       // dG'/dx there
  bool rising;       // G' < 0 at low
};

// Samples at the nodes between two points of the way.
using Nodes = std::span<const CurveSample, degree + 1>;
struct Cell {
  double a, b;
  bool ends_at_corner = false;
};

// Where friction has a corner: points a hair before and behind it, between which the slope of the curve jumps.
struct Corner {
  double before, behind;
  std::optional<Bracket> fold;  // if the slope changes its sign there
};

double node_in(const Cell& cell, std::size_t j) {
  return j == 0 ? cell.a : j == degree ? cell.b : cell.a + 0.5 * (cell.b - cell.a) * (1 + Polynomial::node(j));
}

// Walks a sliding curve and gathers its folds.
class FoldSearch {
 public:
  FoldSearch(const Friction& friction, const Rig& rig, Sliding sliding)
      : friction_(friction), rig_(rig), sliding_(sliding) {}

  SlidingCurve along(double S_from, double S_to) {
    const CurveSample first = sample(way_at(rig_.fibre, sliding_, S_from));
    if (!first.exists)
      throw std::invalid_argument("no fibre of the length S = " + std::to_string(S_from) + " slides out under a force");
    double S = S_from;
    double x = way_at(rig_.fibre, sliding_, S_from);
    std::optional<double> ended;  // a point beyond the end of the branch
    while (S != S_to && !ended) {
      std::vector<Cell> cells;
      for (double a = x; cells.size() < cells_at_once && S != S_to; a = cells.back().b) {
        S = end_of_stretch(friction_, rig_.fibre, S, S_to, 1);
        cells.push_back({a, way_at(rig_.fibre, sliding_, S), S != S_to && is_corner(S)});
      }
      ended = search(cells, x);
    }
    CurveEnd reason = CurveEnd::reached;
    while (ended) {
      // the last cell, up to where the branch ends, and that without what was found in it before
      reason = CurveEnd::branch_ended;
      const double end = last_existing(x, *ended);
      std::erase_if(brackets_, [&](const Bracket& bracket) { return bracket.low >= x; });
      ended = std::nullopt;
      if (end > x) ended = isolate_in({x, end}, exact, 0);
      if (!ended) x = end;
    }
    std::vector<Fold> folds = polished_folds();
    // Between the nodes of a cell there may be a stretch without states, at one end of which the branch then ends.
    const auto lost =
        std::find_if(folds.begin(), folds.end(), [](const Fold& fold) { return std::isnan(fold.point.stage); });
    if (lost != folds.end()) {
      x = last_existing(brackets_[static_cast<std::size_t>(lost - folds.begin())].low,
                        way_at(rig_.fibre, sliding_, lost->point.S));
      reason = CurveEnd::branch_ended;
      folds.erase(lost, folds.end());
    }
    return {friction_, rig_, sliding_, first.point, std::move(folds), sample(x).point, reason, looked_at_};
  }

 private:
  static constexpr std::size_t cells_at_once = 64;

  CurveSample sample(double x) const { return sample_at(friction_, rig_, sliding_, x); }

  double last_existing(double exists, double ended) const {
    while (true) {
      const double middle = 0.5 * (exists + ended);
      if (!(middle > exists && middle < ended)) return exists;
      (sample(middle).exists ? exists : ended) = middle;
    }
  }

  bool is_corner(double S) const {
    const auto knots = friction_.knots();
    return friction_.has_corners() && std::binary_search(knots.begin(), knots.end(), S);
  }

  std::optional<Corner> corner_at_end(const Cell& cell) const {
    constexpr double hair = 1e-9;  // of the cell: beyond how well a knot on rollers is known
    constexpr double jump = 1e-6;  // of the slope, relative to its scale: less is resolved without
    if (!cell.ends_at_corner) return std::nullopt;
    const double before = cell.b - hair * (cell.b - cell.a), behind = cell.b + hair * (cell.b - cell.a);
    const auto beside = tabulated_samples_at(friction_, rig_, sliding_, std::array{before, behind});
    const auto& [low, high] = std::pair(beside[0], beside[1]);
    if (!low.exists || !high.exists || std::abs(high.slope - low.slope) <= jump * std::max(low.scale, high.scale))
      return std::nullopt;
    Corner corner{before, behind, std::nullopt};
    if ((low.slope < 0) != (high.slope < 0))
      corner.fold = {before, behind, cell.b, (high.slope - low.slope) / (behind - before), low.slope < 0};
    return corner;
  }

  // Adjacent cells. x follows to the end of the last that is wholly on the branch.
  std::optional<double> search(const std::vector<Cell>& cells, double& x) {
    std::vector<double> at;
    at.reserve(cells.size() * degree + 1);
    for (const Cell& cell : cells)
      for (std::size_t j = 0; j < degree; ++j) at.push_back(node_in(cell, j));
    at.push_back(cells.back().b);
    const auto samples = tabulated_samples_at(friction_, rig_, sliding_, at);
    looked_at_ += at.size();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto corner = corner_at_end(cells[i]);
      const auto ended = corner || x != cells[i].a
                             ? isolate_in({x, corner ? corner->before : cells[i].b}, table, 0)
                             : isolate(cells[i], Nodes(&samples[i * degree], degree + 1), table, 0);
      if (ended) return ended;
      if (corner && corner->fold) brackets_.push_back(*corner->fold);
      x = corner ? corner->behind : cells[i].b;
    }
    return std::nullopt;
  }

  using Sampler = std::vector<CurveSample> (*)(const Friction&, const Rig&, Sliding, std::span<const double>);
  struct Source {
    Sampler sampler;
    double error;         // of slopes, relative to their scale
    const Source* finer;  // where this cannot decide; none: halve the cell
  };
  static constexpr Source exact{samples_at, exact_error, nullptr};
  static constexpr Source table{tabulated_samples_at, tabulated_error, &exact};

  std::optional<double> isolate_in(const Cell& cell, const Source& source, int halvings) {
    std::array<double, degree + 1> at;
    for (std::size_t j = 0; j <= degree; ++j) at[j] = node_in(cell, j);
    const auto samples = source.sampler(friction_, rig_, sliding_, at);
    looked_at_ += at.size();
    return isolate(cell, Nodes(samples), source, halvings);
  }

  // Brackets the folds between two points of the way; or, if the branch ends there, gives a point beyond its end. What the table resolves
  // but cannot decide is looked at again on the exact map.
  std::optional<double> isolate(const Cell& cell, Nodes samples, const Source& source, int halvings) {
    Values values;
    double scale = 0;
    for (std::size_t j = 0; j <= degree; ++j) {
      if (!samples[j].exists) return node_in(cell, j);
      values[j] = samples[j].slope;
      scale = std::max(scale, samples[j].scale);
    }
    const Values coefficients = Polynomial::chebyshev(values);
    const double tail = std::abs(coefficients[degree]) + std::abs(coefficients[degree - 1]);
    const Values bernstein = Polynomial::bernstein(values);
    const auto [least, greatest] = std::minmax_element(bernstein.begin(), bernstein.end());

    constexpr double accuracy = 1e-6;
    const double at_a = values.front();
    const double at_b = values.back();
    const bool changes_sign = (at_a < 0) != (at_b < 0);
    const bool smooth = !friction_.may_be_held() || !may_have_kink(cell);
    const bool resolved =
        smooth && tail <= (accuracy + exact_error / friction_.smooth_scale()) * scale;  // S itself is rounded, too
    const double least_error = (rig_.fibre.on_edges() ? source.error : tabulated_error) * scale;
    const double error = std::max(4 * tail, least_error);
    if (resolved && !changes_sign && (*least > error || *greatest < -error)) return std::nullopt;
    const bool single = resolved && sign_changes(bernstein) == 1 && std::min(std::abs(at_a), std::abs(at_b)) > error;
    // Along a load line G is level: no halving would tell more than that G' is within its error.
    const bool level = resolved && !source.finer && std::max(-*least, *greatest) <= least_error;
    const bool smallest = halvings == most_halvings || level;
    if (changes_sign && (single || smallest)) {
      add_bracket(cell, at_a < 0, bernstein);
    } else if (resolved && source.finer) {
      return isolate_in(cell, *source.finer, halvings);
    } else if (!smallest) {
      const double middle = 0.5 * (cell.a + cell.b);
      if (const auto ended = isolate_in({cell.a, middle}, source, halvings + 1)) return ended;
      return isolate_in({middle, cell.b}, source, halvings + 1);
    }
    return std::nullopt;
  }

  // May friction begin or end to be held at zero in a cell?
  bool may_have_kink(const Cell& cell) const {
    Values mu;
    for (std::size_t j = 0; j <= degree; ++j) {
      const double x = node_in(cell, j);
      mu[j] = friction_.unheld(rig_.fibre.length_at(x));
    }
    const Values bernstein = Polynomial::bernstein(mu);
    const auto [least, greatest] = std::minmax_element(bernstein.begin(), bernstein.end());
    return *least <= 0 && *greatest >= 0;
  }

  void add_bracket(const Cell& cell, bool rising, const Values& bernstein) {
    constexpr double close = 1e-7;  // below what the interpolant is worth
    const auto slope_at = [&](double t) { return bernstein_at(bernstein, t); };
    const double t = zero_between(slope_at, 0.0, 1.0, 0.5, rising, close);
    const double length = cell.b - cell.a;
    brackets_.push_back({cell.a, cell.b, cell.a + t * length, bernstein_at(bernstein, t).slope / length, rising});
  }

  // The folds themselves, by Newton's iteration kept within the brackets, for all of them at once.
  std::vector<Fold> polished_folds() const {
    std::vector<Bracket> brackets = brackets_;
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
        Bracket& bracket = brackets[active[j]];
        const CurveSample& there = samples[j];
        folds[active[j]] = {there.point, !bracket.rising};
        ((there.slope < 0) == bracket.rising ? bracket.low : bracket.high) = bracket.x;
        double next = bracket.x - there.slope / bracket.bend;
        // Smooth folds are there after three steps; at a corner of friction the bend is another on either side.
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
  std::vector<Bracket> brackets_;
  std::size_t looked_at_ = 0;
};

}  // namespace

SlidingCurve find_folds(const Friction& friction, const Rig& rig, Sliding sliding, double S_from, double S_to) {
  return FoldSearch(friction, rig, sliding).along(S_from, S_to);
}

}  // namespace flexslip
