#include "inference/teeth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "data/names.h"
#include "fibre/elastica.h"
#include "numerics/elementary.h"
#include "numerics/require.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {
constexpr double load_train_error = 0.003;  // [1] relative, of the load-train stiffness
constexpr std::size_t min_rows = 4;         // of a rise that is judged

void require_teeth(const ReducedRecord& record, const Rig& rig, const MeasurementErrors& errors,
                   std::span<const Drop> drops, const ToothOptions& options) {
  const auto require_error = [](const char* name, double value) {
    require(value >= 0 && std::isfinite(value), name, value);
  };
  require(rig.stiffness > 0 && std::isfinite(rig.stiffness), "load-train stiffness", rig.stiffness);
  require(options.min_share > 0 && options.min_share < 1, "least share", options.min_share);
  require_error("force error", errors.force);
  require_error("bending stiffness error", errors.bending_stiffness);
  require_error("contact error", errors.contact);
  require_readings(record);
  std::size_t reached = 0;
  for (const Drop& drop : drops) {
    require(drop.before >= reached && drop.after > drop.before && drop.after < record.force.size(), "drop after point",
            static_cast<double>(drop.before));
    reached = drop.after;
  }
}

// A rise as a straight line.
struct Rise {
  std::size_t first, last;
  double stage, force, slope, slope_error;
};

Rise straight_rise(const ReducedRecord& record, std::size_t first, std::size_t last, double force_error) {
  const auto stage = std::span(record.stage).subspan(first, last - first);
  const auto force = std::span(record.force).subspan(first, last - first);
  const Line line = line_through(stage, force);
  Rise rise{
      .first = first, .last = last, .stage = line.mean_x, .force = line.mean_y, .slope = line.slope, .slope_error = 0};
  if (!(line.sum_xx > 0)) return rise;
  std::vector<double> residuals(stage.size());
  for (std::size_t i = 0; i < stage.size(); ++i)
    residuals[i] = force[i] - line.mean_y - line.slope * (stage[i] - line.mean_x);
  constexpr double max_correlation = 0.8;
  const double scatter = effective_deviation(residuals, 2, correlation_lost_to_line(residuals), max_correlation);
  rise.slope_error = std::max(scatter, force_error) / std::sqrt(line.sum_xx);
  return rise;
}

// What a test takes for known, each off by so many of its standard deviations.
struct AssumedShift {
  double log_stiffness = 0, contact = 0, log_load_train = 0;
};

// The state at the middle of a rise, its slope, and the slopes that the model offers there.
struct Middle {
  double slope, slope_error;
  double S_term, q_term;  // [EI/L^3] F_S, F_q: change of force
  double G_S, G_q;        // change of the stage position
  double T_S, T_q;        // change of the tangential force q Pn

  double stick() const { return q_term / G_q; }
  double slide() const { return S_term / G_S; }
  double position() const { return (slope - slide()) / (stick() - slide()); }

  // p of a stuck fibre on supports of compliance C: dS = C (T_S dS + T_q dq).
  double compliant_position(double C) const {
    const double drawn = C * T_q * G_S;
    const double held = (1 - C * T_S) * G_q;
    return held / (held + drawn);
  }
  double compliant_slope(double C) const {
    const double p = compliant_position(C);
    return (1 - p) * slide() + p * stick();
  }
  // The compliance that explains the slope; NaN if none does.
  double compliance() const {
    const double p = position();
    const double C = (1 - p) * G_q / (p * T_q * G_S + (1 - p) * T_S * G_q);
    return C > 0 && 1 - C * T_S > 0 ? C : not_a_number;
  }
};

std::optional<Middle> middle_of(const Rise& rise, const Rig& rig, const AssumedShift& shift) {
  const double scale = elementary::exp(-shift.log_stiffness);  // of all that is measured in units of EI
  const double stiffness = rig.stiffness * scale * elementary::exp(shift.log_load_train);
  const double F = rise.force * scale;
  const double w = rise.stage - shift.contact - F / stiffness;
  if (!(w > 0 && F > 0)) return std::nullopt;
  const auto state = rig.fibre.state_from_force(w, F);
  if (state.status != FibreStatus::ok || !(state.S > 1)) return std::nullopt;
  const auto [again, slopes] = rig.fibre.state_slopes(state.S, state.q);
  if (again.status != FibreStatus::ok) return std::nullopt;
  return Middle{.slope = rise.slope * scale,
                .slope_error = rise.slope_error * scale,
                .S_term = slopes.F_S,
                .q_term = slopes.F_q,
                .G_S = slopes.w_S + slopes.F_S / stiffness,
                .G_q = slopes.w_q + slopes.F_q / stiffness,
                .T_S = state.q * slopes.Pn_S,
                .T_q = state.Pn + state.q * slopes.Pn_q};
}

// Root sum of squares of what each shift does to a value; NaN results, where a shift leads beyond the model, count as none.
template <class Function>
double systematic_error(std::span<const AssumedShift> shifts, double value, Function at) {
  double sum = 0;
  for (const AssumedShift& shift : shifts) {
    const double change = at(shift) - value;
    if (std::isfinite(change)) sum += change * change;
  }
  return std::sqrt(sum);
}

double chi_squared_of(std::span<const Middle> middles, double C) {
  double sum = 0;
  for (const Middle& m : middles) {
    if (!(1 - C * m.T_S > 0)) return infinity;
    const double deviation = (m.slope - m.compliant_slope(C)) / m.slope_error;
    sum += deviation * deviation;
  }
  return sum;
}

double compliance_slope(const Middle& m, double C) {
  const double h = 1e-5 * C;  // error 1e-10 from curvature, 1e-11 from rounding
  return (m.compliant_slope(C + h) - m.compliant_slope(C - h)) / (2 * h);
}

// The compliance of least chi squared; NaN if no tooth has one. Starts at the best of the teeth's own, so that the least is the global one.
double common_compliance(std::span<const Middle> middles) {
  double best = not_a_number, least = infinity;
  for (const Middle& m : middles) {
    const double C = m.compliance();
    if (!std::isfinite(C)) continue;
    if (const double chi = chi_squared_of(middles, C); chi < least) {
      best = C;
      least = chi;
    }
  }
  for (int iteration = 0; iteration < 30 && std::isfinite(best); ++iteration) {
    double gradient = 0, curvature = 0;
    for (const Middle& m : middles) {
      const double slope = compliance_slope(m, best) / m.slope_error;
      gradient += slope * (m.slope - m.compliant_slope(best)) / m.slope_error;
      curvature += slope * slope;
    }
    double step = gradient / curvature;
    const double before = best;
    for (int halving = 0; halving < 30; ++halving, step *= 0.5) {
      const double C = before + step;
      if (!(C > 0)) continue;
      if (const double chi = chi_squared_of(middles, C); chi < least) {
        best = C;
        least = chi;
        break;
      }
    }
    if (std::abs(best - before) <= 1e-9 * best) break;  // far below its error
  }
  return best;
}

SupportCompliance fit_compliance(std::span<const Rise> rises, const Rig& rig) {
  SupportCompliance result;
  if (rises.size() < 2) return result;
  std::vector<Middle> middles;
  middles.reserve(rises.size());
  for (const Rise& rise : rises)
    if (const auto middle = middle_of(rise, rig, {}); middle && middle->slope_error > 0) middles.push_back(*middle);
  if (middles.size() < 2) return result;
  const double C = common_compliance(middles);
  if (!std::isfinite(C)) return result;

  double information = 0;
  for (const Middle& m : middles) information += std::pow(compliance_slope(m, C) / m.slope_error, 2);
  result.estimate = normal_estimate(C, 1 / std::sqrt(information));
  result.p_value = chi_squared_beyond(chi_squared_of(middles, C), static_cast<double>(middles.size() - 1));
  return result;
}

double length_at(const ReducedRecord& record, const Fibre& fibre, std::size_t row) {
  const double w = record.deflection[row], F = record.force[row];
  if (!(w > 0 && F > 0)) return not_a_number;
  const auto state = fibre.state_from_force(w, F);
  return state.status == FibreStatus::ok ? state.S : not_a_number;
}

}  // namespace

std::string_view name_of(ToothVerdict verdict) {
  return name_in_order<ToothVerdict::undecided>(verdict, {"sliding", "as_if_stuck", "undecided"});
}

Teeth judge_teeth(const ReducedRecord& record, const Rig& rig, const MeasurementErrors& errors,
                  std::span<const Drop> drops, const ToothOptions& options) {
  require_teeth(record, rig, errors, drops, options);
  const std::array<AssumedShift, 3> shifts{AssumedShift{.log_stiffness = errors.bending_stiffness},
                                           AssumedShift{.contact = errors.contact},
                                           AssumedShift{.log_load_train = load_train_error}};
  const double one_sided = elementary::gaussian_quantile(tooth_confidence);

  Teeth result;
  std::vector<Rise> rises;
  for (std::size_t i = 0; i + 1 < drops.size(); ++i) {
    const std::size_t first = drops[i].after, last = drops[i + 1].before + 1;
    if (last < first + min_rows || !(record.stage[last - 1] > record.stage[first])) {
      ++result.too_short;
      continue;
    }
    const Rise rise = straight_rise(record, first, last, errors.force);
    if (middle_of(rise, rig, {})) rises.push_back(rise);
  }
  result.compliance = fit_compliance(rises, rig);

  for (const Rise& rise : rises) {
    const Middle middle = *middle_of(rise, rig, {});
    const auto with = [&](const AssumedShift& shift, auto value) {
      const auto shifted = middle_of(rise, rig, shift);
      return shifted ? value(*shifted) : not_a_number;
    };
    const double width = middle.stick() - middle.slide();
    const double nu = static_cast<double>(rise.last - rise.first) - 2;
    Tooth tooth{.first = rise.first,
                .last = rise.last,
                .S_begin = length_at(record, rig.fibre, rise.first),
                .S_end = length_at(record, rig.fibre, rise.last - 1),
                .slope = student_estimate(rise.slope, rise.slope_error, nu),
                .position = student_estimate(middle.position(), rise.slope_error / width, nu),
                .position_systematic = systematic_error(shifts, middle.position(), [&](const AssumedShift& shift) {
                  return with(shift, [](const Middle& m) { return m.position(); });
                })};

    const double bound = elementary::length(student_quantile(one_sided, nu) * tooth.position.standard_error,
                                            one_sided * tooth.position_systematic);
    const double share = 1 - tooth.position.value;
    if (share - bound > options.min_share) tooth.verdict = ToothVerdict::sliding;
    if (share + bound < options.min_share) tooth.verdict = ToothVerdict::as_if_stuck;

    if (result.compliance.is_found())
      tooth.compliant_position = middle.compliant_position(result.compliance.estimate.value);
    result.teeth.push_back(tooth);
  }
  return result;
}

}  // namespace flexslip
