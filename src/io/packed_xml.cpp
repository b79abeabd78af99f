// The one file that unpacks, by minizip and zlib, and that takes XML apart, by expat.
#include "io/packed_xml.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <exception>
#include <new>
#include <utility>

#include <expat.h>
#include <fmt/format.h>
#include <minizip/unzip.h>

#include "io/input_error.h"

namespace flexslip {
namespace {

constexpr std::size_t piece_size = 1 << 16;  // [bytes] unpacked at a time

// The bytes as a file that minizip reads.
struct Bytes {
  std::string_view all;
  std::uint64_t at = 0;
};

Bytes& bytes_of(void* stream) { return *static_cast<Bytes*>(stream); }

void* open_bytes(void* bytes, const void* /*name*/, int /*mode*/) { return bytes; }

uLong read_bytes(void* /*opaque*/, void* stream, void* to, uLong size) {
  Bytes& bytes = bytes_of(stream);
  const std::string_view rest = bytes.all.substr(std::min<std::uint64_t>(bytes.at, bytes.all.size()), size);
  if (!rest.empty()) std::memcpy(to, rest.data(), rest.size());
  bytes.at += rest.size();
  return static_cast<uLong>(rest.size());
}

uLong write_nothing(void* /*opaque*/, void* /*stream*/, const void* /*from*/, uLong /*size*/) { return 0; }

ZPOS64_T place_in(void* /*opaque*/, void* stream) { return bytes_of(stream).at; }

long seek_in(void* /*opaque*/, void* stream, ZPOS64_T offset, int origin) {
  Bytes& bytes = bytes_of(stream);
  const std::uint64_t from = origin == ZLIB_FILEFUNC_SEEK_CUR   ? bytes.at
                             : origin == ZLIB_FILEFUNC_SEEK_END ? bytes.all.size()
                                                                : 0;
  if (offset > bytes.all.size() || from + offset > bytes.all.size()) return -1;
  bytes.at = from + offset;
  return 0;
}

int nothing_to_close(void* /*opaque*/, void* /*stream*/) { return 0; }
int no_error(void* /*opaque*/, void* /*stream*/) { return 0; }

[[noreturn]] void refuse_damaged(const std::string& found) {
  throw InputError({.expected = "a whole workbook",
                    .found = found,
                    .remedy = "copy or download the file again, or save it anew in the spreadsheet program"});
}

[[noreturn]] void refuse_large(const std::string& part) {
  throw InputError({.expected = fmt::format("parts of at most {} MiB, unpacked", largest_zip_part >> 20),
                    .found = fmt::format("more in {}", in_quotes(part)),
                    .remedy = "save the sheet with the measurement as CSV"});
}

constexpr char between = '|';  // a namespace and a name

std::string_view local(std::string_view name) { return name.substr(name.rfind(between) + 1); }

}  // namespace

struct ZipArchive::Opened {
  Bytes bytes;
  unzFile archive = nullptr;
};

ZipArchive::ZipArchive(std::string_view bytes) : opened_(std::make_unique<Opened>()) {
  opened_->bytes.all = bytes;
  zlib_filefunc64_def functions{open_bytes, read_bytes,       write_nothing, place_in,
                                seek_in,    nothing_to_close, no_error,      &opened_->bytes};
  opened_->archive = unzOpen2_64("", &functions);
  if (opened_->archive == nullptr) refuse_damaged("an archive without its table of contents, as of a file cut off");
}

ZipArchive::~ZipArchive() {
  if (opened_->archive != nullptr) unzClose(opened_->archive);
}

bool ZipArchive::has(const std::string& part) const {
  return unzLocateFile(opened_->archive, part.c_str(), 1) == UNZ_OK;
}

void ZipArchive::read(const std::string& part, const std::function<void(std::string_view)>& take) const {
  const unzFile archive = opened_->archive;
  unz_file_info64 info{};
  if (!has(part)) refuse_damaged("none with the part " + in_quotes(part));
  if (unzGetCurrentFileInfo64(archive, &info, nullptr, 0, nullptr, 0, nullptr, 0) != UNZ_OK)
    refuse_damaged("damage in its table of contents");
  if ((info.flag & 1U) != 0)
    throw InputError({.expected = "a workbook without a password",
                      .found = "an encrypted archive",
                      .remedy = "save it without a password, or the sheet as CSV"});
  if (info.uncompressed_size > largest_zip_part) refuse_large(part);
  if (unzOpenCurrentFile(archive) != UNZ_OK) refuse_damaged("damage at the part " + in_quotes(part));

  // Whatever take throws, the part is closed.
  const std::unique_ptr<void, void (*)(void*)> to_close(archive, [](void* open) { unzCloseCurrentFile(open); });
  std::array<char, piece_size> buffer{};
  std::uint64_t unpacked = 0;
  int got = 0;
  while ((got = unzReadCurrentFile(archive, buffer.data(), static_cast<unsigned>(buffer.size()))) > 0) {
    unpacked += static_cast<std::uint64_t>(got);
    if (unpacked > largest_zip_part) refuse_large(part);
    take({buffer.data(), static_cast<std::size_t>(got)});
  }
  if (got < 0 || unpacked != info.uncompressed_size) refuse_damaged("damage in the part " + in_quotes(part));
  if (unzCloseCurrentFile(archive) == UNZ_CRCERROR)
    refuse_damaged("another checksum than it should have in the part " + in_quotes(part));
}

std::optional<std::string_view> XmlAttributes::find(std::string_view name) const {
  for (const char** pair = pairs_; *pair != nullptr; pair += 2)
    if (local(pair[0]) == name) return pair[1];
  return std::nullopt;
}

struct XmlStream::Parser {
  XmlHandlers handlers;
  XML_Parser parser = XML_ParserCreateNS(nullptr, between);
  std::exception_ptr thrown{};  // by a handler, or here: not through the C of the parser

  template <class Call>
  static void guarded(void* user, const Call& call) {
    Parser& self = *static_cast<Parser*>(user);
    if (self.thrown) return;
    try {
      call(self);
    } catch (...) {
      self.thrown = std::current_exception();
      XML_StopParser(self.parser, XML_FALSE);
    }
  }
};

XmlStream::XmlStream(XmlHandlers handlers) : parser_(std::make_unique<Parser>()) {
  parser_->handlers = std::move(handlers);
  XML_ParserStruct* const parser = parser_->parser;
  if (parser == nullptr) throw std::bad_alloc();
  XML_SetUserData(parser, parser_.get());
  XML_SetElementHandler(
      parser,
      [](void* user, const char* name, const char** attributes) {
        Parser::guarded(user, [&](Parser& self) { self.handlers.begin(local(name), XmlAttributes(attributes)); });
      },
      [](void* user, const char* name) {
        Parser::guarded(user, [&](Parser& self) { self.handlers.end(local(name)); });
      });
  XML_SetCharacterDataHandler(parser, [](void* user, const char* text, int length) {
    Parser::guarded(user, [&](Parser& self) { self.handlers.text({text, static_cast<std::size_t>(length)}); });
  });
  XML_SetStartDoctypeDeclHandler(parser, [](void* user, const char*, const char*, const char*, int) {
    Parser::guarded(user, [](Parser&) {
      throw InputError({.expected = "a workbook as spreadsheet programs write it",
                        .found = "a document type in its XML",
                        .remedy = "save it anew in the spreadsheet program"});
    });
  });
}

XmlStream::~XmlStream() { XML_ParserFree(parser_->parser); }

void XmlStream::feed(std::string_view piece) { parse(piece, false); }

void XmlStream::finish() { parse({}, true); }

void XmlStream::parse(std::string_view piece, bool is_last) {
  const XML_Status status =
      XML_Parse(parser_->parser, piece.data(), static_cast<int>(piece.size()), is_last ? XML_TRUE : XML_FALSE);
  if (parser_->thrown) std::rethrow_exception(parser_->thrown);
  if (status == XML_STATUS_OK) return;
  throw InputError({.expected = "a whole workbook",
                    .found = fmt::format("broken XML in it ({})", XML_ErrorString(XML_GetErrorCode(parser_->parser))),
                    .remedy = "save it anew in the spreadsheet program"});
}

}  // namespace flexslip
