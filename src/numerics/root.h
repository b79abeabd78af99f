// Where a function of one number vanishes, and where something becomes true: within a bracket that is never left.
#pragma once

#include <cmath>
#include <limits>

#include "numerics/elementary.h"

namespace flexslip {

// By halves.

struct Bracket {
  double low, high;

  double width() const { return high - low; }
  double middle() const { return 0.5 * (low + high); }
};

// A bracket is halved until it is `enough`, or two neighbouring numbers; is_beyond(x) is false at its low end, true at its high one, and neither is
// asked. Low and high in either order.
// Fails:      never; where is_beyond turns more than once, one of the turns is kept.
template <class Predicate, class Enough>
Bracket halved_until(const Enough& enough, Bracket bracket, const Predicate& is_beyond) {
  while (!enough(bracket)) {
    const double middle = bracket.middle();
    if (middle == bracket.low || middle == bracket.high) break;
    (is_beyond(middle) ? bracket.high : bracket.low) = middle;
  }
  return bracket;
}

// Halved so many times: to 2^-halvings of its width.
template <class Predicate>
Bracket halved(int halvings, Bracket bracket, const Predicate& is_beyond) {
  const auto enough = [&](const Bracket&) { return halvings-- <= 0; };
  return halved_until(enough, bracket, is_beyond);
}

// The first number from which on something is true, on the way from one at which it is false to `end`, in either direction; `end` where it is
// false even there.
// Max error:  none: the neighbour is false. (2^-200 of the way, which only a place next to 0 is near to.)
// Cost:       one call at the end, and some 50 more where it is true there.
template <class Predicate>
double first_where(double is_false, double end, const Predicate& is_true) {
  constexpr int max_halvings = 200;
  return is_true(end) ? halved(max_halvings, {is_false, end}, is_true).high : end;
}

// By Newton's iteration.

// The zero of a function between a place where it is negative and one where it is positive, in either order; f(x) gives its value and slope.
// Domain:     x between the two; where f does not change its sign, the result lies between them, too.
// Max error:  the square of a step of `close` + `relative` |x|, if the bend is of the order of the slope: the last step is no longer than that.
// Method:     Newton's iteration from x; a step that would leave the bracket halves it.
// Cost:       at most 60 calls of f, the last at the place before the result, or at the result itself where f is 0.
template <class Function>
double zero_between(const Function& f, double negative, double positive, double x, double close, double relative = 0) {
  constexpr int max_steps = 60;  // as many halvings leave nothing of a bracket
  for (int i = 0; i < max_steps; ++i) {
    const auto [value, slope] = f(x);
    if (value == 0) return x;
    (value < 0 ? negative : positive) = x;
    const double tolerance = close + relative * std::abs(x);
    const double newton = x - value / slope;
    const bool is_between = (newton - negative) * (newton - positive) < 0;
    if (!is_between && std::isfinite(slope) && std::abs(newton - x) <= tolerance)
      return x;  // a step that rounding has made none
    const double next = is_between ? newton : 0.5 * (negative + positive);
    const double step = std::abs(next - x);
    x = next;
    if (step <= tolerance) break;
  }
  return x;
}

// Without slopes.

struct Tried {
  double x, value;
};

// The zero of a function between a place where it is negative and one where it is positive, in either order. A value that is infinite or none counts
// as positive.
// Domain:     negative.value < 0, and not positive.value < 0.
// Max error:  |f| <= `small` there; or else its neighbour has the other sign, or both have been approached 200 times.
// Method:     the secant, where an end that stays counts for half each time (Dowell and Jarratt, BIT 11, 1971); halves where it leads nowhere.
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

// As first_where, for a function that is positive until then.
// Domain:     before.value > 0; f continuous but for jumps; where it is not a number it counts as not positive.
// Max error:  as first_where.
// Method:     as zero_by_secant down to some ulp, no closer to an end than half of these, halving where three steps have not halved the bracket; then
//             by halves.
// Cost:       one call at the end, and some ten more where it is not positive there; at a jump up to 250.
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
