#include "case/problem.h"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "case/stage_programme.h"
#include "io/quantity.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

// Does the stage ever unload?
bool turns_back(const Case& input) {
  if (!input.stage) return false;
  const std::vector<double> positions = programme_of(input).positions;
  return !std::is_sorted(positions.begin(), positions.end());
}

void require_slender(const Case& input) {
  if (!input.specimen || !input.specimen->section) return;
  const double thickness = depth(*input.specimen->section);
  const double span = span_of(input);
  if (thickness < thickest * span) return;
  throw wrong_value(
      input, depth_key(*input.specimen->section),
      fmt::format("less than a fifth of the span of {}", readable_length(input, span)),
      readable_length(input, thickness),
      "beam theory does not hold for a thicker specimen: check the units of both, or use flexslip modulus");
}

}  // namespace

Scales scales_of(const Case& input, const BendingStiffnessUsed& stiffness) {
  const double span = span_of(input);
  require_slender(input);
  try {
    return {span, stiffness.value};
  } catch (const std::invalid_argument& error) {
    throw wrong_value(input, "specimen", "a bending stiffness and a span that a computer can hold", error.what());
  }
}

Fibre fibre_of(const Case& input, const std::optional<Section>& section, const Scales& scales) {
  if (input.rig->rollers == Rollers::loose)
    throw wrong_value(input, "rig.rollers", "rollers that hold the specimen by friction", "\"loose\"",
                      "write \"fixed\" or \"pinned\"; flexslip simulate shows what happens on loose rollers");
  return Fibre(supports_of(input, section, scales));
}

Supports supports_of(const Case& input, const std::optional<Section>& section, const Scales& scales) {
  const RigInput& rig = *input.rig;
  const bool is_thick = section && rig.friction_at == FrictionAt::surface;
  const Supports supports{scales.reduced_length(rig.roller_radius.value_or(0)),
                          is_thick ? 0.5 * scales.reduced_length(depth(*section)) : 0};
  if (!(supports.radius + supports.half_depth < widest_supports))
    throw wrong_value(
        input, "rig.roller_radius",
        fmt::format("a roller radius and half a thickness that add up to less than {:g} spans", widest_supports),
        fmt::format("{:g} and {:g} spans", supports.radius, supports.half_depth),
        "check the units of both, and the span");
  return supports;
}

Fibre fibre_of(const Case& input, const Scales& scales) {
  return fibre_of(input, input.specimen ? input.specimen->section : std::nullopt, scales);
}

Rig rig_of(const Case& input, const Scales& scales) {
  return {scales.reduced_stiffness(rig_stiffness_of(input)), fibre_of(input, scales)};
}

double breaking_curvature_of(const SpecimenInput& specimen, const std::optional<SurfaceStrain>& surface) {
  if (surface && specimen.strain_at_break) return surface->curvature_at_strain(*specimen.strain_at_break);
  if (surface && specimen.strength) return surface->curvature_at_stress(*specimen.strength);
  return infinity;
}

BendingTest bending_test_of(const Case& input, const Scales& scales, double farthest) {
  const Rig rig = rig_of(input, scales);
  if (!(farthest / (1 + 48 / rig.stiffness) >= nearest_reduced))
    throw wrong_value(input, "rig.stiffness",
                      fmt::format("a rig that bends the specimen by at least {:g} spans", nearest_reduced),
                      readable(load_train_stiffness_of(input), kind_in(input, kind::stiffness)), "check its unit");
  const double S_max = longest_at_stage(farthest);
  Friction kinetic = friction_of(input, rig.fibre, scales, S_max);
  if (climbs_surface(input) && turns_back(input)) kinetic = on_both_ways(input, kinetic, rig.fibre, scales);
  const double excess = input.friction->static_excess;
  const double most = kinetic.most_up_to(S_max) + excess;
  if (excess > 0 && most > rig.fibre.most_friction())
    throw wrong_value(input, "friction.static_excess", "static " + friction_limit(rig.fibre),
                      fmt::format("{:g}, which raises it to {:g}", excess, most), "write a smaller one");
  if (excess > 0 && rig.fibre.supports().radius > 0)
    throw wrong_value(input, "friction.static_excess", "no excess of static over kinetic friction on rollers",
                      fmt::format("{:g}", excess), "delete it, or roller_radius");
  if (kinetic.walk() && input.stage && input.stage->snaps == SnapRest::overshoot)
    throw wrong_value(input, "stage.snaps", "snaps that rest at the nearest stable state, as the two supports differ",
                      "\"overshoot\"", "delete it, or [friction.other]");
  if (!kinetic.lets_stick() && input.stage && input.stage->snaps == SnapRest::overshoot)
    throw wrong_value(input, "stage.snaps", "snaps that rest at the nearest stable state, as friction builds up",
                      "\"overshoot\"", "delete it, or [friction] build_up_length");
  if (!kinetic.lets_stick() && input.specimen && !input.specimen->cracks.empty())
    throw wrong_value(input, "specimen.cracks", "a specimen without cracks, as friction builds up",
                      fmt::format("{} of them", input.specimen->cracks.size()),
                      "delete them, or [friction] build_up_length");
  return {{std::move(kinetic), Friction::constant(excess)},
          rig,
          input.stage ? input.stage->snaps : SnapRest::nearest_stable};
}

double periods_up_to(const Friction& friction, double stage) {
  constexpr double scales_a_period = 4;
  const double drawn_in = 2.5 * stage * stage;  // S - 1, a deflection as far as the stage
  return drawn_in / (scales_a_period * friction.smooth_scale());
}

std::optional<SurfaceStrain> surface_of(const Case& input, const Scales& scales) {
  const auto& section = input.specimen->section;
  return section ? std::optional(SurfaceStrain(*section, scales)) : std::nullopt;
}

double nose_curvature_of(const Case& input, const std::optional<Section>& section, const Scales& scales) {
  if (!input.rig || !input.rig->nose_radius) return infinity;
  return 1 / scales.reduced_length(*input.rig->nose_radius + (section ? 0.5 * depth(*section) : 0));
}

std::vector<Crack> cracks_of(const Case& input, const Scales& scales) {
  std::vector<Crack> cracks;
  for (const CrackInput& crack : input.specimen->cracks)
    cracks.push_back({scales.reduced_length(crack.deflection), crack.loss});
  return cracks;
}

MeasurementErrors errors_of(const Measurement& measurement, const BendingStiffnessUsed& stiffness,
                            const Scales& scales) {
  return {.force = scales.reduced_force(measurement.force_noise),
          .bending_stiffness = stiffness.relative_error,
          .contact = scales.reduced_length(measurement.contact_error)};
}

}  // namespace flexslip
