// Text from and to files; "-" is standard output.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace flexslip {

// Writes a file, whole or not at all (OutputFile).
// Fails:      InputError if not all could be written.
void write_text(const std::string& path, std::string_view text);

// The whole of a file; none if it cannot be read.
std::optional<std::string> read_text(const std::string& path);

}  // namespace flexslip
