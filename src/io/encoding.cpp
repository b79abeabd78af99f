#include "io/encoding.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <iconv.h>

#include "io/input_error.h"

namespace flexslip {
namespace {

struct Known {
  Encoding encoding;
  std::string_view name;
  const char* iconv_name;
  std::string_view mark;
};

// CP932 is Shift-JIS as Windows writes it: with a backslash at 5C, and NEC's and IBM's characters.
constexpr std::array known{Known{Encoding::utf8, "utf-8", "UTF-8", "\xEF\xBB\xBF"},
                           Known{Encoding::utf16le, "utf-16le", "UTF-16LE", "\xFF\xFE"},
                           Known{Encoding::utf16be, "utf-16be", "UTF-16BE", "\xFE\xFF"},
                           Known{Encoding::cp1252, "cp1252", "CP1252", ""},
                           Known{Encoding::shift_jis, "shift-jis", "CP932", ""}};

const Known& entry(Encoding encoding) {
  const auto* const found =
      std::find_if(known.begin(), known.end(), [&](const Known& each) { return each.encoding == encoding; });
  if (found == known.end()) throw std::invalid_argument("no such encoding");
  return *found;
}

class Converter {
 public:
  explicit Converter(const char* from) : handle_(iconv_open("UTF-8", from)) {
    // The C library of a page knows CP932 by its older name alone, without NEC's and IBM's characters.
    if (!is_open() && std::string_view(from) == "CP932") handle_ = iconv_open("UTF-8", "SJIS");
    if (!is_open()) throw InputError({.expected = fmt::format("a C library that knows {}", from), .found = "none"});
  }
  Converter(const Converter&) = delete;
  Converter& operator=(const Converter&) = delete;
  ~Converter() { iconv_close(handle_); }

  // The UTF-8, and how many bytes it took: fewer than given where one is not of the encoding. A character cut off by
  // the end of the bytes counts as taken: that is how truncated files end.
  std::pair<std::string, std::size_t> convert(std::string_view bytes) {
    std::string text;
    std::vector<char> buffer(1 << 16);
    std::vector<char> input(bytes.begin(), bytes.end());  // iconv wants them writable
    char* in = input.data();
    std::size_t left = input.size();
    while (left > 0) {
      char* out = buffer.data();
      std::size_t room = buffer.size();
      errno = 0;
      const bool failed = iconv(handle_, &in, &left, &out, &room) == static_cast<std::size_t>(-1);
      const int reason = errno;
      text.append(buffer.data(), out);
      // The file ends inside a character: what stands before it is no whole cell.
      if (failed && reason == EINVAL) return {text + "\uFFFD", bytes.size()};
      if (failed && reason != E2BIG) break;
    }
    return {text, bytes.size() - left};
  }

 private:
  bool is_open() const { return handle_ != iconv_t(-1); }  // NOLINT: POSIX says so
  iconv_t handle_;
};

std::optional<std::string> converted(std::string_view bytes, Encoding encoding) {
  auto [text, taken] = Converter(entry(encoding).iconv_name).convert(bytes);
  if (taken < bytes.size()) return std::nullopt;
  return std::move(text);
}

std::size_t line_at(std::string_view bytes, std::size_t at) {
  return 1 + static_cast<std::size_t>(std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

bool is_ascii(std::string_view bytes) {
  return std::none_of(bytes.begin(), bytes.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
}

// Figures, separators and line ends are half zeros in UTF-16: more than a third of the bytes on one side of each pair.
std::optional<Encoding> utf16_without_mark(std::string_view bytes) {
  std::array<std::size_t, 2> zeros{};
  for (std::size_t i = 0; i < bytes.size(); ++i)
    if (bytes[i] == '\0') ++zeros[i % 2];
  if (zeros[1] > bytes.size() / 3 && zeros[0] <= zeros[1] / 8) return Encoding::utf16le;
  if (zeros[0] > bytes.size() / 3 && zeros[1] <= zeros[0] / 8) return Encoding::utf16be;
  return std::nullopt;
}

// Two-byte characters of Shift-JIS with a first byte from 81 to 9F (kana, signs, common kanji), against those beyond
// and single-byte katakana, which letters with accents in CP1252 would be.
bool looks_japanese(std::string_view bytes) {
  std::size_t common = 0;
  std::size_t rare = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const auto byte = static_cast<unsigned char>(bytes[i]);
    if (byte < 0x80) continue;
    const bool single = byte >= 0xA0 && byte < 0xE0;
    ++(byte < 0xA0 ? common : rare);
    if (!single) ++i;
  }
  return common >= 2 && common > rare;
}

Encoding encoding_of(std::string_view bytes) {
  if (const auto utf16 = utf16_without_mark(bytes)) return *utf16;
  if (is_ascii(bytes)) return Encoding::utf8;
  if (converted(bytes, Encoding::utf8)) return Encoding::utf8;
  if (looks_japanese(bytes) && converted(bytes, Encoding::shift_jis)) return Encoding::shift_jis;
  return Encoding::cp1252;
}

}  // namespace

std::string_view name_of(Encoding encoding) { return entry(encoding).name; }

Encoding encoding_named(std::string_view name) {
  std::string lower(name);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  std::vector<std::string> names;
  for (const Known& each : known) {
    if (each.name == lower) return each.encoding;
    names.emplace_back(each.name);
  }
  throw InputError({.expected = "one of the encodings " + listed(names), .found = in_quotes(name)});
}

DecodedText decode(std::string bytes, std::optional<Encoding> wanted) {
  const auto* const marked = std::find_if(known.begin(), known.end(), [&](const Known& each) {
    return !each.mark.empty() && bytes.starts_with(each.mark) && (!wanted || each.encoding == *wanted);
  });
  const bool has_mark = marked != known.end();
  if (has_mark) bytes.erase(0, marked->mark.size());
  const Encoding encoding = wanted ? *wanted : has_mark ? marked->encoding : encoding_of(bytes);
  DecodedText decoded{"", encoding, has_mark};
  if (encoding == Encoding::utf8 && is_ascii(bytes)) {
    decoded.text = std::move(bytes);
  } else {
    auto [text, taken] = Converter(entry(encoding).iconv_name).convert(bytes);
    if (taken < bytes.size())
      throw InputError({.line = line_at(bytes, taken),
                        .expected = fmt::format("text in {}", name_of(encoding)),
                        .found = fmt::format("the byte {:02x}", static_cast<unsigned char>(bytes[taken])),
                        .remedy = "name its encoding with --encoding, or export the measurement as CSV"});
    decoded.text = std::move(text);
  }
  if (const std::size_t nul = decoded.text.find('\0'); nul != std::string::npos)
    throw InputError({.line = line_at(decoded.text, nul),
                      .expected = "text",
                      .found = "binary data (a NUL character)",
                      .remedy = "export the measurement as CSV"});
  return decoded;
}

}  // namespace flexslip
