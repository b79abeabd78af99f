#include "case/inverted_test.h"

#include <cstddef>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "case/problem.h"

namespace flexslip {
namespace {

constexpr std::size_t least_inverted_points = 12;  // a noise, and a profile that is more than a handful of points

std::vector<std::string> assumptions_in_words(const BendingStiffnessUsed& stiffness) {
  constexpr std::string_view remedy =
      R"(state it in the case: modulus = { value = "29.6 GPa", uncertainty = "1.5 GPa" })";
  if (stiffness.source == StiffnessSource::assumed_error)
    return {fmt::format("the bending stiffness is taken to be uncertain by {:g} %; {}", 100 * stiffness.relative_error,
                        remedy)};
  if (stiffness.source == StiffnessSource::initial_slope)
    return {fmt::format("the bending stiffness is that of the initial slope, uncertain by {:.2g} %; {}",
                        100 * stiffness.relative_error, remedy)};
  return {};
}

}  // namespace

InvertedTest invert_test(const Case& asked, const OtherSupports& other) {
  Measurement measurement = read_measurement(asked, least_inverted_points);
  const Case& input = measurement.test;
  const BendingStiffnessUsed stiffness = bending_stiffness_of(input, measurement);
  const Scales scales = scales_of(input, stiffness);
  const ReducedRecord record = to_reduced(measurement.record, scales);
  Rig rig = rig_of(input, scales);
  if (const auto supports = other ? other(input, scales) : std::nullopt) rig.fibre = Fibre(*supports);
  FrictionProfile profile = measure_friction(record, rig, errors_of(measurement, stiffness, scales));
  std::vector<std::string> remarks = assumptions_in_words(stiffness);
  const double most = rig.fibre.most_friction();
  if (!profile.unexplained.empty())
    remarks.push_back(
        fmt::format("no friction between {:g} and {:g} explains {} readings, which are left out; the first is row {}",
                    -most, most, profile.unexplained.size(), file_row(measurement, profile.unexplained.front())));
  const bool is_thick = least_half_depths * rig.fibre.supports().half_depth > hardly_bent;
  std::string why;
  if (profile.points.empty())
    why = fmt::format(
        "{}: friction cannot be read off: all deflections are below {}, or no friction explains them; check the units",
        measurement.file,
        is_thick ? "twice the thickness of the specimen, up to where its surface hardly slides" : "0.02 spans");
  return {std::move(measurement), stiffness, scales, std::move(profile), std::move(remarks), std::move(why)};
}

}  // namespace flexslip
