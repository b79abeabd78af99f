#include "finding/finding.h"

#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/format.h>
#include <fmt/ranges.h>

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
       "a slip would need negative friction", "a slip would let length out", "too short to judge as a slip"});
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
  const std::string parts = fmt::format("{}", fmt::join(verdict.parts, "; "));
  return fmt::format("{}: {}{}", word_of(verdict.code), parts, parts.ends_with('.') ? "" : ".");
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

std::vector<Finding> doubts_of(const Answer& answer) {
  const VerdictCode verdict = answer.verdict.code;
  // What is read off with a wrong input, or of a specimen that lost stiffness, is wrong for that reason.
  if (verdict == VerdictCode::check_input || verdict == VerdictCode::no_answer) return {};
  constexpr std::array whatever_happened{"few_rows", "filtered_force", "other_contact", "sloping_baseline"};
  std::vector<Finding> doubts;
  for (const Finding& finding : answer.findings) {
    if (finding.severity > Severity::doubt || finding.code == answer.verdict.finding) continue;
    if (verdict == VerdictCode::crack &&
        std::find(whatever_happened.begin(), whatever_happened.end(), finding.code) == whatever_happened.end())
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
  if (unjudged > 0) return fmt::format("{} of {} checks passed, {} not possible here.", good, checks, unjudged);
  if (good < checks) {
    std::vector<std::string> remarks;  // of those that neither passed nor stand among the doubts
    for (const Finding& finding : answer.findings)
      if (is_check(finding) && !passed(finding) && finding.severity > Severity::doubt && !finding.short_form.empty())
        remarks.push_back(finding.short_form);
    return fmt::format("{} of {} checks passed{}{}.", good, checks,
                       remarks.empty() ? "" : "; remarked: ", fmt::join(remarks, ", "));
  }
  const bool is_doubted = std::any_of(answer.findings.begin(), answer.findings.end(),
                                      [](const Finding& each) { return each.severity <= Severity::doubt; });
  return fmt::format("{} {} checks passed.", is_doubted ? "The other" : "All", checks);
}

std::string next_in_words(const Answer& answer) {
  if (answer.next.empty()) return "";
  std::string step = answer.next;
  step.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(step.front())));
  return "Next: " + step;
}

}  // namespace flexslip
