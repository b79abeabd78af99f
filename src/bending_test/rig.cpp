#include "bending_test/rig.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>

#include "fibre/elastica.h"

namespace flexslip {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// A way along a curve: x = σ = √(S - 1) for a fibre drawn in, x = -σ for one let out, so that x rises on either.
// In σ the curve has no singularity at its start: dw/dσ -> √15/6 and F -> 48 w.
double direction_of(Sliding sliding) { return sliding == Sliding::in ? 1 : -1; }

double way_at(Sliding sliding, double S) { return direction_of(sliding) * std::sqrt(S - 1); }

struct Sample {
  bool exists;
  RigPoint point;
  double slope;  // dG/dx
  double scale;  // size of its terms
};

Sample sample_at(const Friction& friction, const Rig& rig, Sliding sliding, double x) {
  const double direction = direction_of(sliding);
  const double c = 1 / rig.stiffness;
  const double S = 1 + x * x;
  const double sigma = std::sqrt(S - 1);  // that of the rounded S, at which everything below is evaluated
  const auto mu = friction.at(S);
  const double q = direction * mu.mu;
  if (S == 1) {
    const double slope = std::sqrt(15.0) / 6 * (1 + 48 * c);
    return {true, {1, q, 0, 0, 0, infinity}, direction * slope, slope};
  }
  const auto [state, slopes] = fibre_state_slopes(S, q);
  if (state.status != FibreStatus::ok) return {false, {}, 0, 0};
  const double smooth = slopes.w_S + c * slopes.F_S;
  const double rough = direction * (slopes.w_q + c * slopes.F_q) * mu.slope;
  return {.exists = true,
          .point = {S, q, state.w, state.F, state.w + c * state.F, smooth + rough},
          .slope = direction * 2 * sigma * (smooth + rough),
          .scale = 2 * sigma * (slopes.w_S + c * std::abs(slopes.F_S) + std::abs(rough))};
}

Sample sample_on(const SlidingCurve& curve, double x) { return sample_at(curve.friction, curve.rig, curve.sliding, x); }

// A polynomial through the values at the Chebyshev-Lobatto points of [-1, 1], which include the ends.
constexpr int degree = 8;
using Values = std::array<double, degree + 1>;

double node(int j) { return -std::cos(std::numbers::pi * j / degree); }

// From values at the nodes to Chebyshev coefficients, and from these to Bernstein coefficients; both are linear maps.
struct Basis {
  std::array<Values, degree + 1> chebyshev{};
  std::array<Values, degree + 1> bernstein{};
  Basis() {
    for (int k = 0; k <= degree; ++k)
      for (int j = 0; j <= degree; ++j) {
        const double end_j = j == 0 || j == degree ? 0.5 : 1.0;
        const double end_k = k == 0 || k == degree ? 0.5 : 1.0;
        const double sign = k % 2 ? -1 : 1;  // nodes run from -1 to 1
        chebyshev[static_cast<std::size_t>(k)][static_cast<std::size_t>(j)] =
            sign * 2.0 / degree * end_j * end_k * std::cos(std::numbers::pi * k * j / degree);
      }
    // T_k = Σ_i (-1)^(k-i) C(2k, 2i)/C(k, i) B_i^k, raised from degree k to the full degree.
    const auto binomial = [](int n, int r) {
      double value = 1;
      for (int i = 1; i <= r; ++i) value = value * (n - r + i) / i;
      return value;
    };
    std::array<Values, degree + 1> from_chebyshev{};
    for (int k = 0; k <= degree; ++k)
      for (int j = 0; j <= degree; ++j) {
        double sum = 0;
        for (int i = std::max(0, j + k - degree); i <= std::min(j, k); ++i)
          sum += ((k - i) % 2 ? -1 : 1) * binomial(2 * k, 2 * i) * binomial(degree - k, j - i);
        from_chebyshev[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)] = sum / binomial(degree, j);
      }
    for (std::size_t i = 0; i <= degree; ++i)
      for (std::size_t j = 0; j <= degree; ++j)
        for (std::size_t k = 0; k <= degree; ++k) bernstein[i][j] += from_chebyshev[i][k] * chebyshev[k][j];
  }
};

Values apply(const std::array<Values, degree + 1>& map, const Values& values) {
  Values result{};
  for (std::size_t i = 0; i <= degree; ++i)
    for (std::size_t j = 0; j <= degree; ++j) result[i] += map[i][j] * values[j];
  return result;
}

// Value and derivative of a Bernstein polynomial at t in [0, 1] (de Casteljau).
std::pair<double, double> evaluate(Values b, double t) {
  double slope = 0;
  for (std::size_t n = degree; n > 0; --n) {
    if (n == 1) slope = degree * (b[1] - b[0]);
    for (std::size_t i = 0; i < n; ++i) b[i] += t * (b[i + 1] - b[i]);
  }
  return {b[0], slope};
}

// A root of f in (low, high), where f(low) and f(high) differ in sign (rising: f(low) < 0), by Newton's iteration kept
// within the bracket. f returns the value and the slope.
template <class Function>
double bracketed_root(Function f, double low, double high, double x, bool rising) {
  for (int iteration = 0; iteration < 100; ++iteration) {
    const auto [value, slope] = f(x);
    if (value == 0) return x;
    ((value < 0) == rising ? low : high) = x;
    double next = x - value / slope;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const double step = std::abs(next - x);
    x = next;
    if (step <= 0x1p-51 * std::abs(x) || !(x > low && x < high)) break;
  }
  return x;
}

// Halvings of a cell, after which two folds in one piece are taken for none: 1e-6 of the roughness's period.
constexpr int most_halvings = 20;
// Periods of the roughness in one trace, beyond which it would take more than a minute.
constexpr double most_periods = 1e6;

// Walks a sliding curve and gathers its folds.
class Tracer {
 public:
  Tracer(const Friction& friction, const Rig& rig, Sliding sliding)
      : friction_(friction), rig_(rig), sliding_(sliding) {}

  SlidingCurve trace(double S_from, double S_to) {
    const Sample first = sample(way_at(sliding_, S_from));
    if (!first.exists)
      throw std::invalid_argument("no fibre of the length S = " + std::to_string(S_from) + " slides out under a force");
    CurveEnd reason = CurveEnd::reached;
    Sample from = first;
    double x = way_at(sliding_, S_from);
    for (double S = S_from; S != S_to && reason == CurveEnd::reached;) {
      S = end_of_stretch(friction_, S, S_to, 2);
      double next = way_at(sliding_, S);
      Sample to = sample(next);
      const auto folds_before = folds_.size();
      auto missing = to.exists ? isolate(x, from, next, to, 0) : std::optional(next);
      while (missing) {
        reason = CurveEnd::branch_ended;
        next = last_existing(x, *missing);
        to = sample(next);
        folds_.resize(folds_before);
        missing = next > x ? isolate(x, from, next, to, 0) : std::nullopt;
      }
      x = next;
      from = to;
    }
    return {friction_, rig_, sliding_, first.point, std::move(folds_), from.point, reason};
  }

 private:
  Sample sample(double x) const { return sample_at(friction_, rig_, sliding_, x); }

  double last_existing(double exists, double ended) const {
    while (true) {
      const double middle = 0.5 * (exists + ended);
      if (!(middle > exists && middle < ended)) return exists;
      (sample(middle).exists ? exists : ended) = middle;
    }
  }

  // Gathers the folds between two points of the way; or, if the branch ends there, gives a point beyond its end.
  std::optional<double> isolate(double a, const Sample& at_a, double b, const Sample& at_b, int halvings) {
    std::array<Sample, degree + 1> samples;
    samples.front() = at_a;
    samples.back() = at_b;
    for (int j = 1; j < degree; ++j) {
      const double x = a + 0.5 * (b - a) * (1 + node(j));
      samples[static_cast<std::size_t>(j)] = sample(x);
      if (!samples[static_cast<std::size_t>(j)].exists) return x;
    }
    Values values;
    double scale = 0;
    for (std::size_t j = 0; j <= degree; ++j) {
      values[j] = samples[j].slope;
      scale = std::max(scale, samples[j].scale);
    }
    const Values coefficients = apply(basis().chebyshev, values);
    const double tail = std::abs(coefficients[degree]) + std::abs(coefficients[degree - 1]);
    const Values bernstein = apply(basis().bernstein, values);
    const auto [least, greatest] = std::minmax_element(bernstein.begin(), bernstein.end());
    int changes = 0;
    for (std::size_t i = 0; i < degree; ++i) changes += (bernstein[i] < 0) != (bernstein[i + 1] < 0);

    // Interpolation cannot do better than the rounding of G', and no fold is to be found within that.
    constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
    constexpr double accuracy = 1e-6;
    const bool changes_sign = (at_a.slope < 0) != (at_b.slope < 0);
    const bool smooth = !friction_.may_be_held() || !may_have_kink(a, b);
    const bool resolved =
        smooth && tail <= (accuracy + rounding / friction_.smooth_scale()) * scale;  // S itself is rounded, too
    const double error = std::max(4 * tail, rounding * scale);
    if (resolved && !changes_sign && (*least > error || *greatest < -error)) return std::nullopt;
    const bool single = resolved && changes == 1 && std::min(std::abs(at_a.slope), std::abs(at_b.slope)) > error;
    const bool smallest = halvings == most_halvings;
    if (changes_sign && (single || smallest)) {
      add_fold(a, b, at_a.slope < 0, bernstein);
    } else if (!smallest) {
      const double middle = 0.5 * (a + b);
      const Sample at_middle = samples[degree / 2];  // the middle node is the midpoint
      if (const auto missing = isolate(a, at_a, middle, at_middle, halvings + 1)) return missing;
      return isolate(middle, at_middle, b, at_b, halvings + 1);
    }
    return std::nullopt;
  }

  // May friction begin or end to be held at zero between two points of the way?
  bool may_have_kink(double a, double b) const {
    Values mu;
    for (int j = 0; j <= degree; ++j) {
      const double x = a + 0.5 * (b - a) * (1 + node(j));
      mu[static_cast<std::size_t>(j)] = friction_.unheld(1 + x * x);
    }
    const Values bernstein = apply(basis().bernstein, mu);
    const auto [least, greatest] = std::minmax_element(bernstein.begin(), bernstein.end());
    return *least <= 0 && *greatest >= 0;
  }

  void add_fold(double a, double b, bool rising, const Values& bernstein) {
    const double t = bracketed_root([&](double x) { return evaluate(bernstein, x); }, 0.0, 1.0, 0.5, rising);
    const double x = bracketed_root(
        [&](double at) {
          const double slope = evaluate(bernstein, (at - a) / (b - a)).second / (b - a);
          return std::pair{sample(at).slope, slope};
        },
        a, b, a + t * (b - a), rising);
    folds_.push_back({sample(x).point, !rising});
  }

  static const Basis& basis() {
    static const Basis value;
    return value;
  }

  const Friction& friction_;
  const Rig& rig_;
  Sliding sliding_;
  std::vector<Fold> folds_;
};

// Stage positions in the sense of the way: a fibre let out meets falling ones.
double advance_of(const SlidingCurve& curve, const RigPoint& point) {
  return direction_of(curve.sliding) * point.stage;
}

double way_of(const SlidingCurve& curve, const RigPoint& point) { return way_at(curve.sliding, point.S); }

// What G lacks at a point of the way, and its slope there.
struct Miss {
  double x, error, slope;
};

// Where the error vanishes, by the cubic through two points with their slopes that gives x for an error.
double crossing(const Miss& a, const Miss& b) {
  const double h = b.error - a.error;
  const double t = -a.error / h;
  const double rise = b.x - a.x;
  const double d0 = h / a.slope;
  const double d1 = h / b.slope;
  return a.x + t * (d0 + t * (3 * rise - 2 * d0 - d1 + t * (d0 + d1 - 2 * rise)));
}

// The point between two lengths, G being monotone there, at which G = stage.
RigPoint point_between(const SlidingCurve& curve, const RigPoint& from, const RigPoint& to, double stage,
                       std::optional<double> x_guess = {}) {
  if (stage == from.stage) return from;
  if (stage == to.stage) return to;
  double low = way_of(curve, from);
  double high = way_of(curve, to);
  const bool rising = to.stage > from.stage;
  // Steps are short: the tangent where they begin is the best guess, the chord the next.
  Miss last{low, from.stage - stage, 2 * low * from.stage_slope};
  const double tangent = last.x - last.error / last.slope;
  const double chord = low + (high - low) * std::clamp((stage - from.stage) / (to.stage - from.stage), 0.0, 1.0);
  double x = x_guess && *x_guess > low && *x_guess < high ? *x_guess
             : tangent > low && tangent < high            ? tangent
                                                          : chord;
  const double rounding = 0x1p-50 * stage;  // of w and F, elastica.h
  RigPoint nearest = from;
  double least_error = infinity;
  for (int iteration = 0; iteration < 100; ++iteration) {
    const Sample sample = sample_on(curve, x);
    const Miss miss{x, sample.point.stage - stage, sample.slope};
    if (std::abs(miss.error) < least_error) {
      nearest = sample.point;
      least_error = std::abs(miss.error);
    }
    const double newton = x - miss.error / miss.slope;
    if (least_error <= rounding || std::abs(x * (newton - x)) <= 0x1p-54) break;  // or less than S = 1 + x^2 can tell
    ((miss.error < 0) == rising ? low : high) = x;
    double next = crossing(last, miss);
    if (!(next > low && next < high)) next = newton;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (!(next > low && next < high)) break;
    last = miss;
    x = next;
  }
  return nearest;
}

void require_traceable(const Friction& friction, const Rig& rig, double S_max) {
  if (!(rig.stiffness > 0))
    throw std::invalid_argument("rig stiffness must be positive, not " + std::to_string(rig.stiffness));
  if (!(S_max > 1 && S_max < infinity))
    throw std::invalid_argument("S_max must be above 1 and finite, not " + std::to_string(S_max));
  constexpr double finest = 1e-9;  // of a period, in spans: finer ones would be lost in the rounding of S
  if (4 * friction.smooth_scale() < finest)
    throw std::invalid_argument("a period of the roughness of " + std::to_string(4e9 * friction.smooth_scale()) +
                                "e-9 spans is finer than 1e-9 spans, the finest that is traced");
  const double periods = (S_max - 1) / (4 * friction.smooth_scale());
  if (periods > most_periods)
    throw std::invalid_argument("the roughness has " + std::to_string(periods) +
                                " periods on this length; at most 1e6 are traced");
}

// The first fold beyond a length, on the way; the number of folds if there is none.
std::size_t first_fold_beyond(const SlidingCurve& curve, double S) {
  const double x = way_at(curve.sliding, S);
  const auto fold = std::partition_point(curve.folds.begin(), curve.folds.end(),
                                         [&](const Fold& f) { return way_of(curve, f.point) <= x; });
  return static_cast<std::size_t>(fold - curve.folds.begin());
}

const RigPoint& fold_or_end(const SlidingCurve& curve, std::size_t i) {
  return i < curve.folds.size() ? curve.folds[i].point : curve.end;
}

}  // namespace

SlidingCurve trace_loading_curve(const Friction& friction, const Rig& rig, double S_max) {
  require_traceable(friction, rig, S_max);
  return Tracer(friction, rig, Sliding::in).trace(1, S_max);
}

SlidingCurve trace_unloading_curve(const Friction& friction, const Rig& rig, double S_from) {
  require_traceable(friction, rig, S_from);
  return Tracer(friction, rig, Sliding::out).trace(S_from, 1);
}

double longest_at_stage(double stage) {
  constexpr double least = 1e-6;  // below it S - 1 has lost its digits
  if (!(stage >= least && stage < infinity))
    throw std::invalid_argument("stage position must be at least 1e-6 spans, not " + std::to_string(stage));
  return 1 + 2.4 * stage * stage;
}

RigPoint point_at_length(const SlidingCurve& curve, double S) {
  // A length is known to its rounding: that of σ², of which it is made.
  const double rounding = 0x1p-51 * S;
  const double direction = direction_of(curve.sliding);
  if (!(direction * (S - curve.begin.S) >= -rounding && direction * (curve.end.S - S) >= -rounding))
    throw std::invalid_argument("length S = " + std::to_string(S) + " is not on the curve, which leads from " +
                                std::to_string(curve.begin.S) + " to " + std::to_string(curve.end.S));
  if (direction * (S - curve.begin.S) <= 0) return curve.begin;
  if (direction * (curve.end.S - S) <= 0) return curve.end;
  return sample_on(curve, way_at(curve.sliding, S)).point;
}

std::vector<OverallEquilibrium> overall_equilibria(const SlidingCurve& curve, double stage) {
  const double close = 1e-9 * stage;
  std::vector<OverallEquilibrium> found;
  RigPoint from = curve.begin;
  for (std::size_t i = 0; i <= curve.folds.size(); ++i) {
    const bool is_fold = i < curve.folds.size();
    const RigPoint to = is_fold ? curve.folds[i].point : curve.end;
    const bool stable = advance_of(curve, to) > advance_of(curve, from);
    const bool at_from = i > 0 && std::abs(from.stage - stage) <= close;
    const bool at_to = is_fold && std::abs(to.stage - stage) <= close;
    if (!at_from && !at_to && std::min(from.stage, to.stage) <= stage && stage <= std::max(from.stage, to.stage))
      found.push_back({point_between(curve, from, to, stage), stable ? Stability::stable : Stability::unstable});
    if (at_to) found.push_back({to, Stability::partially_stable});
    from = to;
  }
  return found;
}

StablePart stable_part_from(const SlidingCurve& curve, const RigPoint& point) {
  const RigPoint& next = fold_or_end(curve, first_fold_beyond(curve, point.S));
  return {point, advance_of(curve, next) > advance_of(curve, point) ? next : point};
}

std::optional<RigPoint> landing_after(const SlidingCurve& curve, double S, double stage) {
  const double advance = direction_of(curve.sliding) * stage;
  RigPoint from = point_at_length(curve, S);
  for (std::size_t i = first_fold_beyond(curve, S); i <= curve.folds.size(); ++i) {
    const RigPoint& to = fold_or_end(curve, i);
    if (advance_of(curve, from) <= advance && advance <= advance_of(curve, to) &&
        advance_of(curve, to) > advance_of(curve, from))
      return point_between(curve, from, to, stage);
    from = to;
  }
  return std::nullopt;
}

std::vector<StablePart> stable_parts(const SlidingCurve& curve) {
  std::vector<StablePart> parts{stable_part_from(curve, curve.begin)};
  while (const auto landing = landing_after(curve, parts.back().to.S, parts.back().to.stage))
    parts.push_back(stable_part_from(curve, *landing));
  return parts;
}

namespace {

RigPoint point_in(const SlidingCurve& curve, const StablePart& part, double stage, std::optional<double> x_guess) {
  const double advance = direction_of(curve.sliding) * stage;
  if (!(advance >= advance_of(curve, part.from) && advance <= advance_of(curve, part.to)))
    throw std::invalid_argument("stage position " + std::to_string(stage) + " is not in the stable part");
  return point_between(curve, part.from, part.to, stage, x_guess);
}

}  // namespace

RigPoint point_at_stage(const SlidingCurve& curve, const StablePart& part, double stage) {
  return point_in(curve, part, stage, std::nullopt);
}

RigPoint point_at_stage(const SlidingCurve& curve, const StablePart& part, double stage, double S_guess) {
  return point_in(curve, part, stage, way_at(curve.sliding, S_guess));
}

double end_of_stretch(const Friction& friction, double S, double S_to, double scales) {
  constexpr double smooth_step = 0.125;  // in σ, over which the elastica itself varies little
  const double sigma = std::sqrt(S - 1);
  const double step = scales * friction.smooth_scale();
  const auto knots = friction.knots();
  if (S_to > S) {
    const auto knot = std::upper_bound(knots.begin(), knots.end(), S);
    const double end = std::min({S_to, S + step, 1 + (sigma + smooth_step) * (sigma + smooth_step)});
    return knot == knots.end() ? end : std::min(end, *knot);
  }
  const double shorter = std::max(sigma - smooth_step, 0.0);
  const auto knot = std::lower_bound(knots.begin(), knots.end(), S);
  const double end = std::max({S_to, S - step, 1 + shorter * shorter});
  return knot == knots.begin() ? end : std::max(end, *std::prev(knot));
}

}  // namespace flexslip
