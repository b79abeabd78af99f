#include "io/durable_file.h"

#include <array>
#include <cerrno>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "io/input_error.h"
#include "io/text_file.h"

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

}  // namespace

fs::path unfinished_name(const fs::path& file) {
  std::array<char, 256> computer{};
  gethostname(computer.data(), computer.size() - 1);
  fs::path name = file;
  name += fmt::format(".{}-{}{}", computer.data(), getpid(), suffix);
  return name;
}

bool is_unfinished(const fs::path& file) { return file.extension() == suffix; }

void finish_file(const fs::path& unfinished, const fs::path& file) {
  sync(unfinished);
  std::error_code error;
  fs::rename(unfinished, file, error);  // at once: a reader sees the old file or the new one
  if (error) refuse(file, error);
  sync(folder_of(file));
}

void write_durably(const fs::path& file, std::string_view bytes) {
  const fs::path unfinished = unfinished_name(file);
  try {
    write_text(unfinished.string(), bytes);
    finish_file(unfinished, file);
  } catch (const InputError&) {
    std::error_code gone;
    fs::remove(unfinished, gone);
    throw;
  }
}

}  // namespace flexslip
