// The meaning of column titles in the languages of the machines: English, German, French, Spanish,
// Italian, Portuguese, Turkish, Japanese.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/quantity.h"
#include "io/table.h"

namespace flexslip {

enum class ColumnRole {
  time,
  displacement,  // at the crosshead or at the specimen's midpoint; the title does not say which
  crosshead,     // at the crosshead, stage or actuator
  deflection,    // at the specimen's midpoint
  force,
  other,
};

// The words for a role, and the flags that name its column on the command line.
struct RoleWords {
  std::string_view name;                         // "force"
  std::string_view flag, unit_flag, usual_unit;  // "--force", "--force-unit", "N"
  const Kind* kind;                              // nullptr of other
  std::string_view word() const { return flag.substr(2); }
};
const RoleWords& words_for(ColumnRole role);
bool is_displacement(ColumnRole role);

// The role that a title means.
ColumnRole role_of(std::string_view name);

// True if a title means another quantity: a rate, a stress, a command value. Such a column has no
// role, with any unit.
bool names_other_quantity(std::string_view name);

// True for the title of a column with names of specimens: "SetName", "Specimen", "Probe", "試験片".
bool names_specimens(std::string_view name);

// Splits a title and its unit: "Position (m) Run #1", "Load [N]", "Displacement_mm", "Time sec".
// Any text in square brackets at the end is a unit. In other brackets it must be a known unit;
// after a space or _ its kind must match the title.
ColumnTitle title_parts(std::string_view title);

// The titles on a line without separators, "Ch 1 Displacement Ch 1 Force Time". The line is cut at
// wide gaps, after units in brackets, or after words with a meaning. The result is the first with
// the given number of columns, otherwise empty.
std::vector<std::string> split_titles(std::string_view line, std::size_t columns);

// The titles on a line, cut after units in brackets. The last unit must end the line. Empty without
// units.
std::vector<std::string> titles_by_units(std::string_view line);

// The columns of one specimen in a table with several specimens side by side. Columns count from 0.
struct ColumnGroup {
  std::size_t first;                 // of its own columns
  std::vector<std::size_t> columns;  // shared columns, such as a time before the first specimen, and its own
};

// The specimens on a line of titles: at least two with the same titles in the same order, including
// a force. Columns without a title may lie in between, one shared column before the first, and other
// columns after a gap behind the last. Otherwise empty.
std::vector<ColumnGroup> side_by_side(std::span<const std::string> titles);

}  // namespace flexslip
