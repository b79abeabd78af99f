#include <string>
#include <string_view>

#include <fmt/format.h>

#include "answers/design_fields.h"
#include "case/mechanics.h"
#include "case/simulated_test.h"
#include "design/design_answer.h"
#include "design/design_result.h"
#include "fibre/supported_state.h"
#include "flexslip/design.h"
#include "flexslip/simulate.h"
#include "flexslip/state.h"
#include "library/inputs.h"
#include "numerics/elementary.h"
#include "report/answer_documents.h"
#include "result/table.h"

namespace flexslip::v1 {
namespace {

using library::checked;
using library::described;
using library::guarded;
using library::with;

struct Specimen {
  Scales scales;
  Supports supports;
};

Specimen specimen_of(const Setup& setup) {
  const Test test = checked(described(setup));
  const Scales scales = scales_of(test);
  return {scales, supports_of(test, scales)};
}

void require_between(std::string_view name, double value, double least, double most, std::string_view unit) {
  if (value >= least && value <= most) return;
  throw InputError(
      {.problem = fmt::format("The {0} is {1:g}{4}, not from {2:g} to {3:g}{4}", name, value, least, most, unit)});
}

// [L]
double reduced_deflection(const Specimen& specimen, double deflection) {
  constexpr double least = 1e-60;  // [m] as of every quantity of a case
  require_between("deflection", deflection, least, deepest_on_supports * specimen.scales.span(), " m");
  return specimen.scales.reduced_length(deflection);
}

// A state in SI.
// Fails:      InputError with the reason if it does not exist.
State physical_state(const SupportedState& state, const Scales& scales, const std::string& why_not) {
  if (state.status != FibreStatus::ok) throw InputError({.problem = why_not});
  return {.deflection = scales.physical_length(state.w),
          .force = scales.physical_force(state.F),
          .friction = state.q,
          .length = scales.physical_length(state.length),
          .slid = scales.physical_length(state.slid),
          .slope = state.theta0,
          .normal_force = scales.physical_force(state.Pn),
          .energy = scales.physical_energy(state.U),
          .curvature = state.curvature / scales.span()};
}

Snap physical_snap(const flexslip::Snap& snap, const Scales& scales) {
  return {.stage = scales.physical_length(snap.stage),
          .deflection_before = scales.physical_length(snap.before.w),
          .deflection_after = scales.physical_length(snap.after.w),
          .force_before = scales.physical_force(snap.before.F),
          .force_after = scales.physical_force(snap.after.F),
          .pulled_in = scales.physical_length(snap.after.S - snap.before.S),
          .friction = scales.physical_energy(snap.friction),
          .released = scales.physical_energy(snap.released)};
}

Energies physical_energies(const EnergyAccount& energy, const Scales& scales) {
  return {.stage_work = scales.physical_energy(energy.stage_work),
          .bending = scales.physical_energy(energy.bending),
          .load_train = scales.physical_energy(energy.load_train),
          .friction = scales.physical_energy(energy.friction),
          .snaps = scales.physical_energy(energy.snaps),
          .work_of_fracture = scales.physical_energy(work_of_fracture(energy))};
}

Simulation simulated(const Setup& setup, const Friction& friction, const Programme& programme) {
  const Test test = checked(with(with(described(setup), friction), programme));
  const SimulatedTest of_test = flexslip::simulate(test, {.noise = programme.force_noise, .seed = programme.seed});
  Simulation simulation{.path = {},
                        .snaps = {},
                        .energies = physical_energies(of_test.simulation.energy, of_test.scales),
                        .why_it_ends = of_test.why_it_ends};
  for (const SimulatedPoint& point : of_test.simulation.path)
    simulation.path.push_back({point.stage, point.deflection, point.force, point.length, point.q, point.motion});
  for (const flexslip::Snap& snap : of_test.simulation.snaps)
    simulation.snaps.push_back(physical_snap(snap, of_test.scales));
  return simulation;
}

Design designed(const Setup& setup, const Friction& friction, const Programme& loading) {
  const Test test = checked(with(with(described(setup), friction), loading));
  const DesignAnswer answer = answer_of(one_loading_of(test));
  const std::string sentence = design_in_short(answer);
  const Scales& scales = answer.scales;
  const DesignOutcome& outcome = answer.outcome;
  return {.status = std::string(word_of(status_of(outcome))),
          .sentence = sentence,
          .snaps = outcome.snaps,
          .drops = outcome.drops,
          .largest_drop = scales.physical_force(outcome.largest_drop),
          .maximum_force = scales.physical_force(outcome.greatest_force),
          .critical_stiffness = scales.physical_stiffness(answer.critical),
          .work_of_fracture = scales.physical_energy(outcome.work),
          .friction_share = flexslip::friction_share(outcome),
          .json = json_text(design_fields()({answer, sentence, changes_in_words(answer)}, {scales, false}))};
}

}  // namespace

State state_at(const Setup& setup, double deflection, double friction) {
  return guarded([&] {
    const Specimen specimen = specimen_of(setup);
    require_between("friction", friction, -largest_q, largest_q, "");
    return physical_state(state_on_supports(reduced_deflection(specimen, deflection), friction, specimen.supports),
                          specimen.scales,
                          fmt::format("No state with a force exists at a deflection of {} m with a friction of {}",
                                      deflection, friction));
  });
}

State state_from_force(const Setup& setup, double deflection, double force) {
  return guarded([&] {
    const Specimen specimen = specimen_of(setup);
    require_between("force", force, 0, infinity, " N");
    return physical_state(
        state_on_supports_from_force(reduced_deflection(specimen, deflection), specimen.scales.reduced_force(force),
                                     specimen.supports),
        specimen.scales, fmt::format("No friction from -2 to 2 gives {} N at a deflection of {} m", force, deflection));
  });
}

Simulation simulate(const Setup& setup, const Friction& friction, const Programme& programme) {
  return guarded([&] { return simulated(setup, friction, programme); });
}

Design design(const Setup& setup, const Friction& friction, double travel, double step) {
  return guarded([&] { return designed(setup, friction, {.stages = {0, travel}, .step = step}); });
}

}  // namespace flexslip::v1
