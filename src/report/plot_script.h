// A figure as a script of gnuplot, which reads the tables beside it: people restyle it.
#pragma once

#include <string>
#include <string_view>

#include "report/plot.h"

namespace flexslip {

inline constexpr double png_resolution = 400;  // [1/in]

// Domain:     as layout_of.
std::string script_of(const Plot& plot);

// Text as a word of a script, in quotes.
std::string in_script(std::string_view text);

}  // namespace flexslip
