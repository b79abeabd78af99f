// Text as one word of a shell's command line.
#pragma once

#include <string>
#include <string_view>

namespace flexslip {

// As it is, if no shell would read it otherwise; else in single quotes.
std::string shell_word(std::string_view text);

}  // namespace flexslip
