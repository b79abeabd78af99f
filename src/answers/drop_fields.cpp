#include "answers/drop_fields.h"

#include <algorithm>
#include <functional>
#include <optional>

#include "data/names.h"
#include "finding/finding.h"

namespace flexslip {
namespace {

using T = const FittedTest&;

Fields<Slip> slip_fields() {
  return Fields<Slip>()
      .row("row_before", "row of the file before the slip", [](const Slip& slip) { return slip.drop.before; })
      .row("row_after", "row of the file after the slip", [](const Slip& slip) { return slip.drop.after; })
      .number("length_before", kind::length,
              "length between the supports before the slip: the span and what was pulled in", &Slip::S_before)
      .number("length_after", kind::length,
              "length between the supports after the slip: the span and what was pulled in", &Slip::S_after)
      .number("mu_before", "friction before the slip", &Slip::mu_before)
      .number("mu_after", "friction after the slip", &Slip::mu_after);
}

Fields<RiseExplanation> rise_fields() {
  return Fields<RiseExplanation>()
      .number("bic", "Bayesian information criterion of the explanation", &RiseExplanation::bic)
      .number("friction", "mean friction of the explanation", &RiseExplanation::friction)
      .number("stiffness_left", "bending stiffness after the last drop divided by that before the first",
              &RiseExplanation::left);
}

Fields<Tooth> tooth_fields() {
  return Fields<Tooth>()
      .row("first_row", "first row of the rise in the file", &Tooth::first)
      .row("last_row", "last row of the rise in the file", [](const Tooth& tooth) { return tooth.last - 1; })
      .number("length_before", kind::length, "length between the supports where the rise begins", &Tooth::S_begin)
      .number("length_after", kind::length, "length between the supports where the rise ends", &Tooth::S_end)
      .number("q_before", "mobilised friction where the rise begins", &Tooth::q_begin)
      .number("q_after", "mobilised friction where the rise ends", &Tooth::q_end)
      .estimate("slope", kind::stiffness, "mean slope of force over stage position in the rise", &Tooth::slope)
      .number("stick_slope", kind::stiffness, "slope of force over stage position for a specimen that sticks",
              &Tooth::stick_slope)
      .number("slide_slope", kind::stiffness,
              "slope of force over stage position for a specimen that slides at constant friction", &Tooth::slide_slope)
      .estimate("position", kind::number,
                "position p of the slope between sliding (0) and sticking (1); its error from scatter",
                &Tooth::position)
      .number("position_systematic", "error of position from EI, contact and load train, common to all rises",
              &Tooth::position_systematic)
      .estimate("advance", kind::length, "length pulled in (both supports) during the rise", &Tooth::advance)
      .words("verdict", "what the specimen does during the rise: sliding, as_if_stuck or undecided",
             [](const Tooth& tooth) { return name_of(tooth.verdict); })
      .number("compliant_position", "position p of a stuck specimen on supports that yield as fitted",
              &Tooth::compliant_position)
      .number("compliant_deviation", "position minus compliant_position, in standard errors",
              &Tooth::compliant_deviation)
      .yes_no("compliant_rejected", "the deviation is too large: the specimen slides even on such supports",
              &Tooth::compliant_rejected);
}

Fields<SupportCompliance> compliance_fields() {
  return Fields<SupportCompliance>()
      .words(
          "status", "whether a compliance was found: ok, too_few_teeth or none_fits",
          [](const SupportCompliance& compliance) {
            return name_in_order<ComplianceStatus::none_fits>(compliance.status, {"ok", "too_few_teeth", "none_fits"});
          })
      .only_where([](const SupportCompliance& compliance) { return compliance.status == ComplianceStatus::ok; })
      .number("value", kind::compliance, "compliance of both supports together, if the specimen were stuck",
              [](const SupportCompliance& compliance) { return compliance.estimate.value; })
      .number("standard_error", kind::compliance, "standard error of value, from scatter",
              [](const SupportCompliance& compliance) { return compliance.estimate.standard_error; })
      .number("systematic", kind::compliance, "error of value from EI, contact and load train",
              &SupportCompliance::systematic)
      .words("unit", "unit of value and its errors",
             [](const SupportCompliance&, const Frame& frame) { return unit_of(kind::compliance, frame.reduced); })
      .number("chi_squared", "chi-squared of the slopes about the compliance", &SupportCompliance::chi_squared)
      .count("freedom", "degrees of freedom of chi_squared", &SupportCompliance::freedom)
      .number("p_value", "probability of a chi_squared at least this large for a stuck specimen",
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
      .row("row_after", "row of the file after the drop", [](D drop) { return drop.slip.drop.after; })
      .own("stage", kind::length, "stage position before the drop", before(&Record::stage))
      .own("deflection_before", kind::length, "deflection before the drop", before(&Record::deflection))
      .own("deflection_after", kind::length, "deflection after the drop", after(&Record::deflection))
      .own("force_before", kind::force, "force before the drop", before(&Record::force))
      .own("force_after", kind::force, "force after the drop", after(&Record::force))
      .own("force_fall", kind::force, "fall of the force in the drop", [](D drop) { return drop.slip.drop.force_fall; })
      .number("significance", "fall of the force beyond that of the smooth curve, in standard deviations of the noise",
              [](D drop) { return drop.slip.drop.significance; })
      .number("false_alarms", "number of equally significant drops expected in a test of this length without slips",
              [](D drop) { return drop.slip.drop.false_alarms; })
      .words("slip",
             "whether the drop can be a slip: possible, too_short, or not: unexplained, implausible, negative or "
             "moves_out",
             [](D drop) { return name_of(drop.slip.verdict); })
      .words("reading", "the same in words, as tables and page print it",
             [](D drop) { return reading_of(drop.slip.verdict); })
      .estimate("pulled_in", kind::length, "length pulled in (both supports) if the drop is a slip",
                [](D drop) { return normal_estimate(drop.slip.S_after - drop.slip.S_before, drop.slip.advance_error); })
      .number("mu_before", "friction before the drop, if it is a slip", [](D drop) { return drop.slip.mu_before; })
      .number("mu_after", "friction after the drop, if it is a slip", [](D drop) { return drop.slip.mu_after; });
}

Fields<TestAnalysis> slips_fields() {
  const auto summary = [](auto part) {
    return [part](const TestAnalysis& analysis) { return analysis.slip_summary.*part; };
  };
  return Fields<TestAnalysis>()
      .count("count", "number of drops that can be slips", summary(&SlipSummary::count))
      .number("median_spacing", kind::length,
              "median length of specimen that passes over each support from the beginning of one slip to the next",
              summary(&SlipSummary::median_spacing))
      .number("mean_spacing", kind::length,
              "mean length of specimen that passes over each support from one slip to the next",
              summary(&SlipSummary::mean_spacing))
      .number("median_fall_of_mu", "median fall of friction in a slip", summary(&SlipSummary::median_fall))
      .list("slips", "drops that can be slips", slip_fields(), [](const TestAnalysis& analysis) {
        std::vector<Slip> possible;
        for (const Slip& slip : analysis.slips)
          if (slip.verdict == SlipVerdict::possible) possible.push_back(slip);
        return possible;
      });
}

Fields<SlipOrCrack> slip_or_crack_fields() {
  const Fields<RiseExplanation> rise = rise_fields();
  return Fields<SlipOrCrack>()
      .words("verdict", "whether cracks alone can make the drops: not_by_cracks_alone, cracks or cannot_be_told",
             [](const SlipOrCrack& judged) { return name_of(judged.verdict); })
      .number("margin", "D*: BIC of the best explanation by cracks minus BIC of the best by slips",
              &SlipOrCrack::margin)
      .number("margin_arrested", "D: like margin, without cracks that grow during a rise",
              &SlipOrCrack::margin_arrested)
      .count("rises", "number of rises between drops that are judged", &SlipOrCrack::rises)
      .count("stiffer_rises", "number of judged rises that grow stiffer towards their end", &SlipOrCrack::stiffer_rises)
      .group("cracks", "explanation by cracks that arrest, friction free to vary", rise, &SlipOrCrack::cracks)
      .group("cracks_constant", "explanation by cracks that arrest, friction constant", rise,
             &SlipOrCrack::cracks_constant)
      .group("cracks_running", "explanation by cracks that grow during a rise", rise, &SlipOrCrack::cracks_running)
      .group("slip", "explanation by slips alone", rise, &SlipOrCrack::slip)
      .group("slip_and_cracks", "explanation by slips and cracks", rise, &SlipOrCrack::slip_and_cracks);
}

Fields<FittedTest> teeth_fields() {
  const auto count = [](ToothVerdict verdict) {
    return [verdict](T test) {
      const auto& teeth = test.analysis.teeth->teeth;
      return std::count_if(teeth.begin(), teeth.end(), [&](const Tooth& tooth) { return tooth.verdict == verdict; });
    };
  };
  return Fields<FittedTest>()
      .number("confidence", "one-sided confidence of each verdict", [](T) { return tooth_confidence; })
      .number("least_share", "share of the stage's motion that is pulled in, below which the specimen is called stuck",
              [](T test) { return test.provenance.options.teeth.least_share; })
      .group(
          "compliance", "compliance of the supports that would explain the slopes of a stuck specimen",
          compliance_fields(), [](T test) -> const auto& { return test.analysis.teeth->compliance; })
      .count("sliding", "number of rises in which the specimen slides", count(ToothVerdict::sliding))
      .count("as_if_stuck", "number of rises that cannot be distinguished from sticking",
             count(ToothVerdict::as_if_stuck))
      .count("undecided", "number of rises that remain undecided", count(ToothVerdict::undecided))
      .count("too_short", "number of rises with fewer than four rows",
             [](T test) { return test.analysis.teeth->too_short; })
      .count("unexplained", "number of rises whose middle no friction explains",
             [](T test) { return test.analysis.teeth->unexplained; })
      .list("teeth", "rises between drops", tooth_fields(), [](T test) { return test.analysis.teeth->teeth; });
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
      .number("length", kind::length, "length between the supports: the span and what was pulled in",
              read(&ProfilePoint::S))
      .number("mu", "friction that the point needs", read(&ProfilePoint::mu))
      .number("mu_error", "standard error of mu", read(standard_error));
}

Fields<SuspectReport> suspect_criteria_fields() {
  return Fields<SuspectReport>()
      .number("limit", "limit above which friction is implausible", &SuspectReport::limit)
      .count("points_judged", "number of points judged, at deflections beyond a tenth of the span",
             &SuspectReport::points_judged)
      .count("points_above_limit", "number of judged points above the limit",
             [](const SuspectReport& report) { return report.points.size(); })
      .count("points_above_limit_beyond_error",
             "number of judged points above the limit by more than 1.96 standard errors", &SuspectReport::beyond_error)
      .count("points_above_euler_bernoulli",
             "number of judged points with a force above 48 EI w/L³, the criterion of the paper",
             &SuspectReport::above_euler_bernoulli);
}

}  // namespace flexslip
