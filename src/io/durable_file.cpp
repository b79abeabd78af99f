#include "io/durable_file.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/input_error.h"

namespace flexslip {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view suffix = ".unfinished";

[[noreturn]] void refuse(const std::string& path, const std::error_code& error) {
  throw unwritable(path, error.message());
}

std::error_code last_error() { return {errno, std::generic_category()}; }

// Makes the system write a file or folder to the disk. Errors for a folder are ignored: some file
// systems write it without being asked, others do not allow it.
std::error_code sync(const fs::path& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return last_error();
  const std::error_code error = fsync(descriptor) == 0 ? std::error_code() : last_error();
  close(descriptor);
  return error;
}

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : "."; }

// Writes a file to the disk, then gives it its final name.
void rename_synced(const fs::path& unfinished, const fs::path& file) {
  std::error_code error = sync(unfinished);
  if (error) refuse(file.string(), error);
  fs::rename(unfinished, file, error);  // atomic: a reader sees the old file or the new one
  if (error) refuse(file.string(), error);
  error = sync(folder_of(file));
  if (error && error != std::errc::invalid_argument && error != std::errc::permission_denied)
    refuse(file.string(), error);
}

// An empty file in the folder of another file. Its name is unique, also if several computers share
// the folder. Fails:      an empty path, and errno.
fs::path new_file_beside(const fs::path& file, mode_t mode) {
  constexpr std::size_t longest = 150;  // [bytes] file systems allow 255
  std::array<char, 64> computer{};
  gethostname(computer.data(), computer.size() - 1);
  const std::string begin = file.filename().string().substr(0, longest);
  for (int i = 0;; ++i) {
    fs::path name = folder_of(file) / fmt::format("{}.{}-{}-{}{}", begin, computer.data(), getpid(), i, suffix);
    const int descriptor = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (descriptor < 0 && errno == EEXIST) continue;  // left by a program that was killed
    if (descriptor < 0) return {};
    close(descriptor);
    return name;
  }
}

}  // namespace

bool is_unfinished(const fs::path& file) { return file.extension() == suffix; }

bool is_descriptor(const fs::path& target) { return target.native().starts_with("/proc/"); }

fs::path target_of(fs::path path) {
  constexpr int most_links = 40;  // the limit of Linux
  for (int links = 0; links < most_links; ++links) {
    std::error_code error;
    const fs::path folder = fs::weakly_canonical(folder_of(path), error);
    if (!error) path = folder / path.filename();
    if (is_descriptor(path) || !fs::is_symlink(path, error)) break;
    const fs::path target = fs::read_symlink(path, error);
    if (error) break;
    path = folder_of(path) / target;  // the target alone if it is absolute
  }
  return path;
}

OutputFile::OutputFile(std::string path) : path_(std::move(path)) {
  if (path_ == "-") return;
  file_ = target_of(path_);
  struct stat old {};
  const bool exists = stat(file_.c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode)) refuse(path_, std::make_error_code(std::errc::is_a_directory));
  std::error_code absent;
  if (!exists && fs::is_symlink(file_, absent))
    refuse(path_, std::make_error_code(std::errc::too_many_symbolic_link_levels));
  is_replaced_ = !is_descriptor(file_) && (!exists || S_ISREG(old.st_mode));
  name_ = file_;
  if (is_replaced_) {
    if (exists && faccessat(AT_FDCWD, file_.c_str(), W_OK, AT_EACCESS) != 0) refuse(path_, last_error());
    const mode_t mode = exists ? (old.st_mode & 0777) | S_IRUSR | S_IWUSR : 0666;
    name_ = new_file_beside(file_, mode);
    if (name_.empty()) refuse(path_, last_error());
    if (exists) permissions_ = static_cast<fs::perms>(old.st_mode & 0777);
    if (exists && chown(name_.c_str(), old.st_uid, old.st_gid) != 0) errno = 0;  // only a superuser always can
  }
  errno = 0;
  stream_.open(name_, std::ios::binary);
}

OutputFile::~OutputFile() {
  std::error_code absent;
  if (is_replaced_) fs::remove(name_, absent);
}

std::ostream& OutputFile::stream() {
  if (path_ == "-") return std::cout;
  return stream_;
}

void OutputFile::finish() {
  if (!stream().flush()) refuse(path_ == "-" ? "standard output" : path_, last_error());
  if (path_ == "-") return;
  stream_.close();
  if (!stream_) refuse(path_, last_error());
  if (!is_replaced_) return;
  std::error_code error;
  if (permissions_) fs::permissions(name_, *permissions_, error);
  if (error) refuse(path_, error);
  rename_synced(name_, file_);
  is_replaced_ = false;
}

std::time_t date_of_source(std::time_t otherwise) {
  const char* asked = std::getenv("SOURCE_DATE_EPOCH");
  return asked ? std::strtoll(asked, nullptr, 10) : otherwise;
}

std::tm calendar_date(std::time_t seconds) {
  std::tm date{};
  gmtime_r(&seconds, &date);
  return date;
}

}  // namespace flexslip
