// What columns of an export hold, as far as their titles say, in the languages of the machines: English, German, French, Spanish, Italian,
// Portuguese, Turkish, Japanese.
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
  displacement,  // of the crosshead, or of the specimen's midpoint: the words do not say which
  crosshead,     // the words say that of the crosshead, stage or actuator
  deflection,    // the words say that of the specimen's midpoint
  force,
  other,
};

// How a role is told, and how a user names its column on the command line.
struct RoleWords {
  std::string_view name;                         // "force"
  std::string_view flag, unit_flag, usual_unit;  // "--force", "--force-unit", "N"
  const Kind* kind;                              // nullptr of other
  std::string_view word() const { return flag.substr(2); }
};
const RoleWords& words_for(ColumnRole role);
bool is_displacement(ColumnRole role);

// What the words of a title mean.
ColumnRole role_of(std::string_view name);

// Do the words of a title mean another quantity, a rate, a stress, what a controller was told? It is none of ours, in whatever unit.
bool names_other_quantity(std::string_view name);

// Does a column of words with this name tell the specimen: "SetName", "Specimen", "Probe", "試験片"?
bool names_specimens(std::string_view name);

// A title and the unit in it, "Position (m) Run #1", "Load [N]", "Displacement_mm", "Time sec". In square brackets at
// the end anything is a unit, else what is known as one; behind a space or _ only one of the kind that the words mean.
ColumnTitle title_parts(std::string_view title);

// The titles on a line without a separator of their own, "Ch 1 Displacement Ch 1 Force Time": cut at wider gaps, or behind
// units in brackets, or behind the words that mean something; that of these ways which gives the number of columns.
// Empty if none does.
std::vector<std::string> split_titles(std::string_view line, std::size_t columns);

// Likewise, cut behind units in brackets only, the last of which ends the line; empty if there are none.
std::vector<std::string> titles_by_units(std::string_view line);

// Tables of several specimens beside each other, the same titles again and again on one line: which columns, counted from 0, belong to one specimen.
struct ColumnGroup {
  std::size_t first;                 // of its own columns
  std::vector<std::size_t> columns;  // those that all share, such as a time before the first, and its own
};

// The specimens on a line of titles: at least two with the same titles in the same order, a force among them, columns without a title
// between them at will; before the first, one column may stand that all share. Empty if that is not so.
std::vector<ColumnGroup> side_by_side(std::span<const std::string> titles);

}  // namespace flexslip
