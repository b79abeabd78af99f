#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "answers/path_fields.h"
#include "bending_test/history.h"
#include "bending_test/rolling.h"
#include "case/problem.h"
#include "case/simulation.h"
#include "cli/case_flags.h"
#include "cli/commands.h"
#include "cli/output.h"
#include "cli/progress.h"
#include "data/section.h"
#include "fibre/elastica.h"
#include "io/input_error.h"
#include "report/model_figures.h"
#include "result/json.h"
#include "result/table.h"

namespace flexslip {
namespace {

struct SimulateRequest {
  std::string file;
  std::vector<std::string> changes;
  int points = 200;
  std::string noise;
  std::uint64_t seed = 1;
  bool energies = false;
  std::string figure;
  std::vector<std::string> equilibria_at;
  Output output;
};

double noise_of(const SimulateRequest& request, const Case& input) {
  if (request.noise.empty()) return 0;
  try {
    return parse_quantity(request.noise, input.reduced ? kind::number : kind::force, Range::non_negative);
  } catch (const InputError& error) {
    throw located(error, "", 0, "--noise");
  }
}

// The stage positions [L] at which the figure is to show all equilibria.
std::vector<double> marked_stages(const SimulateRequest& request, const Case& input, const Scales& scales) {
  std::vector<double> stages;
  for (const std::string& text : request.equilibria_at) try {
      stages.push_back(
          scales.reduced_length(parse_quantity(text, input.reduced ? kind::number : kind::length, Range::positive)));
    } catch (const InputError& error) {
      throw located(error, "", 0, "--equilibria-at");
    }
  return stages;
}

PathColumns columns_of(const Simulation& test, const SimulateRequest& request) {
  return {test.has_surface, test.has_three_lengths, test.has_two_sides, request.energies};
}

void write_test(const SimulateRequest& request, const Simulation& test, const Scales& scales, bool reduced) {
  const Frame frame{scales, reduced};
  if (request.output.json)
    write_json(request.output.path, simulation_fields(columns_of(test, request))(test, frame));
  else
    write_csv(request.output.path, path_fields(columns_of(test, request)), test.path, frame);
}

// Why the path ends before its programme does.
std::string reason_of_end(const Case& input, HistoryStatus status, const Simulation& test) {
  const std::string last =
      readable(test.path.empty() ? 0 : test.path.back().stage, input.reduced ? kind::number : kind::length);
  if (status == HistoryStatus::slipped_through)
    return fmt::format("{}: the specimen slips through the supports after the stage position {}: the path ends there",
                       input.source, last);
  return fmt::format(
      "{}: a snap lets the specimen out until no force is left on it, after the stage position {}: the path ends there",
      input.source, last);
}

// A continuous path has so many points on each stretch of sliding and each snap, and fine roughness has very many.
// Fails:      InputError for more than fit into a gigabyte.
void require_path_that_fits(const Case& input, const Friction& friction, const std::vector<double>& turns, int points) {
  constexpr double most_points = 8e6;  // of a hundred bytes
  double periods = 0;                  // passed at most
  for (std::size_t i = 1; i < turns.size(); ++i)
    periods += std::abs(periods_up_to(friction, turns[i]) - periods_up_to(friction, turns[i - 1]));
  const double expected = 2 * periods * points;
  if (expected <= most_points) return;
  throw wrong_value(input, "stage.step",
                    fmt::format("a step, as friction varies over some {:.0e} periods on the way", periods),
                    "none: a continuous path",
                    fmt::format("write step = \"…\" into [stage], or pass --points {:.0f}",
                                std::max(std::floor(most_points / (2 * periods)), 2.0)));
}

// Where the nose first lifts off a specimen that stays bent; "" where it does not.
std::string lift_in_words(const Case& input, const History& history, const Scales& scales) {
  const auto apart = std::find_if(history.path.begin(), history.path.end(),
                                  [](const PathPoint& point) { return point.motion == Motion::apart; });
  if (apart == history.path.end()) return "";
  return fmt::format(
      "the nose lifts off at the stage position {}: friction holds the specimen bent there without a force, until the "
      "nose is back",
      readable(scales.physical_length(apart->w), input.reduced ? kind::number : kind::length));
}

// What the mechanics leaves out of a specimen: that it breaks, and that it shears.
std::vector<std::string> left_out_in_words(const Case& input, const Simulation& test, const Scales& scales) {
  std::vector<std::string> remarks;
  const SpecimenInput& specimen = *input.specimen;
  const double breaks_at = breaking_curvature_of(specimen, surface_of(input, scales));
  const auto surface = surface_of(input, scales);
  const auto breaks =
      surface ? std::find_if(test.path.begin(), test.path.end(),
                             [&](const SimulatedPoint& point) { return point.strain >= surface->strain(breaks_at); })
              : test.path.end();
  if (breaks != test.path.end())
    remarks.push_back(fmt::format(
        "the specimen would break at the stage position {}, as stated: what follows is for a specimen that bears more",
        readable(breaks->stage, input.reduced ? kind::number : kind::length)));
  constexpr double worth_a_word = 0.01;
  if (specimen.section)
    if (const double share = shear_share(*specimen.section, scales.span()); share > worth_a_word)
      remarks.push_back(fmt::format("shear, which is left out, would add {:.1f} % to a small deflection", 100 * share));
  return remarks;
}

// On rollers that roll loose: no snaps, no heat, no history.
void run_rolling(const SimulateRequest& request, const Case& input, const Scales& scales,
                 const StageProgramme& programme) {
  for (const auto& [asked, field] :
       {std::pair{!request.figure.empty(), "--figure"}, std::pair{!request.equilibria_at.empty(), "--equilibria-at"},
        std::pair{!input.specimen->cracks.empty(), "[specimen] cracks"},
        std::pair{input.friction && input.friction->other, "[friction.other]"}})
    if (asked)
      throw InputError({.file = input.source,
                        .field = field,
                        .expected = "rollers that are fixed or on pins beside it",
                        .found = "rollers = \"loose\"",
                        .remedy = "leave it out"});
  const Supports supports = supports_of(input, input.specimen->section, scales);
  const double stiffness = scales.reduced_stiffness(rig_stiffness_of(input));
  const auto surface = surface_of(input, scales);
  std::vector<double> stages{programme.positions.front()};
  for (std::size_t i = 1; i < programme.positions.size(); ++i) {
    const double from = programme.positions[i - 1], to = programme.positions[i];
    const int parts = programme.in_steps ? 1 : request.points;
    for (int j = 1; j <= parts; ++j) stages.push_back(j < parts ? from + (to - from) * j / parts : to);
  }
  Simulation test{.status = {},
                  .path = {},
                  .snaps = {},
                  .cracks = {},
                  .wraps_nose_from = {},
                  .legs = {},
                  .has_surface = surface.has_value(),
                  .has_three_lengths = true,
                  .has_two_sides = false};
  EnergyAccount energy{};
  bool gets_there = true;
  // A roller needs friction to roll.
  std::optional<Friction> friction;
  if (input.friction && input.friction->profile)
    friction =
        frictions_of(input, Fibre(supports), scales, longest_at_stage(scales.reduced_length(programme.farthest))).first;
  std::optional<double> slides_from, friction_there;
  const auto shown = [&](double position) { return readable(position, input.reduced ? kind::number : kind::length); };
  for (const double position : stages) {
    const double stage = scales.reduced_length(position);
    const auto found = state_at_stage(stage, stiffness, supports);
    gets_there = found.has_value();
    if (!gets_there) break;
    const SupportedState& state = found->state;
    if (friction && !slides_from && std::abs(state.q) > friction->at(state.length).mu) {
      slides_from = position;
      friction_there = std::abs(state.q);
    }
    energy.bending = state.U;
    energy.load_train = std::isinf(stiffness) ? 0 : 0.5 * state.F * state.F / stiffness;
    energy.stage_work = energy.bending + energy.load_train;
    test.path.push_back({.stage = position,
                         .deflection = scales.physical_length(state.w),
                         .force = scales.physical_force(state.F),
                         .length = scales.physical_length(state.length),
                         .q = state.q,
                         .motion = "rolls",
                         .drawn_in = scales.physical_length(state.slid),
                         .imaged = scales.physical_length(state.imaged),
                         .strain = surface ? surface->strain(state.curvature) : 0,
                         .stress = surface ? surface->stress(state.curvature) : 0,
                         .energy = energy});
  }
  test.status = gets_there ? "ok" : "not_computable";
  test.energy = energy;
  add_noise(test.path, noise_of(request, input), rig_stiffness_of(input), request.seed);
  write_test(request, test, scales, input.reduced);
  for (const std::string& remark : left_out_in_words(input, test, scales)) note(request.output, remark);
  if (slides_from)
    note(request.output, fmt::format("from the stage position {} on, rolling takes more friction than the case states, "
                                     "{:.3g} and more: the specimen slides on its rollers, as if these were fixed",
                                     shown(*slides_from), *friction_there));
  if (!gets_there)
    throw CalculationFailed(
        fmt::format("{}: loose rollers are computed up to the stage position {}: beyond, the specimen slips through, "
                    "is bent by more than {:g} spans, or the rollers, with half of its thickness, take more than {:g} "
                    "of the distance that is left between them",
                    input.source, shown(test.path.back().stage), deepest_on_supports, widest_supports));
}

void run_simulate(const SimulateRequest& request) {
  constexpr double least_measured_travel = 0.02;  // of a turn of a stage that was measured, with its noise
  constexpr double least_stated_travel = 1e-9;    // of one that was written down
  const Case input = read_case(request.file, request.changes);
  const double noise = noise_of(request, input);
  const Scales scales = scales_of(input, bending_stiffness_of(input));
  const StageProgramme programme = programme_of(input);
  if (input.rig->rollers == Rollers::loose) return run_rolling(request, input, scales, programme);
  if (!request.equilibria_at.empty() && !input.specimen->cracks.empty())
    throw wrong_value(input, "specimen.cracks", "a specimen without cracks, to draw all equilibria of",
                      fmt::format("{}", input.specimen->cracks.size()), "leave out --equilibria-at, or the cracks");
  std::vector<double> marked;
  if (!request.figure.empty()) marked = marked_stages(request, input, scales);
  double farthest = scales.reduced_length(programme.farthest);
  for (const double stage : marked) farthest = std::max(farthest, stage);
  const BendingTest bending_test = bending_test_of(input, scales, farthest);

  std::vector<double> stages;
  stages.reserve(programme.positions.size());
  for (const double position : programme.positions) stages.push_back(scales.reduced_length(position));
  if (!programme.in_steps) require_path_that_fits(input, bending_test.friction.kinetic, stages, request.points);
  const std::vector<Crack> cracks = cracks_of(input, scales);
  const auto progress = progress_of("stage positions", request.output);
  const History history = programme.in_steps
                              ? follow_in_steps(bending_test, stages, cracks, progress)
                              : follow_continuously(bending_test, stages, request.points, cracks, progress);
  if (const std::string lift = lift_in_words(input, history, scales); !lift.empty()) note(request.output, lift);
  const LegOptions leg_options{programme.measured ? least_measured_travel : least_stated_travel};
  Simulation test = simulated(input, history, bending_test.rig.fibre, scales, leg_options);
  if (test.wraps_nose_from)
    note(request.output, fmt::format("from the stage position {} on the specimen is bent more sharply than the nose, "
                                     "and wraps it: what follows is for a sharp nose",
                                     readable(scales.physical_length(*test.wraps_nose_from),
                                              input.reduced ? kind::number : kind::length)));
  // A stage in steps stands where it was asked to, without the rounding of there and back.
  if (programme.in_steps)
    for (std::size_t i = 0; i < test.path.size(); ++i) test.path[i].stage = programme.positions[i];
  for (const std::string& remark : left_out_in_words(input, test, scales)) note(request.output, remark);
  add_noise(test.path, noise, rig_stiffness_of(input), request.seed);

  if (!request.figure.empty()) {
    const DrawnIn units{scales, input.reduced};
    // Also between the readings of a stage in steps.
    const History drawn = programme.in_steps ? follow_continuously(bending_test, stages, 2, cracks) : history;
    draw_for(request.output,
             marked.empty() ? measured_figure(bending_test, drawn, legs_of(drawn, leg_options), units)
                            : overall_equilibria_figure(bending_test.friction.kinetic, bending_test.rig, marked, units),
             request.figure);
  }
  write_test(request, test, scales, input.reduced);
  if (history.status != HistoryStatus::ok) throw CalculationFailed(reason_of_end(input, history.status, test));
}

}  // namespace

void add_simulate_command(CLI::App& app) {
  const auto request = std::make_shared<SimulateRequest>();
  CLI::App* command = app.add_subcommand("simulate", "What a test would measure: its path, snaps and energy account");
  command->add_option("case", request->file, "Case file; - is standard input")->type_name("CASE")->required();
  add_set_option(*command, request->changes);
  command
      ->add_option("--points", request->points,
                   "Points on each stretch of sticking or sliding, if the stage has the step \"continuous\"")
      ->type_name("N")
      ->check(CLI::Range(2, 1000000).description(""))
      ->capture_default_str();
  command->add_option("--noise", request->noise, "Standard deviation of the force readings, such as \"10 uN\"")
      ->type_name("FORCE");
  command->add_option("--seed", request->seed, "Seed of the noise: the same seed gives the same readings")
      ->type_name("N")
      ->capture_default_str();
  command->add_flag("--energies", request->energies, "Add the energies up to each point of the path");
  add_figure_option(*command, request->figure);
  command
      ->add_option("--equilibria-at", request->equilibria_at,
                   "Draw all overall equilibria at this stage position in the figure; may be repeated")
      ->type_name("LENGTH");
  add_output_options(*command, request->output);
  command->footer(
      "Writes w_s,w,F,S,q,motion: stage, deflection, force, length between the supports, mobilised friction and\n"
      "how the specimen moved there, in SI, or reduced if the case is. motion is stick, slip_in, slip_out, snap,\n"
      "crack, apart (the nose is off the specimen) or rolls (on loose rollers). The output is a record that\n"
      "`flexslip fit` reads.\n"
      "\n"
      "Some tests have more columns:\n"
      "  section known            strain and stress of bending, at the surface at midspan\n"
      "  supports not alike       left and right, what is drawn in over the first and over the other\n"
      "  thick, or on rollers     drawn_in, what has slid past the first contacts, and imaged, what a camera sees\n"
      "  --energies               stage_work, bending, load_train, friction, snaps and cracks, from the start\n"
      "With --json, the result also has snaps and cracks, the energies of each loading and unloading, and the\n"
      "energy account. The figure of a test that is unloaded shows its loops and their direction.\n"
      "\n"
      "If the specimen slips through the supports, the path ends there, and the exit code is 1. Where the nose\n"
      "lifts off, w stays that of the specimen.\n\n"
      "Examples:\n"
      "  flexslip simulate case.toml --output test.csv\n"
      "  flexslip simulate case.toml --noise \"10 uN\" --seed 7 --json");
  command->callback([request] { run_simulate(*request); });
}

}  // namespace flexslip
