#include "case/simulated_test.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include <fmt/format.h>

#include "data/names.h"
#include "data/section.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

std::string_view name_of(Motion motion) {
  return name_in_order<Motion::apart>(motion, {"stick", "slip_in", "slip_out", "snap", "crack", "apart"});
}

EnergyAccount difference(const EnergyAccount& after, const EnergyAccount& before) {
  EnergyAccount change{};
  for (auto part : {&EnergyAccount::stage_work, &EnergyAccount::bending, &EnergyAccount::load_train,
                    &EnergyAccount::friction, &EnergyAccount::snaps, &EnergyAccount::cracks})
    change.*part = after.*part - before.*part;
  return change;
}

// The legs of a path, as indices of its points. The start from the straight fibre belongs to the
// first leg.
template <class Point>
std::vector<Leg> legs_along(const std::vector<Point>& path, const LegOptions& options) {
  std::vector<double> stages{0};
  stages.reserve(path.size() + 1);
  for (const Point& point : path) stages.push_back(point.stage);
  std::vector<Leg> legs;
  for (const Leg& leg : find_legs(stages, options)) {
    const Leg of_path{std::max<std::size_t>(leg.first, 1) - 1, leg.last - 1, leg.direction};
    if (of_path.last > of_path.first) legs.push_back(of_path);
  }
  return legs;
}

// The stage position at which the specimen first wraps the nose.
std::optional<double> wraps_nose_from(const Test& input, const History& history, const Fibre& fibre,
                                      const Scales& scales) {
  const double most = nose_curvature_of(input, scales);
  if (std::isinf(most)) return std::nullopt;
  const auto wraps = std::find_if(history.path.begin(), history.path.end(), [&](const PathPoint& point) {
    return fibre.curvature_at_midspan(state_at(fibre, point)) > most;
  });
  return wraps == history.path.end() ? std::nullopt : std::optional(wraps->stage);
}

std::vector<SimulatedLeg> told_legs(const Simulation& test, const LegOptions& options) {
  std::vector<SimulatedLeg> told;
  EnergyAccount before{};
  double from = 0;
  for (const Leg& leg : legs_along(test.path, options)) {
    const bool is_last = leg.last == test.path.size();
    const EnergyAccount& after = is_last ? test.energy : test.path[leg.last - 1].energy;
    const double to = test.path[leg.last - 1].stage;
    told.push_back(
        {leg.direction, from, to, difference(after, before), work_of_fracture(after) - work_of_fracture(before)});
    before = after;
    from = to;
  }
  return told;
}

}  // namespace

Simulation simulated(const Test& input, const History& history, const Fibre& fibre, const Scales& scales,
                     const LegOptions& options) {
  const auto surface = surface_of(input, scales);
  Simulation test{
      .status = name_in_order<HistoryStatus::contact_lost>(history.status, {"ok", "slipped_through", "contact_lost"}),
      .path = {},
      .snaps = history.snaps,
      .cracks = history.cracks,
      .wraps_nose_from = wraps_nose_from(input, history, fibre, scales),
      .legs = {},
      .energy = history.energy,
      .has_surface = surface.has_value(),
      .has_three_lengths = !fibre.on_edges(),
      .has_two_sides = !history.contacts.empty()};
  test.path.reserve(history.path.size());
  for (std::size_t i = 0; i < history.path.size(); ++i) {
    const PathPoint& point = history.path[i];
    const FibreState state = state_at(fibre, point);
    SimulatedPoint told{.stage = scales.physical_length(point.stage),
                        .deflection = scales.physical_length(point.w),
                        .force = scales.physical_force(point.F),
                        .length = scales.physical_length(fibre.length_between_contacts(state)),
                        .q = point.q,
                        .motion = name_of(point.motion),
                        .drawn_in = scales.physical_length(point.S - 1),
                        .imaged = scales.physical_length(fibre.imaged_length(state)),
                        .energy = history.energy_at[i]};
    if (surface) {
      const double curvature = fibre.curvature_at_midspan(state);
      told.strain = surface->strain(curvature);
      told.stress = surface->stress(curvature) * point.left;
    }
    if (test.has_two_sides) {
      told.left = scales.physical_length(history.contacts[i].left);
      told.right = scales.physical_length(history.contacts[i].right);
    }
    test.path.push_back(told);
  }
  test.legs = told_legs(test, options);
  return test;
}

namespace {

// Gaussian noise on the force. It also affects the deflection, which is computed from force and
// stage.
// Units:      deviation and load-train stiffness in the units of the case. The same seed gives the
//             same readings.
void add_noise(std::vector<SimulatedPoint>& path, double deviation, double stiffness, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  const auto uniform = [&] { return (static_cast<double>(generator() >> 11) + 0.5) * 0x1p-53; };
  for (SimulatedPoint& point : path) {
    // Box & Muller, because std::normal_distribution differs between libraries.
    const double radius = std::sqrt(-2 * elementary::log(uniform()));
    const double error = deviation * radius * elementary::sine_and_cosine(2 * std::numbers::pi * uniform()).cosine;
    point.force += error;
    point.deflection -= error / stiffness;
  }
}

// The reason why the path ends before its programme.
std::string reason_of_end(const Test& input, HistoryStatus status, const Simulation& test) {
  const std::string last = readable(test.path.empty() ? 0 : test.path.back().stage, kind_in(input, kind::length));
  if (status == HistoryStatus::slipped_through)
    return fmt::format("{}: the specimen slips through the supports after the stage position {}: the path ends there",
                       input.source, last);
  return fmt::format(
      "{}: a snap lets the specimen out until no force is left on it, after the stage position {}: the path ends there",
      input.source, last);
}

// A continuous path has a number of points on each sliding segment and each snap. Fine roughness
// has very many.
// Fails:      InputError for more than a gigabyte.
void require_path_that_fits(const Test& input, const Friction& friction, const std::vector<double>& turns, int points) {
  constexpr double max_points = 8e6;  // of a hundred bytes
  double periods = 0;                 // maximum number passed
  for (std::size_t i = 1; i < turns.size(); ++i)
    periods += std::abs(periods_up_to(friction, turns[i]) - periods_up_to(friction, turns[i - 1]));
  const double expected = 2 * periods * points;
  if (expected <= max_points) return;
  throw wrong_value(
      input, "stage.step",
      fmt::format("Friction goes through about {:.0e} periods on the way, too many for a continuous path", periods),
      fmt::format("write step = \"…\" into [stage], or pass --points {:.0f}",
                  std::max(std::floor(max_points / (2 * periods)), 2.0)));
}

// The stage position at which the nose first lifts off a bent specimen; "" if it never does.
std::string lift_in_words(const Test& input, const History& history, const Scales& scales) {
  const auto apart = std::find_if(history.path.begin(), history.path.end(),
                                  [](const PathPoint& point) { return point.motion == Motion::apart; });
  if (apart == history.path.end()) return "";
  return fmt::format(
      "the nose lifts off at the stage position {}: friction holds the specimen bent there without a force, until the "
      "nose is back",
      readable(scales.physical_length(apart->w), kind_in(input, kind::length)));
}

// Effects missing from the mechanics: fracture and shear.
std::vector<std::string> left_out_in_words(const Test& input, const Simulation& test, const Scales& scales) {
  std::vector<std::string> remarks;
  const double breaks_at = breaking_curvature_of(input, scales);
  const auto surface = surface_of(input, scales);
  const auto breaks =
      surface ? std::find_if(test.path.begin(), test.path.end(),
                             [&](const SimulatedPoint& point) { return point.strain >= surface->strain(breaks_at); })
              : test.path.end();
  if (breaks != test.path.end())
    remarks.push_back(fmt::format(
        "the specimen would break at the stage position {}, as stated; what follows is for a stronger specimen",
        readable(breaks->stage, kind_in(input, kind::length))));
  constexpr double worth_a_word = 0.01;
  if (const auto section = section_of(input))
    if (const double share = shear_share(*section, scales.span()); share > worth_a_word)
      remarks.push_back(
          fmt::format("shear, which is neglected, would add {:.1f} % to a small deflection", 100 * share));
  return remarks;
}

}  // namespace

SimulatedTest simulate(const Test& input, const SimulationOptions& options, double farthest) {
  constexpr double min_measured_travel = 0.02;  // of a turn in a measured, noisy stage path
  constexpr double min_stated_travel = 1e-9;    // of a turn in a stated programme
  const Scales scales = scales_of(input);
  const StageProgramme programme = programme_of(input);
  const LegOptions legs{programme.measured ? min_measured_travel : min_stated_travel};
  BendingTest bending_test =
      bending_test_of(input, scales, std::max(farthest, scales.reduced_length(programme.farthest)));

  std::vector<double> stages;
  stages.reserve(programme.positions.size());
  for (const double position : programme.positions) stages.push_back(scales.reduced_length(position));
  if (!programme.in_steps) require_path_that_fits(input, bending_test.friction.kinetic, stages, options.points);
  const std::vector<Crack> cracks = cracks_of(input, scales);
  History history = programme.in_steps
                        ? follow_in_steps(bending_test, stages, cracks, options.progress)
                        : follow_continuously(bending_test, stages, options.points, cracks, options.progress);
  std::vector<std::string> remarks;
  if (std::string lift = lift_in_words(input, history, scales); !lift.empty()) remarks.push_back(std::move(lift));
  Simulation test = simulated(input, history, bending_test.rig.fibre, scales, legs);
  if (test.wraps_nose_from)
    remarks.push_back(
        fmt::format("from the stage position {} on, the specimen is bent more sharply than the nose and "
                    "wraps around it; what follows is for a sharp nose",
                    readable(scales.physical_length(*test.wraps_nose_from), kind_in(input, kind::length))));
  // A stage in steps is at the requested positions, without rounding.
  if (programme.in_steps)
    for (std::size_t i = 0; i < test.path.size(); ++i) test.path[i].stage = programme.positions[i];
  for (std::string& remark : left_out_in_words(input, test, scales)) remarks.push_back(std::move(remark));
  add_noise(test.path, options.noise, rig_stiffness_of(input), options.seed);
  std::string why = history.status == HistoryStatus::ok ? "" : reason_of_end(input, history.status, test);
  return {input.reduced,
          is_in_inches(input),
          scales,
          std::move(test),
          FollowedTest{std::move(bending_test), std::move(history), std::move(stages), programme.in_steps, legs},
          std::move(remarks),
          std::move(why)};
}

SimulatedPortrait portrait_of(const SimulatedTest& test, const std::vector<Crack>& cracks) {
  const FollowedTest& followed = test.followed;
  History history =
      followed.in_steps ? follow_continuously(followed.bending_test, followed.stages, 2, cracks) : followed.history;
  std::vector<Leg> legs = legs_along(history.path, followed.legs);
  SlidingLimits limits = limits_of(followed.bending_test, history);
  return {std::move(history), std::move(legs), std::move(limits)};
}

OverallPortrait overall_portrait(const SimulatedTest& test, std::span<const double> stages) {
  const BendingTest& bending_test = test.followed.bending_test;
  return overall_portrait(bending_test.friction.kinetic, bending_test.rig, stages);
}

}  // namespace flexslip
