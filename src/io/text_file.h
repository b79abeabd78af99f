// Text to a file or to standard output.
#pragma once

#include <string>
#include <string_view>

namespace flexslip {

// Writes a file, whole or not at all (OutputFile); "-" is standard output.
// Fails:      InputError if not all could be written.
void write_text(const std::string& path, std::string_view text);

}  // namespace flexslip
