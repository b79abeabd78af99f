#include "answers/drop_fields.h"

#include <algorithm>
#include <functional>
#include <optional>

#include "data/names.h"

namespace flexslip {
namespace {

using T = const FittedTest&;

Fields<Slip> slip_fields() {
  return Fields<Slip>()
      .row("row_before", "row of the file before the slip", [](const Slip& slip) { return slip.drop.before; })
      .row("row_after", "row of the file after it", [](const Slip& slip) { return slip.drop.after; })
      .number("length_before", kind::length, "drawn in before it, and the span", &Slip::S_before)
      .number("length_after", kind::length, "drawn in after it, and the span", &Slip::S_after)
      .number("mu_before", "friction before it", &Slip::mu_before)
      .number("mu_after", "friction after it", &Slip::mu_after);
}

Fields<RiseExplanation> rise_fields() {
  return Fields<RiseExplanation>()
      .number("bic", "Bayes' information criterion", &RiseExplanation::bic)
      .number("friction", "mean friction", &RiseExplanation::friction)
      .number("stiffness_left", "bending stiffness after the last drop over that before the first",
              &RiseExplanation::left);
}

Fields<Tooth> tooth_fields() {
  return Fields<Tooth>()
      .row("first_row", "first row of the file of the rise", &Tooth::first)
      .row("last_row", "its last row", [](const Tooth& tooth) { return tooth.last - 1; })
      .number("length_before", kind::length, "drawn in where it begins, and the span", &Tooth::S_begin)
      .number("length_after", kind::length, "drawn in where it ends, and the span", &Tooth::S_end)
      .number("q_before", "mobilised friction where it begins", &Tooth::q_begin)
      .number("q_after", "mobilised friction where it ends", &Tooth::q_end)
      .estimate("slope", kind::stiffness, "force over stage position, mean of the rise", &Tooth::slope)
      .number("stick_slope", kind::stiffness, "likewise, of a specimen that is stuck", &Tooth::stick_slope)
      .number("slide_slope", kind::stiffness, "likewise, of one that slides at constant friction", &Tooth::slide_slope)
      .estimate("position", kind::number,
                "p: 1 where the slope is that of sticking, 0 where it is that of sliding; its error from scatter",
                &Tooth::position)
      .number("position_systematic", "its error from EI, contact and load train, common to all rises",
              &Tooth::position_systematic)
      .estimate("advance", kind::length, "length drawn in over the rise", &Tooth::advance)
      .words("verdict", "sliding, as_if_stuck or undecided", [](const Tooth& tooth) { return name_of(tooth.verdict); })
      .number("compliant_position", "p of a stuck specimen on supports that give way as fitted",
              &Tooth::compliant_position)
      .number("compliant_deviation", "of the position from that, in standard errors", &Tooth::compliant_deviation)
      .yes_no("compliant_rejected", "that is too much: it slides all the same", &Tooth::compliant_rejected);
}

Fields<SupportCompliance> compliance_fields() {
  return Fields<SupportCompliance>()
      .words(
          "status", "ok, too_few_teeth or none_fits",
          [](const SupportCompliance& compliance) {
            return name_in_order<ComplianceStatus::none_fits>(compliance.status, {"ok", "too_few_teeth", "none_fits"});
          })
      .only_where([](const SupportCompliance& compliance) { return compliance.status == ComplianceStatus::ok; })
      .number("value", kind::compliance, "of both supports together, if the specimen were stuck",
              [](const SupportCompliance& compliance) { return compliance.estimate.value; })
      .number("standard_error", kind::compliance, "of value, from scatter",
              [](const SupportCompliance& compliance) { return compliance.estimate.standard_error; })
      .number("systematic", kind::compliance, "error of value from EI, contact and load train",
              &SupportCompliance::systematic)
      .words("unit", "of these",
             [](const SupportCompliance&, const Frame& frame) { return unit_of(kind::compliance, frame.reduced); })
      .number("chi_squared", "of the slopes about it", &SupportCompliance::chi_squared)
      .count("freedom", "degrees of freedom", &SupportCompliance::freedom)
      .number("p_value", "probability of so large a chi_squared of a specimen that is stuck",
              &SupportCompliance::p_value);
}

}  // namespace

Fields<DropOf> drop_fields() {
  using D = const DropOf&;
  const auto before = [](std::vector<double> Record::*column) {
    return [column](D drop) { return (drop.record.*column)[drop.slip.drop.before]; };
  };
  const auto after = [](std::vector<double> Record::*column) {
    return [column](D drop) { return (drop.record.*column)[drop.slip.drop.after]; };
  };
  return Fields<DropOf>()
      .row("row_before", "row of the file before the drop", [](D drop) { return drop.slip.drop.before; })
      .row("row_after", "row of the file after it", [](D drop) { return drop.slip.drop.after; })
      .own("stage", kind::length, "stage position before it", before(&Record::stage))
      .own("deflection_before", kind::length, "deflection before it", before(&Record::deflection))
      .own("deflection_after", kind::length, "deflection after it", after(&Record::deflection))
      .own("force_before", kind::force, "force before it", before(&Record::force))
      .own("force_after", kind::force, "force after it", after(&Record::force))
      .own("force_fall", kind::force, "by which the force falls", [](D drop) { return drop.slip.drop.force_fall; })
      .number("significance", "fall beyond that of the smooth curve, in standard deviations of the noise",
              [](D drop) { return drop.slip.drop.significance; })
      .number("false_alarms", "drops as significant to be expected in a test of this length without slips",
              [](D drop) { return drop.slip.drop.false_alarms; })
      .words("slip",
             "whether it can be a slip: possible, too_short to judge, or why not: unexplained by any friction, "
             "implausible "
             "friction before, negative friction after, moves_out",
             [](D drop) { return name_of(drop.slip.verdict); })
      .estimate("pulled_in", kind::length, "length that it draws in over both supports, if it is a slip",
                [](D drop) { return normal_estimate(drop.slip.S_after - drop.slip.S_before, drop.slip.advance_error); })
      .number("mu_before", "friction before it, if it is a slip", [](D drop) { return drop.slip.mu_before; })
      .number("mu_after", "friction after it, likewise", [](D drop) { return drop.slip.mu_after; });
}

Fields<TestAnalysis> slips_fields() {
  const auto summary = [](auto part) {
    return [part](const TestAnalysis& analysis) { return analysis.slip_summary.*part; };
  };
  return Fields<TestAnalysis>()
      .count("count", "drops that slips can explain", summary(&SlipSummary::count))
      .number("median_spacing", kind::length,
              "of the specimen that passes over a support from the beginning of a slip to that of the next, median",
              summary(&SlipSummary::median_spacing))
      .number("mean_spacing", kind::length, "likewise, mean", summary(&SlipSummary::mean_spacing))
      .number("median_fall_of_mu", "by which friction falls in a slip, median", summary(&SlipSummary::median_fall))
      .list("slips", "those drops", slip_fields(), [](const TestAnalysis& analysis) {
        std::vector<Slip> possible;
        for (const Slip& slip : analysis.slips)
          if (slip.verdict == SlipVerdict::possible) possible.push_back(slip);
        return possible;
      });
}

Fields<SlipOrCrack> slip_or_crack_fields() {
  const Fields<RiseExplanation> rise = rise_fields();
  return Fields<SlipOrCrack>()
      .words("verdict", "not_by_cracks_alone, cracks or cannot_be_told",
             [](const SlipOrCrack& judged) { return name_of(judged.verdict); })
      .number("margin", "D*: BIC of the best of the cracks less that of the best of the slips", &SlipOrCrack::margin)
      .number("margin_arrested", "D: likewise, without cracks that run on within a rise", &SlipOrCrack::margin_arrested)
      .count("rises", "between the drops that are judged", &SlipOrCrack::rises)
      .count("stiffer_rises", "of these, those that grow stiffer towards their end", &SlipOrCrack::stiffer_rises)
      .group("cracks", "cracks that are arrested, friction free", rise, &SlipOrCrack::cracks)
      .group("cracks_constant", "likewise, friction constant", rise, &SlipOrCrack::cracks_constant)
      .group("cracks_running", "cracks that run on within a rise", rise, &SlipOrCrack::cracks_running)
      .group("slip", "slips alone", rise, &SlipOrCrack::slip)
      .group("slip_and_cracks", "both", rise, &SlipOrCrack::slip_and_cracks);
}

Fields<FittedTest> teeth_fields() {
  const auto count = [](ToothVerdict verdict) {
    return [verdict](T test) {
      const auto& teeth = test.analysis.teeth->teeth;
      return std::count_if(teeth.begin(), teeth.end(), [&](const Tooth& tooth) { return tooth.verdict == verdict; });
    };
  };
  return Fields<FittedTest>()
      .number("confidence", "of each verdict, one-sided", [](T) { return tooth_confidence; })
      .number("least_share", "of the stage's motion drawn in, below which a specimen is called stuck",
              [](T test) { return test.provenance.options.teeth.least_share; })
      .group(
          "compliance", "of supports that give way", compliance_fields(),
          [](T test) -> const auto& { return test.analysis.teeth->compliance; })
      .count("sliding", "rises that reject that the specimen is stuck", count(ToothVerdict::sliding))
      .count("as_if_stuck", "rises as steep as if it were stuck", count(ToothVerdict::as_if_stuck))
      .count("undecided", "rises that tell neither", count(ToothVerdict::undecided))
      .count("too_short", "rises of fewer than four rows", [](T test) { return test.analysis.teeth->too_short; })
      .count("unexplained", "rises whose middle no friction explains",
             [](T test) { return test.analysis.teeth->unexplained; })
      .list("teeth", "the rises between drops", tooth_fields(), [](T test) { return test.analysis.teeth->teeth; });
}

std::vector<SuspectPoint> suspects_of(T test) {
  std::vector<SuspectPoint> all;
  const auto& points = test.analysis.profile.points;
  for (const auto index : test.analysis.suspects.points) {
    const auto found = std::lower_bound(points.begin(), points.end(), index,
                                        [](const ProfilePoint& point, std::size_t i) { return point.index < i; });
    all.push_back({index, found != points.end() && found->index == index ? &*found : nullptr});
  }
  return all;
}

Fields<SuspectPoint> suspect_fields() {
  const auto read = [](auto value) {
    return [value](const SuspectPoint& point) {
      return point.read ? std::optional<double>(std::invoke(value, *point.read)) : std::nullopt;
    };
  };
  return Fields<SuspectPoint>()
      .row("row", "row of the file", &SuspectPoint::index)
      .number("length", kind::length, "drawn in, and the span", read(&ProfilePoint::S))
      .number("mu", "friction that it needs", read(&ProfilePoint::mu))
      .number("mu_error", "its standard error", read(standard_error));
}

Fields<SuspectReport> suspect_criteria_fields() {
  return Fields<SuspectReport>()
      .number("limit", "friction above it is implausible", &SuspectReport::limit)
      .count("points_judged", "past a deflection of a tenth of the span", &SuspectReport::points_judged)
      .count("points_above_limit", "of these", [](const SuspectReport& report) { return report.points.size(); })
      .count("points_above_limit_beyond_error", "of these by more than 1.96 standard errors",
             &SuspectReport::beyond_error)
      .count("points_above_euler_bernoulli", "points past there with a force above 48 EI w/L³: the paper's criterion",
             &SuspectReport::above_euler_bernoulli);
}

}  // namespace flexslip
