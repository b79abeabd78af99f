#include "case/supports_share.h"

#include "case/problem.h"
#include "fibre/loose_rollers.h"
#include "fibre/supported_state.h"

namespace flexslip {
namespace {

struct Deflections {
  double from, to;  // [m] from the contact, as the record counts them
};

Deflections told_between(const Record& record, const SmallDeflection& numbers) {
  if (const auto& chord = numbers.chord)
    return {numbers.origin + chord->deflection_from, numbers.origin + chord->deflection_to};
  return {record.deflection[numbers.first], record.deflection[numbers.last - 1]};
}

}  // namespace

std::optional<double> supports_share(const Measurement& measurement, const SmallDeflection& numbers) {
  const Case& test = measurement.test;
  if (!test.rig || !test.rig->span) return std::nullopt;
  const Scales scales(*test.rig->span, 1);
  const Supports supports = supports_of(test, test.specimen ? test.specimen->section : std::nullopt, scales);
  if (supports.radius == 0 && supports.half_depth == 0) return std::nullopt;
  const bool loose = test.rig->rollers == Rollers::loose;
  const auto state = [&](double w) {
    return loose ? state_on_loose_rollers(w, supports).state : state_on_supports(w, 0, supports);
  };
  const auto [from, to] = told_between(measurement.record, numbers);
  const double w_from = scales.reduced_length(from), w_to = scales.reduced_length(to);
  if (!(w_from > 0 && w_to > w_from && w_to <= deepest_on_supports)) return std::nullopt;
  const SupportedState low = state(w_from), high = state(w_to);
  if (low.status != FibreStatus::ok || high.status != FibreStatus::ok) return std::nullopt;
  constexpr double euler_bernoulli = 48;
  return (high.F - low.F) / (euler_bernoulli * (w_to - w_from)) - 1;
}

}  // namespace flexslip
