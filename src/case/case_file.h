// Case files: one TOML file describes a test, for simulating and for fitting (docs/case-files.md).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case/test.h"
#include "io/input_error.h"
#include "io/quantity.h"
#include "io/table.h"

namespace flexslip {

// Reads a test. Every value is in range, every key is known, and dependent keys are complete. Each
// command checks the sections that it needs (see missing()); design/sweep.h reads [sweep].
// Fails:      InputError with file, line and key.
Test read_case(std::string_view text, const std::string& source, const std::vector<std::string>& changes = {});

// Reads a file with changes from the command line; "-" is standard input.
Test read_case(const std::string& path, const std::vector<std::string>& changes = {});

// The text of a case file; "-" is standard input.
// Fails:      InputError if it cannot be read or is too long.
std::string case_text(const std::string& path);

// The test as the text of a case file. In the same working directory, read_case returns the same
// test, bit for bit.
std::string to_toml(Test test);

// The folder to which the paths of a test are relative.
std::vector<std::string*> files_of(Test& test);

// The section of the specimen; empty if it is not stated.
std::optional<Section> section_of(const Test& test);

// The key of the dimension in the direction of bending.
std::string depth_key(const Section& section);

// The kind in which a quantity of a test is displayed: a plain number in reduced tests, inches and
// pounds if the span is in inches.
Kind kind_in(const Test& test, const Kind& kind);
bool is_in_inches(const Test& test);
// [m] "1278 µm".
std::string readable_length(const Test& test, double length);

// A quantity from a flag.
// Fails:      InputError, naming the flag.
double quantity_of_flag(std::string_view flag, std::string_view text, const Kind& kind, Range range);

// A key of a case and its new value, as text in quotes or as a number.
struct KeyChange {
  std::string_view section, name;
  std::string value;

  std::string in_case() const;  // "[record] sign = "keep""
  std::string flag() const;     // "--sign keep", or the equivalent "--set rig.roller_radius="5 mm""
};

// The change in the form that the user of this test writes: in_case or flag.
std::string in_words(const Test& test, const KeyChange& change);

// An instruction with changes in one section: "write sign = "keep" into [record]", or "pass --sign
// keep".
std::string instruction_to_set(const Test& test, const std::vector<KeyChange>& changes);
std::string instruction_to_set(const Test& test, const KeyChange& change);

// Keys of one section in words: "[rig] supports or roller_radius", or "--supports or --set
// rig.roller_radius=…".
std::string keys_in_words(const Test& test, std::string_view section, const std::vector<std::string>& names);

// The error for a value of a test that turns out wrong later. `key` as in Test::lines.
InputError wrong_value(const Test& test, std::string_view key, std::string problem, std::string remedy = "");

// The error for a cell of a table that a test names.
InputError wrong_cell(const Table& table, std::size_t row, const Column& column, std::string problem,
                      std::string remedy = "");

// The error for a missing input: a section, "friction", or a key, "rig.stiffness". The remedy shows
// an example.
InputError missing(const Test& test, std::string_view key);
// The same error with a reason after "is missing", such as "for rollers = "pinned"", and a remedy.
InputError missing(const Test& test, std::string_view key, std::string why, std::string remedy);

}  // namespace flexslip
