// Files that are there whole or not at all, whatever happens to the program or the computer while they are written.
#pragma once

#include <ctime>
#include <filesystem>
#include <fstream>
#include <optional>
#include <ostream>
#include <string>

namespace flexslip {

// Is this the name of a file that was being written?
bool is_unfinished(const std::filesystem::path& file);

// The file that is written where a path leads: spelled in one way, its symbolic links followed, also to where nothing is yet.
std::filesystem::path target_of(std::filesystem::path path);

// Is it, as a target, what a process has open, /dev/stdout or /dev/fd/3: a name for it, and no place in a folder?
bool is_descriptor(const std::filesystem::path& target);

// A file of results. It is written under another name beside its place, and only once it is whole replaces the file that is
// there, whose permissions it takes: what cannot be written, on a full disk, leaves the old file. Standard output, devices and
// pipes are written as they are.
class OutputFile {
 public:
  // "-" is standard output.
  // Fails:      InputError if the file, or the folder it lies in, cannot be written to.
  explicit OutputFile(std::string path);
  ~OutputFile();  // removes it unless it is finished
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  std::ostream& stream();

  // What is being written, for a library that writes by name; empty for standard output.
  const std::filesystem::path& name() const { return name_; }

  // Gives it its name, replacing a file that is there. When this returns, it outlives a power cut.
  // Fails:      InputError if not all could be written, with nothing left behind.
  void finish();

 private:
  std::string path_;
  std::filesystem::path file_{}, name_{};
  std::optional<std::filesystem::perms> permissions_{};  // of the file that is there
  std::ofstream stream_{};
  bool is_replaced_ = false;  // yet to be
};

// The date that files bear, [s] SOURCE_DATE_EPOCH where it is set, so that they can be made again to the byte; and a date of Greenwich.
std::time_t date_of_source(std::time_t otherwise);
std::tm calendar_date(std::time_t seconds);

}  // namespace flexslip
