// What workbooks are made of: a zip archive in memory, and XML as it comes, of any size.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace flexslip {

// What a part may hold, unpacked [bytes]: ten times what the largest sheet of a measurement has, and little enough that an archive
// made to fill the memory is refused in seconds.
constexpr std::uint64_t largest_zip_part = 1ULL << 30;

// The parts of an archive by name.
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

// The attributes of an element, by their names without namespace; valid while it begins.
class XmlAttributes {
 public:
  explicit XmlAttributes(const char** pairs) : pairs_(pairs) {}
  std::optional<std::string_view> find(std::string_view name) const;

 private:
  const char** pairs_;  // name, value, ..., nullptr
};

// What is called for each; names are without namespace. They may throw.
struct XmlHandlers {
  std::function<void(std::string_view name, const XmlAttributes&)> begin;
  std::function<void(std::string_view name)> end;
  std::function<void(std::string_view text)> text;  // in pieces
};

// The elements of a document as they come; what holds them is not kept.
class XmlStream {
 public:
  explicit XmlStream(XmlHandlers handlers);
  ~XmlStream();
  XmlStream(const XmlStream&) = delete;
  XmlStream& operator=(const XmlStream&) = delete;

  // The next piece of the document, and its end.
  // Fails:      InputError, without a file: not well-formed; a document type, which could define entities. Whatever a handler
  //             throws.
  void feed(std::string_view piece);
  void finish();

 private:
  struct Parser;
  void parse(std::string_view piece, bool is_last);
  std::unique_ptr<Parser> parser_;
};

}  // namespace flexslip
