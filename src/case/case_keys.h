// Every key of a case file, described once: its type and its member of Test. The reader, the
// writer, error messages, flags, --set, campaign tables, axes of maps and sweeps, `flexslip keys`
// and docs/case-file-keys.md use these rows.
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
  title,           // title of a column with a quantity of `kind`
  file,            // relative to the case file
  name_or_number,  // of a sheet: text, or a whole number from 1
  place,           // in a record: a row, a stage position, or { deflection = … }
  lengths,         // an array of lengths
  section,
  axes,    // of a sweep: a section whose keys are the varied keys of the case
  tables,  // an array of tables with keys in their own section, "specimen.cracks"
};

// The structs that keys are members of, and the types of keys. A number or text that is not
// optional is required.
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
  const Kind* kind;  // nullptr if a kind has no meaning
  Range range;
  int min;                         // of a whole number
  std::string_view words;          // "find|keep|reverse"; for a quantity, words allowed instead of it
  std::string_view example;        // as in a file: "\"34.8 um\""
  std::string_view reduced;        // with reduced = true; "": the key does not exist then
  std::string_view meaning;        // a phrase
  std::string_view more;           // addition in docs/case-file-keys.md (Markdown)
  double max = infinity;           // maximum within the range
  std::string_view why_max = "";   // remedy above the maximum
  std::string_view gone = "";      // a word of earlier versions, no longer valid; "": no such word
  std::string_view why_gone = "";  // its remedy
  bool has_flag = false;           // has a flag for data files without a case (flag_of)
  std::string_view section = "";   // "": a key outside sections
  Slot (*slot)(const TestPart&) = nullptr;

  // The member of a part; nullptr if the part has no such member.
  Slot of(const TestPart& part) const { return slot ? slot(part) : Slot(); }
};

std::span<const CaseKey> case_keys();

// All sections with keys in order: "specimen", "specimen.cracks", …
std::vector<std::string> case_sections();

// The key with a name in a section, or in a table of a section. "friction.other" has the keys of
// "friction", "specimen.cracks[1]" the keys of "specimen.cracks", and every name in "sweep.axes" is
// an axis. nullptr for other names.
const CaseKey* case_key(std::string_view section, std::string_view name);

// The number of a key of a test, for reading and writing: of an array the last, of an estimate its
// value. nullptr if the key has no number.
double* number_of(Test& test, const CaseKey& key);

// "--inner-diameter"
std::string flag_of(std::string_view name);

// The words of "find|keep|reverse", and the words of a key.
std::vector<std::string_view> words_of(std::string_view list);
std::vector<std::string_view> words_of(const CaseKey& key);

// "a, b or c"
std::string in_words(const std::vector<std::string>& names, std::string_view before_last = "or");

// The type of a key in words: "a length", "\"find\", \"keep\" or a force".
std::string what_holds(const CaseKey& key);

}  // namespace flexslip
