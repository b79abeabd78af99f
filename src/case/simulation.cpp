#include "case/simulation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

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
                    &EnergyAccount::friction, &EnergyAccount::snaps, &EnergyAccount::cracks, &EnergyAccount::imbalance})
    change.*part = after.*part - before.*part;
  return change;
}

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

// Where the specimen first wraps the nose.
std::optional<double> wraps_nose_from(const Case& input, const History& history, const Fibre& fibre,
                                      const Scales& scales) {
  const double most = nose_curvature_of(input, input.specimen->section, scales);
  if (std::isinf(most)) return std::nullopt;
  const auto wraps = std::find_if(history.path.begin(), history.path.end(), [&](const PathPoint& point) {
    return fibre.curvature_at_midspan(state_at(fibre, point)) > most;
  });
  return wraps == history.path.end() ? std::nullopt : std::optional(wraps->stage);
}

}  // namespace

std::vector<Leg> legs_of(const History& history, const LegOptions& options) {
  return legs_along(history.path, options);
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

Simulation simulated(const Case& input, const History& history, const Fibre& fibre, const Scales& scales,
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

}  // namespace flexslip
