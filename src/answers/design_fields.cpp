#include "answers/design_fields.h"

#include <cmath>
#include <optional>
#include <variant>

#include "answers/mechanics_fields.h"
#include "data/names.h"
#include "design/design_result.h"

namespace flexslip {
namespace {

struct DescribedChange {
  const DesignChange& change;
  const std::string& words;
};

std::vector<DescribedChange> changes_of(const DescribedDesign& design) {
  std::vector<DescribedChange> all;
  for (std::size_t i = 0; i < design.changes.size(); ++i) all.push_back({design.answer.changes[i], design.changes[i]});
  return all;
}

Fields<DescribedChange> change_fields() {
  using C = const DescribedChange&;
  return Fields<DescribedChange>()
      .words("parameter", "parameter that changes; the others keep their values",
             [](C c) { return c.change.parameter; })
      .own("from", kind::number, "current value, in the unit of the parameter", [](C c) { return c.change.from; })
      .own("to", kind::number, "changed value, in the unit of the parameter", [](C c) { return c.change.to; })
      .yes_no("and_beyond", "the changed answer also holds for every value beyond `to`",
              [](C c) { return c.change.and_beyond; })
      .number("largest_drop_share", "largest drop after the change, as a share of the maximum force",
              [](C c) { return c.change.outcome.largest_drop / c.change.outcome.greatest_force; })
      .words("words", "the change as a sentence", [](C c) { return c.words; });
}

Fields<PhaseStudy> phase_fields() {
  return Fields<PhaseStudy>()
      .count("count", "number of phases of the waves of friction that were tried", &PhaseStudy::phases)
      .count("snapping", "number of phases with which the specimen snaps", &PhaseStudy::snapping)
      .number("least_largest_drop", kind::force, "smallest of the largest drops, one for each phase",
              &PhaseStudy::min_drop)
      .number("greatest_largest_drop", kind::force, "largest of the largest drops, one for each phase",
              &PhaseStudy::largest_drop)
      .number("critical_stiffness", kind::stiffness, "smallest stiffness at and above which no phase leads to a snap",
              &PhaseStudy::critical);
}

Fields<ReloadPlan> plan_fields() {
  using P = const ReloadPlan&;
  return Fields<ReloadPlan>()
      .own("travel", kind::length, "stage position to which the specimen is loaded", &ReloadPlan::travel)
      .own("unload_to", kind::length, "stage position at which the unloading ends", &ReloadPlan::unload_to)
      .own("force", kind::force, "force at the end of the unloading", &ReloadPlan::force)
      .count("drops", "number of drops in the first loading", &ReloadPlan::drops)
      .number("loss_needed",
              "stiffness loss, as a share, that the drops require if they are cracks only; null if undetermined",
              &ReloadPlan::loss_needed)
      .number("loss_error", "standard error of the measured stiffness loss, as a share; null if undetermined",
              &ReloadPlan::loss_error)
      .number("chance_if_cracks", "probability that fit says CRACK if the drops are cracks only",
              [](P plan) { return plan.chances.cracks; })
      .number("chance_if_slips", "probability that fit says SLIP if the drops are slips only",
              [](P plan) { return plan.chances.slips; });
}

Fields<ReloadStudy> reload_fields() {
  using S = const ReloadStudy&;
  const auto changes =
      Fields<ReloadChange>()
          .words("parameter", "travel, stiffness, step or noise", &ReloadChange::parameter)
          .own("from", kind::number, "current value, in the unit of the parameter", &ReloadChange::from)
          .own("to", kind::number, "changed value, in the unit of the parameter", &ReloadChange::to)
          .group("plan", "plan with this change", plan_fields(), &ReloadChange::plan);
  return Fields<ReloadStudy>()
      .count(
          "drops",
          "number of drops that fit would detect in the planned loading: snaps, and smooth decreases that are as steep",
          &ReloadStudy::drops)
      .own("noise", kind::force, "standard deviation of a force reading, as used", &ReloadStudy::noise)
      .yes_no("noise_is_usual", "no noise is stated; 0.1 % of the maximum force is assumed",
              &ReloadStudy::noise_is_usual)
      .own("step", kind::length, "distance between two readings, as used", &ReloadStudy::step)
      .number("required_chance", "minimum probability of the right verdict for a plan to suffice",
              &ReloadStudy::required_chance)
      .group("planned",
             "planned travel with the shallowest sufficient unloading, or else the most reliable one; null if there is "
             "nothing to decide",
             plan_fields(),
             [](S study) { return study.plans.empty() ? std::nullopt : std::optional(study.of_travel()); })
      .group("least", "smallest sufficient travel, with the shallowest sufficient unloading; null if no plan suffices",
             plan_fields(), [](S study) { return study.least(); })
      .list("plans",
            "plans tried, by travel, then from the shallowest unloading to the deepest; empty if there is nothing to "
            "decide",
            plan_fields(), &ReloadStudy::plans)
      .list("changes", "single changes that make a plan sufficient; empty if one is sufficient already", changes,
            &ReloadStudy::changes);
}

Fields<OpenStudy> open_fields() {
  using N = const OpenNumber&;
  const auto ranges = Fields<OpenNumber>()
                          .words("parameter", "number of friction that the case does not state",
                                 [](N each) { return each.axis.parameter.name; })
                          .own("from", kind::number, "lower end of its range, in the unit of the parameter",
                               [](N each) { return std::get<AxisRange>(each.axis.values).from; })
                          .own("to", kind::number, "upper end of its range, in the unit of the parameter",
                               [](N each) { return std::get<AxisRange>(each.axis.values).to; })
                          .words("reason", "origin of the range", &OpenNumber::reason);
  return Fields<OpenStudy>()
      .count("designs", "number of designs over these ranges", &OpenStudy::designs)
      .count("snapping", "number of these designs in which the specimen snaps", &OpenStudy::snapping)
      .number("least_snap_share", "smallest of the largest snaps of the designs, as a share of the maximum force",
              &OpenStudy::min_snap)
      .number("greatest_snap_share", "largest snap of all designs, as a share of the maximum force",
              &OpenStudy::max_snap)
      .number("least_force", kind::force, "smallest maximum force of a design", &OpenStudy::min_force)
      .number("greatest_force", kind::force, "largest maximum force of a design", &OpenStudy::max_force)
      .list("ranges", "numbers of friction that the case does not state, with their ranges", ranges, &OpenStudy::open);
}

// The parameters of the case, each in its unit.
Fields<DescribedDesign> changed_parameter_fields() {
  Fields<DescribedDesign> fields;
  fields.left_out_where_missing();
  for (const DesignParameter& known : design_parameters())
    fields.own(known.name, known.kind(), known.description, [parameter = known.name](const DescribedDesign& design) {
      return value_of(design.answer.input, parameter);
    });
  return fields;
}

DesignResult design_result(const DescribedDesign& design) {
  const DesignAnswer& answer = design.answer;
  return {status_of(answer.outcome), DesignUnits{answer.scales, answer.surface}, answer.outcome};
}

constexpr std::string_view statuses =
    "ok; slipped_through or breaks (results up to that point); impossible; or not_computable";

}  // namespace

Fields<DescribedDesign> design_fields() {
  return Fields<DescribedDesign>()
      .in_frame([](const DescribedDesign& design) {
        return Frame{design.answer.scales, design.answer.input.reduced};
      })
      .words("status", statuses,
             [](const DescribedDesign& design) { return word_of(status_of(design.answer.outcome)); })
      .all_of(outcome_fields(), design_result)
      .yes_no("wraps_nose", "the specimen is curved more sharply than the loading nose",
              [](const DescribedDesign& design) { return design.answer.wraps_nose; })
      .number("friction_share", "share of the work that goes into friction and snaps",
              [](const DescribedDesign& design) { return friction_share(design.answer.outcome); })
      .words("answer", "prediction whether the test shows a sawtooth, as a sentence",
             [](const DescribedDesign& design) { return design.words; })
      .number("critical_stiffness", kind::stiffness,
              "smallest load-train stiffness at and above which this loading has no snap; null if it snaps on every "
              "rig, 0 if on no rig",
              [](const DescribedDesign& design) { return design.answer.critical; })
      .number("pin_limit",
              "largest friction that can act, because the rollers turn on their pins; null for other supports",
              [](const DescribedDesign& design) { return pin_limit_of(design.answer.input); })
      .yes_no("snaps_whatever_the_stiffness", "the specimen snaps even under displacement control",
              [](const DescribedDesign& design) {
                return design.answer.critical > 0 && !std::isfinite(design.answer.critical);
              })
      .group("phases", "effect of the phase of the waves of friction; null if it has none", phase_fields(),
             [](const DescribedDesign& design) { return design.answer.phases; })
      .list("changes", "single changes that reverse the answer", change_fields(), changes_of)
      .group("reload", "whether a second loading will distinguish slips from cracks; null unless requested",
             reload_fields(), [](const DescribedDesign& design) { return design.answer.reload; })
      .group("open",
             "outcomes over the friction that the case does not state, whose middle is the design; null if it states "
             "all",
             open_fields(),
             [](const DescribedDesign& design) {
               const auto& open = design.answer.open;
               return open && !open->open.empty() ? open : std::nullopt;
             })
      .group("parameters", "parameters of the design, in their units; null if infinite", changed_parameter_fields())
      .group("units", "units of plain numbers", units_of_numbers<DescribedDesign>());
}

Fields<DesignPoint> point_fields(const std::vector<DesignAxis>& axes) {
  using P = const DesignPoint&;
  Fields<DesignPoint> fields;
  fields.left_out_where_missing();
  for (std::size_t i = 0; i < axes.size(); ++i)
    fields.own(axes[i].parameter.name, axes[i].parameter.kind(), axes[i].parameter.description,
               [i](P point) { return point.values[i]; });
  return fields.words("status", statuses, [](P point) { return word_of(point.result.status); })
      .all_of(outcome_fields(), &DesignPoint::result);
}

Fields<MapPoint> map_fields(const std::vector<DesignAxis>& axes) {
  using P = const MapPoint&;
  return Fields<MapPoint>()
      .left_out_where_missing()
      .all_of(point_fields(axes), [](P point) -> const DesignPoint& { return point; })
      .number("stiffness_margin",
              "ln of the ratio of stiffness to critical stiffness, limited to ±3; the specimen does not snap above 0",
              [](P point) { return point.result.outcome ? std::optional(point.margin) : std::nullopt; });
}

Fields<std::vector<MapPoint>> design_map_fields(const std::vector<DesignAxis>& axes) {
  return Fields<std::vector<MapPoint>>()
      .group("units", "units of plain numbers", units_of_numbers<std::vector<MapPoint>>())
      .list(
          "designs", "designs, one for each combination of values", map_fields(axes),
          [](const std::vector<MapPoint>& points) -> const auto& { return points; });
}

}  // namespace flexslip
