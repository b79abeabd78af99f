#include "io/encoding.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <iconv.h>

#include "io/input_error.h"
#include "io/text.h"

namespace flexslip {
namespace {

struct Known {
  Encoding encoding;
  std::string_view name;
  const char* iconv_name;
  std::string_view mark;
};

// CP932 is Shift-JIS as Windows writes it: with a backslash at 5C, and the characters of NEC and
// IBM.
constexpr std::array known{
    Known{Encoding::utf8, "utf-8", "", "\xEF\xBB\xBF"}, Known{Encoding::utf16le, "utf-16le", "UTF-16LE", "\xFF\xFE"},
    Known{Encoding::utf16be, "utf-16be", "UTF-16BE", "\xFE\xFF"}, Known{Encoding::cp1252, "cp1252", "CP1252", ""},
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
    // In the page, the C library knows CP932 only by its older name and lacks the characters of NEC
    // and IBM.
    if (!is_open() && std::string_view(from) == "CP932") handle_ = iconv_open("UTF-8", "SJIS");
    if (!is_open()) throw InputError({.problem = fmt::format("The C library does not know {}", from)});
  }
  Converter(const Converter&) = delete;
  Converter& operator=(const Converter&) = delete;
  ~Converter() { iconv_close(handle_); }

  // The UTF-8 and the number of bytes consumed, which is smaller if a byte is invalid. A character
  // cut by the end of the bytes counts as consumed, because truncated files end in this way.
  std::pair<std::string, std::size_t> convert(std::string_view bytes) {
    std::string text;
    std::vector<char> buffer(1 << 16);
    std::vector<char> input(bytes.begin(), bytes.end());  // iconv needs writable input
    char* in = input.data();
    std::size_t left = input.size();
    while (left > 0) {
      char* out = buffer.data();
      std::size_t room = buffer.size();
      errno = 0;
      const bool failed = iconv(handle_, &in, &left, &out, &room) == static_cast<std::size_t>(-1);
      const int reason = errno;
      text.append(buffer.data(), out);
      // The file ends inside a character, so the cell before it is incomplete.
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

// The result of reading bytes as UTF-8.
struct AsUtf8 {
  std::size_t characters = 0;  // non-ASCII
  std::size_t strays = 0;      // invalid bytes
  std::size_t first_stray = 0;
  std::size_t cut_off = 0;  // bytes of an incomplete character at the end, as in truncated files
};

bool is_cut_off(std::string_view last) {
  const auto first = static_cast<unsigned char>(last.front());
  const std::size_t wanted = first < 0xc2 || first > 0xf4 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
  return last.size() < wanted && std::all_of(last.begin() + 1, last.end(),
                                             [](char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; });
}

AsUtf8 as_utf8(std::string_view bytes) {
  AsUtf8 found;
  for (std::size_t at = 0; at < bytes.size();) {
    std::uint64_t eight = 0;
    if (at + 8 <= bytes.size()) std::memcpy(&eight, bytes.data() + at, 8);
    if (at + 8 <= bytes.size() && (eight & 0x8080808080808080U) == 0) {
      at += 8;
      continue;
    }
    const std::string_view rest = bytes.substr(at, 4);
    // U+FFFE and U+FFFF are no characters but are well-formed: damaged UTF-16 contains them.
    const bool is_well_formed = rest.starts_with("\xef\xbf\xbe") || rest.starts_with("\xef\xbf\xbf");
    const std::size_t size = is_well_formed ? 3 : first_character(rest).bytes;
    if (size == 0 && is_cut_off(rest)) {
      found.cut_off = rest.size();
      break;
    }
    if (size == 0 && found.strays++ == 0) found.first_stray = at;
    if (size > 1) ++found.characters;
    at += std::max<std::size_t>(size, 1);
  }
  return found;
}

// In UTF-16, every second byte of digits, separators and line ends is zero. UTF-16 is assumed if
// over a third of the bytes on one side of each pair are zero.
std::optional<Encoding> utf16_without_mark(std::string_view bytes) {
  std::array<std::size_t, 2> zeros{};
  for (std::size_t i = 0; i < bytes.size(); ++i)
    if (bytes[i] == '\0') ++zeros[i % 2];
  if (zeros[1] > bytes.size() / 3 && zeros[0] <= zeros[1] / 8) return Encoding::utf16le;
  if (zeros[0] > bytes.size() / 3 && zeros[1] <= zeros[0] / 8) return Encoding::utf16be;
  return std::nullopt;
}

// True if two-byte characters with a first byte from 81 to 9F (kana, signs, common kanji) outnumber
// other two-byte characters and single-byte katakana. Accented letters of CP1252 would be read as
// the latter.
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
  if (bytes.find('\0') != std::string_view::npos)
    if (const auto utf16 = utf16_without_mark(bytes)) return *utf16;
  const AsUtf8 found = as_utf8(bytes);
  if (found.characters >= found.strays) return Encoding::utf8;
  if (looks_japanese(bytes) && converted(bytes, Encoding::shift_jis)) return Encoding::shift_jis;
  return Encoding::cp1252;
}

[[noreturn]] void refuse_binary(std::string_view bytes, std::size_t at, std::string_view what) {
  throw InputError({.line = line_at(bytes, at),
                    .problem = fmt::format("The file holds binary data ({}), not text", what),
                    .remedy = "export the measurement as CSV"});
}

// True if over 1 % of the bytes are control characters that texts do not contain.
bool is_binary(std::string_view bytes) {
  constexpr std::ptrdiff_t share = 100;
  const auto controls = std::count_if(bytes.begin(), bytes.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20 && (c < '\t' || c > '\r') && c != '\x1a' && c != '\x1b';
  });
  return controls * share > std::ssize(bytes);
}

[[noreturn]] void refuse_byte(std::string_view bytes, std::size_t at, Encoding encoding) {
  if (is_binary(bytes)) refuse_binary(bytes, at, "control characters");
  throw InputError(
      {.line = line_at(bytes, at),
       .problem =
           fmt::format("The byte {:02x} is no text in {}", static_cast<unsigned char>(bytes[at]), name_of(encoding)),
       .remedy = "correct that character, name another encoding with --encoding, or export the measurement as CSV"});
}

std::string utf8_of(std::string bytes) {
  const AsUtf8 found = as_utf8(bytes);
  if (found.strays > 0) refuse_byte(bytes, found.first_stray, Encoding::utf8);
  if (found.cut_off > 0) bytes.replace(bytes.size() - found.cut_off, found.cut_off, "\uFFFD");
  return bytes;
}

// Removes NUL characters at line ends, which some programs write after each string.
std::string without_string_ends(std::string text) {
  std::size_t kept = 0, nuls = 0;
  for (const char c : text) {
    if (c == '\n' || c == '\r') kept -= nuls;
    nuls = c == '\0' ? nuls + 1 : 0;
    text[kept++] = c;
  }
  text.resize(kept);
  return text;
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
  throw InputError({.problem = fmt::format("{} is not one of the encodings {}", in_quotes(name), listed(names))});
}

DecodedText decode(std::string bytes, std::optional<Encoding> wanted) {
  const auto* const marked = std::find_if(known.begin(), known.end(), [&](const Known& each) {
    return !each.mark.empty() && bytes.starts_with(each.mark) && (!wanted || each.encoding == *wanted);
  });
  const bool has_mark = marked != known.end();
  if (has_mark) bytes.erase(0, marked->mark.size());
  const Encoding encoding = wanted ? *wanted : has_mark ? marked->encoding : encoding_of(bytes);
  DecodedText decoded{"", encoding, has_mark};
  if (encoding == Encoding::utf8) {
    decoded.text = utf8_of(std::move(bytes));
  } else {
    auto [text, taken] = Converter(entry(encoding).iconv_name).convert(bytes);
    if (taken < bytes.size()) refuse_byte(bytes, taken, encoding);
    decoded.text = std::move(text);
  }
  if (decoded.text.find('\0') != std::string::npos) decoded.text = without_string_ends(std::move(decoded.text));
  if (const std::size_t nul = decoded.text.find('\0'); nul != std::string::npos)
    refuse_binary(decoded.text, nul, "a NUL character");
  return decoded;
}

}  // namespace flexslip
