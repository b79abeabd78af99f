// A zip archive in memory, as workbooks are: its parts by name.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace flexslip {

// What a part may hold, unpacked [bytes]: ten times what the largest sheet of a measurement has, and little enough that an archive
// made to fill the memory is refused in seconds.
constexpr std::uint64_t largest_zip_part = 1ULL << 30;

class ZipArchive {
 public:
  // The bytes must outlive the archive.
  // Fails:      InputError, without a file: no archive, or one that is cut off.
  explicit ZipArchive(std::string_view bytes);
  ~ZipArchive();
  ZipArchive(const ZipArchive&) = delete;
  ZipArchive& operator=(const ZipArchive&) = delete;

  bool has(const std::string& part) const;

  // Hands over what a part holds, piece by piece.
  // Fails:      InputError, without a file: there is no such part; it is encrypted, damaged (its checksum is another), or
  //             larger than largest_zip_part, of which nothing more is unpacked.
  void read(const std::string& part, const std::function<void(std::string_view)>& take) const;

 private:
  struct Opened;
  std::unique_ptr<Opened> opened_;
};

}  // namespace flexslip
