// Compiled once for each instruction set (Highway's foreach_target.h).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fibre/batch.cpp"
#include "fibre/batch.h"

#include <cstddef>

#include <hwy/foreach_target.h>  // must come before highway.h

#include "fibre/elastica-inl.h"

HWY_BEFORE_NAMESPACE();
namespace flexslip::HWY_NAMESPACE {

HWY_INLINE Lanes or_nan(LanesMask valid, Lanes value) { return choose(valid, value, Lanes(hn::NaN(DoubleTag()))); }

// Each of these leaves NaN for states outside the common range.
void common_states(const double* S, const double* q, std::size_t count, double* w, double* F) {
  for_each_lanes(S, q, count, [&](std::size_t i, std::size_t n, Lanes lengths, Lanes frictions) HWY_ATTR {
    const auto state = common_state<Lanes>(lengths, frictions, force_line(frictions));
    const auto valid = is_common(lengths, state);
    store(or_nan(valid, state.w), w + i, n);
    store(or_nan(valid, state.F), F + i, n);
  });
}

void common_states_slopes(const double* S, const double* q, std::size_t count, double* const* columns) {
  for_each_lanes(S, q, count, [&](std::size_t i, std::size_t n, Lanes lengths, Lanes frictions) HWY_ATTR {
    const auto line = force_line(frictions);
    const auto state = common_state<Lanes>(lengths, frictions, line);
    const auto valid = is_common(lengths, state);
    const auto slopes = state_slopes<Lanes>(lengths, state.u, line, common_doublings);
    const Lanes values[] = {state.w, state.F, slopes.w_S, slopes.w_q, slopes.F_S, slopes.F_q};
    for (std::size_t k = 0; k < 6; ++k) store(or_nan(valid, values[k]), columns[k] + i, n);
  });
}

}  // namespace flexslip::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <cmath>
#include <stdexcept>
#include <string>

#include "fibre/elastica.h"
#include "numerics/effort.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

HWY_EXPORT(common_states);
HWY_EXPORT(common_states_slopes);

}  // namespace

FibrePoints::FibrePoints(std::span<const double> S, std::span<const double> q) : S_(S), q_(q) {
  if (S.size() != q.size())
    throw std::invalid_argument("there are " + std::to_string(S.size()) + " lengths, but " + std::to_string(q.size()) +
                                " frictions");
  effort_spent += S.size();
  bool valid = true;  // one pass that can be vectorised; the index is searched afterwards
  for (std::size_t i = 0; i < S.size(); ++i) valid &= S[i] >= 1 && S[i] < infinity && std::abs(q[i]) <= largest_q;
  for (std::size_t i = 0; !valid && i < S.size(); ++i) try {
      fibre_state(S[i], q[i]);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("state " + std::to_string(i) + ": " + error.what());
    }
}

StateArrays fibre_states(const FibrePoints& points) {
  StateArrays states(points.size());
  HWY_DYNAMIC_DISPATCH(common_states)
  (points.lengths(), points.frictions(), points.size(), states.w.data(), states.F.data());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isnan(states.w[i])) continue;
    const FibreState state = fibre_state(points.lengths()[i], points.frictions()[i]);
    states.w[i] = state.w;
    states.F[i] = state.F;
  }
  return states;
}

SlopeArrays fibre_states_slopes(const FibrePoints& points) {
  SlopeArrays states(points.size());
  const auto columns = states.columns();
  HWY_DYNAMIC_DISPATCH(common_states_slopes)(points.lengths(), points.frictions(), points.size(), columns.data());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isnan(states.w[i])) continue;
    const auto [state, slopes] = fibre_state_slopes(points.lengths()[i], points.frictions()[i]);
    const double values[] = {state.w, state.F, slopes.w_S, slopes.w_q, slopes.F_S, slopes.F_q};
    for (std::size_t k = 0; k < columns.size(); ++k) columns[k][i] = values[k];
  }
  return states;
}

}  // namespace flexslip

#endif  // HWY_ONCE
