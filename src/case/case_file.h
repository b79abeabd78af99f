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

// Reads a test. Every value is in its range, every key is known, and what belongs together is complete; which
// sections a command needs is its own affair (see missing()), and [sweep] that of its own reader (design/sweep.h).
// Fails:      InputError with file, line and key.
Test read_case(std::string_view text, const std::string& source, const std::vector<std::string>& changes = {});

// The same from a file, "-" is standard input, with changes from the command line.
Test read_case(const std::string& path, const std::vector<std::string>& changes = {});

// The text of a case file; "-" is standard input.
// Fails:      InputError if it cannot be read, or is too long for a case.
std::string case_text(const std::string& path);

// The test as the text of a case file: read_case gives the same test back, to the last bit, in the same working directory.
std::string to_toml(Test test);

// Where a test names its files.
std::vector<std::string*> files_of(Test& test);

// The section of the specimen, as far as it is stated.
std::optional<Section> section_of(const Test& test);

// The key that says how thick a specimen is in the direction of bending.
std::string depth_key(const Section& section);

// As a quantity of a test is shown to people: in a reduced one a plain number, in inches and pounds where the span is in inches.
Kind kind_in(const Test& test, const Kind& kind);
bool is_in_inches(const Test& test);
// [m] "1278 µm".
std::string readable_length(const Test& test, double length);

// A quantity that a flag states.
// Fails:      InputError, naming the flag.
double quantity_of_flag(std::string_view flag, std::string_view text, const Kind& kind, Range range);

// A key of a case, and what to write there: "find" in quotes, or a number.
struct KeyChange {
  std::string_view section, name;
  std::string value;

  std::string in_case() const;  // "[record] sign = "keep""
  std::string flag() const;     // "--sign keep", or "--set rig.roller_radius="5 mm"", which says the same
};

// One in the words of who states the test: in_case, or flag.
std::string in_words(const Test& test, const KeyChange& change);

// Changes in one section, a clause likewise: "write sign = "keep" into [record]", or "pass --sign keep".
std::string instruction_to_set(const Test& test, const std::vector<KeyChange>& changes);
std::string instruction_to_set(const Test& test, const KeyChange& change);

// Keys of one section likewise: "[rig] supports or roller_radius", or "--supports or --set rig.roller_radius=…".
std::string keys_in_words(const Test& test, std::string_view section, const std::vector<std::string>& names);

// The error to throw when a value of a test turns out wrong later. `key` as in Test::lines.
InputError wrong_value(const Test& test, std::string_view key, std::string problem, std::string remedy = "");

// Likewise of a cell of a table that a test names.
InputError wrong_cell(const Table& table, std::size_t row, const Column& column, std::string problem,
                      std::string remedy = "");

// The error to throw when a command needs what a test does not have: a section, "friction", or a key, "rig.stiffness".
// The message shows an example of it.
InputError missing(const Test& test, std::string_view key);
// The same with words that follow "is missing", "beside rollers = "pinned"", and what to do.
InputError missing(const Test& test, std::string_view key, std::string why, std::string remedy);

}  // namespace flexslip
