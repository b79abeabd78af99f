#include "fibre/loose_rollers.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "numerics/elementary.h"

namespace flexslip {

LooseState state_on_loose_rollers(double w, const Supports& supports) {
  if (!(supports.radius > 0))
    throw std::invalid_argument("a roller that rolls has a radius > 0, not " + std::to_string(supports.radius));
  constexpr int most_rounds = 200;
  constexpr double settled = 1e-15;
  double span = 1, q = 0;
  SupportedState state{};
  for (int i = 0; i < most_rounds; ++i) {
    if (!(w / span <= deepest_on_supports && (supports.radius + supports.half_depth) / span < widest_supports)) {
      if (i == 0) return {state_on_supports(w, q, supports), span};  // says what is wrong
      state.status = FibreStatus::beyond_branch;
      return {state, span};
    }
    state = state_on_supports(w / span, q, {supports.radius / span, supports.half_depth / span});
    if (state.status != FibreStatus::ok) return {state, span};
    const double nearer = 2 / (2 + state.slid);  // what a roller has come in is half of what has been drawn in over it
    const auto [sine, cosine] = elementary::sine_and_cosine(0.5 * state.theta0);
    const double next = sine / cosine;
    const bool is_settled = std::abs(nearer - span) <= settled && std::abs(next - q) <= settled;
    span = nearer;
    q = next;
    if (is_settled) break;
  }
  state.length *= span;
  state.slid = 1 - span;
  state.imaged *= span;
  state.w = w;
  state.F /= span * span;
  state.Pn /= span * span;
  state.U /= span;
  state.curvature /= span;
  return {state, span};
}

}  // namespace flexslip
