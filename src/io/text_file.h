// Text from and to files.
#pragma once

#include <string>
#include <string_view>

namespace flexslip {

// Writes a file, whole or not at all (OutputFile); "-" is standard output.
// Fails:      InputError if not all could be written.
void write_text(const std::string& path, std::string_view text);

// The whole of a file; nothing if it cannot be read.
std::string read_text(const std::string& path);

}  // namespace flexslip
