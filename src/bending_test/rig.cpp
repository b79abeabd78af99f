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

// In σ = √(S - 1) the curve has no singularity at its start: dw/dσ -> √15/6 and F -> 48 w.
struct Sample {
  bool exists;
  RigPoint point;
  double slope;  // dG/dσ
  double scale;  // size of its terms
};

Sample sample_at(const Friction& friction, const Rig& rig, double sigma) {
  const double c = 1 / rig.stiffness;
  const double S = 1 + sigma * sigma;
  sigma = std::sqrt(S - 1);  // that of the rounded S, at which everything below is evaluated
  const auto mu = friction.at(S);
  if (sigma == 0 || S == 1) {
    const double slope = std::sqrt(15.0) / 6 * (1 + 48 * c);
    return {true, {1, mu.mu, 0, 0, 0, infinity}, slope, slope};
  }
  const auto [state, slopes] = fibre_state_slopes(S, mu.mu);
  if (state.status != FibreStatus::ok) return {false, {}, 0, 0};
  const double smooth = slopes.w_S + c * slopes.F_S;
  const double rough = (slopes.w_q + c * slopes.F_q) * mu.slope;
  return {.exists = true,
          .point = {S, mu.mu, state.w, state.F, state.w + c * state.F, smooth + rough},
          .slope = 2 * sigma * (smooth + rough),
          .scale = 2 * sigma * (slopes.w_S + c * std::abs(slopes.F_S) + std::abs(rough))};
}

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

// Walks the sliding curve and gathers its folds.
class Tracer {
 public:
  Tracer(const Friction& friction, const Rig& rig) : friction_(friction), rig_(rig) {}

  LoadingCurve trace(double S_max) {
    CurveEnd reason = CurveEnd::at_S_max;
    Sample from = sample_at(friction_, rig_, 0);
    double sigma = 0;
    for (double S = 1; S < S_max && reason != CurveEnd::branch_ended;) {
      S = next_edge(S, S_max);
      double next = std::sqrt(S - 1);
      Sample to = sample_at(friction_, rig_, next);
      const auto folds_before = folds_.size();
      auto missing = to.exists ? isolate(sigma, from, next, to, 0) : std::optional(next);
      while (missing) {
        reason = CurveEnd::branch_ended;
        next = last_existing(sigma, *missing);
        to = sample_at(friction_, rig_, next);
        folds_.resize(folds_before);
        missing = next > sigma ? isolate(sigma, from, next, to, 0) : std::nullopt;
      }
      sigma = next;
      from = to;
    }
    return {friction_, rig_, std::move(folds_), from.point, reason};
  }

 private:
  double next_edge(double S, double S_max) const {
    constexpr double smooth_step = 0.125;  // in σ, over which the elastica itself varies little
    const double sigma = std::sqrt(S - 1) + smooth_step;
    const auto knots = friction_.knots();
    const auto knot = std::upper_bound(knots.begin(), knots.end(), S);
    const double smooth_end = std::min({S_max, S + 2 * friction_.smooth_scale(), 1 + sigma * sigma});
    return knot == knots.end() ? smooth_end : std::min(smooth_end, *knot);
  }

  double last_existing(double exists, double ended) const {
    while (true) {
      const double middle = 0.5 * (exists + ended);
      if (!(middle > exists && middle < ended)) return exists;
      (sample_at(friction_, rig_, middle).exists ? exists : ended) = middle;
    }
  }

  // Gathers the folds between two σ; or, if the branch ends there, a σ beyond its end.
  std::optional<double> isolate(double a, const Sample& at_a, double b, const Sample& at_b, int halvings) {
    std::array<Sample, degree + 1> samples;
    samples.front() = at_a;
    samples.back() = at_b;
    for (int j = 1; j < degree; ++j) {
      const double sigma = a + 0.5 * (b - a) * (1 + node(j));
      const Sample sample = sample_at(friction_, rig_, sigma);
      if (!sample.exists) return sigma;
      samples[static_cast<std::size_t>(j)] = sample;
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
    const bool resolved = tail <= (accuracy + rounding / friction_.smooth_scale()) * scale;  // S itself is rounded, too
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

  void add_fold(double a, double b, bool rising, const Values& bernstein) {
    const double t = bracketed_root([&](double x) { return evaluate(bernstein, x); }, 0.0, 1.0, 0.5, rising);
    const double sigma = bracketed_root(
        [&](double x) {
          const double slope = evaluate(bernstein, (x - a) / (b - a)).second / (b - a);
          return std::pair{sample_at(friction_, rig_, x).slope, slope};
        },
        a, b, a + t * (b - a), rising);
    folds_.push_back({sample_at(friction_, rig_, sigma).point, !rising});
  }

  static const Basis& basis() {
    static const Basis value;
    return value;
  }

  const Friction& friction_;
  const Rig& rig_;
  std::vector<Fold> folds_;
};

// The point between two lengths, G being monotone there, at which G = stage.
RigPoint point_between(const LoadingCurve& curve, const RigPoint& from, const RigPoint& to, double stage) {
  if (stage == from.stage) return from;
  if (stage == to.stage) return to;
  const double low = std::sqrt(from.S - 1);
  const double high = std::sqrt(to.S - 1);
  const bool rising = to.stage > from.stage;
  const double start = low + (high - low) * std::clamp((stage - from.stage) / (to.stage - from.stage), 0.0, 1.0);
  const double sigma = bracketed_root(
      [&](double x) {
        const Sample sample = sample_at(curve.friction, curve.rig, x);
        return std::pair{sample.point.stage - stage, sample.slope};
      },
      low, high, start, rising);
  return sample_at(curve.friction, curve.rig, sigma).point;
}

}  // namespace

LoadingCurve trace_loading_curve(const Friction& friction, const Rig& rig, double S_max) {
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
  return Tracer(friction, rig).trace(S_max);
}

double longest_at_stage(double stage) {
  constexpr double least = 1e-6;  // below it S - 1 has lost its digits
  if (!(stage >= least && stage < infinity))
    throw std::invalid_argument("stage position must be at least 1e-6 spans, not " + std::to_string(stage));
  return 1 + 2.4 * stage * stage;
}

RigPoint point_at_length(const LoadingCurve& curve, double S) {
  if (!(S >= 1 && S <= curve.end.S))
    throw std::invalid_argument("length S = " + std::to_string(S) + " is not on the curve, which ends at " +
                                std::to_string(curve.end.S));
  return sample_at(curve.friction, curve.rig, std::sqrt(S - 1)).point;
}

std::vector<OverallEquilibrium> overall_equilibria(const LoadingCurve& curve, double stage) {
  const double close = 1e-9 * stage;
  std::vector<OverallEquilibrium> found;
  RigPoint from = sample_at(curve.friction, curve.rig, 0).point;
  for (std::size_t i = 0; i <= curve.folds.size(); ++i) {
    const bool is_fold = i < curve.folds.size();
    const RigPoint to = is_fold ? curve.folds[i].point : curve.end;
    const bool rising = to.stage > from.stage;
    const bool at_from = i > 0 && std::abs(from.stage - stage) <= close;
    const bool at_to = is_fold && std::abs(to.stage - stage) <= close;
    if (!at_from && !at_to && std::min(from.stage, to.stage) <= stage && stage <= std::max(from.stage, to.stage))
      found.push_back({point_between(curve, from, to, stage), rising ? Stability::stable : Stability::unstable});
    if (at_to) found.push_back({to, Stability::partially_stable});
    from = to;
  }
  return found;
}

std::vector<StablePart> stable_parts(const LoadingCurve& curve) {
  std::vector<StablePart> parts;
  RigPoint from = sample_at(curve.friction, curve.rig, 0).point;
  double record = 0;
  for (std::size_t i = 0; i <= curve.folds.size(); ++i) {
    const RigPoint to = i < curve.folds.size() ? curve.folds[i].point : curve.end;
    if (to.stage > record) {
      parts.push_back({from.stage < record ? point_between(curve, from, to, record) : from, to});
      record = to.stage;
    }
    from = to;
  }
  return parts;
}

RigPoint point_at_stage(const LoadingCurve& curve, const StablePart& part, double stage) {
  if (!(stage >= part.from.stage && stage <= part.to.stage))
    throw std::invalid_argument("stage position " + std::to_string(stage) + " is not in the stable part");
  return point_between(curve, part.from, part.to, stage);
}

}  // namespace flexslip
