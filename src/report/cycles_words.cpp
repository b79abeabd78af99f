#include "report/cycles_words.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "answers/cycles_fields.h"
#include "answers/fit_fields.h"
#include "data/names.h"
#include "io/quantity.h"
#include "numerics/elementary.h"
#include "report/field_table.h"

namespace flexslip {
namespace {

constexpr double two_sided = 1.96;  // standard errors to the ends of a 95 % interval

bool is_measurable(const CyclicFriction& friction) {
  return friction.status == CyclesStatus::ok || friction.status == CyclesStatus::no_mirror;
}

std::string why_nothing(CyclesStatus status) {
  if (status == CyclesStatus::too_few_points)
    return "Friction cannot be read off the loops: fewer than 20 points slide at deflections where friction shows.";
  return "Friction cannot be read off the loops: no bending stiffness and contact near those assumed make the two "
         "directions mirror images.";
}

std::string against_reference(const FittedTest& test) {
  const double ratio = std::exp(test.cycles->friction.log_stiffness.value);
  if (test.stiffness != StiffnessSource::mirror)
    return fmt::format("{} from {}", signed_percent(ratio - 1),
                       test.stiffness == StiffnessSource::initial_slope ? "the initial slope" : "that stated");
  const double over_slope = ratio * test.analysis.stiffness_over_slope;
  return std::isfinite(over_slope) ? fmt::format("{:+.0f} % from the initial slope", 100 * (over_slope - 1))
                                   : "the initial slope gives no value to compare with";
}

std::string stiffness_in_words(const FittedTest& test) {
  const CyclicFriction& friction = test.cycles->friction;
  if (friction.status == CyclesStatus::no_mirror)
    return "No part of the specimen slid in both directions, so the loops determine neither bending stiffness nor "
           "contact. "
           "Both are as assumed, and the friction given rests on these assumptions.";
  const auto [logarithm, error, low, high] = friction.log_stiffness;
  const double value = test.analysis.scales.bending_stiffness() * std::exp(logarithm);
  return fmt::format(
      "The specimen slides in at q = +μ and out at q = −μ, past the same points. With the right bending stiffness and "
      "contact, the two directions therefore mirror each other. This gives EI = {} ({}). The error covers noise and "
      "roughness; the choice of the points compared changes EI by another 1 to 2 % in the authors' tests.",
      readable(value, value * error, Print(test).as(kind::bending_stiffness)), against_reference(test));
}

std::string asymmetry_in_words(const CyclicFriction& friction) {
  const auto [in, out, rms] = direction_means(friction);
  const auto& [value, error, low, high] = friction.asymmetry;
  const std::string means = fmt::format(
      "Friction is {:.3g} while sliding in and {:.3g} while sliding out (means of all loops); at single places the two "
      "directions differ by {:.2g} rms. The agreement of the means is no evidence, because EI and contacts were chosen "
      "to make them agree. If the difference of the means is fitted as well, it is {}",
      in, out, rms, readable(value, error, kind::number));
  if (is_beyond_friction(friction))
    return means +
           ", more than friction itself. No friction can do that. It is a sign of an error in the model (a contact "
           "that "
           "settles, supports or a load train that yield, a specimen that is not uniform), which EI and contacts have "
           "absorbed. Take friction and EI only as rough values.";
  if (std::abs(value) > two_sided * error)
    return means + fmt::format(
                       ": less than friction itself, but {:.1f} standard errors from zero. One test in twenty shows 2 "
                       "by chance. "
                       "More means that friction, or something that the model neglects, depends on the direction.",
                       std::abs(value) / error);
  return means + ", which cannot be distinguished from zero.";
}

std::string correlation_in_words(const BumpCorrelation& correlation) {
  if (!std::isfinite(correlation.value))
    return "Too few places were passed in both directions to show whether the same points of the specimen resist in "
           "both.";
  const std::string words = fmt::format(
      "The bumps of friction along the specimen, without slow trends, correlate between the two directions with r = "
      "{:.2f} (95 %: {:.2f} to {:.2f}; {:.0f} independent places). ",
      correlation.value, correlation.low, correlation.high, correlation.effective_points);
  if (correlation.low > 0)
    return words +
           "The same points resist in both directions, so at least part of the bumps belongs to the specimen's "
           "surface. "
           "This does not show what the bumps are, nor that all of them belong to the surface.";
  if (correlation.high < 0)
    return words +
           "Where friction is high in one direction, it is low in the other. No surface does that, but an error of "
           "force or "
           "deflection that depends only on the deflection does, as it enters the two directions with opposite signs.";
  return words +
         "This is consistent with no correlation: these loops do not show that the same points resist in both "
         "directions. "
         "They do not show the contrary either, because an error that depends only on the deflection lowers r.";
}

std::string list_of(const std::vector<std::string>& items) { return fmt::format("{}", fmt::join(items, ", ")); }

std::string energy_in_words(const FittedTest& test) {
  LoopEnergy sum{};
  std::size_t complete = 0;
  const auto& loops = test.cycles->friction.loops;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (!loops[i].loading || !loops[i].unloading) continue;
    const LoopEnergy& energy = test.cycles->energy[i];
    ++complete;
    sum.loading += energy.loading;
    sum.lost += energy.lost;
    sum.friction += energy.friction;
  }
  if (complete == 0) return "No loop is complete, so the work given back is unknown.";
  return fmt::format(
      "Of the work put in, {} was lost: {} in {}. The specimen gave back or still stores the rest. Friction during "
      "sliding accounts for {} of the loss. Friction is read off the same force, so this checks the account, not the "
      "cause. Loss and friction both come from points beyond the deflection at which friction shows.",
      percent(sum.lost / sum.loading), Print(test).energy(sum.lost), counted(complete, "loop", "loops"),
      percent(sum.friction / sum.lost));
}

std::string build_up_in_words(const FittedTest& test) {
  const auto& build_up = test.cycles->build_up;
  if (!build_up)
    return "No reversal is recorded from its beginning, so the record does not show whether friction builds up.";
  const double unit = test.analysis.scales.span();
  const std::string from = counted(build_up->reversals, "reversal", "reversals");
  if (!build_up->is_told())
    return fmt::format(
        "{} {} not show a length of sliding over which friction builds up. The fit assumes full friction from the "
        "beginning of sliding.",
        from, build_up->reversals == 1 ? "does" : "do");
  return fmt::format(
      "After {}, friction builds up over {} of sliding (Dahl's length, both supports together; build_up_length under "
      "[friction] takes it into account). The fit assumes full friction from the beginning of sliding.",
      from,
      std::isfinite(build_up->length.standard_error)
          ? readable(unit * build_up->length.value, unit * build_up->length.standard_error,
                     Print(test).as(kind::length))
          : roughly(unit * build_up->length.value, Print(test).as(kind::length)));
}

std::string loops_replayed_in_words(const FittedTest& test) {
  std::vector<std::string> errors;
  for (const double rms : test.cycles->replay.residual_rms)
    errors.push_back(std::isfinite(rms) ? fmt::format("{:.1f} %", 100 * rms) : "not run");
  if (errors.empty()) return "No friction profile could be run forward.";
  return fmt::format(
      "One friction profile for all loops and both directions, run forward over the stage positions, reproduces the "
      "force to {} of the greatest force (rms{}). The profile was made from these loops, so this shows what one "
      "profile "
      "can describe and is not a prediction.",
      list_of(errors), errors.size() > 1 ? ", loop by loop" : "");
}

// Under the names of the answer.
const std::vector<std::pair<std::string_view, std::string_view>> remarks_on_loadings{
    {"ok", ""},
    {"reference", "the reference"},
    {"loaded_too_little", "not loaded far enough"},
    {"window_not_covered", "not unloaded far enough"},
    {"too_few_points", "too few rows"},
    {"not_rising", "the force does not rise"},
    {"still_drawn_in", "friction still holds the length pulled in"},
    {"no_reference", "the first loading has no slope"}};

}  // namespace

std::vector<std::string> cycles_in_words(const FittedTest& test) {
  const CyclicFriction& friction = test.cycles->friction;
  if (!is_measurable(friction)) return {why_nothing(friction.status)};
  std::vector<std::string> paragraphs{stiffness_in_words(test)};
  if (friction.status == CyclesStatus::ok) {
    paragraphs.push_back(asymmetry_in_words(friction));
    paragraphs.push_back(correlation_in_words(friction.correlation));
  }
  paragraphs.push_back(build_up_in_words(test));
  paragraphs.push_back(energy_in_words(test));
  paragraphs.push_back(loops_replayed_in_words(test));
  return paragraphs;
}

std::string smoothing_in_words(const FittedTest& test) {
  if (!test.cycles || !test.cycles->build_up || !test.cycles->build_up->is_told()) return "";
  const double length = test.cycles->build_up->length.value;
  const auto& fit = test.analysis.fit;
  const auto shown = [&](double reduced) {
    return roughly(test.analysis.scales.physical_length(reduced), Print(test).as(kind::length));
  };
  const auto larger_by = [&](double wavelength) {
    return fmt::format("{:.0f} %", 100 * (1 / share_read(*test.cycles->build_up, wavelength) - 1));
  };
  std::string words = fmt::format(
      "The reversals show that friction builds up over {} of sliding. This smooths the friction read off: variation "
      "with "
      "a wavelength of {} or less is larger at the contact by {} or more",
      shown(length), shown(std::numbers::pi * length), larger_by(std::numbers::pi * length));
  if (fit.model != ProfileModel::roughness || fit.wave_claimed)
    for (const auto& wave : fit.waves)
      words += fmt::format(", the wave of {} by {}", shown(wave.wavelength.value), larger_by(wave.wavelength.value));
  return words + ".";
}

PrintedTable loop_table(const FittedTest& test) {
  return shown(fit_fields(), test, frame_of(test), "cycles.loops",
               {{"Loop", ""},
                {.heading = "Rows", .field = "first_row", .last = "last_row"},
                {"Contact", "contact"},
                {"μ sliding in", "mu_in"},
                {"μ sliding out", "mu_out"},
                {"difference, rms", "rms_difference"},
                {"correlation", "correlation.value", 2},
                {"95 % from", "correlation.low", 2},
                {"to", "correlation.high", 2}});
}

PrintedTable loop_energy_table(const FittedTest& test) {
  return shown(fit_fields(), test, frame_of(test), "cycles.loops",
               {{"Loop", ""},
                {"Put in", "energy.loading"},
                {"Given back", "energy.unloading"},
                {"Lost", "energy.lost"},
                {.heading = "Lost, of the work put in (%)", .field = "energy.lost_share", .digits = 3, .factor = 100},
                {"by friction", "energy.friction"}});
}

std::string reloading_in_words(const FittedTest& test) {
  const auto& loadings = test.cycles->stiffness;
  const auto those = [&](auto&& wanted) {
    std::vector<std::string> numbers;
    for (std::size_t i = 1; i < loadings.size(); ++i)
      if (wanted(loadings[i])) numbers.push_back(fmt::format("{}", i + 1));
    return numbers;
  };
  const auto with = [&](DamageVerdict verdict) {
    return those([=](const LoadingStiffness& loading) {
      return loading.status == LoadingStatus::ok && loading.verdict == verdict;
    });
  };
  if (loadings.size() < 2) return "The specimen was loaded only once, so there is no reloading to compare.";
  const std::string loss = fmt::format("a loss of stiffness of {:.0f} %", 100 * relevant_loss);
  std::string words = "Damage lowers the initial stiffness of a reloading; friction does not.";
  const auto damaged = with(DamageVerdict::damaged);
  const auto sound = with(DamageVerdict::not_damaged);
  const auto open = with(DamageVerdict::undecided);
  const auto unknown = those([](const LoadingStiffness& loading) { return loading.status != LoadingStatus::ok; });
  const auto say = [&](const std::vector<std::string>& numbers, std::string_view what) {
    if (!numbers.empty())
      words += fmt::format(" {} {}: {}.", numbers.size() == 1 ? "Loading" : "Loadings", list_of(numbers), what);
  };
  say(damaged, loss + " or more is shown");
  say(sound, loss + " or more is rejected");
  say(open, loss + " is neither shown nor rejected");
  say(unknown, "cannot be compared");
  return words +
         fmt::format(
             " Each verdict has {:.0f} % confidence and comes from the slope between {:.0f} and {:.0f} % of the "
             "smallest peak force among the loadings. The errors do not cover a contact that settles "
             "differently from one loading to the next.",
             100 * loading_confidence, 100 * loading_window_from, 100 * loading_window_up_to);
}

PrintedTable loading_table(const FittedTest& test) {
  return shown(fit_fields(), test, frame_of(test), "cycles.loading_stiffness",
               {{"Loading", ""},
                {"Rows", "rows"},
                {"Slope", "slope"},
                {"ratio to the first", "ratio"},
                {"error from the window", "ratio_systematic", 2},
                {.heading = "Verdict", .field = "verdict", .in_words = {{"not_damaged", "not damaged"}}},
                {.heading = "Remark", .field = "status", .in_words = remarks_on_loadings}});
}

}  // namespace flexslip
