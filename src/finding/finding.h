// The answer of a measured test: its verdict, its rows and its findings. Each is data that carries
// its own sentence, which screen, report, campaign, JSON, Python and page print unchanged.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "inference/judgement.h"
#include "inference/profile.h"
#include "io/quantity.h"

namespace flexslip {

// The effect of a finding on the answer, the most serious first.
enum class Severity {
  refusal,    // the test has no usable answer
  suspicion,  // the conclusion may be wrong
  doubt,      // the numbers may be wrong
  condition,  // the answer holds only under this condition
  note,       // information that casts no doubt
  passed,     // a check that passed
  unjudged,   // a check that this record does not allow
};

std::string_view name_of(Severity severity);

struct FindingNumber {
  std::string_view name;
  double value;  // SI, or reduced if the test is
  Kind kind = kind::number;
};

struct Finding {
  std::string_view code{};  // of the rule that made the finding; codes do not change between versions
  Severity severity;
  std::string sentence;      // whole sentences that can be quoted alone
  std::string short_form{};  // a few words for tables and rows; may be empty
  std::string remedy{};      // the action to take, in whole sentences; may be empty
  std::vector<FindingNumber> numbers{};
  bool is_check = false;  // the finding is the result of a check of the fit
};

// The possible causes of one drop: "slip", "slip or crack", "crack; a slip would need negative
// friction", "neither slip nor crack".
std::string reading_of(const Slip& slip);

// The conclusion about a test.
enum class VerdictCode { slip, slip_and_damage, undecided, crack, settled, no_drops, check_input, no_answer };

std::string_view name_of(VerdictCode code);  // "check_input"
std::string_view word_of(VerdictCode code);  // "CHECK INPUT"

// True if the verdict answers the question about the drops. Only then does the command fit exit
// with 0.
constexpr bool is_answered(VerdictCode code) {
  return code != VerdictCode::check_input && code != VerdictCode::no_answer;
}

struct Verdict {
  VerdictCode code;
  std::string meaning;         // one sentence: what the verdict means for this test; true when quoted alone
  std::string evidence{};      // sentences with the number behind it; may be empty
  std::string_view finding{};  // the code of the finding that the verdict rests on; empty if it rests on none
};

// The word, the meaning and the evidence: "SLIP. All 35 force drops can be slips over the supports.
// Probability ...".
std::string sentence_of(const Verdict& verdict);

// One row of an answer: clauses with "; " between them, the most important first.
struct AnswerRow {
  std::string label;
  std::string words;
};

// True if a finding refuses the answer.
bool is_refused(const std::vector<Finding>& findings);

// True if there is a refusal or a suspicion. A campaign excludes such a test from its means.
bool is_suspect(const std::vector<Finding>& findings);

// The finding with the given code; null if there is none.
const Finding* finding_in(const std::vector<Finding>& findings, std::string_view code);

// The answer of a test, in the order in which it is printed.
struct Answer {
  Verdict verdict;
  std::vector<AnswerRow> rows;
  std::vector<AnswerRow> details;  // rows of the full answer that are not on the screen
  std::vector<Finding> findings;   // in the order of the rules, refusals first
  std::string next;                // the recommended next step; may be empty
};

// The rows, then the details.
std::vector<AnswerRow> all_rows(const Answer& answer);

// Refusals, suspicions and doubts that the verdict neither states nor implies, the most serious
// first.
std::vector<Finding> doubts_of(const Answer& answer);

// "All 7 checks passed.", "6 of 7 checks passed, 1 not possible.", "0 of 2 checks passed, as
// expected of a cracked specimen."; empty without checks.
std::string checks_in_words(const Answer& answer);

}  // namespace flexslip
