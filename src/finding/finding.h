// What the program finds out about a test: data with its sentence, worded once, where it is found out. Screen, report, campaign, JSON, Python
// and page print the same strings.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "inference/judgement.h"
#include "inference/profile.h"
#include "io/quantity.h"

namespace flexslip {

// What a finding does to the answer, the weightiest first.
enum class Severity {
  refusal,    // there is no answer, or none to use
  suspicion,  // the conclusion does not survive it
  doubt,      // it may not matter
  condition,  // the answer is told under it
  note,       // it casts no doubt
  passed,     // what was checked is in order
  unjudged,   // this record does not allow the check
};

std::string_view name_of(Severity severity);

struct FindingNumber {
  std::string_view name;
  double value;  // SI, or reduced if the test is
  Kind kind = kind::number;
};

struct Finding {
  std::string_view code{};  // as the rule has it that finds it
  Severity severity;
  std::string sentence;      // whole sentences, understood when read alone
  std::string short_form{};  // a few words, for a table of many tests or a row of one; may be empty
  std::string remedy{};      // what to do, a whole sentence; empty where there is nothing to do
  std::vector<FindingNumber> numbers{};
  bool is_check = false;  // of a check that was passed, or was not
};

// What one drop can be: "slip", "slip or crack", "crack; a slip would need negative friction", "neither slip nor crack".
std::string reading_of(const Slip& slip);

// What a test comes to in one word.
enum class VerdictCode { slip, slip_and_damage, undecided, crack, settled, no_drops, check_input, no_answer };

std::string_view name_of(VerdictCode code);  // "check_input"
std::string_view word_of(VerdictCode code);  // "CHECK INPUT"

// Is the question about the drops answered? Then fit exits with 0, and a campaign whose tests all are; else with 1.
constexpr bool is_answered(VerdictCode code) {
  return code != VerdictCode::check_input && code != VerdictCode::no_answer;
}

struct Verdict {
  VerdictCode code;
  std::vector<std::string> parts;  // what belongs to it: numbers, or the sentence of the finding that it rests on
  std::string_view finding{};      // the code of that finding, whose remedy is the next step; empty if it rests on none
};

// "SLIP: friction 0.47 ± 0.06; 18 % of the work was friction, not toughness."
std::string sentence_of(const Verdict& verdict);

struct AnswerRow {
  std::string label;  // "drops"
  std::string words;
};

// Does a finding refuse the answer: is there none, or none to use?
bool is_refused(const std::vector<Finding>& findings);

// Is it refused, or does its conclusion not survive a finding? A campaign leaves such a test out of its means.
bool is_suspect(const std::vector<Finding>& findings);

// That of a code; null where it was not found.
const Finding* finding_in(const std::vector<Finding>& findings, std::string_view code);

// All that is told of a test at a glance, in the order in which it is told.
struct Answer {
  Verdict verdict;
  std::vector<AnswerRow> rows;
  std::vector<Finding> findings;  // the weightiest first
  std::string next;               // the one step that would tell most; may be empty
};

// Those against the answer that the verdict does not tell already, and that do not follow from it, the weightiest first: refusals, suspicions and
// doubts.
std::vector<Finding> doubts_of(const Answer& answer);

// "All 7 checks passed.", "The other 7 checks passed." where a doubt is told, "6 of 7 checks passed; remarked: the fit leaves more than noise.", "5 of 7 checks passed, 2 not possible here."
std::string checks_in_words(const Answer& answer);

// "Next: unload and load once more."; empty where there is no step.
std::string next_in_words(const Answer& answer);

}  // namespace flexslip
