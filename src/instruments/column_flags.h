// How a user names a column and its unit on the command line.
#pragma once

#include <optional>
#include <string_view>

#include "instruments/column_role.h"
#include "io/quantity.h"

namespace flexslip {

bool is_displacement(ColumnRole role);

// The flag that names the column with a role, and the word for it.
std::string_view flag_of(ColumnRole role);
std::string_view word_for(ColumnRole role);

// The flag that states the unit of a column with a role, and a unit that it often has.
std::string_view unit_flag_of(ColumnRole role);
std::string_view usual_unit(ColumnRole role);

// None of a column with no role.
std::optional<Dimension> dimension_of(ColumnRole role);

}  // namespace flexslip
