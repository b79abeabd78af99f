#include "io/encoding.h"

#include <random>
#include <string>

#include <doctest/doctest.h>

#include "io/input_error.h"
#include "tests/has.h"
#include "tests/refusal.h"

using namespace flexslip;

TEST_CASE("encoding: byte order marks, and UTF-16 without one, against bytes written by hand") {
  CHECK(decode("\xEF\xBB\xBFµm").text == "µm");
  CHECK(decode("\xEF\xBB\xBFµm").byte_order_mark);
  const std::string le("\xFF\xFE\xB5\0m\0", 6);
  CHECK(decode(le).text == "µm");
  CHECK(decode(le).encoding == Encoding::utf16le);
  const std::string be("\xFE\xFF\0\xB5\0m", 6);
  CHECK(decode(be).text == "µm");
  CHECK(decode(std::string("1\0,\0002\0\n\0", 8)).encoding == Encoding::utf16le);
  CHECK(decode(std::string("\0001\0,\0002\0\n", 8)).text == "1,2\n");
}

TEST_CASE("encoding: German, French and Japanese bytes against the code tables") {
  CHECK(decode("Pr\xFC"
               "fzeit")
            .text == "Prüfzeit");
  CHECK(decode("Pr\xFC"
               "fzeit")
            .encoding == Encoding::cp1252);
  CHECK(decode("\xC9paisseur \xE9prouvette").text == "Épaisseur éprouvette");  // pairs that Shift-JIS has, too
  CHECK(decode("\x8E\x9E\x8A\xD4,\x97\xCD").text == "時間,力");
  CHECK(decode("\x8E\x9E\x8A\xD4,\x97\xCD").encoding == Encoding::shift_jis);
  CHECK(decode("時間").encoding == Encoding::utf8);
  CHECK(decode("1,2\n時\xE9\x96").text == "1,2\n時\uFFFD");  // cut off within a character
  CHECK(decode("\xE9", Encoding::cp1252).text == "é");
}

TEST_CASE("encoding: NUL characters that end a line are none of it") {
  CHECK(decode(std::string("a.csv\0\r\n1,2\n", 12)).text == "a.csv\r\n1,2\n");
  CHECK(decode(std::string("a\0\0\nb\n", 6)).text == "a\nb\n");
  CHECK_THROWS_AS(decode(std::string("a\0b\0\n1,2\n", 9)), InputError);
  CHECK_THROWS_AS(decode(std::string("1,2\n\0\0", 6)), InputError);
}

TEST_CASE("encoding: what no encoding makes a text of is binary, and no other encoding is proposed") {
  const auto said = [](const std::string& bytes) { return message_of([&] { decode(bytes); }); };
  std::mt19937 random(1);
  for (int file = 0; file < 50; ++file) {
    std::string bytes;
    for (int i = 0; i < 3000; ++i) bytes += static_cast<char>(random() & 0xFF);
    CHECK(has(said(bytes), "The file holds binary data"));
    CHECK_FALSE(has(said(bytes), "--encoding"));
  }
  CHECK(has(said("Weg;Kraft\n1;2\n\x81;3\n"), "--encoding"));
}

TEST_CASE("encoding: what is no text, or not in the encoding asked for, is refused with its line") {
  const auto line_of = [](const std::string& bytes, std::optional<Encoding> wanted = {}) {
    try {
      decode(bytes, wanted);
    } catch (const InputError& error) {
      return error.fault.line;
    }
    return std::size_t{0};
  };
  CHECK(line_of(std::string("ab\n\0cdefgh", 10)) == 2);
  CHECK(line_of("a\nb\n\x81") == 3);  // no character of CP1252
  CHECK(line_of("a\n\xFF", Encoding::utf8) == 2);
  CHECK(line_of("Weg µm, Prüfkraft µN\nL\xE4nge") ==
        2);  // more is explained as UTF-8: no mojibake for the sake of one byte
  CHECK(line_of("L\xE4nge µm") == 1);
  CHECK_THROWS_AS(encoding_named("latin9"), InputError);
  CHECK(encoding_named("Shift-JIS") == Encoding::shift_jis);
}
