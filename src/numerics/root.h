// Zeros of functions of one variable, and the points at which a condition becomes true. Every
// search stays within its bracket.
#pragma once

#include <cmath>
#include <limits>

#include "numerics/elementary.h"

namespace flexslip {

// ---- Bisection

struct Bracket {
  double low, high;

  double width() const { return high - low; }
  double middle() const { return 0.5 * (low + high); }
};

// Bisects the bracket until enough(bracket) is true or its ends are neighbouring numbers. is_beyond
// is false at `low`, true at `high`, and evaluated at neither. `low` may exceed `high`.
// Fails:      never; where is_beyond changes more than once, the result brackets one of the
//             changes.
template <class Predicate, class Enough>
Bracket halved_until(const Enough& enough, Bracket bracket, const Predicate& is_beyond) {
  while (!enough(bracket)) {
    const double middle = bracket.middle();
    if (middle == bracket.low || middle == bracket.high) break;
    (is_beyond(middle) ? bracket.high : bracket.low) = middle;
  }
  return bracket;
}

// Bisects `halvings` times, to a width of 2^-halvings.
template <class Predicate>
Bracket halved(int halvings, Bracket bracket, const Predicate& is_beyond) {
  const auto enough = [&](const Bracket&) { return halvings-- <= 0; };
  return halved_until(enough, bracket, is_beyond);
}

// The first number at which is_true holds, on the way from `is_false` to `end`, in either
// direction; `end` if it is false there too.
// Max error:  none: is_true is false at the neighbour. Exception: a point closer to 0 than 2^-200
//             of the way.
// Cost:       one call at the end, and about 50 more if it is true there.
template <class Predicate>
double first_where(double is_false, double end, const Predicate& is_true) {
  constexpr int max_halvings = 200;
  return is_true(end) ? halved(max_halvings, {is_false, end}, is_true).high : end;
}

// ---- Newton's iteration

// The zero of a function between a point where it is negative and one where it is positive, in
// either order. f(x) returns value and slope.
// Domain:     x between the two. If f does not change sign, the result still lies between them.
// Max error:  the square of a step of `close` + `relative` |x|, if f'' is of the order of f'. The
//             last step is at most that long.
// Method:     Newton's iteration from x; bisection where a step would leave the bracket.
// Cost:       at most 60 calls of f. The last is at the point before the result, or at the result
//             where f is 0.
template <class Function>
double zero_between(const Function& f, double negative, double positive, double x, double close, double relative = 0) {
  constexpr int max_steps = 60;  // 60 bisections exhaust any bracket
  for (int i = 0; i < max_steps; ++i) {
    const auto [value, slope] = f(x);
    if (value == 0) return x;
    (value < 0 ? negative : positive) = x;
    const double tolerance = close + relative * std::abs(x);
    const double newton = x - value / slope;
    const bool is_between = (newton - negative) * (newton - positive) < 0;
    if (!is_between && std::isfinite(slope) && std::abs(newton - x) <= tolerance)
      return x;  // rounding made the step zero
    const double next = is_between ? newton : 0.5 * (negative + positive);
    const double step = std::abs(next - x);
    x = next;
    if (step <= tolerance) break;
  }
  return x;
}

// ---- Without a slope

struct Tried {
  double x, value;
};

// The zero of a function between a point where it is negative and one where it is positive, in
// either order. NaN and infinity count as positive.
// Domain:     negative.value < 0, and not positive.value < 0.
// Max error:  |f| <= `small` at the result. Otherwise f changes sign at the neighbouring number, or
//             200 steps were made.
// Method:     regula falsi with the retained end's value halved each time (Illinois method: Dowell
//             and Jarratt, BIT 11, 1971); otherwise bisection.
template <class Function>
double zero_by_secant(const Function& f, Tried negative, Tried positive, double small) {
  constexpr int max_steps = 200;
  Tried* stayed = nullptr;
  for (int i = 0; i < max_steps; ++i) {
    const double secant = negative.x - (positive.x - negative.x) * negative.value / (positive.value - negative.value);
    const bool is_between = (secant - negative.x) * (secant - positive.x) < 0;
    const double x = is_between ? secant : 0.5 * (negative.x + positive.x);
    if (x == negative.x || x == positive.x) break;
    const double value = f(x);
    if (std::abs(value) <= small) return x;
    Tried& moved = value < 0 ? negative : positive;
    Tried& stays = value < 0 ? positive : negative;
    moved = {x, value};
    if (stayed == &stays) stays.value *= 0.5;
    stayed = &stays;
  }
  return negative.x;
}

// The first number at which f is not positive, as first_where.
// Domain:     before.value > 0; f continuous except for jumps. NaN counts as not positive.
// Max error:  as first_where.
// Method:     as zero_by_secant down to a few ulp, with at least half of that distance from both
//             ends. Bisection if three steps have not halved the bracket, and at the end.
// Cost:       one call at the end, and about ten more if f is not positive there; at a jump up to
//             250.
template <class Function>
double first_not_positive(const Function& f, Tried before, double end) {
  Tried after{end, f(end)};
  if (after.value > 0) return end;
  constexpr int max_steps = 200, patience = 3;
  constexpr double few_ulp = 4 * std::numeric_limits<double>::epsilon();
  Tried* stayed = nullptr;
  double width_then = infinity;
  for (int i = 0; i < max_steps; ++i) {
    const double width = std::abs(after.x - before.x);
    const double close = few_ulp * std::fmax(std::abs(before.x), std::abs(after.x));
    if (width <= close) break;
    const double onward = after.x > before.x ? 1 : -1;
    double x = before.x + (after.x - before.x) * before.value / (before.value - after.value);
    if (i % patience == 0) {
      if (width > 0.5 * width_then) x = not_a_number;
      width_then = width;
    }
    if (std::isnan(x))
      x = 0.5 * (before.x + after.x);
    else if (onward * (x - before.x) < 0.5 * close)
      x = before.x + onward * 0.5 * close;
    else if (onward * (after.x - x) < 0.5 * close)
      x = after.x - onward * 0.5 * close;
    const double value = f(x);
    Tried& moved = value > 0 ? before : after;
    Tried& stays = value > 0 ? after : before;
    moved = {x, value};
    if (stayed == &stays) stays.value *= 0.5;
    stayed = &stays;
  }
  return halved(max_steps, {before.x, after.x}, [&](double x) { return !(f(x) > 0); }).high;
}

}  // namespace flexslip
