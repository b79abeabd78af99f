// Files read and text written; "-" is standard input, or output.
#pragma once

#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace flexslip {

// A file to read from.
// Fails:      OutputClash if the call writes it; InputError if it is missing, a directory or cannot be opened.
std::shared_ptr<std::istream> open_to_read(const std::string& path);

// All that a file holds.
// Fails:      as open_to_read; InputError for more than 2 GiB, before it is read if the file says its size; for a MiB of NUL characters, as
//             /dev/zero has without end; for an error while reading.
std::string bytes_of(const std::string& path);

// The whole of a file of the program's own; none if it cannot be read.
std::optional<std::string> read_text(const std::string& path);

// Writes a file, whole or not at all (OutputFile).
// Fails:      InputError if not all could be written.
void write_text(const std::string& path, std::string_view text);

}  // namespace flexslip
