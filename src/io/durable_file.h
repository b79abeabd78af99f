// Output files that are complete or absent, even if the program or the computer fails while writing.
#pragma once

#include <ctime>
#include <filesystem>
#include <fstream>
#include <optional>
#include <ostream>
#include <string>

namespace flexslip {

// True for the name of an unfinished file.
bool is_unfinished(const std::filesystem::path& file);

// The canonical path of a file: symbolic links are resolved. The file need not exist.
std::filesystem::path target_of(std::filesystem::path path);

// True for an open descriptor of a process, such as /dev/stdout or /dev/fd/3, which lies in no
// folder.
bool is_descriptor(const std::filesystem::path& target);

// A file of results. It is written under a temporary name in the same folder and replaces an existing file when it is
// complete, with the permissions of the existing file. If writing fails, as on a full disk, the old file remains.
// Standard output, devices and pipes are written directly.
class OutputFile {
 public:
  // "-" is standard output.
  // Fails:      InputError if the file, or the folder it lies in, cannot be written to.
  explicit OutputFile(std::string path);
  ~OutputFile();  // removes an unfinished file
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  std::ostream& stream();

  // The temporary name, for a library that writes by name; empty for standard output.
  const std::filesystem::path& name() const { return name_; }

  // Gives the file its final name, replacing an existing file. Afterwards the file survives a power failure.
  // Fails:      InputError if the file could not be written completely; nothing remains of it.
  void finish();

 private:
  std::string path_;
  std::filesystem::path file_{}, name_{};
  std::optional<std::filesystem::perms> permissions_{};  // of the existing file
  std::ofstream stream_{};
  bool is_replaced_ = false;  // true while the rename is outstanding
};

// [s] The date that files carry: SOURCE_DATE_EPOCH if it is set, so that output is reproducible.
// calendar_date is in UTC.
std::time_t date_of_source(std::time_t otherwise);
std::tm calendar_date(std::time_t seconds);

}  // namespace flexslip
