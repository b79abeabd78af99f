#include "platform/files.h"

#include <array>

#include <windows.h>

namespace flexslip {
namespace {

std::error_code last_error() { return {static_cast<int>(GetLastError()), std::system_category()}; }

// An open file or folder, for what its handle alone says.
class Opened {
 public:
  Opened(const std::filesystem::path& path, DWORD access)
      : handle_(CreateFileW(path.c_str(), access, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr,
                            OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr)) {}
  ~Opened() {
    if (is_open()) CloseHandle(handle_);
  }
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;
  bool is_open() const { return handle_ != INVALID_HANDLE_VALUE; }
  HANDLE get() const { return handle_; }

 private:
  HANDLE handle_;
};

}  // namespace

std::optional<FileIdentity> identity_of(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
  const Opened file(path, 0);
  BY_HANDLE_FILE_INFORMATION about{};
  if (!file.is_open() || !GetFileInformationByHandle(file.get(), &about)) return std::nullopt;
  return FileIdentity{about.dwVolumeSerialNumber,
                      static_cast<std::uint64_t>(about.nFileIndexHigh) << 32U | about.nFileIndexLow};
}

bool is_writable(const std::filesystem::path& file) { return Opened(file, GENERIC_WRITE).is_open(); }

std::error_code write_to_disk(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) return {};  // written with its files
  const Opened file(path, GENERIC_WRITE);
  return file.is_open() && FlushFileBuffers(file.get()) ? std::error_code() : last_error();
}

void copy_owner(const std::filesystem::path&, const std::filesystem::path&) {}  // files inherit their folder's rights

std::string name_of_process() {
  std::array<char, MAX_COMPUTERNAME_LENGTH + 1> computer{};
  DWORD size = static_cast<DWORD>(computer.size());
  GetComputerNameA(computer.data(), &size);
  return std::string(computer.data()) + "-" + std::to_string(GetCurrentProcessId());
}

}  // namespace flexslip
