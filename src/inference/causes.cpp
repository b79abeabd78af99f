#include "inference/causes.h"

#include <algorithm>
#include <cmath>

#include "inference/cause_coefficients.h"

namespace flexslip {
namespace {

constexpr double of_needed = 0.12;  // [1] relative error of the loss required by the drops

double squashed(double x) { return 1 - 2 / (1 + elementary::exp(2 * std::clamp(x, -20.0, 20.0))); }  // tanh

// The log odds are relative to slips only.
template <std::size_t n>
Causes causes_by(const std::array<double, n>& inputs, const std::array<double, n>& of_cracks,
                 const std::array<double, n>& of_both) {
  double cracks = 0, both = 0;
  for (std::size_t i = 0; i < n; ++i) cracks += of_cracks[i] * inputs[i], both += of_both[i] * inputs[i];
  const double greatest = std::max({cracks, both, 0.0});
  const double weight_of_cracks = elementary::exp(cracks - greatest), weight_of_both = elementary::exp(both - greatest);
  const double weight_of_slips = elementary::exp(-greatest), all = weight_of_slips + weight_of_cracks + weight_of_both;
  return {.slips = weight_of_slips / all, .cracks = weight_of_cracks / all, .both = weight_of_both / all};
}

}  // namespace

CauseInputs inputs_of(const DropFeatures& f, double load_train) {
  constexpr double many = 16;
  constexpr double usual = 100, stiffest = 1e5;  // [EI/L^3] load trains
  const double sure = std::sqrt(std::min(static_cast<double>(f.drops), many) / many);
  const double follows = squashed((f.follows_drops - 0.5) / (3 * elementary::length(f.follows_drops_error, 0.12)));
  return {1,
          follows,
          follows * sure,
          squashed(f.max_steepness / 0.5),
          squashed(f.recovery_near),
          squashed(f.recovery_far),
          squashed(f.least_after_drop / 3),
          squashed(std::min(f.least_after_drop, 0.0) / 6),
          squashed((f.stiffness_recovery - 0.5) / 0.5) * sure,
          squashed(f.roughness),
          sure,
          squashed(f.slid_in / 0.5),
          elementary::log(std::min(load_train, stiffest) / usual)};
}

Causes causes_of(const DropFeatures& features, double load_train) {
  return causes_by(inputs_of(features, load_train), cause_coefficients::cracks, cause_coefficients::both);
}

Causes causes_of(const Causes& by_one_loading, const Reload& reload) {
  constexpr double surest = 0.98;  // limit of the probability from one loading
  const double z = reload.log_loss / reload.error;
  const double c =
      (reload.log_needed - reload.log_loss) / elementary::length(reload.error, of_needed * reload.log_needed);
  const auto bounded = [surest](double p) { return std::isnan(p) ? 1.0 / 3 : std::clamp(p, (1 - surest) / 2, surest); };
  const double slips = bounded(by_one_loading.slips);
  const std::array inputs{1.0,
                          squashed(z / 3),
                          squashed(z / 8),
                          squashed((z * z - c * c) / 12),
                          reload.drops_again ? 1.0 : 0.0,
                          elementary::log(bounded(by_one_loading.cracks) / slips),
                          elementary::log(bounded(by_one_loading.both) / slips)};
  return causes_by(inputs, cause_coefficients::cracks_by_reload, cause_coefficients::both_by_reload);
}

bool slips_at_all(const Causes& causes) { return causes.cracks < 0.05; }

bool loses_at_all(const Causes& causes, bool is_reloaded) { return causes.slips < (is_reloaded ? 0.05 : 0.03); }

bool is_loss(double log_loss, double error) {
  constexpr double errors = 3;
  return log_loss > errors * error;
}

CauseChances chances_of_causes(double log_needed, double error, const Causes& slips_by_one_loading,
                               bool slips_come_again) {
  constexpr int points = 2001;
  constexpr double farthest = 5;  // [standard deviations]
  double weights = 0, slips = 0, cracks = 0;
  const double error_if_cracks = elementary::length(error, of_needed * log_needed);
  for (int i = 0; i < points; ++i) {
    const double x = farthest * (2.0 * i / (points - 1) - 1), weight = elementary::exp(-0.5 * x * x);
    const double told_of_slips = x * error, told_of_cracks = log_needed + x * error_if_cracks;
    const Causes if_slips = causes_of(slips_by_one_loading, {told_of_slips, error, log_needed, slips_come_again});
    const Causes if_cracks = causes_of(Causes{}, {told_of_cracks, error, log_needed, false});
    weights += weight;
    if (slips_at_all(if_slips) && !loses_at_all(if_slips, true) && !is_loss(told_of_slips, error)) slips += weight;
    if ((loses_at_all(if_cracks, true) || is_loss(told_of_cracks, error)) && !slips_at_all(if_cracks)) cracks += weight;
  }
  return {slips / weights, cracks / weights};
}

}  // namespace flexslip
