#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <variant>

#include <fmt/format.h>

#include "finding/printed.h"
#include "inference/profile.h"
#include "report/answer_documents.h"

namespace flexslip {
namespace {

class InUnits : public Print {
 public:
  explicit InUnits(const DesignAnswer& answer) : Print(answer.input, answer.scales) {}

  // [units of the case]
  std::string stiffness(double value) const {
    return std::isfinite(value) ? own(value, kind::stiffness) : "infinite stiffness";
  }
  // All digits of a number with few digits. Six digits in inches and pounds, because conversion
  // makes many.
  std::string exactly(double value, const Kind& kind) const {
    const Kind shown = as(kind);
    const std::string_view unit = best_unit(value, shown);
    const Unit scale = unit.empty() ? Unit{} : parse_unit(unit);
    return typeset(scale.factor == 1 ? exact_text(value, shown)
                                     : fmt::format("{:.6g} {}", from_si(value, scale), unit));
  }
};

// Rounded up to three digits.
double rounded_to_enough(double value) {
  if (value == 0) return value;
  const double step = std::pow(10, std::floor(std::log10(value)) - 2);
  return step * std::ceil(value / step);
}

std::string share(double part, double whole) {
  const double percentage = std::max(0.0, 100 * part / whole);  // rounding may make it negative
  return percentage > 0 && percentage < 0.1 ? "less than 0.1 %"
                                            : fmt::format("{:.{}f} %", percentage, percentage < 10 ? 1 : 0);
}

bool hidden(const DesignOutcome& outcome) { return outcome.snaps > 0 && outcome.drops == 0; }

std::string strain_text(double strain) { return fmt::format("{:.2g} %", 100 * strain); }

std::string first_snap_in_words(const DesignAnswer& answer, const InUnits& shown) {
  if (!answer.outcome.first_snap) return "";
  const auto& first = *answer.outcome.first_snap;
  const std::string before = shown.force(first.F_before), after = shown.force(first.F_after);
  return fmt::format("at the stage position {}, a deflection of {}: the force falls {}", shown.length(first.stage),
                     shown.length(first.w),
                     before == after ? fmt::format("by {} from {}", shown.force(first.F_before - first.F_after), before)
                                     : fmt::format("from {} to {}", before, after));
}

std::string record_in_words(const DesignAnswer& answer, const InUnits& shown) {
  const DesignOutcome& outcome = answer.outcome;
  const std::string record =
      answer.design.step > 0 ? fmt::format("with a reading every {}", shown.length(answer.design.step)) : "continuous";
  if (outcome.drops == 0)
    return fmt::format("{}: the force never falls; its maximum is {}", record, shown.force(outcome.greatest_force));
  return fmt::format("{}: the force falls {}, by up to {} ({} of the maximum force, {}){}{}", record,
                     outcome.drops == 1 ? "once" : fmt::format("{} times", outcome.drops),
                     shown.force(outcome.largest_drop), share(outcome.largest_drop, outcome.greatest_force),
                     shown.force(outcome.greatest_force),
                     outcome.drops == 1 ? "" : fmt::format(", {} on average", shown.force(outcome.mean_drop)),
                     outcome.snaps > outcome.drops ? "; snaps between the same two readings appear as one fall"
                     : outcome.snaps == 0 && outcome.drops > 1
                         ? "; these falls are no snaps: the force follows a friction that varies, on any load train"
                         : "");
}

std::string strain_in_words(const DesignAnswer& answer, const InUnits& shown) {
  const double curvature = answer.outcome.greatest_curvature;
  return !answer.surface
             ? ""
             : fmt::format("up to {} at the surface{}{}", strain_text(answer.surface->strain(curvature)),
                           answer.input.reduced
                               ? ""
                               : fmt::format(" ({})", shown.own(answer.surface->stress(curvature), kind::pressure)),
                           std::isfinite(answer.design.breaking_curvature)
                               ? ""
                               : "; the strength is not stated: state it to learn whether the specimen breaks first");
}

// The critical stiffness, compared with the stiffness of this rig.
std::string critical_in_words(const DesignAnswer& answer, const InUnits& shown) {
  const std::string yours = shown.stiffness(answer.scales.physical_stiffness(answer.design.rig.stiffness));
  if (answer.critical == 0) {
    const bool varies = std::isfinite(answer.design.friction.smooth_scale()) || !answer.design.friction.knots().empty();
    return fmt::format("{}; none, however soft, lets the specimen snap in this test{}", yours,
                       varies ? ""
                              : ": friction that is uniform along the specimen makes no sawtooth; state an amplitude "
                                "and a wavelength, for example from a fit");
  }
  if (!std::isfinite(answer.critical))
    return fmt::format("{}; the specimen snaps on any, even if the deflection itself is controlled", yours);
  const double critical = rounded_to_enough(answer.scales.physical_stiffness(answer.critical));
  const bool is_too_soft = answer.outcome.snaps == 0 && answer.design.rig.stiffness < answer.critical;
  return fmt::format(
      "{}; {}at {} or more the specimen does not snap{}{}", yours,
      support_compliance_of(answer.input) > 0 ? "with the supports together, " : "", shown.stiffness(critical),
      is_too_soft
          ? fmt::format("; here it does not, as this rig bends it only by {}", shown.length(answer.outcome.w_reached))
          : "",
      critical * support_compliance_of(answer.input) >= 1 ? "; on these supports no load train reaches that" : "");
}

std::string work_of_design_in_words(const DesignAnswer& answer, const InUnits& shown) {
  const DesignOutcome& outcome = answer.outcome;
  return fmt::format("{} on the specimen: friction at the supports takes {}{}; the rest bends it",
                     shown.energy(outcome.work), share(outcome.friction_heat, outcome.work),
                     outcome.snaps > 0
                         ? fmt::format(", and snaps set free {} beyond that", share(outcome.released, outcome.work))
                         : "");
}

std::string phases_in_words(const DesignAnswer& answer, const InUnits& shown) {
  if (!answer.phases) return "";
  const PhaseStudy& study = *answer.phases;
  const std::string least = shown.force(study.min_drop), most = shown.force(study.largest_drop);
  return fmt::format(
      "seldom known before a test: the specimen snaps with {} of {}{}{}",
      study.snapping == 0              ? "none"
      : study.snapping == study.phases ? "each"
                                       : fmt::format("{}", study.snapping),
      study.phases,
      !(study.largest_drop > 0)
          ? ""
          : fmt::format(", and the largest drop is {}", least == most ? most : fmt::format("{} to {}", least, most)),
      study.snapping == 0 ? ""
      : std::isfinite(study.critical)
          ? fmt::format("; with a load train{} of {} or more with none",
                        support_compliance_of(answer.input) > 0 ? " and supports together" : "",
                        shown.stiffness(rounded_to_enough(answer.scales.physical_stiffness(study.critical))))
          : "; with some of them however stiff the load train is");
}

// The words for a change upwards and downwards, and before its values.
struct ChangeWords {
  std::string_view parameter;
  std::string_view more, less, of, of_less = of;
};
constexpr std::array changes_known{
    ChangeWords{"stiffness", "a stiffer load train", "a softer load train", ""},
    ChangeWords{"span", "a longer support span", "a shorter support span", ""},
    ChangeWords{"diameter", "a thicker specimen", "a thinner specimen", "a diameter of "},
    ChangeWords{"height", "a thicker specimen", "a thinner specimen", "a height of "},
    ChangeWords{"width", "a wider specimen", "a narrower specimen", "a width of "},
    ChangeWords{"modulus", "a stiffer specimen", "a softer specimen", "a modulus of "},
    ChangeWords{"mu0", "supports with more friction", "lubricated supports", "mu0 "},
    ChangeWords{"amplitude", "rougher supports or specimens", "polished supports", "an amplitude of "},
    ChangeWords{"wavelength", "another specimen, with roughness of a longer wavelength",
                "another specimen, with roughness of a shorter wavelength", ""},
    ChangeWords{"travel", "loading farther", "stopping before the first snap", "up to the stage position ",
                "at the stage position "},
    ChangeWords{"pin_friction", "rollers that turn harder on their pins", "rollers that turn more easily on their pins",
                "pin_friction "}};

std::string change_in_words(const DesignChange& change, const InUnits& shown) {
  const auto known = std::find_if(changes_known.begin(), changes_known.end(),
                                  [&](const ChangeWords& each) { return each.parameter == change.parameter; });
  if (known == changes_known.end()) throw std::invalid_argument("no change of this parameter is looked for");
  const Kind& kind = design_parameter(change.parameter).kind();
  const bool more = change.to > change.from;
  return fmt::format("{}: {}{}{} instead of {}", more ? known->more : known->less, more ? known->of : known->of_less,
                     shown.exactly(change.printed, kind),
                     !change.and_beyond ? ""
                     : more             ? " or more"
                                        : " or less",
                     change.parameter == "stiffness" ? shown.stiffness(change.from) : shown.own(change.from, kind));
}

bool falls_no_less(const DesignOutcome& then, const DesignOutcome& now) {
  return then.largest_drop * now.greatest_force >= now.largest_drop * then.greatest_force;
}

// The force may decrease without a snap: friction that varies along the specimen makes it oscillate
// on any rig.
std::string what_remains(const DesignAnswer& answer, const DesignChange& change) {
  const DesignOutcome& then = change.outcome;
  if (answer.outcome.snaps == 0 || then.drops == 0) return "";
  const double part = then.largest_drop / then.greatest_force;
  return fmt::format(" (smooth falls of {}{} remain{})", part < 0.001 ? "" : "up to ",
                     share(then.largest_drop, then.greatest_force),
                     falls_no_less(then, answer.outcome)
                         ? fmt::format("; now the force drops by {}",
                                       share(answer.outcome.largest_drop, answer.outcome.greatest_force))
                         : "");
}

// "0.5 to 0.721", "5 µm to 50 µm".
std::string range_in_words(const OpenNumber& open, const InUnits& shown) {
  const auto& range = std::get<AxisRange>(open.axis.values);
  const Kind& kind = open.axis.parameter.kind();
  return fmt::format("{} to {}", shown.own(range.from, kind), shown.own(range.to, kind));
}

std::string percentages(double low, double high) {
  const std::string least = share(low, 1), most = share(high, 1);
  return least == most ? most : fmt::format("{} to {}", least, most);
}

// The answer over the ranges of the quantities that the case does not state.
std::string open_in_short(const OpenStudy& study) {
  if (study.snapping == 0)
    return "No sawtooth, for any friction in the ranges below: the specimen slides without a snap.";
  if (study.snapping == study.designs)
    return fmt::format(
        "Yes, you will see a sawtooth, for any friction in the ranges below: the largest snap is {} of the maximum "
        "force.",
        percentages(study.min_snap, study.max_snap));
  return fmt::format(
      "It depends on friction, which is not stated: the specimen snaps in {} of {} designs over the ranges below, by "
      "up to {} of the maximum force.",
      study.snapping, study.designs, share(study.max_snap, 1));
}

Chapter chapter_of(const OpenStudy& study, const InUnits& shown) {
  Rows rows;
  for (const OpenNumber& each : study.open)
    rows.push_back({std::string(each.axis.parameter.name), fmt::format("{}, {}: {}", each.axis.parameter.description,
                                                                       range_in_words(each, shown), each.reason)});
  rows.push_back(
      {"maximum force", fmt::format("{} to {}", shown.force(study.min_force), shown.force(study.max_force))});
  rows.push_back(
      {"tried", fmt::format("three values of each, with {}: {} designs",
                            study.phases == 1 ? "one phase" : fmt::format("{} phases", study.phases), study.designs)});
  return {"", {open_in_short(study), rows}};
}

std::string answer_in_short(const DesignAnswer& answer) {
  const InUnits shown(answer);
  const DesignOutcome& outcome = answer.outcome;
  if (hidden(outcome))
    return fmt::format("The specimen will snap {}, but readings {} apart will not show it.",
                       outcome.snaps == 1 ? "once" : fmt::format("{} times", outcome.snaps),
                       shown.length(answer.design.step));
  constexpr double stands_out = 0.05;  // [1] of the largest drop, which is a smooth one
  if (outcome.snaps > 1 && outcome.largest_snap < stands_out * outcome.largest_drop)
    return fmt::format("No visible sawtooth: the specimen will snap {} times, but by at most {} each.", outcome.snaps,
                       shown.force(outcome.largest_snap));
  if (outcome.snaps > 0) {
    const std::string most = fmt::format("{}, {} of the maximum force", shown.force(outcome.largest_drop),
                                         share(outcome.largest_drop, outcome.greatest_force));
    return outcome.snaps == 1 ? fmt::format("Yes: the specimen will snap, once. The force drops by up to {}.", most)
                              : fmt::format("Yes, you will see a sawtooth: the force drops by up to {}.", most);
  }
  if (outcome.drops == 1) return "No sawtooth: the specimen slides without a snap, past a smooth peak of the force.";
  if (outcome.drops > 1)
    return "No sawtooth, but a wavy force: the specimen slides without a snap, and the force falls only smoothly.";
  return "No sawtooth: the specimen slides without a snap, and the force never falls.";
}

// ---- A second loading

// [1] A probability as a number of tests in 100, at most 99, the limit of a simulation.
std::string of_tests(double chance) {
  return fmt::format("{:.0f} of 100 tests", std::min(std::floor(100 * chance), 99.0));
}

std::string percent(double share) { return fmt::format("{:.2g} %", 100 * share); }

std::string programme_in_words(const ReloadPlan& plan, const InUnits& shown) {
  const std::string travel = shown.own(plan.travel, kind::length);
  return fmt::format("load to the stage position {}, unload to {} or less (stage position {}), and load to {} again",
                     travel, format_roughly(plan.force, shown.as(kind::force)), shown.own(plan.unload_to, kind::length),
                     travel);
}

std::string prospects_in_words(const ReloadPlan& plan) {
  const std::string drops = plan.drops == 1 ? "1 drop" : fmt::format("{} drops", plan.drops);
  if (!std::isfinite(plan.loss_needed))
    return drops + "; the specimen slides outwards too little for a second loading to determine a loss of stiffness";
  return fmt::format(
      "{}; if they were cracks only, they would cost {} of the stiffness, and the second loading determines a loss "
      "to ± {}: the right verdict in {} with cracks only, and in {} with slips only",
      drops, percent(plan.loss_needed), percent(plan.loss_error), of_tests(plan.chances.cracks),
      of_tests(plan.chances.slips));
}

std::string reload_in_short(const ReloadStudy& study, const InUnits& shown) {
  if (study.drops == 0) return "No drops are expected in this loading: there is nothing to decide.";
  const ReloadPlan& plan = study.of_travel();
  if (study.suffices(plan))
    return fmt::format("A second loading will distinguish slips from cracks: {}.", programme_in_words(plan, shown));
  if (const auto least = study.least())
    return fmt::format("A second loading will distinguish slips from cracks only after less travel: {}.",
                       programme_in_words(*least, shown));
  return fmt::format(
      "No second loading up to this travel distinguishes slips from cracks in {:.0f} of 100 tests or more.",
      100 * study.required_chance);
}

std::string change_of_reload_in_words(const ReloadChange& change, const InUnits& shown) {
  const bool is_noise = change.parameter == "noise";
  const Kind& kind = is_noise ? kind::force : design_parameter(change.parameter).kind();
  const std::string_view what = is_noise                          ? "a load cell with a noise of"
                                : change.parameter == "travel"    ? "loading to the stage position"
                                : change.parameter == "stiffness" ? "a load train of"
                                                                  : "a reading every";
  return fmt::format("{} {} instead of {}: {}", what, shown.own(change.to, kind), shown.own(change.from, kind),
                     prospects_in_words(change.plan));
}

std::string least_travel_in_words(const ReloadStudy& study, const InUnits& shown) {
  const auto least = study.least();
  const ReloadPlan& planned = study.of_travel();
  if (!least) return "";
  if (least->travel == planned.travel) return "the planned one: no shorter one that was tried suffices";
  const std::string prospects = prospects_in_words(*least);
  return study.suffices(planned) ? fmt::format("{}: {}", programme_in_words(*least, shown), prospects) : prospects;
}

Chapter chapter_of(const ReloadStudy& study, const InUnits& shown) {
  Chapter chapter{"Slips or cracks", {reload_in_short(study, shown)}};
  if (study.drops == 0) return chapter;
  Rows rows{
      {"planned travel", prospects_in_words(study.of_travel())},
      {"minimum travel", least_travel_in_words(study, shown)},
      {"noise", fmt::format("{} of a force reading{}", shown.own(study.noise, kind::force),
                            study.noise_is_usual ? ", 0.1 % of the maximum force: pass --noise if it is known" : "")}};
  for (const ReloadChange& change : study.changes)
    rows.push_back({"would suffice", change_of_reload_in_words(change, shown)});
  if (!study.least() && study.changes.empty())
    rows.push_back({"would suffice",
                    "no single change: loading a quarter farther, a load train half as stiff, twice the "
                    "readings, a third of the noise"});
  chapter.blocks.push_back(rows);
  return chapter;
}

// The answer for the numbers of the case, or the middle of their ranges.
std::string of_this_design_in_short(const DesignAnswer& answer) {
  std::string words = answer_in_short(answer);
  if (answer.outcome.status == DesignStatus::ok) return words;
  const std::string where = InUnits(answer).length(answer.outcome.stage_reached);
  if (answer.outcome.status == DesignStatus::breaks)
    return fmt::format("The specimen will break at the stage position {}, at a bending strain of {}{}. Up to there: {}",
                       where, strain_text(answer.surface->strain(answer.outcome.greatest_curvature)),
                       answer.outcome.snaps == 0 ? ", before the first snap" : "", words);
  return fmt::format("The specimen will slip through its supports at the stage position {}. Up to there: {}", where,
                     words);
}

bool is_open(const DesignAnswer& answer) { return answer.open && !answer.open->open.empty(); }

}  // namespace

std::string design_in_short(const DesignAnswer& answer) {
  return is_open(answer) ? open_in_short(*answer.open) : of_this_design_in_short(answer);
}

std::vector<std::string> changes_in_words(const DesignAnswer& answer) {
  const InUnits shown(answer);
  std::vector<std::string> words;
  words.reserve(answer.changes.size());
  for (const DesignChange& change : answer.changes)
    words.push_back(change_in_words(change, shown) + what_remains(answer, change));
  return words;
}

std::vector<Chapter> document_of(const DesignAnswer& answer) {
  const InUnits shown(answer);
  const DesignOutcome& outcome = answer.outcome;
  const double from = min_informative_deflection(answer.design.rig.fibre);
  const auto limit = pin_limit_of(answer.input);
  const Rows rows{
      {"first snap", first_snap_in_words(answer, shown)},
      {"snaps", fmt::format("{} up to the stage position {}, a deflection of {}",
                            outcome.snaps == 0 ? "none" : fmt::format("{}", outcome.snaps),
                            shown.length(outcome.stage_reached), shown.length(outcome.w_reached))},
      {"record", record_in_words(answer, shown)},
      {"load train", critical_in_words(answer, shown)},
      {"work", work_of_design_in_words(answer, shown)},
      {"strain", strain_in_words(answer, shown)},
      {"nose", answer.wraps_nose ? "the specimen wraps around it; beyond that point the nose is treated as sharp" : ""},
      {"rollers", limit
                      ? fmt::format("turn on their pins at a friction of {}, which limits the friction of the specimen",
                                    readable(*limit, kind::number))
                      : ""},
      {"phase", phases_in_words(answer, shown)},
      {"friction",
       from > 0.5 * outcome.w_reached
           ? fmt::format("can be determined only beyond a deflection of {} (the larger of a twentieth of the "
                         "span and twice the thickness)",
                         shown.length(from))
           : ""}};
  Rows changes;
  for (const std::string& words : changes_in_words(answer)) {
    const std::size_t colon = words.find(": ");
    changes.push_back({words.substr(0, colon), words.substr(colon + 2)});
  }
  const std::string_view otherwise = outcome.snaps > 0 ? "keep it from snapping" : "make it snap";
  std::vector<Chapter> chapters;
  if (is_open(answer)) chapters.push_back(chapter_of(*answer.open, shown));
  chapters.push_back({is_open(answer) ? "In the middle of these ranges" : "", {of_this_design_in_short(answer), rows}});
  if (answer.reload) chapters.push_back(chapter_of(*answer.reload, shown));
  chapters.push_back(
      {fmt::format("What would {}", otherwise),
       {changes.empty() ? std::string("No single change was found.")
                        : std::string("Any one of these, if everything else stays the same. Without \"or more\" or "
                                      "\"or less\" it is known only at this value."),
        changes}});
  return chapters;
}

}  // namespace flexslip
