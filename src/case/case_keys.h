// Every key of a case file, described once: a row says what it holds and which member of a Test that is. The reader, the writer, refusals, flags, --set,
// the columns of a campaign's table, the axes of maps and sweeps, `flexslip keys` and docs/case-file-keys.md are made of the rows.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "case/test.h"
#include "io/quantity.h"
#include "numerics/elementary.h"

namespace flexslip {

enum class Holds {
  quantity,      // of `kind`, within `range`
  share,         // a positive number, or text in percent
  whole_number,  // from `min` on
  yes_no,        // true or false
  estimate,      // a quantity of `kind`, within `range`, or { value, uncertainty }
  word,          // one of `words`
  text,
  title,           // of a column that holds a quantity of `kind`
  file,            // relative to the case file
  name_or_number,  // of a sheet: text, or a whole number from 1
  place,           // in a record: a row, a stage position, or { deflection = … }
  lengths,         // an array of them
  section,
  axes,    // of a sweep: a section whose keys are numbers of the case that vary
  tables,  // an array of tables, whose keys are in a section of their own: "specimen.cracks"
};

// What the keys of a section are members of, and what a key may be there. A number or a text that is not optional is required.
using TestPart =
    std::variant<SpecimenInput*, CrackInput*, RigInput*, FrictionInput*, WaveInput*, StageInput*, RecordInput*>;
using Slot =
    std::variant<std::monostate, double*, std::optional<double>*, std::string*, std::optional<std::string>*,
                 std::uint64_t*, std::optional<std::uint64_t>*, char*, std::optional<char>*, std::optional<Known>*,
                 std::optional<StatedStiffness>*, std::vector<double>*, std::vector<CrackInput>*,
                 std::vector<WaveInput>*, Rollers*, FrictionAt*, std::optional<SupportKind>*,
                 std::optional<FrictionModel>*, Nose*, TraceDirection*, std::optional<SnapRest>*,
                 std::optional<DisplacementOf>*, SignRule*, FailureRule*, ForceZeroRule*, std::optional<ContactRule>*,
                 std::optional<PlaceInRecord>*, std::optional<SheetChoice>*>;
inline bool is_required(const Slot& slot) {
  return std::holds_alternative<double*>(slot) || std::holds_alternative<std::string*>(slot);
}

struct CaseKey {
  std::string_view name;
  Holds holds;
  const Kind* kind;  // none where that has no meaning
  Range range;
  int min;                         // of a whole number
  std::string_view words;          // "find|keep|reverse"; beside a quantity, what may stand in its place
  std::string_view example;        // as it is written in a file: "\"34.8 um\""
  std::string_view reduced;        // likewise, with reduced = true; "": not there
  std::string_view meaning;        // a phrase
  std::string_view more;           // what docs/case-file-keys.md adds (Markdown)
  double max = infinity;           // the greatest value within the range
  std::string_view why_max = "";   // a remedy for one that is greater
  std::string_view gone = "";      // a word of earlier versions; "": none
  std::string_view why_gone = "";  // a remedy for it
  bool has_flag = false;           // flag_of its name says it of a data file without a case
  std::string_view section = "";   // "": a key of the case itself
  Slot (*slot)(const TestPart&) = nullptr;

  // Its member of a part; none of a part that has no such member.
  Slot of(const TestPart& part) const { return slot ? slot(part) : Slot(); }
};

std::span<const CaseKey> case_keys();

// The sections that the keys are in, "specimen", "specimen.cracks", …, in their order.
std::vector<std::string> case_sections();

// The key of a section or of a table in it: "friction.other" has those of "friction", "friction.waves[2]" likewise, "specimen.cracks[1]" those of
// "specimen.cracks", and each of "sweep.axes" is one of its axes. Null if there is none.
const CaseKey* case_key(std::string_view section, std::string_view name);

// The number that a key of a section of a test holds, to be read or set: of an array the last one, of an estimate its value. Null if it holds none.
double* number_of(Test& test, const CaseKey& key);

// "--inner-diameter"
std::string flag_of(std::string_view name);

// The words of "find|keep|reverse", and those of a key.
std::vector<std::string_view> words_of(std::string_view list);
std::vector<std::string_view> words_of(const CaseKey& key);

// "a, b or c"
std::string in_words(const std::vector<std::string>& names, std::string_view before_last = "or");

// What it holds, in words: "a length", "\"find\", \"keep\" or a force".
std::string what_holds(const CaseKey& key);

}  // namespace flexslip
