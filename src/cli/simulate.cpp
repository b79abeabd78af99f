#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "answers/mechanics_fields.h"
#include "case/mechanics.h"
#include "case/simulated_test.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "report/figures.h"
#include "result/table.h"

namespace flexslip {
namespace {

struct SimulateRequest {
  CaseRequest test;
  int points = 200;
  std::string noise;
  std::uint64_t seed = 1;
  bool energies = false;
  std::string figure;
  std::vector<std::string> equilibria_at;
  Output output;
};

double noise_of(const SimulateRequest& request, const Test& input) {
  if (request.noise.empty()) return 0;
  return quantity_of_flag("--noise", request.noise, kind_in(input, kind::force), Range::non_negative);
}

// [L] The stage positions of all equilibria in the figure.
std::vector<double> marked_stages(const SimulateRequest& request, const Test& input, const Scales& scales) {
  std::vector<double> stages;
  for (const std::string& text : request.equilibria_at)
    stages.push_back(scales.reduced_length(
        quantity_of_flag("--equilibria-at", text, kind_in(input, kind::length), Range::positive)));
  return stages;
}

void write_test(const SimulateRequest& request, const SimulatedTest& test) {
  const PathColumns columns = columns_of(test.simulation, request.energies);
  write_rows(request.output, simulation_fields(columns), test.simulation, path_fields(columns), test.simulation.path,
             {test.scales, test.reduced});
}

void run_simulate(const SimulateRequest& request) {
  const Test input = request.test.read();
  const double noise = noise_of(request, input);
  if (!request.equilibria_at.empty() && input.specimen && !input.specimen->cracks.empty())
    throw wrong_value(input, "specimen.cracks",
                      fmt::format("All equilibria are drawn of a specimen without cracks only, and this one has {}",
                                  input.specimen->cracks.size()),
                      "leave out --equilibria-at, or the cracks");
  std::vector<double> marked;
  if (!request.figure.empty() && !request.equilibria_at.empty())
    marked = marked_stages(request, input, scales_of(input, bending_stiffness_of(input)));
  const double farthest = marked.empty() ? 0 : *std::max_element(marked.begin(), marked.end());
  const SimulatedTest test =
      simulate(input, {request.points, noise, request.seed, progress_of("stage positions", request.output)}, farthest);
  for (const std::string& remark : test.remarks) note(request.output, remark);
  write_test(request, test);
  if (!request.figure.empty())
    draw_for(request.output,
             marked.empty() ? simulated_figure(test, cracks_of(input, test.scales)) : equilibria_figure(test, marked),
             request.figure);
  if (!test.why_it_ends.empty()) throw CalculationFailed(test.why_it_ends);
}

}  // namespace

void add_simulate_command(CLI::App& app) {
  const auto [command, request] =
      add_command(app, "simulate", "What a test would measure: its path, snaps and energy account", run_simulate);
  add_case(command, request.test);
  add_option(command, "--points N", request.points,
             "Points on each stretch of sticking or sliding, if the stage moves continuously")
      ->check(count_between(2, 1000000))
      ->capture_default_str();
  add_option(command, "--noise FORCE", request.noise, "Standard deviation of the force readings, such as \"10 uN\"");
  add_option(command, "--seed N", request.seed, "Seed of the noise; the same seed gives the same readings")
      ->check(whole_number())
      ->capture_default_str();
  command.add_flag("--energies", request.energies, "Add the energies from the start to each point of the path");
  add_figure_option(command, request.figure);
  add_repeated(command, "--equilibria-at LENGTH", request.equilibria_at,
               "Draw all equilibria at this stage position in the figure; may be repeated");
  add_output_options(command, request.output, "CSV");
  add_csv_option(command, request.output);
  command.footer(
      "Writes w_s,w,F,S,q,motion: stage, deflection, force, length between the supports, mobilised friction and\n"
      "how the specimen moved there, in SI, or reduced if the case is. motion is stick, slip_in, slip_out, snap,\n"
      "crack or apart (no contact at the nose). The output is a record that `flexslip fit` reads.\n"
      "\n"
      "Some tests have more columns:\n"
      "  section known            strain and stress of bending, at the surface at midspan\n"
      "  supports differ          left and right, the lengths pulled in over the first and the other support\n"
      "  thick, or on rollers     drawn_in, the length pulled in past the first contacts, and imaged, as a camera sees "
      "it\n"
      "  --energies               stage_work, bending, load_train, friction, snaps and cracks, from the start\n"
      "With --json, the result also has snaps and cracks, the energies of each loading and unloading, and the\n"
      "energy account. The figure of a test that is unloaded shows its loops and their direction.\n"
      "\n"
      "If the specimen slips through the supports, the path ends there and the exit code is 1. Where the nose lifts\n"
      "off, w is still the deflection of the specimen.\n\n"
      "Examples:\n"
      "  flexslip simulate case.toml --output test.csv\n"
      "  flexslip simulate case.toml --noise \"10 uN\" --seed 7 --json");
}

}  // namespace flexslip
