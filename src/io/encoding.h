// Detection of the encoding of a text file from its bytes, and conversion to UTF-8.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace flexslip {

enum class Encoding { utf8, utf16le, utf16be, cp1252, shift_jis };

// "utf-8", "utf-16le", "utf-16be", "cp1252", "shift-jis"
std::string_view name_of(Encoding encoding);

// The encoding with a name; case is ignored.
// Fails:      InputError, without a place, for another name.
Encoding encoding_named(std::string_view name);

struct DecodedText {
  std::string text;  // UTF-8, without a byte order mark
  Encoding encoding;
  bool byte_order_mark;
};

// Converts bytes to text.
// Fails:      InputError, without a file, for binary data and for bytes that are invalid in the requested encoding.
// Method:     the byte order mark decides. Without one, zero bytes mean UTF-16. UTF-8 is taken if
//             all bytes are valid. It is also taken if its non-ASCII characters outnumber the
//             invalid bytes; the first invalid byte is then refused. Shift-JIS is taken if the
//             bytes are valid and most two-byte characters are kana or common kanji, whose first
//             bytes are rare in CP1252. Everything else is CP1252. Letter statistics would take
//             German CP1252 for ISO-8859-3.
DecodedText decode(std::string bytes, std::optional<Encoding> wanted = {});

}  // namespace flexslip
