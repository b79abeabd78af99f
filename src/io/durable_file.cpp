#include "io/durable_file.h"

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "io/input_error.h"
#include "platform/files.h"

namespace flexslip {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view suffix = ".unfinished";

[[noreturn]] void refuse(const std::string& path, const std::error_code& error) {
  throw unwritable(path, error.message());
}

std::error_code last_error() { return {errno, std::generic_category()}; }

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : "."; }

// Writes a file to the disk, then gives it its final name.
void rename_synced(const fs::path& unfinished, const fs::path& file) {
  std::error_code error = write_to_disk(unfinished);
  if (error) refuse(file.string(), error);
  fs::rename(unfinished, file, error);  // atomic: a reader sees the old file or the new one
  if (error) refuse(file.string(), error);
  if ((error = write_to_disk(folder_of(file)))) refuse(file.string(), error);
}

// An empty file in the folder of another file. Its name is unique, also if several computers share
// the folder.
// Fails:      an empty path, and errno.
fs::path new_file_beside(const fs::path& file) {
  constexpr std::size_t longest = 150;  // [bytes] file systems allow 255
  const std::string begin = file.filename().string().substr(0, longest), process = name_of_process();
  for (int i = 0;; ++i) {
    fs::path name = folder_of(file) / fmt::format("{}.{}-{}{}", begin, process, i, suffix);
    errno = 0;
    if (std::FILE* made = std::fopen(name.string().c_str(), "wx")) {
      std::fclose(made);
      return name;
    }
    if (errno != EEXIST) return {};  // otherwise left by a program that was killed
  }
}

}  // namespace

bool is_unfinished(const fs::path& file) { return file.extension() == suffix; }

bool is_descriptor(const fs::path& target) { return target.string().starts_with("/proc/"); }

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
  std::error_code absent;
  const fs::file_status old = fs::status(file_, absent);
  if (fs::is_directory(old)) refuse(path_, std::make_error_code(std::errc::is_a_directory));
  if (!fs::exists(old) && fs::is_symlink(file_, absent))
    refuse(path_, std::make_error_code(std::errc::too_many_symbolic_link_levels));
  is_replaced_ = !is_descriptor(file_) && (!fs::exists(old) || fs::is_regular_file(old));
  name_ = file_;
  if (is_replaced_) {
    if (fs::exists(old) && !is_writable(file_)) refuse(path_, std::make_error_code(std::errc::permission_denied));
    name_ = new_file_beside(file_);
    if (name_.empty()) refuse(path_, last_error());
    if (fs::exists(old)) {
      permissions_ = old.permissions() & fs::perms::all;
      fs::permissions(name_, *permissions_ | fs::perms::owner_read | fs::perms::owner_write, absent);
      copy_owner(file_, name_);
    }
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
  using namespace std::chrono;
  const sys_seconds time{std::chrono::seconds(seconds)};
  const auto day = floor<days>(time);
  const year_month_day date(day);
  const hh_mm_ss clock(time - day);
  std::tm parts{};
  parts.tm_year = static_cast<int>(date.year()) - 1900;
  parts.tm_mon = static_cast<int>(static_cast<unsigned>(date.month())) - 1;
  parts.tm_mday = static_cast<int>(static_cast<unsigned>(date.day()));
  parts.tm_wday = static_cast<int>(weekday(day).c_encoding());
  parts.tm_hour = static_cast<int>(clock.hours().count());
  parts.tm_min = static_cast<int>(clock.minutes().count());
  parts.tm_sec = static_cast<int>(clock.seconds().count());
  return parts;
}

}  // namespace flexslip
