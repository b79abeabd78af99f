#include "platform/files.h"

#include <array>
#include <cerrno>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace flexslip {
namespace {

std::error_code last_error() { return {errno, std::generic_category()}; }

}  // namespace

std::optional<FileIdentity> identity_of(const std::filesystem::path& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return FileIdentity{status.st_dev, status.st_ino};
}

bool is_writable(const std::filesystem::path& file) { return faccessat(AT_FDCWD, file.c_str(), W_OK, AT_EACCESS) == 0; }

std::error_code write_to_disk(const std::filesystem::path& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return errno == EACCES && std::filesystem::is_directory(path) ? std::error_code() : last_error();
  const bool is_written = fsync(descriptor) == 0 || errno == EINVAL;
  const std::error_code error = is_written ? std::error_code() : last_error();
  close(descriptor);
  return error;
}

void copy_owner(const std::filesystem::path& from, const std::filesystem::path& to) {
  struct stat status {};
  if (stat(from.c_str(), &status) != 0) return;
  if (chown(to.c_str(), status.st_uid, status.st_gid) != 0) errno = 0;  // only a superuser always can
}

std::string name_of_process() {
  std::array<char, 64> computer{};
  gethostname(computer.data(), computer.size() - 1);
  return std::string(computer.data()) + "-" + std::to_string(getpid());
}

}  // namespace flexslip
