#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bending_test/history.h"
#include "cli/commands.h"
#include "cli/output.h"
#include "io/input_error.h"
#include "io/model_figures.h"
#include "io/problem.h"

namespace flexslip {
namespace {

struct SimulateRequest {
  std::string file;
  int points = 200;
  std::string noise;
  std::uint64_t seed = 1;
  std::string figure;
  std::vector<std::string> equilibria_at;
  Output output;
};

std::string_view name_of(Motion motion) {
  switch (motion) {
    case Motion::stick:
      return "stick";
    case Motion::slip_in:
      return "slip_in";
    case Motion::slip_out:
      return "slip_out";
    case Motion::snap:
      return "snap";
  }
  throw std::invalid_argument("no such motion");
}

// The path of a history in SI, as it is written.
struct SimulatedTest {
  std::vector<double> stage, deflection, force, length, friction;
  std::vector<std::string_view> motion;
};

SimulatedTest physical_path(const History& history, const Scales& scales) {
  SimulatedTest test;
  for (const PathPoint& point : history.path) {
    test.stage.push_back(scales.physical_length(point.stage));
    test.deflection.push_back(scales.physical_length(point.w));
    test.force.push_back(scales.physical_force(point.F));
    test.length.push_back(scales.physical_length(point.S));
    test.friction.push_back(point.q);
    test.motion.push_back(name_of(point.motion));
  }
  return test;
}

// Gaussian noise on the force, and so on the deflection, which an experiment infers from the force and the stage.
void add_noise(SimulatedTest& test, double deviation, double stiffness, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  const auto uniform = [&] { return (static_cast<double>(generator() >> 11) + 0.5) * 0x1p-53; };
  for (std::size_t i = 0; i < test.force.size(); ++i) {
    // Box & Muller, because std::normal_distribution differs between libraries.
    const double radius = std::sqrt(-2 * std::log(uniform()));
    const double error = deviation * radius * std::cos(2 * std::numbers::pi * uniform());
    test.force[i] += error;
    test.deflection[i] -= error / stiffness;
  }
}

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

void run_simulate(const SimulateRequest& request) {
  const Case input = read_case(request.file);
  const double noise = noise_of(request, input);
  const Scales scales = scales_of(input, bending_stiffness_of(input));
  const Rig rig = rig_of(input, scales);
  const double farthest = scales.reduced_length(farthest_stage(input));
  const Friction friction = friction_of(input, scales, longest_at_stage(farthest));

  std::vector<double> stages;  // [m] asked for
  if (input.stage->step) stages = stages_of(input);
  std::vector<double> reduced_stages;
  reduced_stages.reserve(stages.size());
  for (const double stage : stages) reduced_stages.push_back(scales.reduced_length(stage));
  const History history = input.stage->step
                              ? follow_in_steps({friction, rig}, reduced_stages)
                              : follow_continuously({friction, rig}, input.stage->program, request.points);

  SimulatedTest test = physical_path(history, scales);
  // A stage in steps stands where it was asked to, without the rounding of there and back.
  if (input.stage->step)
    test.stage.assign(stages.begin(), stages.begin() + static_cast<std::ptrdiff_t>(test.stage.size()));
  add_noise(test, noise, input.rig->stiffness.value(), request.seed);

  if (!request.figure.empty()) {
    const DrawnIn units{scales, input.reduced};
    const std::vector<double> marked = marked_stages(request, input, scales);
    draw_for(request.output,
             marked.empty() ? measured_figure(friction, history, units)
                            : overall_equilibria_figure(friction, rig, marked, units),
             request.figure);
  }
  const bool json = request.output.json;
  const auto title = [&](std::string_view symbol, std::string_view word, std::string_view unit) {
    return json ? std::string(word) : column_title(symbol, unit, input.reduced);
  };
  const std::vector<OutputColumn> columns{{title("w_s", "stage", "m"), test.stage},
                                          {title("w", "deflection", "m"), test.deflection},
                                          {title("F", "force", "N"), test.force},
                                          {title("S", "length", "m"), test.length},
                                          {"q", test.friction},
                                          {"motion", test.motion}};
  const bool slipped_through = history.status == HistoryStatus::slipped_through;
  if (json)
    write_json(request.output.path, {{"status", slipped_through ? "slipped_through" : "ok"},
                                     {"units", units_json(input.reduced)},
                                     {"path", rows_json(columns)},
                                     {"snaps", snaps_json(history.snaps, scales)},
                                     {"energy", energy_json(history.energy, scales)}});
  else
    write_table(request.output.path, columns);
  if (slipped_through)
    throw CalculationFailed(fmt::format(
        "{}: the specimen slips through the supports after the stage position {}: the path ends there", input.source,
        readable(test.stage.empty() ? 0 : test.stage.back(), input.reduced ? kind::number : kind::length)));
}

}  // namespace

void add_simulate_command(CLI::App& app) {
  const auto request = std::make_shared<SimulateRequest>();
  CLI::App* command = app.add_subcommand("simulate", "What a test would measure: its path, snaps and energy account");
  command->add_option("case", request->file, "Case file; - is standard input")->type_name("CASE")->required();
  command
      ->add_option("--points", request->points, "Points on each stable part, if the stage has the step \"continuous\"")
      ->type_name("N")
      ->check(CLI::Range(2, 1000000).description(""))
      ->capture_default_str();
  command->add_option("--noise", request->noise, "Standard deviation of the force readings, such as \"10 uN\"")
      ->type_name("FORCE");
  command->add_option("--seed", request->seed, "Of the noise: the same seed gives the same readings")
      ->type_name("N")
      ->capture_default_str();
  add_figure_option(*command, request->figure);
  command
      ->add_option("--equilibria-at", request->equilibria_at,
                   "In the figure, all overall equilibria at this stage position; may be repeated")
      ->type_name("LENGTH");
  add_output_options(*command, request->output);
  command->footer(
      "Writes w_s,w,F,S,q,motion: stage, deflection, force, length between the supports, mobilised friction\n"
      "and how the specimen moved there (slip_in, snap); in SI, or reduced if the case is. With --json also\n"
      "the snaps and the energy account. The output is a record that `flexslip fit` reads. If the specimen\n"
      "slips through the supports, the path ends there, and the exit code is 1.\n\n"
      "Examples:\n"
      "  flexslip simulate case.toml --output test.csv\n"
      "  flexslip simulate case.toml --noise \"10 uN\" --seed 7 --json");
  command->callback([request] { run_simulate(*request); });
}

}  // namespace flexslip
