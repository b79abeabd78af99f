// Maxima and minima of functions: of one variable, of several without a gradient, and of several
// with a gradient.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace flexslip {

// ---- One variable

struct Greatest {
  double at, value;
};

// The maximum of a function between two limits, or a local maximum within them.
// Domain:     low < high; tolerance above the rounding of both. The function is evaluated only
//             between them.
// Max error:  of the position, 2 `tolerance` plus 1e-8 of the width of a smooth peak, because of
//             rounding.
// Method:     parabolas through the best three points, golden sections where a parabola fails
//             (Brent 1973, chapter 5). The function may have kinks.
// Cost:       about 10 calls for a smooth function, 1.44 log2(width/tolerance) otherwise.
template <class Function>
Greatest greatest_within(const Function& f, double low, double high, double tolerance) {
  constexpr double golden = 0.3819660112501051;
  double x = low + golden * (high - low), second = x, third = x;
  double at_x = f(x), at_second = at_x, at_third = at_x;
  double step = 0, step_before = 0;
  while (std::max(high - x, x - low) > 2 * tolerance) {
    const double r = (x - second) * (at_x - at_third);
    const double t = (x - third) * (at_x - at_second);
    const double parabola = -((x - third) * t - (x - second) * r) / (2 * (t - r));
    const bool is_good = std::abs(parabola) < 0.5 * std::abs(step_before) && x + parabola > low && x + parabola < high;
    step_before = is_good ? step : (x < 0.5 * (low + high) ? high : low) - x;
    step = is_good ? parabola : golden * step_before;
    const bool is_at_end = is_good && std::min(x + step - low, high - x - step) < 2 * tolerance;
    if (is_at_end) step = std::copysign(tolerance, 0.5 * (low + high) - x);
    const double next = x + (std::abs(step) >= tolerance ? step : std::copysign(tolerance, step));
    const double at_next = f(next);
    if (at_next >= at_x) {
      (next >= x ? low : high) = x;
      third = second;
      at_third = at_second;
      second = x;
      at_second = at_x;
      x = next;
      at_x = at_next;
    } else {
      (next < x ? low : high) = next;
      if (at_next >= at_second || second == x) {
        third = second;
        at_third = at_second;
        second = next;
        at_second = at_next;
      } else if (at_next >= at_third || third == x || third == second) {
        third = next;
        at_third = at_next;
      }
    }
  }
  return {x, at_x};
}

// ---- Several variables, no gradient

using FunctionOfNumbers = std::function<double(std::span<const double>)>;

struct Least {
  std::vector<double> at;
  double value = std::numeric_limits<double>::infinity();
};

struct LeastOptions {
  std::vector<double> steps;  // [units of each variable] the initial steps
  double close_in_value;      // stop if the values of the simplex differ by less,
  double close_in_numbers;    // or its points do, in every variable
  int max_calls;              // for each start
};

// The smallest value found from any of the starts.
// Domain:     starts not empty, each as long as the steps. The function may return infinity or NaN
//             where it is undefined.
// Method:     Nelder and Mead's simplex (NLopt). The function may have kinks and steps.
// Fails:      never; but the result may be a local minimum.
Least least_from(const FunctionOfNumbers& f, std::span<const std::vector<double>> starts, const LeastOptions& options);

// ---- Several variables with a gradient, within a box

template <class Vector>
struct Box {
  Vector low, high;
  Vector longest_step;
};

template <class Vector>
using SquareOf = Eigen::Matrix<double, Vector::RowsAtCompileTime, Vector::RowsAtCompileTime, 0,
                               Vector::MaxRowsAtCompileTime, Vector::MaxRowsAtCompileTime>;

// A local maximum of f within a box. The search ends after `iterations`, or when a step gained less
// than `negligible` and the next promises as little, or when no step increases f.
// Domain:     Vector: an Eigen column; f(Vector) returns a struct with `value` and `gradient`,
//             finite within the box. Variables and values are of the order of 1. inverse: roughly
//             the inverse of minus the Hessian.
// Method:     BFGS. Each step is limited to the longest step and to the box, then shortened by 0.3
//             at most five times until f increases. `inverse` is updated, except by steps shorter
//             than 1e-6.
// Fails:      never; but in a curved valley that meets a wall the search may end early.
// Cost:       1 + (1 to 6) calls per iteration.
template <class Function, class Vector>
Vector maximised_in_box(const Function& f, const Vector& start, const Box<Vector>& box, SquareOf<Vector>& inverse,
                        int iterations, double negligible) {
  const Eigen::Index n = start.size();
  if (n < 1) return start;  // without variables, the gradient has no first element
  Vector x = start.cwiseMax(box.low).cwiseMin(box.high);
  auto now = f(x);
  double gain = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < iterations; ++iteration) {
    Vector step = inverse * now.gradient;
    for (Eigen::Index i = 0; i < n; ++i)  // at a wall, do not step into it
      if ((x[i] <= box.low[i] && step[i] < 0) || (x[i] >= box.high[i] && step[i] > 0)) step[i] = 0;
    if (!step.allFinite()) break;
    if (gain < negligible && 0.5 * now.gradient.dot(step) < negligible) break;
    const double over = step.cwiseQuotient(box.longest_step).cwiseAbs().maxCoeff();
    if (over > 1) step /= over;
    bool has_risen = false;
    Vector next = x;
    auto then = now;
    for (int shortening = 0; shortening < 6 && !has_risen; ++shortening, step *= 0.3) {
      next = (x + step).cwiseMax(box.low).cwiseMin(box.high);
      then = f(next);
      has_risen = then.value > now.value;
    }
    if (!has_risen) break;
    const Vector s = next - x, y = (now.gradient - then.gradient).head(n);  // y: of minus f
    const double sy = s.dot(y);
    gain = then.value - now.value;
    if (sy > 1e-12) {
      const SquareOf<Vector> I = SquareOf<Vector>::Identity(n, n);
      inverse = (I - s * y.transpose() / sy) * inverse * (I - y * s.transpose() / sy) + s * s.transpose() / sy;
    }
    x = next;
    now = then;
  }
  return x;
}

}  // namespace flexslip
