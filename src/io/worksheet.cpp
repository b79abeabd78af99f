#include "io/worksheet.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include "io/input_error.h"
#include "io/text.h"
#include "io/xml_stream.h"

namespace flexslip {
namespace {

constexpr std::size_t most_rows = 1 << 20, most_columns = 1 << 14;  // of the format
constexpr std::size_t most_text = std::size_t{1} << 29;             // [bytes]

[[noreturn]] void refuse(std::size_t row, std::string field, std::string expected, std::string found) {
  throw InputError({.line = row,
                    .field = std::move(field),
                    .expected = std::move(expected),
                    .found = std::move(found),
                    .remedy = "save the workbook anew in the spreadsheet program"});
}

std::optional<std::size_t> whole(std::string_view text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// The column of "BC12", from 1; 0 if there is none.
std::size_t column_in(std::string_view reference) {
  std::size_t column = 0;
  for (const char c : reference) {
    if (c < 'A' || c > 'Z') break;
    column = 26 * column + static_cast<std::size_t>(c - 'A' + 1);
    if (column > most_columns) return 0;
  }
  return column;
}

// "_x000D_" is how the format writes a character that XML has not; to a table it is a blank.
std::string without_escapes(std::string text) {
  for (std::size_t at = text.find("_x"); at != std::string::npos; at = text.find("_x", at + 1)) {
    const bool is_whole = at + 6 < text.size() && text[at + 6] == '_';
    if (is_whole && text.find_first_not_of("0123456789abcdefABCDEF", at + 2) == at + 6 &&
        text.compare(at, 4, "_x00") == 0)
      text.replace(at, 7, " ");
  }
  return text;
}

// Words on one line.
std::string on_a_line(std::string text) {
  text = without_escapes(std::move(text));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
  return std::string(trimmed(text));
}

std::string in_cell_quotes(std::string_view words) {
  std::string quoted = "\"";
  for (const char c : words) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

// Digits with marks alone: a number in the manner of some country, or a line of several, of a text file opened as a workbook.
bool is_like_number(std::string_view words) {
  return words.find_first_of("0123456789") != std::string_view::npos &&
         words.find_first_not_of("0123456789+-.,;eE' ") == std::string_view::npos;
}

// The words of <si> and <is>: those of their runs, without what tells how to pronounce them.
class Words {
 public:
  void begin(std::string_view name) {
    if (name == "rPh") ++pronounced_;
    in_text_ = name == "t" && pronounced_ == 0;
  }
  void end(std::string_view name) {
    if (name == "rPh" && pronounced_ > 0) --pronounced_;
    in_text_ = false;
  }
  void text(std::string_view piece) {
    if (in_text_) words_ += piece;
    if (words_.size() > most_text) refuse(0, "", "words of at most 512 MiB", "more in a cell");
  }
  std::string take() { return std::exchange(words_, {}); }

 private:
  std::string words_;
  std::size_t pronounced_ = 0;
  bool in_text_ = false;
};

void parse(const ZipArchive& archive, const std::string& part, XmlHandlers handlers) {
  XmlStream xml(std::move(handlers));
  archive.read(part, [&](std::string_view piece) { xml.feed(piece); });
  xml.finish();
}

class SheetReader {
 public:
  SheetReader(const std::vector<std::string>& shared_strings, const std::vector<CellKind>& styles)
      : shared_(shared_strings), styles_(styles) {}

  void begin(std::string_view name, const XmlAttributes& attributes) {
    if (name == "row") begin_row(attributes);
    if (name == "c") begin_cell(attributes);
    if (name == "f" && in_cell_) has_formula_ = true;
    in_value_ = name == "v" && in_cell_;
    if (in_cell_) inline_.begin(name);
  }

  void end(std::string_view name) {
    in_value_ = false;
    if (in_cell_) inline_.end(name);
    if (name == "c") end_cell();
    if (name == "row") end_row();
  }

  void text(std::string_view piece) {
    if (in_value_) value_ += piece;
    if (in_cell_) inline_.text(piece);
  }

  Worksheet take() {
    out_.one_column = only_words_ && out_.numbers == 0 && !ends_.empty();
    if (!out_.one_column) {
      fill_rows();
    } else {
      out_.text = std::move(words_);
      out_.kinds = {};  // its lines are cut into cells by whoever reads them
    }
    return std::move(out_);
  }

 private:
  void begin_row(const XmlAttributes& attributes) {
    const auto stated = attributes.find("r");
    const std::size_t row = stated ? whole(*stated).value_or(0) : row_ + 1;
    if (row <= row_ || row > most_rows) refuse(row_ + 1, "", "rows in their order", "one out of place");
    out_.text.append(row - row_ - 1, '\n');
    if (only_words_) words_.append(row - row_ - 1, '\n');
    row_ = row;
    column_ = 0;
    numbers_in_row_ = words_in_row_ = 0;
  }

  void begin_cell(const XmlAttributes& attributes) {
    if (row_ == 0 || in_cell_) refuse(row_, "", "cells in rows", "one out of place");
    const auto stated = attributes.find("r");
    const std::size_t column = stated ? column_in(*stated) : column_ + 1;
    if (column <= column_ || column > most_columns)
      refuse(row_, stated ? "cell " + in_quotes(*stated) : "", "cells in their order", "one out of place");
    next_column_ = column;
    type_ = attributes.find("t").value_or("n");
    style_ = whole(attributes.find("s").value_or("0")).value_or(0);
    in_cell_ = true;
    has_formula_ = false;
    value_.clear();
    inline_ = {};
  }

  void end_cell() {
    if (!in_cell_) return;
    in_cell_ = false;
    bool is_number = false;
    std::string cell = content(is_number);
    if (cell.empty()) return;
    ++(is_number || is_like_number(cell) ? numbers_in_row_ : words_in_row_);
    const std::size_t tabs = next_column_ - (column_ == 0 ? 1 : column_);
    out_.text.append(tabs, '\t');
    column_ = next_column_;
    only_words_ = only_words_ && !is_number && next_column_ == 1;
    if (only_words_) words_ += cell;
    const bool is_comment = column_ == 1 && cell.front() == '#' && type_ != "e";
    const bool needs_quotes = !is_number && !is_comment && (cell.find_first_of(" ,;\"#") != std::string::npos);
    out_.text += needs_quotes ? in_cell_quotes(cell) : cell;
    if (out_.text.size() > most_text) refuse_large();
  }

  std::string content(bool& is_number) {
    if (has_formula_ && trimmed(value_).empty() && type_ != "inlineStr" && type_ != "str") ++out_.without_value;
    if (type_ == "s") return counted(on_a_line(shared()));
    if (type_ == "inlineStr") return counted(on_a_line(inline_.take()));
    if (type_ == "b")
      return value_.empty() ? "" : trimmed(value_) == "1" || trimmed(value_) == "true" ? "TRUE" : "FALSE";
    if (type_ != "n") return counted(on_a_line(value_));  // str, e, d
    std::string number(trimmed(value_));
    if (number.empty()) return number;
    double ignored = 0;
    const std::string_view digits = std::string_view(number).substr(number.front() == '+' ? 1 : 0);
    const auto [end, error] = fast_float::from_chars(digits.data(), digits.data() + digits.size(), ignored);
    if (error != std::errc{} || end != digits.data() + digits.size())
      refuse(row_, fmt::format("column {}", next_column_), "a number, as the cell says that it holds",
             in_quotes(number));
    ++out_.numbers;
    is_number = true;
    if (style_ < styles_.size()) out_.kinds.add(row_, next_column_, styles_[style_]);
    return number;
  }

  std::string counted(std::string words) {
    if (!is_like_number(words)) return words;
    if (out_.numeric_words++ == 0) out_.first_numeric_word = row_;
    out_.kinds.add(row_, next_column_, CellKind::word);
    return words;
  }

  const std::string& shared() const {
    const auto index = whole(trimmed(value_));
    if (!index || *index >= shared_.size())
      refuse(row_, fmt::format("column {}", next_column_),
             fmt::format("one of the {} strings of the workbook", shared_.size()), in_quotes(value_));
    return shared_[*index];
  }

  void end_row() {
    if (column_ > 0) ends_.push_back({out_.text.size(), column_});
    if (numbers_in_row_ > 1 || (numbers_in_row_ == 1 && words_in_row_ == 0)) ++out_.rows_of_readings;
    out_.text += '\n';
    if (only_words_) words_ += '\n';
  }

  // All rows get as many cells as the widest, as spreadsheet programs write CSV.
  void fill_rows() {
    std::size_t widest = 0, missing = 0;
    for (const RowEnd& end : ends_) widest = std::max(widest, end.columns);
    for (const RowEnd& end : ends_) missing += widest - end.columns;
    if (missing == 0) return;
    if (out_.text.size() + missing > most_text) refuse_large();
    std::string filled;
    filled.reserve(out_.text.size() + missing);
    std::size_t from = 0;
    for (const RowEnd& end : ends_) {
      filled.append(out_.text, from, end.offset - from).append(widest - end.columns, '\t');
      from = end.offset;
    }
    out_.text = std::move(filled.append(out_.text, from));
  }

  [[noreturn]] void refuse_large() const {
    throw InputError({.line = row_,
                      .expected = "a sheet of at most 512 MiB of text",
                      .found = "a larger one",
                      .remedy = "save the columns of the measurement as CSV"});
  }

  struct RowEnd {
    std::size_t offset, columns;
  };

  const std::vector<std::string>& shared_;
  const std::vector<CellKind>& styles_;
  Worksheet out_;
  std::vector<RowEnd> ends_;  // of rows that are not empty
  std::string words_;         // of the first column, while there is no other
  bool only_words_ = true;
  std::size_t row_ = 0, column_ = 0, next_column_ = 0;  // last written; of the cell that is read
  std::size_t style_ = 0, numbers_in_row_ = 0, words_in_row_ = 0;
  bool in_cell_ = false, in_value_ = false, has_formula_ = false;
  std::string type_, value_;
  Words inline_;
};

}  // namespace

Worksheet read_worksheet(const ZipArchive& archive, const std::string& part,
                         const std::vector<std::string>& shared_strings, const std::vector<CellKind>& styles) {
  SheetReader sheet(shared_strings, styles);
  parse(archive, part,
        {[&](std::string_view name, const XmlAttributes& attributes) { sheet.begin(name, attributes); },
         [&](std::string_view name) { sheet.end(name); }, [&](std::string_view piece) { sheet.text(piece); }});
  return sheet.take();
}

std::vector<std::string> read_shared_strings(const ZipArchive& archive, const std::string& part) {
  std::vector<std::string> strings;
  std::size_t size = 0;
  Words words;
  parse(archive, part,
        {[&](std::string_view name, const XmlAttributes&) { words.begin(name); },
         [&](std::string_view name) {
           words.end(name);
           if (name != "si") return;
           strings.push_back(words.take());
           size += sizeof(std::string) + strings.back().size();
           if (size > most_text) refuse(0, "", "words of at most 512 MiB", "more in the workbook");
         },
         [&](std::string_view piece) { words.text(piece); }});
  return strings;
}

}  // namespace flexslip
