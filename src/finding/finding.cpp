#include "finding/finding.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "data/names.h"

namespace flexslip {

std::string_view name_of(Severity severity) {
  return name_in_order<Severity::unjudged>(
      severity, {"refusal", "suspicion", "doubt", "condition", "note", "passed", "unjudged"});
}

std::string reading_of(const Slip& slip) {
  if (slip.verdict == SlipVerdict::possible) return slip.can_be_crack ? "slip or crack" : "slip";
  const std::string_view reason = name_in_order<SlipVerdict::too_short>(
      slip.verdict,
      {"", "no friction explains a slip", "a slip would need too much friction before it",
       "a slip would need negative friction", "a slip would slide outwards", "too small to judge as a slip"});
  return fmt::format("{}; {}", slip.can_be_crack ? "crack" : "neither slip nor crack", reason);
}

std::string_view name_of(VerdictCode code) {
  return name_in_order<VerdictCode::no_answer>(
      code, {"slip", "slip_and_damage", "undecided", "crack", "settled", "no_drops", "check_input", "no_answer"});
}

std::string_view word_of(VerdictCode code) {
  return name_in_order<VerdictCode::no_answer>(
      code, {"SLIP", "SLIP AND DAMAGE", "UNDECIDED", "CRACK", "SETTLED", "NO DROPS", "CHECK INPUT", "NO ANSWER"});
}

std::string sentence_of(const Verdict& verdict) {
  return fmt::format("{}. {}{}{}", word_of(verdict.code), verdict.meaning, verdict.evidence.empty() ? "" : " ",
                     verdict.evidence);
}

bool is_refused(const std::vector<Finding>& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const Finding& finding) { return finding.severity == Severity::refusal; });
}

bool is_suspect(const std::vector<Finding>& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const Finding& finding) { return finding.severity <= Severity::suspicion; });
}

const Finding* finding_in(const std::vector<Finding>& findings, std::string_view code) {
  const auto found =
      std::find_if(findings.begin(), findings.end(), [&](const Finding& each) { return each.code == code; });
  return found == findings.end() ? nullptr : &*found;
}

std::vector<AnswerRow> all_rows(const Answer& answer) {
  std::vector<AnswerRow> rows = answer.rows;
  rows.insert(rows.end(), answer.details.begin(), answer.details.end());
  return rows;
}

std::vector<Finding> doubts_of(const Answer& answer) {
  const VerdictCode verdict = answer.verdict.code;
  // Other findings follow from a wrong input, and most of them from lost stiffness.
  if (verdict == VerdictCode::check_input || verdict == VerdictCode::no_answer) return {};
  constexpr std::array independent_of_cracks{"few_rows", "filtered_force", "other_contact", "sloping_baseline"};
  std::vector<Finding> doubts;
  for (const Finding& finding : answer.findings) {
    if (finding.severity > Severity::doubt || finding.code == answer.verdict.finding) continue;
    if (verdict == VerdictCode::crack && std::find(independent_of_cracks.begin(), independent_of_cracks.end(),
                                                   finding.code) == independent_of_cracks.end())
      continue;
    doubts.push_back(finding);
  }
  std::stable_sort(doubts.begin(), doubts.end(),
                   [](const Finding& a, const Finding& b) { return a.severity < b.severity; });
  return doubts;
}

std::string checks_in_words(const Answer& answer) {
  if (answer.verdict.code == VerdictCode::check_input || answer.verdict.code == VerdictCode::no_answer) return "";
  const auto is_check = [](const Finding& finding) { return finding.is_check; };
  const auto passed = [](const Finding& finding) { return finding.severity == Severity::passed; };
  const auto checks = std::count_if(answer.findings.begin(), answer.findings.end(), is_check);
  const auto good = std::count_if(answer.findings.begin(), answer.findings.end(), passed);
  if (checks == 0) return "";
  const auto unjudged = std::count_if(answer.findings.begin(), answer.findings.end(), [&](const Finding& finding) {
    return is_check(finding) && finding.severity == Severity::unjudged;
  });
  return fmt::format(
      "{} checks of the fit passed{}{}.",
      good == checks ? fmt::format("All {}", checks) : fmt::format("{} of {}", good, checks),
      unjudged > 0 ? fmt::format(", {} not possible", unjudged) : "",
      good < checks && answer.verdict.code == VerdictCode::crack ? ", as expected of a cracked specimen" : "");
}

}  // namespace flexslip
