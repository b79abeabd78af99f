// Case files: one TOML file describes a test, for simulating and for fitting (docs/case-files.md).
//
// Numbers are in SI and radians; where the file says `reduced = true`, they are in the model's scaled variables: lengths
// in spans L, forces in EI/L^2, stiffnesses in EI/L^3. A field's unit below is that of the physical case.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case/friction_input.h"
#include "case/record_input.h"
#include "case/rig_input.h"
#include "case/specimen_input.h"
#include "case/stage_input.h"
#include "io/input_error.h"
#include "io/quantity.h"

namespace flexslip {

struct Case {
  std::string source;  // the file as the user named it
  bool reduced;
  std::optional<SpecimenInput> specimen;  // this and the rig are always there in reduced cases
  std::optional<RigInput> rig;
  std::optional<FrictionInput> friction;
  std::optional<StageInput> stage;
  std::optional<RecordInput> record;
  std::map<std::string, std::size_t, std::less<>>
      lines;                           // of every key: "specimen", "specimen.diameter", "stage.program[1]"
  std::vector<std::string> changed{};  // keys that the command line says, "rig.stiffness"
};

// Reads a case. Every value is in its range, every key is known, and what belongs together is complete; which
// sections a command needs is its own affair (see missing()), and [sweep] that of its own reader (sweep_plan.h).
// Fails:      InputError with file, line and key.
Case read_case(std::string_view text, const std::string& source, const std::vector<std::string>& changes = {});

// The same from a file, "-" is standard input, with changes from the command line (case_changes.h).
Case read_case(const std::string& path, const std::vector<std::string>& changes = {});

// The text of a case file; "-" is standard input.
// Fails:      InputError if it cannot be read, or is too long for a case.
std::string case_text(const std::string& path);

// The case as TOML text: read_case gives the same case back, to the last bit, in the same working directory.
std::string to_toml(const Case& input);

// The error to throw when a value of a case turns out wrong later. `key` as in Case::lines.
InputError wrong_value(const Case& input, std::string_view key, std::string expected, std::string found,
                       std::string remedy = "");

// The key that says how thick a specimen is in the direction of bending.
std::string depth_key(const Section& section);

// As a quantity of a case is shown to people: in a reduced case a plain number, in inches and pounds where the span is in inches.
Kind kind_in(const Case& input, const Kind& kind);
bool is_in_inches(const Case& input);
// [m] "1278 µm".
std::string readable_length(const Case& input, double length);

// The error to throw when a command needs what a case does not have: a section, "friction", or a key, "rig.stiffness".
// The message shows an example of it.
InputError missing(const Case& input, std::string_view key);
// The same with words that follow "is missing", "beside rollers = "pinned"", and what to do.
InputError missing(const Case& input, std::string_view key, std::string why, std::string remedy);

}  // namespace flexslip
