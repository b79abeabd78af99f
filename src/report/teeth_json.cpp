#include "report/teeth_json.h"

#include <algorithm>
#include <string>

#include "data/names.h"

namespace flexslip {
namespace {

Json compliance_json(const SupportCompliance& compliance, const FittedTest& test) {
  const auto status =
      name_in_order<ComplianceStatus::none_fits>(compliance.status, {"ok", "too_few_teeth", "none_fits"});
  Json out = {{"status", status}, {"value", nullptr},       {"error", nullptr},   {"systematic", nullptr},
              {"unit", nullptr},  {"chi_squared", nullptr}, {"freedom", nullptr}, {"p_value", nullptr}};
  if (compliance.status != ComplianceStatus::ok) return out;
  const double unit = test.analysis.scales.stiffness_unit();
  out["value"] = compliance.value / unit;
  out["error"] = compliance.error / unit;
  out["systematic"] = compliance.systematic / unit;
  out["unit"] = test.reduced ? "1" : "m/N";
  out["chi_squared"] = compliance.chi_squared;
  out["freedom"] = compliance.freedom;
  out["p_value"] = compliance.p_value;
  return out;
}

Json tooth_json(const Tooth& tooth, const FittedTest& test) {
  const auto& scales = test.analysis.scales;
  return {{"first_row", file_row(test, tooth.first)},
          {"last_row", file_row(test, tooth.last - 1)},
          {"length_before", scales.physical_length(tooth.S_begin)},
          {"length_after", scales.physical_length(tooth.S_end)},
          {"q_before", tooth.q_begin},
          {"q_after", tooth.q_end},
          {"slope", scales.physical_stiffness(tooth.slope)},
          {"slope_error", scales.physical_stiffness(tooth.slope_error)},
          {"stick_slope", scales.physical_stiffness(tooth.stick_slope)},
          {"slide_slope", scales.physical_stiffness(tooth.slide_slope)},
          {"position", tooth.position},
          {"position_error", tooth.position_error},
          {"position_systematic", tooth.position_systematic},
          {"advance", scales.physical_length(tooth.advance)},
          {"advance_error", scales.physical_length(tooth.advance_error)},
          {"verdict", name_of(tooth.verdict)},
          {"compliant_position", tooth.compliant_position},
          {"compliant_deviation", tooth.compliant_deviation},
          {"compliant_rejected", tooth.compliant_rejected}};
}

}  // namespace

std::string name_of(ToothVerdict verdict) {
  return std::string(name_in_order<ToothVerdict::undecided>(verdict, {"sliding", "as_if_stuck", "undecided"}));
}

Json teeth_json(const FittedTest& test) {
  if (test.analysis.status != AnalysisStatus::ok || !test.analysis.teeth) return nullptr;
  const Teeth& judged = *test.analysis.teeth;
  const ToothOptions& options = test.provenance.options.teeth;
  const auto count = [&](ToothVerdict verdict) {
    return std::count_if(judged.teeth.begin(), judged.teeth.end(),
                         [&](const Tooth& tooth) { return tooth.verdict == verdict; });
  };
  Json out = {{"confidence", tooth_confidence},
              {"least_share", options.least_share},
              {"compliance", compliance_json(judged.compliance, test)},
              {"sliding", count(ToothVerdict::sliding)},
              {"as_if_stuck", count(ToothVerdict::as_if_stuck)},
              {"undecided", count(ToothVerdict::undecided)},
              {"too_short", judged.too_short},
              {"unexplained", judged.unexplained}};
  Json each = Json::array();
  for (const Tooth& tooth : judged.teeth) each.push_back(tooth_json(tooth, test));
  out["teeth"] = each;
  return out;
}

}  // namespace flexslip
