#include "io/durable_file.h"

#include <array>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/input_error.h"

namespace flexslip {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view suffix = ".unfinished";

[[noreturn]] void refuse(const fs::path& path, const std::error_code& error) {
  throw InputError({.file = path.string(), .expected = "a file that can be written", .found = error.message()});
}

// Has the system write to the disk what it holds of a file or folder.
void sync(const fs::path& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool is_synced = descriptor >= 0 && fsync(descriptor) == 0;
  const std::error_code error(errno, std::generic_category());
  if (descriptor >= 0) close(descriptor);
  if (!is_synced && error != std::errc::invalid_argument) refuse(path, error);  // no folders on some file systems
}

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : "."; }

// Has the system write a new file to the disk. What a write or a close could not do, a later sync need not tell.
void write_synced(const fs::path& path, std::string_view bytes) {
  const int descriptor = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) refuse(path, {errno, std::generic_category()});
  bool is_written = true;
  while (is_written && !bytes.empty()) {
    const ssize_t count = write(descriptor, bytes.data(), bytes.size());
    is_written = count >= 0 || errno == EINTR;
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  is_written = is_written && fsync(descriptor) == 0;
  const int reason = errno;
  const bool is_closed = close(descriptor) == 0;
  if (!is_written || !is_closed) refuse(path, {is_written ? errno : reason, std::generic_category()});
}

// Gives a file that is on the disk its name.
void rename_synced(const fs::path& unfinished, const fs::path& file) {
  std::error_code error;
  fs::rename(unfinished, file, error);  // at once: a reader sees the old file or the new one
  if (error) refuse(file, error);
  sync(folder_of(file));
}

// Of this process alone, also where several computers share the folder.
fs::path own_name(const fs::path& file) {
  std::array<char, 256> computer{};
  gethostname(computer.data(), computer.size() - 1);
  fs::path name = file;
  name += fmt::format(".{}-{}{}", computer.data(), getpid(), suffix);
  return name;
}

bool is_open_as(int descriptor, const fs::path& name) {
  struct stat opened {};
  struct stat named {};
  return fstat(descriptor, &opened) == 0 && stat(name.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
         opened.st_ino == named.st_ino;
}

}  // namespace

bool is_unfinished(const fs::path& file) { return file.extension() == suffix; }

void write_durably(const fs::path& file, std::string_view bytes) {
  const fs::path unfinished = own_name(file);
  try {
    write_synced(unfinished, bytes);
    rename_synced(unfinished, file);
  } catch (...) {
    std::error_code gone;
    fs::remove(unfinished, gone);
    throw;
  }
}

UnfinishedFile::UnfinishedFile(fs::path file) : file_(std::move(file)), name_(file_) {
  name_ += suffix;
  while (!is_open_as(lock_, name_)) {  // again if it was finished or removed before it was locked
    if (lock_ >= 0) close(lock_);
    lock_ = open(name_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (lock_ < 0) refuse(name_, {errno, std::generic_category()});
    if (flock(lock_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) continue;  // or a file system without locks
    close(lock_);
    throw InputError({.file = file_.string(),
                      .expected = "one program that writes it",
                      .found = "another one that does",
                      .remedy = "wait for it, or pass another --output"});
  }
}

UnfinishedFile::~UnfinishedFile() {
  std::error_code absent;
  if (!is_finished_) fs::remove(name_, absent);
  close(lock_);
}

void UnfinishedFile::finish() {
  sync(name_);
  rename_synced(name_, file_);
  is_finished_ = true;
}

}  // namespace flexslip
