#include "report/design_words.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "finding/printed.h"
#include "inference/profile.h"
#include "report/plain_text.h"

namespace flexslip {
namespace {

class InUnits : public Print {
 public:
  explicit InUnits(const DesignAnswer& answer) : Print(answer.input, answer.scales) {}

  // [units of the case]
  std::string stiffness(double value) const {
    return std::isfinite(value) ? own(value, kind::stiffness) : "infinite stiffness";
  }
  // A number of few digits, all of them; of inches and pounds, which turn few into many, six.
  std::string exactly(double value, const Kind& kind) const {
    const Kind shown = as(kind);
    const std::string_view unit = best_unit(value, shown);
    const Unit scale = unit.empty() ? Unit{} : parse_unit(unit);
    return typeset(scale.factor == 1 ? exact_text(value, shown)
                                     : fmt::format("{:.6g} {}", from_si(value, scale), unit));
  }
};

// To three digits, no less than it is.
double rounded_to_enough(double value) {
  if (value == 0) return value;
  const double step = std::pow(10, std::floor(std::log10(value)) - 2);
  return step * std::ceil(value / step);
}

std::string share(double part, double whole) {
  const double percentage = std::max(0.0, 100 * part / whole);  // what is rounding may be below
  return percentage > 0 && percentage < 0.1 ? "less than 0.1 %"
                                            : fmt::format("{:.{}f} %", percentage, percentage < 10 ? 1 : 0);
}

bool hidden(const DesignOutcome& outcome) { return outcome.snaps > 0 && outcome.drops == 0; }

std::string drops_in_words(const DesignAnswer& answer, const InUnits& shown) {
  const DesignOutcome& outcome = answer.outcome;
  const std::string record = answer.design.step > 0
                                 ? fmt::format("a record with a reading every {}", shown.length(answer.design.step))
                                 : "a continuous record";
  if (outcome.drops == 0)
    return fmt::format("In {} the force never falls; its maximum is {}.", record, shown.force(outcome.greatest_force));
  const std::string why =
      outcome.snaps > outcome.drops ? " Some snaps lie between the same two readings and appear as one fall."
      : outcome.snaps == 0 && outcome.drops > 1 ? " These falls are not snaps: friction varies along the specimen, and "
                                                  "the force follows it on any load train."
                                                : "";
  return fmt::format(
      "In {} the force falls {}: by {} at most ({} of the greatest force, {}){}.{}", record,
      outcome.drops == 1 ? "once" : fmt::format("{} times", outcome.drops), shown.force(outcome.largest_drop),
      share(outcome.largest_drop, outcome.greatest_force), shown.force(outcome.greatest_force),
      outcome.drops == 1 ? "" : fmt::format(", and by {} on average", shown.force(outcome.mean_drop)), why);
}

std::string strain_text(double strain) { return fmt::format("{:.2g} %", 100 * strain); }

// How far the specimen is strained; nothing without a section.
std::string strain_in_words(const DesignAnswer& answer) {
  const std::string wraps = answer.wraps_nose ? " The specimen is bent more sharply than the nose and wraps around it; "
                                                "from there on the nose is taken to be sharp."
                                              : "";
  if (!answer.surface) return wraps;
  const double curvature = answer.outcome.greatest_curvature;
  return fmt::format(" The bending strain at the surface reaches {}{}.{}",
                     strain_text(answer.surface->strain(curvature)),
                     answer.input.reduced
                         ? ""
                         : fmt::format(" ({})", InUnits(answer).own(answer.surface->stress(curvature), kind::pressure)),
                     wraps);
}

std::string snaps_in_words(const DesignAnswer& answer, const InUnits& shown) {
  const DesignOutcome& outcome = answer.outcome;
  if (!outcome.first_snap)
    return fmt::format("Up to the stage position {} (a deflection of {}) the specimen does not snap.{}",
                       shown.length(outcome.stage_reached), shown.length(outcome.w_reached), strain_in_words(answer));
  const auto& first = *outcome.first_snap;
  const std::string before = shown.force(first.F_before), after = shown.force(first.F_after);
  const std::string fall = before == after
                               ? fmt::format("by {} from {}", shown.force(first.F_before - first.F_after), before)
                               : fmt::format("from {} to {}", before, after);
  return fmt::format(
      "The first snap comes at the stage position {} and a deflection of {}: the force falls {}. Up to the stage "
      "position {} (a deflection of {}) there {}.{}",
      shown.length(first.stage), shown.length(first.w), fall, shown.length(outcome.stage_reached),
      shown.length(outcome.w_reached),
      outcome.snaps == 1 ? "is no other" : fmt::format("are {} snaps in all", outcome.snaps), strain_in_words(answer));
}

std::string critical_in_words(const DesignAnswer& answer, const InUnits& shown) {
  const std::string yours =
      fmt::format("This rig has {}.", shown.stiffness(answer.scales.physical_stiffness(answer.design.rig.stiffness)));
  const std::string_view which = support_compliance_of(answer.input) > 0
                                     ? "stiffness of load train and supports together"
                                     : "load-train stiffness";
  if (answer.critical == 0) {
    const bool varies = std::isfinite(answer.design.friction.smooth_scale()) || !answer.design.friction.knots().empty();
    return fmt::format("No load train, however soft, lets the specimen snap in this test. {}{}", yours,
                       varies ? ""
                              : " Friction that is uniform along the specimen makes no sawtooth: state an amplitude "
                                "and a wavelength, such as those of a fit, to see the effect of variation.");
  }
  if (!std::isfinite(answer.critical))
    return fmt::format(
        "There is no critical {}: in this test the specimen snaps even if the deflection itself is controlled. {}",
        which, yours);
  const double critical = rounded_to_enough(answer.scales.physical_stiffness(answer.critical));
  const bool is_too_soft = answer.outcome.snaps == 0 && answer.design.rig.stiffness < answer.critical;
  const std::string why =
      is_too_soft
          ? fmt::format(" That is softer, but the specimen does not snap, as this rig bends it by no more than {}.",
                        shown.length(answer.outcome.w_reached))
          : "";
  const bool is_out_of_reach = critical * support_compliance_of(answer.input) >= 1;
  return fmt::format(
      "The critical {} of this test is {}, the smallest at and above which the specimen does not snap. {}{}{}", which,
      shown.stiffness(critical), yours, why,
      is_out_of_reach ? " On these supports no load train reaches that, however stiff." : "");
}

std::string work_in_words(const DesignAnswer& answer, const InUnits& shown) {
  const DesignOutcome& outcome = answer.outcome;
  const std::string snaps =
      outcome.snaps > 0 ? fmt::format(", and the snaps set free {} beyond that", share(outcome.released, outcome.work))
                        : "";
  return fmt::format(
      "The work done on the specimen is {}. Friction at the supports takes {} of it{}; the rest bends the specimen.",
      shown.energy(outcome.work), share(outcome.friction_heat, outcome.work), snaps);
}

std::string pins_in_words(double limit) {
  return fmt::format(
      "The rollers turn on their pins at a friction of {}. Friction on the specimen cannot exceed that; where the "
      "specimen's own friction is greater, its variation has no effect.",
      readable(limit, kind::number));
}

std::string phases_in_words(const DesignAnswer& answer, const InUnits& shown) {
  const PhaseStudy& study = *answer.phases;
  const std::string_view known =
      "The phase (the position of the waves of friction along the specimen) is seldom known before a test.";
  const std::string least = shown.force(study.least_drop), most = shown.force(study.largest_drop);
  const std::string drops = !(study.largest_drop > 0) ? ""
                            : least == most           ? fmt::format(", and the largest drop is {}", most)
                                            : fmt::format(", and the largest drop lies between {} and {}", least, most);
  if (study.snapping == 0)
    return fmt::format("{} The specimen snaps with none of {} phases{}.", known, study.phases, drops);
  const std::string count = study.snapping == study.phases
                                ? fmt::format("with each of {} phases", study.phases)
                                : fmt::format("with {} of {} phases", study.snapping, study.phases);
  const std::string remedy =
      std::isfinite(study.critical)
          ? fmt::format("With a load train{} of at least {}, it snaps with none of these phases",
                        support_compliance_of(answer.input) > 0 ? " and supports together" : "",
                        shown.stiffness(rounded_to_enough(answer.scales.physical_stiffness(study.critical))))
          : "With some of these phases, it snaps however stiff the load train is";
  return fmt::format("{} The specimen snaps {}{}. {}.", known, count, drops, remedy);
}

std::string change_in_words(const DesignChange& change, const InUnits& shown) {
  const DesignParameter parameter = change.parameter;
  const Kind& kind = described(parameter).kind;
  const bool more = change.to > change.from;
  const std::string value = shown.exactly(change.printed, kind);
  const std::string to = change.and_beyond ? fmt::format("{} or {}", value, more ? "more" : "less") : value;
  const std::string from = shown.own(change.from, kind);
  switch (parameter) {
    case DesignParameter::stiffness:
      return fmt::format("a {} load train: {} instead of {}", more ? "stiffer" : "softer", to,
                         shown.stiffness(change.from));
    case DesignParameter::span:
      return fmt::format("a {} support span: {} instead of {}", more ? "longer" : "shorter", to, from);
    case DesignParameter::diameter:
      return fmt::format("a {} specimen: a diameter of {} instead of {}", more ? "thicker" : "thinner", to, from);
    case DesignParameter::height:
      return fmt::format("a {} specimen: a height of {} instead of {}", more ? "thicker" : "thinner", to, from);
    case DesignParameter::width:
      return fmt::format("a {} specimen: a width of {} instead of {}", more ? "wider" : "narrower", to, from);
    case DesignParameter::modulus:
      return fmt::format("a {} specimen: a modulus of {} instead of {}", more ? "stiffer" : "softer", to, from);
    case DesignParameter::mu0:
      return fmt::format("{}: mu0 {} instead of {}", more ? "supports with more friction" : "lubricated supports", to,
                         from);
    case DesignParameter::amplitude:
      return fmt::format("{}: an amplitude of {} instead of {}",
                         more ? "rougher supports or specimens" : "polished supports", to, from);
    case DesignParameter::wavelength:
      return fmt::format("another specimen, with roughness of a {} wavelength: {} instead of {}",
                         more ? "longer" : "shorter", to, from);
    case DesignParameter::travel:
      return more ? fmt::format("loading farther: up to the stage position {} instead of {}", to, from)
                  : fmt::format("stopping before the first snap: at the stage position {} instead of {}", to, from);
    case DesignParameter::pin_friction:
      return fmt::format("rollers that turn {} on their pins: pin_friction {} instead of {}",
                         more ? "harder" : "more easily", to, from);
    case DesignParameter::phase:
    case DesignParameter::step:
    case DesignParameter::reference:
      break;
  }
  throw std::invalid_argument("no change of this parameter is looked for");
}

bool falls_no_less(const DesignOutcome& then, const DesignOutcome& now) {
  return then.largest_drop * now.greatest_force >= now.largest_drop * then.greatest_force;
}

// The force may fall without a snap: friction that varies along the specimen makes it wavy on any rig.
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

std::string answer_in_short(const DesignAnswer& answer) {
  const InUnits shown(answer);
  const DesignOutcome& outcome = answer.outcome;
  if (hidden(outcome))
    return fmt::format("The specimen will snap {}, but readings {} apart will not show it.",
                       outcome.snaps == 1 ? "once" : fmt::format("{} times", outcome.snaps),
                       shown.length(answer.design.step));
  constexpr double stands_out = 0.05;  // of the largest fall, which is then a smooth one
  if (outcome.snaps > 1 && outcome.largest_snap < stands_out * outcome.largest_drop)
    return fmt::format("No visible sawtooth: the specimen will snap {} times, but by no more than {} each.",
                       outcome.snaps, shown.force(outcome.largest_snap));
  if (outcome.snaps > 0) {
    const std::string most = fmt::format("{}, {} of the greatest force", shown.force(outcome.largest_drop),
                                         share(outcome.largest_drop, outcome.greatest_force));
    return outcome.snaps == 1 ? fmt::format("Yes: the specimen will snap, once. The force drops by up to {}.", most)
                              : fmt::format("Yes, you will see a sawtooth: the force drops by up to {}.", most);
  }
  if (outcome.drops == 1) return "No sawtooth: the specimen slides without a snap, past a smooth peak of the force.";
  if (outcome.drops > 1)
    return "No sawtooth, but a wavy force: the specimen slides without a snap, and the force falls only smoothly.";
  return "No sawtooth: the specimen slides without a snap, and the force never falls.";
}

}  // namespace

std::string design_in_short(const DesignAnswer& answer) {
  std::string words = answer_in_short(answer);
  if (answer.outcome.status == DesignStatus::ok) return words;
  const std::string where = InUnits(answer).length(answer.outcome.stage_reached);
  if (answer.outcome.status == DesignStatus::breaks)
    return fmt::format("The specimen will break at the stage position {}, at a bending strain of {}{}. Up to there: {}",
                       where, strain_text(answer.surface->strain(answer.outcome.greatest_curvature)),
                       answer.outcome.snaps == 0 ? ", before the first snap" : "", words);
  return fmt::format("The specimen will slip through its supports at the stage position {}. Up to there: {}",
                     InUnits(answer).length(answer.outcome.stage_reached), words);
}

std::vector<std::string> design_in_words(const DesignAnswer& answer) {
  const InUnits shown(answer);
  std::vector<std::string> paragraphs{snaps_in_words(answer, shown), drops_in_words(answer, shown),
                                      critical_in_words(answer, shown), work_in_words(answer, shown)};
  if (const auto limit = pin_limit_of(answer.input)) paragraphs.push_back(pins_in_words(*limit));
  if (answer.phases) paragraphs.push_back(phases_in_words(answer, shown));
  if (const double from = friction_told_from(answer.design.rig.fibre); from > 0.5 * answer.outcome.w_reached)
    paragraphs.push_back(fmt::format(
        "Friction can be read off the curve only beyond a deflection of {} (the larger of a twentieth of the "
        "span and twice the thickness); this loading reaches {}.",
        shown.length(from), shown.length(answer.outcome.w_reached)));
  return paragraphs;
}

std::vector<std::string> changes_in_words(const DesignAnswer& answer) {
  const InUnits shown(answer);
  std::vector<std::string> words;
  words.reserve(answer.changes.size());
  for (const DesignChange& change : answer.changes)
    words.push_back(change_in_words(change, shown) + what_remains(answer, change));
  return words;
}

std::string design_text(const DesignAnswer& answer) {
  std::string text = wrapped(design_in_short(answer), "") + "\n";
  for (const std::string& paragraph : design_in_words(answer)) text += wrapped(paragraph, "");
  const bool snaps = answer.outcome.snaps > 0;
  const auto changes = changes_in_words(answer);
  if (changes.empty())
    return text + fmt::format("\nNo single change was found that would {}.\n",
                              snaps ? "keep it from snapping" : "make it snap");
  const std::string intention = snaps ? "keep it from snapping" : "make it snap";
  text += '\n';
  text +=
      wrapped(fmt::format("Any one of these changes would {} if everything else stays the same. A change without \"or "
                          "more\" or \"or less\" is known to do so only at this value:",
                          intention),
              "");
  for (const std::string& change : changes) text += wrapped(change, "    ", "  - ");
  return text;
}

}  // namespace flexslip
