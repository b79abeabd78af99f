// The lines and cells of a delimited text, of any size.
#pragma once

#include <cstddef>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

namespace flexslip {

// The lines of a stream, numbered, whatever ends them.
class LineReader {
 public:
  // Fails:      InputError, also from next(), for what is no text in UTF-8: binary data, UTF-16, a line of more than 1 MiB.
  LineReader(std::istream& in, const std::string& source);

  std::size_t number() const { return number_; }  // of the line last read, counted from 1

  // The next line without its ending, valid until the next call.
  std::optional<std::string_view> next();

 private:
  std::string_view unread() const { return std::string_view(buffer_).substr(begin_); }
  bool refill();
  [[noreturn]] void refuse_binary(std::size_t nul);
  [[noreturn]] void refuse(std::string expected, std::string found, std::string remedy) const;

  std::istream& in_;
  const std::string& source_;
  std::string buffer_;
  std::size_t begin_ = 0;
  std::size_t number_ = 0;
  char ending_ = '\n';
};

// Takes the cells off a line, one by one. With a space as delimiter, any run of spaces and tabs separates.
class CellReader {
 public:
  CellReader(std::string_view line, char delimiter);

  // The next cell, without spaces around it and without its quotes; nothing at the end of the line.
  // Fails:      std::nullopt, with broken() true, if a quote is not closed.
  std::optional<std::string_view> next();

  bool broken() const { return broken_; }

 private:
  std::optional<std::string_view> next_quoted(std::size_t open);
  void advance(std::size_t end);

  std::string_view rest_;
  char delimiter_;
  bool more_ = true;
  bool broken_ = false;
};

// The delimiter that separates most in the header line, quoted cells apart: , ; or tab, or else a space.
char delimiter_of(std::string_view header);

// Is there nothing on the line, or a # before anything?
bool is_comment_or_blank(std::string_view line);

// A cell with its doubled quotes made single.
std::string unescaped(std::string_view cell);

}  // namespace flexslip
