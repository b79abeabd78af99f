// Files that are there whole or not at all, whatever happens to the program or the computer while they are written.
#pragma once

#include <filesystem>
#include <string_view>

namespace flexslip {

// A name beside a file for writing it under: of this process alone, also where several computers share the folder.
std::filesystem::path unfinished_name(const std::filesystem::path& file);
bool is_unfinished(const std::filesystem::path& file);

// Gives a file that is written its name, replacing one that is there. When this returns, it outlives a power cut.
// Fails:      InputError.
void finish_file(const std::filesystem::path& unfinished, const std::filesystem::path& file);

// Writes a whole file so.
// Fails:      InputError, with nothing left behind.
void write_durably(const std::filesystem::path& file, std::string_view bytes);

}  // namespace flexslip
