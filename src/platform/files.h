// What std::filesystem does not say or do with files.
#pragma once

#include <compare>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>

namespace flexslip {

// A file under any of its names.
struct FileIdentity {
  std::uint64_t volume, number;
  auto operator<=>(const FileIdentity&) const = default;
};

// Empty for a device, pipe or folder, which cannot be overwritten by mistake, and for no file.
std::optional<FileIdentity> identity_of(const std::filesystem::path& path);

// True if this user may write to an existing file.
bool is_writable(const std::filesystem::path& file);

// Makes the system write a file or folder to the disk. Some file systems cannot write a folder; that
// is no error.
std::error_code write_to_disk(const std::filesystem::path& path);

// Gives a file the owner of another file, where this user may do so.
void copy_owner(const std::filesystem::path& from, const std::filesystem::path& to);

// A name of this process, unique on all computers that share a folder: "computer-1234".
std::string name_of_process();

}  // namespace flexslip
