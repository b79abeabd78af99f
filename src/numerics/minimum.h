// Where functions are greatest or least: of one number, of a few numbers, and of a few with slopes.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace flexslip {

// Of one number.

struct Greatest {
  double at, value;
};

// The greatest value of a function between two numbers, or at a place where it is greater than about it.
// Domain:     low < high, tolerance above the rounding of both. The function is asked between them alone.
// Max error:  of the place 2 `tolerance`, and what rounding leaves of a smooth peak: the root of 1e-16 of its width.
// Method:     parabolas through the best three points, golden sections where they lead nowhere (Brent 1973, chapter 5): the function may have
//             kinks.
// Cost:       some 10 calls where it is smooth, 1.44 log2(width/tolerance) where it is not.
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

// Of a few numbers, without slopes.

using FunctionOfNumbers = std::function<double(std::span<const double>)>;

struct Least {
  std::vector<double> at;
  double value = std::numeric_limits<double>::infinity();
};

struct LeastOptions {
  std::vector<double> steps;  // the first, of each number
  double close_in_value;      // ends where the values met differ by less,
  double close_in_numbers;    // or the numbers do
  int max_calls;              // from each start
};

// The least value met from any of the starts.
// Domain:     starts not empty, each as long as the steps. The function may be infinite or no number where it has none.
// Method:     Nelder and Mead's simplex (NLopt): the function may have kinks and steps.
// Fails:      never; a valley that ends elsewhere is not found.
Least least_from(const FunctionOfNumbers& f, std::span<const std::vector<double>> starts, const LeastOptions& options);

// Of a few numbers, with slopes, in a box.

template <class Vector>
struct Box {
  Vector low, high;
  Vector longest_step;
};

template <class Vector>
using SquareOf = Eigen::Matrix<double, Vector::RowsAtCompileTime, Vector::RowsAtCompileTime, 0,
                               Vector::MaxRowsAtCompileTime, Vector::MaxRowsAtCompileTime>;

// Uphill until a step gains less than `negligible` and the next promises no more, or none of six lengths of a step gains at all, or for so many
// iterations.
// Domain:     Vector: a column of Eigen's; f(Vector) gives a struct with `value` and `gradient`, finite in the box. inverse: that of minus the
//             curvature, roughly; it is left as it was learned. Numbers and values of the order of 1: of steps shorter than 1e-6 no curvature is learned.
// Method:     BFGS, each step shortened to the longest and to the box, then by 0.3 until it rises, at most five times.
// Fails:      never; where none of six lengths of a step rises it ends, in a bent valley that leads into a wall maybe before its end.
// Cost:       1 + (1 to 6) calls an iteration.
template <class Function, class Vector>
Vector maximised_in_box(const Function& f, const Vector& start, const Box<Vector>& box, SquareOf<Vector>& inverse,
                        int iterations, double negligible) {
  const Eigen::Index n = start.size();
  if (n < 1) return start;  // no number can move, and a gradient of none has no first element
  Vector x = start.cwiseMax(box.low).cwiseMin(box.high);
  auto now = f(x);
  double gain = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < iterations; ++iteration) {
    Vector step = inverse * now.gradient;
    for (Eigen::Index i = 0; i < n; ++i)  // at a wall, nothing moves into it
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
    const Vector s = next - x, y = (now.gradient - then.gradient).head(n);  // of minus the function
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
