// Reading files and writing text. "-" is standard input or standard output.
#pragma once

#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace flexslip {

// Opens a file for reading.
// Fails:      OutputClash if the call writes it; InputError if it is missing, a directory or cannot be opened.
std::shared_ptr<std::istream> open_to_read(const std::string& path);

// The content of a file.
// Fails:      as open_to_read; InputError for more than 2 GiB, for a first MiB of NUL characters (as in /dev/zero), and
//             for an error while reading.
std::string bytes_of(const std::string& path);

// The content of a file of the program itself; empty if the file cannot be read.
std::optional<std::string> read_text(const std::string& path);

// Writes a file completely or not at all (OutputFile).
// Fails:      InputError if the file could not be written completely.
void write_text(const std::string& path, std::string_view text);

}  // namespace flexslip
