// Which program wrote an export.
#pragma once

#include <string>

#include "instruments/export.h"

namespace flexslip {

// "Instron Bluehill", ..., by the marks that it bears; "table" if it bears none. Do its units stand in brackets on a line of their own?
std::string program_of(const Export& file, bool has_bracketed_units);

}  // namespace flexslip
