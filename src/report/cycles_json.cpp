#include "report/cycles_json.h"

#include <cmath>
#include <optional>
#include <string>

#include "data/names.h"

namespace flexslip {
namespace {

constexpr double two_sided = 1.96;  // standard errors to the ends of a 95 % interval

Json measured(const Measured& measured, double factor) {
  return {{"value", measured.value * factor}, {"error", measured.standard_error * factor}};
}

// Its interval is symmetric in the logarithm.
Json stiffness_json(const FittedTest& test) {
  const double nominal = test.analysis.scales.bending_stiffness();
  const auto [logarithm, error] = test.cycles->friction.log_stiffness;
  const double value = nominal * std::exp(logarithm);
  return {{"value", value},
          {"standard_error", value * error},
          {"interval95", {value * std::exp(-two_sided * error), value * std::exp(two_sided * error)}},
          {"unit", test.reduced ? "1" : "N m^2"},
          {"relative_to_nominal", std::exp(logarithm)}};
}

Json correlation_json(const BumpCorrelation& correlation) {
  return {{"value", correlation.value},
          {"low", correlation.low},
          {"high", correlation.high},
          {"effective_points", correlation.effective_points}};
}

Json leg_json(const FittedTest& test, std::optional<std::size_t> leg) {
  if (!leg) return nullptr;
  const Leg& rows = test.cycles->friction.legs[*leg];
  return {{"first_row", cyclic_row(test, rows.first)}, {"last_row", cyclic_row(test, rows.last - 1)}};
}

Json corner_json(const FittedTest& test, const std::optional<LoopCorner>& corner) {
  if (!corner) return nullptr;
  return {{"row", cyclic_row(test, corner->index)},
          {"length", test.analysis.scales.physical_length(corner->S)},
          {"q", corner->q}};
}

Json table_json(const FrictionTable& table, const Scales& scales) {
  Json out = Json::array();
  for (std::size_t i = 0; i < table.S.size(); ++i)
    out.push_back({{"length", scales.physical_length(table.S[i])},
                   {"drawn_in", scales.physical_length(table.S[i] - 1)},
                   {"position", scales.physical_length(table.S[i] / 2)},
                   {"mu", table.mu[i]}});
  return out;
}

Json build_up_json(const FittedTest& test) {
  const auto& build_up = test.cycles->build_up;
  if (!build_up) return nullptr;
  const double unit = test.analysis.scales.span();
  return {{"value", unit * build_up->value},
          {"standard_error", unit * build_up->standard_error},
          {"least", unit * build_up->least},
          {"reversals", build_up->reversals},
          {"told", build_up->is_told()}};
}

Json loop_json(const FittedTest& test, std::size_t i) {
  const auto& scales = test.analysis.scales;
  const FrictionLoop& loop = test.cycles->friction.loops[i];
  Json out = {{"loading", leg_json(test, loop.loading)},
              {"unloading", leg_json(test, loop.unloading)},
              {"contact", measured(loop.contact, scales.span())},
              {"corners",
               {{"start", corner_json(test, loop.start)},
                {"turn", corner_json(test, loop.turn)},
                {"slides_back", corner_json(test, loop.slides_back)},
                {"end", corner_json(test, loop.end)}}},
              {"stick_advance", scales.physical_length(loop.stick_advance)},
              {"places", loop.places},
              {"mu_in", nullptr},
              {"mu_out", nullptr},
              {"mean_difference", nullptr},
              {"rms_difference", nullptr},
              {"correlation", nullptr}};
  if (loop.places > 0) {
    out["mu_in"] = measured(loop.mu_in, 1);
    out["mu_out"] = measured(loop.mu_out, 1);
    out["mean_difference"] = measured(loop.mean_difference, 1);
    out["rms_difference"] = measured(loop.rms_difference, 1);
    out["correlation"] = correlation_json(loop.correlation);
  }
  const LoopEnergy& energy = test.cycles->energy[i];
  out["energy"] = {{"loading", scales.physical_energy(energy.loading)},
                   {"unloading", scales.physical_energy(energy.unloading)},
                   {"stored", scales.physical_energy(energy.stored)},
                   {"lost", scales.physical_energy(energy.lost)},
                   {"friction", scales.physical_energy(energy.friction)}};
  const auto& replayed = test.cycles->replay.residual_rms;
  out["replay_rms"] = i < replayed.size() ? Json(replayed[i]) : Json();  // over the greatest force
  out["profile"] = table_json(loop.table, scales);
  for (std::size_t k = 0; k < loop.table.S.size(); ++k) out["profile"][k]["standard_error"] = loop.error[k];
  return out;
}

Json loading_json(const FittedTest& test, const LoadingStiffness& loading) {
  const auto status = name_in_order<LoadingStatus::no_reference>(
      loading.status, {"ok", "loaded_too_little", "window_not_covered", "too_few_points", "not_rising",
                       "still_drawn_in", "no_reference"});
  Json out = {{"status", status},
              {"rows", nullptr},
              {"slope", nullptr},
              {"slope_error", nullptr},
              {"ratio", nullptr},
              {"ratio_error", nullptr},
              {"ratio_systematic", nullptr},
              {"verdict", nullptr}};
  if (loading.status != LoadingStatus::ok) return out;
  out["rows"] = {cyclic_row(test, loading.first), cyclic_row(test, loading.last - 1)};
  out["slope"] = loading.slope;  // in the units of the test already
  out["slope_error"] = loading.slope_error;
  out["ratio"] = loading.ratio;
  out["ratio_error"] = loading.ratio_error;
  out["ratio_systematic"] = loading.ratio_systematic;
  out["verdict"] = name_of(loading.verdict);
  return out;
}

std::string name_of(LegMotion motion) {
  return std::string(name_in_order<LegMotion::stuck>(motion, {"slip_in", "slip_out", "stick"}));
}

Json points_json(const FittedTest& test) {
  Json out = Json::array();
  for (const CyclicPoint& point : test.cycles->friction.points)
    out.push_back({{"row", cyclic_row(test, point.index)},
                   {"length", test.analysis.scales.physical_length(point.S)},
                   {"q", point.q},
                   {"standard_error", point.standard_error},
                   {"motion", name_of(point.motion)}});
  return out;
}

}  // namespace

std::size_t cyclic_row(const FittedTest& test, std::size_t point) { return cyclic_file_row(test.measurement, point); }

std::string name_of(CyclesStatus status) {
  return std::string(
      name_in_order<CyclesStatus::not_converged>(status, {"ok", "no_mirror", "too_few_points", "not_converged"}));
}

std::string name_of(DamageVerdict verdict) {
  return std::string(name_in_order<DamageVerdict::undecided>(verdict, {"damaged", "not_damaged", "undecided"}));
}

Json cycles_json(const FittedTest& test) {
  if (!test.cycles) return nullptr;
  const CyclicFriction& friction = test.cycles->friction;
  const bool mirrored = friction.status == CyclesStatus::ok;
  const bool measurable = mirrored || friction.status == CyclesStatus::no_mirror;
  Json out = {{"status", name_of(friction.status)},
              {"bending_stiffness", measurable ? stiffness_json(test) : Json()},
              {"asymmetry", mirrored ? measured(friction.asymmetry, 1) : Json()},
              {"correlation", mirrored ? correlation_json(friction.correlation) : Json()},
              {"build_up_length", build_up_json(test)},
              {"force_noise", measurable ? Json(test.analysis.scales.physical_force(friction.force_noise)) : Json()},
              {"loops", Json::array()},
              {"loading_stiffness", Json::array()},
              {"profile", Json::array()},
              {"points", Json::array()}};
  for (const LoadingStiffness& loading : test.cycles->stiffness)
    out["loading_stiffness"].push_back(loading_json(test, loading));
  if (!measurable) return out;
  for (std::size_t i = 0; i < friction.loops.size(); ++i) out["loops"].push_back(loop_json(test, i));
  out["profile"] = table_json(friction.table, test.analysis.scales);
  out["points"] = points_json(test);
  return out;
}

}  // namespace flexslip
