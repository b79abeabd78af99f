#include "case/studies.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "case/fitted.h"
#include "case/mechanics.h"
#include "fibre/supported_state.h"
#include "io/input_error.h"
#include "io/quantity.h"

namespace flexslip {
namespace {

constexpr double longest_by_default = 1.5;  // [L] about the end of a real test, at a deflection of half the span

// The maximum length of the computation.
double longest_of(const EquilibriumChoice& choice, const Test& input, const Scales& scales) {
  if (choice.longest.empty()) return longest_by_default;
  const Kind kind = kind_in(input, kind::length);
  const double S_max = scales.reduced_length(quantity_of_flag("--longest", choice.longest, kind, Range::positive));
  if (S_max > 1) return S_max;
  throw InputError({.field = "--longest",
                    .problem = fmt::format("{} is not a length greater than the span", in_quotes(choice.longest))});
}

// Enough points to resolve every period and piece of friction. Points are evenly spaced in √(S -
// 1); the last are the farthest apart, 2 (S_max - 1)/n.
int points_for(const Friction& friction, double S_max) {
  const double for_waves = 8 * (S_max - 1) / friction.smooth_scale();
  const double for_knots = 4 * static_cast<double>(friction.knots().size());
  return static_cast<int>(std::clamp(std::max(for_waves, for_knots), 500.0, static_cast<double>(max_equilibria)));
}

constexpr std::size_t min_inverted_points = 12;  // for a noise estimate and a useful profile

std::vector<std::string> assumptions_in_words(const BendingStiffnessUsed& stiffness) {
  constexpr std::string_view remedy =
      R"(state it in the case: modulus = { value = "29.6 GPa", uncertainty = "1.5 GPa" })";
  if (stiffness.source == StiffnessSource::assumed_error)
    return {fmt::format("the bending stiffness is taken to be uncertain by {:g} %; {}", 100 * stiffness.relative_error,
                        remedy)};
  if (stiffness.source == StiffnessSource::initial_slope)
    return {fmt::format("the bending stiffness follows from the initial slope, uncertain by {:.2g} %; {}",
                        100 * stiffness.relative_error, remedy)};
  return {};
}

}  // namespace

EquilibriumStudy study_equilibria(const Test& input, const EquilibriumChoice& choice) {
  const Scales scales = scales_of(input);
  const double S_max = longest_of(choice, input, scales);
  const Fibre fibre = fibre_of(input, scales);
  const Friction friction = friction_of(input, fibre, scales, S_max);
  const int n = choice.points > 0 ? choice.points : choice.region ? 100 : points_for(friction, S_max);
  EquilibriumStudy study{
      input.reduced, is_in_inches(input), choice.region, scales, fibre, friction, S_max, EquilibriumStatus::ok, {}};
  if (choice.region) {
    study.points = equilibrium_region(friction, S_max, n, choice.levels, fibre);
    return study;
  }
  auto curve = equilibrium_curve(friction, Sliding::in, S_max, n, fibre);
  study.status = curve.status;
  study.points = std::move(curve.points);
  return study;
}

EquilibriumPortrait portrait_of(const EquilibriumStudy& study) {
  return portrait_of(study.friction, study.fibre, study.longest);
}

InvertedTest invert_test(const Test& asked, const OtherSupports& other) {
  Measurement measurement = read_measurement(asked, {.points = min_inverted_points, .span = true});
  const Test& input = measurement.test;
  const BendingStiffnessUsed stiffness = bending_stiffness_of(input, measurement);
  const Scales scales = scales_of(input, stiffness);
  const ReducedRecord record = to_reduced(measurement.record, scales);
  Rig rig = rig_of(input, scales);
  if (const auto supports = other ? other(input, scales) : std::nullopt) rig.fibre = Fibre(*supports);
  FrictionProfile profile = measure_friction(record, rig, errors_of(measurement, stiffness, scales));
  std::vector<std::string> remarks = assumptions_in_words(stiffness);
  const double most = rig.fibre.max_friction();
  if (!profile.unexplained.empty())
    remarks.push_back(
        fmt::format("no friction between {:g} and {:g} explains {} readings, which are left out; the first is row {}",
                    -most, most, profile.unexplained.size(), file_row(measurement, profile.unexplained.front())));
  const bool is_thick = least_half_depths * rig.fibre.supports().half_depth > min_profile_deflection;
  std::string why;
  if (profile.points.empty())
    why = fmt::format(
        "{}: friction cannot be determined: all deflections are below {}, or no friction explains them; check the "
        "units",
        measurement.file,
        is_thick ? "twice the thickness of the specimen, where its surface slides almost nowhere" : "0.02 spans");
  return {std::move(measurement), stiffness, scales, std::move(profile), std::move(remarks), std::move(why)};
}

std::optional<ForceWindow> window_of(const std::vector<std::string>& words) {
  if (words.empty()) return std::nullopt;
  const auto share = [](const std::string& text) {
    return quantity_of_flag("--window", text, kind::number, Range::non_negative);
  };
  const ForceWindow window{share(words.at(0)), share(words.at(1))};
  if (window.from < window.up_to && window.up_to <= 1) return window;
  throw InputError({.field = "--window",
                    .problem = fmt::format("{} and {} are not two increasing shares of the maximum force, at most 1",
                                           words[0], words[1])});
}

ModulusStudy study_modulus(const Test& input, const std::optional<ForceWindow>& window,
                           const std::optional<ShareRange>& friction) {
  constexpr std::size_t min_points_of_line = 11;  // for a noise estimate
  Measurement measurement = read_measurement(input, {.points = min_points_of_line});
  const BeamGeometry geometry = geometry_of(measurement.test);
  const SmallDeflection numbers = small_deflection_of(measurement, window);
  const SupportsGain supports =
      numbers.status == SmallDeflectionStatus::ok ? supports_gain(measurement, numbers, friction) : SupportsGain{};
  return {std::move(measurement), geometry, numbers, supports};
}

}  // namespace flexslip
