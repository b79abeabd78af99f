#include "report/cycles_document.h"

#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "answers/fit_fields.h"
#include "data/names.h"
#include "finding/printed.h"
#include "report/cycles_figures.h"

namespace flexslip {
namespace {

std::string against_reference(const FittedTest& test, double ratio) {
  if (test.stiffness != StiffnessSource::mirror)
    return fmt::format("{} from that {}", signed_percent(ratio - 1),
                       test.stiffness == StiffnessSource::initial_slope ? "of the initial slope" : "stated");
  const double over_slope = ratio * test.analysis.stiffness_over_slope;
  return std::isfinite(over_slope) ? fmt::format("{:+.0f} % from that of the initial slope", 100 * (over_slope - 1))
                                   : "the initial slope gives none to compare with";
}

std::string mirror_in_words(const FittedTest& test) {
  const CyclicFriction& friction = test.cycles->friction;
  switch (friction.status) {
    case CyclesStatus::too_few_points:
      return "friction cannot be read off the loops: fewer than 20 points slide at deflections where it shows";
    case CyclesStatus::not_converged:
      return "friction cannot be read off the loops: no bending stiffness and contact near those assumed make the two "
             "directions mirror images";
    case CyclesStatus::no_mirror:
      return "as assumed, and the contact too: no part of the specimen slid in both directions";
    case CyclesStatus::ok:
      break;
  }
  const double ratio = std::exp(friction.log_stiffness.value), EI = test.analysis.scales.bending_stiffness() * ratio;
  return fmt::format(
      "EI {} ({}), at which sliding in and sliding out mirror each other; other points to compare change it by another "
      "1 to 2 % in the authors' tests",
      readable(EI, EI * friction.log_stiffness.standard_error, Print(test).as(kind::bending_stiffness)),
      against_reference(test, ratio));
}

std::string asymmetry_in_words(const CyclicFriction& friction) {
  constexpr double two_sided = 1.96;  // standard errors to the ends of a 95 % interval
  const auto& [value, error, low, high] = friction.asymmetry;
  return fmt::format(
      "{:.3g} sliding in, {:.3g} sliding out, which EI and contacts were chosen to make agree; {:.2g} rms apart at "
      "single places; fitted beside EI and contacts they differ by {}, {}",
      direction_means(friction).in, direction_means(friction).out, direction_means(friction).rms_difference,
      readable(value, error, kind::number),
      is_beyond_friction(friction)
          ? "more than friction itself: the model errs (a contact that settles, supports or a "
            "load train that yield, a specimen that is not uniform); take friction and EI only "
            "as rough values"
      : std::abs(value) > two_sided * error
          ? fmt::format(
                "{:.1f} standard errors from zero: one test in twenty shows 2 by chance; more means that friction, "
                "or what the model neglects, depends on the direction",
                std::abs(value) / error)
          : "not distinguishable from zero");
}

std::string bumps_in_words(const BumpCorrelation& bumps) {
  if (!std::isfinite(bumps.value)) return "too few places were passed in both directions to compare them";
  return fmt::format(
      "correlate between the directions with r = {:.2f} (95 %: {:.2f} to {:.2f}; {:.0f} independent "
      "places, slow trends taken off): {}",
      bumps.value, bumps.low, bumps.high, bumps.effective_points,
      bumps.low > 0    ? "the same points resist in both, so at least part of the bumps belongs to the "
                         "specimen's surface"
      : bumps.high < 0 ? "where friction is high in one, it is low in the other; no surface does that, but an error of "
                         "force or deflection that depends only on the deflection does"
                       : "consistent with none; an error that depends only on the deflection lowers r");
}

std::string build_up_of_loops(const FittedTest& test) {
  const auto& build_up = test.cycles->build_up;
  if (!build_up) return "not known: no reversal is recorded from its beginning";
  const std::string after = counted(build_up->reversals, "reversal", "reversals");
  const double unit = test.analysis.scales.span();
  const Kind length = Print(test).as(kind::length);
  if (!build_up->is_told()) return fmt::format("none shows after {}; the fit assumes none", after);
  return fmt::format(
      "over {} of sliding after {} (Dahl's length, both supports together; build_up_length under [friction] "
      "takes it into account); the fit assumes none",
      std::isfinite(build_up->length.standard_error)
          ? readable(unit * build_up->length.value, unit * build_up->length.standard_error, length)
          : roughly(unit * build_up->length.value, length),
      after);
}

std::string energy_of_loops(const FittedTest& test) {
  double loading = 0, lost = 0, friction = 0;
  std::size_t complete = 0;
  const auto& loops = test.cycles->friction.loops;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (!loops[i].loading || !loops[i].unloading) continue;
    const LoopEnergy& energy = test.cycles->energy[i];
    ++complete;
    loading += energy.loading;
    lost += energy.lost;
    friction += energy.friction;
  }
  if (complete == 0) return "no loop is complete, so the work given back is unknown";
  return fmt::format(
      "{} of that put in ({} in {}); friction during sliding, read off the same force, is {} of it, beyond "
      "the deflection at which friction shows",
      percent(lost / loading), Print(test).energy(lost), counted(complete, "loop", "loops"), percent(friction / lost));
}

std::string replay_of_loops(const FittedTest& test) {
  std::vector<std::string> errors;
  for (const double rms : test.cycles->replay.residual_rms)
    errors.push_back(std::isfinite(rms) ? fmt::format("{:.1f} %", 100 * rms) : "not run");
  return errors.empty() ? "no friction profile could be run forward"
                        : fmt::format(
                              "one friction profile, made from these loops, gives their force to {} of the greatest "
                              "(rms, loop by loop)",
                              fmt::join(errors, ", "));
}

std::string reloads_in_words(const FittedTest& test) {
  if (test.cycles->stiffness.size() < 2) return "none: the specimen was loaded once";
  return fmt::format(
      "damage lowers the initial stiffness of a reload, friction does not; the verdicts below are on a loss of "
      "{:.0f} % or more, at {:.0f} %, by the slope between {:.0f} and {:.0f} % of the smallest peak force; "
      "a contact that settles differently is not in the errors",
      100 * relevant_loss, 100 * loading_confidence, 100 * loading_window_from, 100 * loading_window_up_to);
}

PrintedTable of_cycles(const FittedTest& test, std::string_view list, const std::vector<Shown>& columns) {
  return shown(fit_fields(), test, frame_of(test), list, columns);
}

}  // namespace

Chapter cycles_chapter(const FittedTest& test) {
  const CyclicFriction& friction = test.cycles->friction;
  const bool has_friction = friction.status == CyclesStatus::ok;
  const bool has_numbers = has_friction || friction.status == CyclesStatus::no_mirror;
  Chapter chapter{"Load and unload", {}};
  if (has_loops(test))
    chapter.blocks.emplace_back(Pictures{[&test] { return std::vector{loops_figure(test), boxes_figure(test)}; }});
  chapter.blocks.emplace_back(Rows{{"stiffness", mirror_in_words(test)},
                                   {"friction", has_friction ? asymmetry_in_words(friction) : ""},
                                   {"bumps", has_friction ? bumps_in_words(friction.correlation) : ""},
                                   {"build-up", has_numbers ? build_up_of_loops(test) : ""},
                                   {"work lost", has_numbers ? energy_of_loops(test) : ""},
                                   {"replay", has_numbers ? replay_of_loops(test) : ""},
                                   {"reloads", reloads_in_words(test)}});
  chapter.blocks.emplace_back(of_cycles(test, "cycles.loops",
                                        {{"Loop", ""},
                                         {.heading = "Rows", .field = "first_row", .last = "last_row"},
                                         {"Contact", "contact"},
                                         {"μ sliding in", "mu_in"},
                                         {"μ sliding out", "mu_out"},
                                         {"difference, rms", "rms_difference"},
                                         {"correlation", "correlation.value", 2},
                                         {"95 % from", "correlation.low", 2},
                                         {"to", "correlation.high", 2}}));
  chapter.blocks.emplace_back(
      of_cycles(test, "cycles.loops",
                {{"Loop", ""},
                 {"Put in", "energy.loading"},
                 {"Given back", "energy.unloading"},
                 {"Lost", "energy.lost"},
                 {.heading = "Lost, of the work put in (%)", .field = "energy.lost_share", .digits = 3, .factor = 100},
                 {"by friction", "energy.friction"}}));
  chapter.blocks.emplace_back(
      of_cycles(test, "cycles.loading_stiffness",
                {{"Loading", ""},
                 {"Rows", "rows"},
                 {"Slope", "slope"},
                 {"ratio to the first", "ratio"},
                 {"error from the window", "ratio_systematic", 2},
                 {.heading = "Verdict", .field = "verdict", .in_words = {{"not_damaged", "not damaged"}}},
                 {.heading = "Remark",
                  .field = "status",
                  .in_words = {{"ok", ""},
                               {"reference", "the reference"},
                               {"loaded_too_little", "not loaded far enough"},
                               {"window_not_covered", "not unloaded far enough"},
                               {"too_few_points", "too few rows"},
                               {"not_rising", "the force does not rise"},
                               {"still_drawn_in", "friction still holds the length pulled in"},
                               {"no_reference", "the first loading has no slope"}}}}));
  return chapter;
}

std::string smoothing_in_words(const FittedTest& test) {
  if (!test.cycles || !test.cycles->build_up || !test.cycles->build_up->is_told()) return "";
  const double length = test.cycles->build_up->length.value;
  const auto& fit = test.analysis.fit;
  const auto wave = [&](double wavelength) {
    return fmt::format("a wave of {} is larger at the contact by {:.0f} %",
                       roughly(test.analysis.scales.physical_length(wavelength), Print(test).as(kind::length)),
                       100 * (1 / share_read(*test.cycles->build_up, wavelength) - 1));
  };
  std::vector<std::string> waves{wave(std::numbers::pi * length) + " or more, shorter ones even more"};
  if (fit.model != ProfileModel::roughness || fit.wave_claimed)
    for (const auto& each : fit.waves) waves.push_back(wave(each.wavelength.value));
  return fmt::format("friction that builds up smooths what is read off: {}", fmt::join(waves, "; "));
}

}  // namespace flexslip
