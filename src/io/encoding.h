// The encoding of a text file: found from its bytes, and undone.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace flexslip {

enum class Encoding { utf8, utf16le, utf16be, cp1252, shift_jis };

// "utf-8", "utf-16le", "utf-16be", "cp1252", "shift-jis"
std::string_view name_of(Encoding encoding);

// Fails:      InputError, without a place, for a name that is none of these; letters of either case.
Encoding encoding_named(std::string_view name);

struct DecodedText {
  std::string text;  // UTF-8, without a byte order mark
  Encoding encoding;
  bool byte_order_mark;
};

// The text in some bytes.
// Fails:      InputError, without a file, for binary data and for bytes that the wanted encoding does not have.
// Method:     the byte order mark; or else UTF-16 by its zero bytes; UTF-8 where all bytes are, or fewer are none than it explains characters beyond
//             ASCII (the first that is none is refused then); Shift-JIS if the bytes are valid
//             and most of its two-byte characters are of the rows of kana and common kanji, whose first bytes are rare
//             signs in CP1252; or else CP1252. No statistics of letters: these take German CP1252 for ISO-8859-3.
DecodedText decode(std::string bytes, std::optional<Encoding> wanted = {});

}  // namespace flexslip
