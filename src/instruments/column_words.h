// What the titles of columns say, in the languages of the machines: English, German, French, Spanish, Italian,
// Portuguese, Turkish, Japanese.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "instruments/column_role.h"

namespace flexslip {

// What the words of a title mean. Rates, stresses, strains, energies and moments are none of ours, whatever of.
ColumnRole role_of(std::string_view name);

// Does a column of words with this name tell the specimen: "SetName", "Specimen", "Probe", "試験片"?
bool names_specimens(std::string_view name);

struct TitleParts {
  std::string name;
  std::string unit;  // empty if the title states none
};

// A title and the unit in it, "Position (m) Run #1", "Load [N]", "Displacement_mm", "Time sec". In square brackets at
// the end anything is a unit, else what is known as one; behind a space or _ only one of the kind that the words mean.
TitleParts title_parts(std::string_view title);

// The titles on a line without a separator of their own, "Ch 1 Displacement Ch 1 Force Time": cut at wider gaps, or behind
// units in brackets, or behind the words that mean something; that of these ways which gives the number of columns.
// Empty if none does.
std::vector<std::string> split_titles(std::string_view line, std::size_t columns);

}  // namespace flexslip
