#include "io/workbook.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <new>
#include <set>
#include <utility>

#include <expat.h>
#include <fmt/format.h>
#include <minizip/unzip.h>

#include "io/input_error.h"
#include "io/text.h"

namespace flexslip {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view zip_mark = "PK\x03\x04"sv, empty_zip_mark = "PK\x05\x06"sv;
constexpr std::string_view office_mark = "\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"sv;
// rows: a calibration or a sheet of settings has one or two with numbers alone, a sheet of results a
// few
constexpr std::size_t fewest_readings = 3, usual_readings = 11;

// [bytes] The limit of an unpacked part: ten times the largest sheet of a measurement. An archive
// made to fill the memory is refused within seconds.
constexpr std::uint64_t largest_part = 1ULL << 30;
constexpr std::size_t most_rows = 1 << 20, most_columns = 1 << 14;  // limits of the format
constexpr std::size_t most_text = std::size_t{1} << 29;             // [bytes]
constexpr std::size_t most_cells = std::size_t{1} << 26;
constexpr std::size_t most_relations = 10'000;  // of a part; also limits the number of sheets
constexpr std::uint64_t longest_token = 1ULL
                                        << 24;  // [bytes] of XML: one that does not end is begun anew with each piece
constexpr int deepest = 100;                    // nesting of elements

// ---- the archive, unpacked by minizip

constexpr std::size_t piece_size = 1 << 16;  // [bytes] unpacked at a time

// The bytes as a file for minizip.
struct Bytes {
  std::string_view all;
  std::uint64_t at = 0;
};

Bytes& unpacked_from(void* stream) { return *static_cast<Bytes*>(stream); }

void* open_bytes(void* bytes, const void* /*name*/, int /*mode*/) { return bytes; }

uLong read_bytes(void* /*opaque*/, void* stream, void* to, uLong size) {
  Bytes& bytes = unpacked_from(stream);
  const std::string_view rest = bytes.all.substr(std::min<std::uint64_t>(bytes.at, bytes.all.size()), size);
  if (!rest.empty()) std::memcpy(to, rest.data(), rest.size());
  bytes.at += rest.size();
  return static_cast<uLong>(rest.size());
}

uLong write_nothing(void* /*opaque*/, void* /*stream*/, const void* /*from*/, uLong /*size*/) { return 0; }

ZPOS64_T place_in(void* /*opaque*/, void* stream) { return unpacked_from(stream).at; }

long seek_in(void* /*opaque*/, void* stream, ZPOS64_T offset, int origin) {
  Bytes& bytes = unpacked_from(stream);
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
  throw InputError({.problem = fmt::format("The workbook is damaged: {}", found),
                    .remedy = "copy or download the file again, or save it anew in the spreadsheet program"});
}

[[noreturn]] void refuse_odd(const std::string& found) {
  throw InputError({.problem = fmt::format("The workbook is not as spreadsheet programs write it: {}", found),
                    .remedy = "save it anew in the spreadsheet program"});
}

[[noreturn]] void refuse_large(const std::string& part) {
  throw InputError({.problem = fmt::format("The part {} of the workbook has more than {} MiB, unpacked",
                                           in_quotes(part), largest_part >> 20),
                    .remedy = "save the sheet with the measurement as CSV"});
}

// The parts of an archive by name.
class ZipArchive {
 public:
  // The bytes must outlive the archive.
  explicit ZipArchive(std::string_view bytes) : bytes_{bytes} {
    zlib_filefunc64_def functions{open_bytes, read_bytes,       write_nothing, place_in,
                                  seek_in,    nothing_to_close, no_error,      &bytes_};
    archive_ = unzOpen2_64("", &functions);
    if (archive_ == nullptr) refuse_damaged("an archive without its table of contents, as of a file cut off");
  }
  ~ZipArchive() { unzClose(archive_); }
  ZipArchive(const ZipArchive&) = delete;
  ZipArchive& operator=(const ZipArchive&) = delete;

  bool has(const std::string& part) const { return unzLocateFile(archive_, part.c_str(), 1) == UNZ_OK; }

  // Passes on the content of a part piece by piece. A part that is too large is not unpacked
  // further.
  template <class Take>
  void read(const std::string& part, const Take& take) const {
    unz_file_info64 info{};
    if (!has(part)) refuse_damaged("no part " + in_quotes(part));
    if (unzGetCurrentFileInfo64(archive_, &info, nullptr, 0, nullptr, 0, nullptr, 0) != UNZ_OK)
      refuse_damaged("damage in its table of contents");
    if ((info.flag & 1U) != 0)
      throw InputError(
          {.problem = "The workbook is encrypted", .remedy = "save it without a password, or the sheet as CSV"});
    if (info.uncompressed_size > largest_part) refuse_large(part);
    if (unzOpenCurrentFile(archive_) != UNZ_OK) refuse_damaged("damage at the part " + in_quotes(part));

    // The part is closed, whichever exception `take` throws.
    const std::unique_ptr<void, void (*)(void*)> to_close(archive_, [](void* open) { unzCloseCurrentFile(open); });
    std::array<char, piece_size> buffer{};
    std::uint64_t unpacked = 0;
    int got = 0;
    while ((got = unzReadCurrentFile(archive_, buffer.data(), static_cast<unsigned>(buffer.size()))) > 0) {
      unpacked += static_cast<std::uint64_t>(got);
      if (unpacked > largest_part) refuse_large(part);
      take({buffer.data(), static_cast<std::size_t>(got)});
    }
    if (got < 0 || unpacked != info.uncompressed_size) refuse_damaged("damage in the part " + in_quotes(part));
    if (unzCloseCurrentFile(archive_) == UNZ_CRCERROR)
      refuse_damaged("another checksum than it should have in the part " + in_quotes(part));
  }

 private:
  Bytes bytes_;
  unzFile archive_ = nullptr;
};

// ---- its XML, parsed by expat

constexpr char between = '|';  // between namespace and name

std::string_view local(std::string_view name) { return name.substr(name.rfind(between) + 1); }

// The attributes of an element by name, without namespace; valid while the element begins.
class XmlAttributes {
 public:
  explicit XmlAttributes(const char** pairs) : pairs_(pairs) {}
  std::optional<std::string_view> find(std::string_view name) const {
    for (const char** pair = pairs_; *pair != nullptr; pair += 2)
      if (local(pair[0]) == name) return pair[1];
    return std::nullopt;
  }

 private:
  const char** pairs_;  // name, value, ..., nullptr
};

// The handlers of elements and text. Names have no namespace. Handlers may throw.
struct XmlHandlers {
  std::function<void(std::string_view name, const XmlAttributes&)> begin;
  std::function<void(std::string_view name)> end = [](std::string_view) {};
  std::function<void(std::string_view text)> text = [](std::string_view) {};  // in pieces
};

// The elements of a document in order; enclosing elements are not stored.
class XmlStream {
 public:
  explicit XmlStream(XmlHandlers handlers) : handlers_(std::move(handlers)) {
    if (parser_ == nullptr) throw std::bad_alloc();
    XML_SetUserData(parser_, this);
    XML_SetElementHandler(
        parser_,
        [](void* user, const char* name, const char** attributes) {
          guarded(user, [&](XmlStream& self) {
            if (++self.depth_ > deepest) refuse_odd(fmt::format("elements more than {} deep in its XML", deepest));
            self.handlers_.begin(local(name), XmlAttributes(attributes));
          });
        },
        [](void* user, const char* name) {
          guarded(user, [&](XmlStream& self) {
            --self.depth_;
            self.handlers_.end(local(name));
          });
        });
    XML_SetCharacterDataHandler(parser_, [](void* user, const char* text, int length) {
      guarded(user, [&](XmlStream& self) { self.handlers_.text({text, static_cast<std::size_t>(length)}); });
    });
    XML_SetStartDoctypeDeclHandler(parser_, [](void* user, const char*, const char*, const char*, int) {
      guarded(user, [](XmlStream&) {  // a document type could define entities
        refuse_odd("a document type in its XML");
      });
    });
  }
  ~XmlStream() { XML_ParserFree(parser_); }
  XmlStream(const XmlStream&) = delete;
  XmlStream& operator=(const XmlStream&) = delete;

  // Parses the next piece of the document. Throws the exception of a handler.
  void feed(std::string_view piece, bool is_last = false) {
    const XML_Status status =
        XML_Parse(parser_, piece.data(), static_cast<int>(piece.size()), is_last ? XML_TRUE : XML_FALSE);
    if (thrown_) std::rethrow_exception(thrown_);
    fed_ += piece.size();
    const auto begun = static_cast<std::uint64_t>(std::max<XML_Index>(XML_GetCurrentByteIndex(parser_), 0));
    if (status == XML_STATUS_OK) {
      if (fed_ > begun + longest_token) refuse_odd("a name or an attribute in its XML without an end");
      return;
    }
    throw InputError({.problem = fmt::format("The workbook is damaged: its XML is broken ({})",
                                             XML_ErrorString(XML_GetErrorCode(parser_))),
                      .remedy = "save it anew in the spreadsheet program"});
  }

 private:
  // Exceptions must not pass through the C code of the parser.
  template <class Call>
  static void guarded(void* user, const Call& call) {
    XmlStream& self = *static_cast<XmlStream*>(user);
    if (self.thrown_) return;
    try {
      call(self);
    } catch (...) {
      self.thrown_ = std::current_exception();
      XML_StopParser(self.parser_, XML_FALSE);
    }
  }

  XmlHandlers handlers_;
  XML_Parser parser_ = XML_ParserCreateNS(nullptr, between);
  std::exception_ptr thrown_{};
  std::uint64_t fed_ = 0;  // [bytes]
  int depth_ = 0;
};

void parse(const ZipArchive& archive, const std::string& part, XmlHandlers handlers) {
  XmlStream xml(std::move(handlers));
  archive.read(part, [&](std::string_view piece) { xml.feed(piece); });
  xml.feed({}, true);
}

// ---- how formats display numbers

std::optional<std::size_t> whole(std::string_view text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// A built-in format, including those for Chinese, Japanese and Korean (ECMA-376, 18.8.30).
CellKind built_in(std::size_t number) {
  const auto within = [&](std::size_t first, std::size_t last) { return number >= first && number <= last; };
  if (number == 22) return CellKind::date_and_clock;
  if (within(18, 21) || within(32, 35) || within(45, 47) || within(55, 56)) return CellKind::clock;
  if (within(14, 17) || within(27, 31) || number == 36 || within(50, 54) || within(57, 58)) return CellKind::date;
  return CellKind::number;
}

// The date and time letters of a format for positive numbers, without its words: "[h]:mm" is
// "h:mm". Empty for a number, with or without a unit.
std::string letters_of(std::string_view code) {
  std::string letters;
  for (std::size_t i = 0; i < code.size() && code[i] != ';'; ++i) {
    const char c = code[i];
    if (c == '"') {
      i = std::min(code.find('"', i + 1), code.size());
    } else if (c == '\\' || c == '_' || c == '*') {
      ++i;
    } else if (c == '[') {  // a colour, condition, language, or hours beyond 24
      const std::size_t end = std::min(code.find(']', i), code.size());
      const std::string_view inside = code.substr(i + 1, end - i - 1);
      const bool is_elapsed = !inside.empty() && inside.find_first_not_of("hms") == std::string_view::npos;
      if (is_elapsed) letters += 'h';
      i = end;
    } else if (c == '#' || c == '?' || (c == '0' && letters.empty())) {
      return "";
    } else if (std::string_view("dmyhs").find(c) != std::string_view::npos) {
      letters += c;
    }
  }
  return letters;
}

std::vector<CellKind> read_cell_styles(const ZipArchive& archive, const std::string& part) {
  std::map<std::size_t, std::string> codes;
  std::vector<CellKind> kinds;
  bool in_cells = false;  // true in cellXfs, the formats of cells; cellStyleXfs are base styles
  const auto number_of = [](const XmlAttributes& attributes) {
    return whole(attributes.find("numFmtId").value_or("0")).value_or(0);
  };
  const auto begin = [&](std::string_view name, const XmlAttributes& attributes) {
    if (name == "numFmt")
      codes.insert_or_assign(number_of(attributes), std::string(attributes.find("formatCode").value_or("")));
    if (name == "cellXfs") in_cells = true;
    if (name != "xf" || !in_cells) return;
    const std::size_t number = number_of(attributes);
    const auto code = codes.find(number);
    kinds.push_back(kind_of_format(number, code == codes.end() ? std::string_view{} : code->second));
  };
  const auto end = [&](std::string_view name) {
    if (name == "cellXfs") in_cells = false;
  };
  parse(archive, part, {begin, end});
  return kinds;
}

// ---- the cells of a sheet

[[noreturn]] void refuse(std::size_t row, std::string field, std::string problem) {
  throw InputError({.line = row,
                    .field = std::move(field),
                    .problem = std::move(problem),
                    .remedy = "save the workbook anew in the spreadsheet program"});
}

// The column of "BC12", from 1; 0 for other text.
std::size_t column_in(std::string_view reference) {
  std::size_t column = 0;
  for (const char c : reference) {
    if (c < 'A' || c > 'Z') break;
    column = 26 * column + static_cast<std::size_t>(c - 'A' + 1);
    if (column > most_columns) return 0;
  }
  return column;
}

// "_x000D_" encodes a character that XML lacks; in a table it is a blank.
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

// True for digits and marks only: a number in some notation, or a line of numbers of a text file
// opened as a workbook.
bool is_like_number(std::string_view words) {
  return words.find_first_of("0123456789") != std::string_view::npos &&
         words.find_first_not_of("0123456789+-.,;eE' ") == std::string_view::npos;
}

// The words of <si> and <is>: the text of their runs, without phonetic hints.
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
    if (words_.size() > most_text) refuse(0, "", "A cell holds more than 512 MiB of words");
  }
  std::string take() { return std::exchange(words_, {}); }

 private:
  std::string words_;
  std::size_t pronounced_ = 0;
  bool in_text_ = false;
};

struct Worksheet {
  Sheet cells;
  std::string lines;                   // instead of the cells: words in one column only
  std::size_t rows_of_readings = 0;    // rows with at least two numbers, or only numbers
  std::size_t first_reading = 0;       // first row of readings, from 1
  std::size_t numbers = 0;             // cells with numbers
  std::size_t numeric_words = 0;       // cells whose words are digits and marks
  std::size_t first_numeric_word = 0;  // row, from 1
  std::size_t without_value = 0;       // formulas without a computed value
  std::vector<std::size_t> hidden{};   // hidden rows, from 1
  bool has_filter = false;             // a filter may hide rows
};

class SheetReader {
 public:
  SheetReader(const std::vector<std::string>& shared_strings, const std::vector<CellKind>& styles, bool dates_from_1904)
      : shared_(shared_strings), styles_(styles) {
    out_.cells = Sheet(dates_from_1904);
  }

  void begin(std::string_view name, const XmlAttributes& attributes) {
    if (name == "row") begin_row(attributes);
    if (name == "autoFilter") out_.has_filter = true;
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
    if (only_words_ && out_.numbers == 0 && filled_rows_ > 0) {
      for (std::size_t line = 0; line < out_.cells.size(); ++line) out_.lines.append(out_.cells.at(line, 0)) += '\n';
      return std::move(out_);
    }
    out_.cells.fill();
    return std::move(out_);
  }

 private:
  void begin_row(const XmlAttributes& attributes) {
    const auto stated = attributes.find("r");
    const std::size_t row = stated ? whole(*stated).value_or(0) : row_ + 1;
    if (row <= row_ || row > most_rows) refuse(row_ + 1, "", "A row is out of order");
    row_ = row;
    const std::string_view hidden = attributes.find("hidden").value_or("0");
    is_hidden_ = hidden == "1" || hidden == "true";
    cells_.clear();
    column_ = 0;
  }

  void begin_cell(const XmlAttributes& attributes) {
    if (row_ == 0 || in_cell_) refuse(row_, "", "A cell is outside a row");
    const auto stated = attributes.find("r");
    const std::size_t column = stated ? column_in(*stated) : column_ + 1;
    if (column <= column_ || column > most_columns)
      refuse(row_, stated ? "cell " + in_quotes(*stated) : "", "A cell is out of order");
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
    SheetCell cell = content();
    if (cell.text.empty()) return;
    only_words_ = only_words_ && next_column_ == 1;
    size_ += cell.text.size();
    if (size_ > most_text) refuse_large();
    column_ = next_column_;
    cells_.resize(column_);
    cells_.back() = std::move(cell);
  }

  SheetCell content() {
    if (has_formula_ && trimmed(value_).empty() && type_ != "inlineStr" && type_ != "str") ++out_.without_value;
    if (type_ == "s") return counted(on_a_line(shared()));
    if (type_ == "inlineStr") return counted(on_a_line(inline_.take()));
    if (type_ == "b")
      return {value_.empty() ? "" : trimmed(value_) == "1" || trimmed(value_) == "true" ? "TRUE" : "FALSE"};
    if (type_ == "e") return {on_a_line(value_), CellKind::error};
    if (type_ != "n") return counted(on_a_line(value_));  // str, d
    std::string number(trimmed(value_));
    if (number.empty()) return {};
    if (!plain_number(number))
      refuse(row_, fmt::format("column {}", next_column_),
             fmt::format("The cell says that it holds a number, but it holds {}", in_quotes(number)));
    ++out_.numbers;
    return {std::move(number), style_ < styles_.size() ? styles_[style_] : CellKind::number};
  }

  SheetCell counted(std::string words) {
    if (is_like_number(words) && out_.numeric_words++ == 0) out_.first_numeric_word = row_;
    return {std::move(words)};
  }

  const std::string& shared() const {
    const auto index = whole(trimmed(value_));
    if (!index || *index >= shared_.size())
      refuse(row_, fmt::format("column {}", next_column_),
             fmt::format("The cell names the string {}, but the workbook has {}", in_quotes(value_), shared_.size()));
    return shared_[*index];
  }

  void end_row() {
    if (row_ <= out_.cells.size()) return;  // an end tag without a start tag
    widest_ = std::max(widest_, cells_.size());
    if ((filled_rows_ + 1) * widest_ > most_cells) refuse_large();
    out_.cells.append(row_ - 1, cells_);
    if (cells_.empty()) return;
    if (is_hidden_) out_.hidden.push_back(row_);
    ++filled_rows_;
    std::size_t numbers = 0, words = 0;
    for (const SheetCell& cell : cells_)
      if (!cell.text.empty())
        ++(cell.kind == CellKind::number || is_dated(cell.kind) || is_like_number(cell.text) ? numbers : words);
    if ((numbers > 1 || (numbers == 1 && words == 0)) && out_.rows_of_readings++ == 0) out_.first_reading = row_;
  }

  [[noreturn]] void refuse_large() const {
    throw InputError({.line = row_,
                      .problem = "The sheet has more than 512 MiB of text or 67 million cells",
                      .remedy = "save the columns of the measurement as CSV"});
  }

  const std::vector<std::string>& shared_;
  const std::vector<CellKind>& styles_;
  Worksheet out_;
  std::vector<SheetCell> cells_;  // of the current row
  bool only_words_ = true;        // true if all cells are words in one column
  std::size_t filled_rows_ = 0, widest_ = 0, size_ = 0;
  std::size_t row_ = 0, column_ = 0, next_column_ = 0,
              style_ = 0;  // row_ and column_: last written; the others: of the current cell
  bool in_cell_ = false, in_value_ = false, has_formula_ = false, is_hidden_ = false;
  std::string type_, value_;
  Words inline_;
};

// The shared strings of a workbook.
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
           if (size > most_text) refuse(0, "", "The workbook holds more than 512 MiB of words");
         },
         [&](std::string_view piece) { words.text(piece); }});
  return strings;
}

// ---- the workbook

[[noreturn]] void refuse_kind(std::string found, std::string remedy) {
  throw InputError({.problem = fmt::format("The file is {}, not an Excel workbook (.xlsx) or a table as text", found),
                    .remedy = std::move(remedy)});
}

// Office documents from before 2007 contain their own file system. An encrypted workbook does too,
// and its parts have names in UTF-16.
[[noreturn]] void refuse_office_document(std::string_view bytes) {
  std::string encrypted;
  for (const char c : "EncryptedPackage"sv) encrypted.append({c, '\0'});
  if (bytes.find(encrypted) != std::string_view::npos)
    refuse_kind("a workbook with a password", "save it without a password, or the sheet with the measurement as CSV");
  refuse_kind("a workbook of Excel 97 to 2003 (.xls), or another office document of that time",
              "convert it: libreoffice --headless --convert-to xlsx FILE");
}

struct Relation {
  std::string kind;  // "worksheet", the last word of its type
  std::string part;
};

// The relations of a part, by identifier.
std::map<std::string, Relation> relations_of(const ZipArchive& archive, const std::string& part) {
  const std::filesystem::path path(part);
  const std::filesystem::path file = path.parent_path() / "_rels" / (path.filename().string() + ".rels");
  std::map<std::string, Relation> relations;
  if (!archive.has(file.generic_string())) return relations;
  const auto begin = [&](std::string_view name, const XmlAttributes& attributes) {
    if (name != "Relationship") return;
    const std::string_view type = attributes.find("Type").value_or("");
    const std::string_view target = attributes.find("Target").value_or("");
    const std::filesystem::path to =
        target.starts_with('/') ? std::filesystem::path(target.substr(1)) : path.parent_path() / target;
    if (relations.size() == most_relations)
      refuse_odd(fmt::format("more than {} relations of {}", most_relations, in_quotes(part)));
    relations.insert_or_assign(
        std::string(attributes.find("Id").value_or("")),
        Relation{std::string(type.substr(type.rfind('/') + 1)), to.lexically_normal().generic_string()});
  };
  parse(archive, file.generic_string(), {begin});
  return relations;
}

std::optional<Relation> of_kind(const std::map<std::string, Relation>& relations, std::string_view kind) {
  for (const auto& [id, relation] : relations)
    if (relation.kind == kind) return relation;
  return std::nullopt;
}

struct ListedSheet {
  std::string name, part;
  bool is_hidden;
};

class Workbook {
 public:
  explicit Workbook(std::string_view bytes) : archive_(bytes) {
    const std::optional<Relation> document = of_kind(relations_of(archive_, ""), "officeDocument");
    const std::string main = !document ? "xl/workbook.xml" : document->part;
    if (!document || !main.ends_with(".xml") || !archive_.has(main)) refuse_other(main);
    const std::map<std::string, Relation> relations = relations_of(archive_, main);
    if (const std::optional<Relation> strings = of_kind(relations, "sharedStrings"))
      strings_ = read_shared_strings(archive_, strings->part);
    if (const std::optional<Relation> styles = of_kind(relations, "styles"))
      styles_ = read_cell_styles(archive_, styles->part);
    std::set<std::string> parts;
    const auto begin = [&](std::string_view name, const XmlAttributes& attributes) {
      if (name == "workbookPr") {
        const std::string_view from_1904 = attributes.find("date1904").value_or("0");
        dates_from_1904_ = from_1904 == "1" || from_1904 == "true";
      }
      if (name != "sheet") return;
      const auto relation = relations.find(std::string(attributes.find("id").value_or("")));
      if (relation == relations.end() || relation->second.kind != "worksheet") return;  // a chart
      const std::string& part = relation->second.part;
      if (!parts.insert(part).second) refuse_odd("two sheets of one part");
      sheets_.push_back({std::string(attributes.find("name").value_or("")), part,
                         attributes.find("state").value_or("visible") != "visible"});
    };
    parse(archive_, main, {begin});
    if (sheets_.empty()) refuse_kind("a workbook without a sheet of cells", "save the table in one");
  }

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const ListedSheet& sheet : sheets_) names.push_back(sheet.name);
    return names;
  }

  struct Chosen {
    std::size_t index;
    Worksheet sheet;
    bool has_readings;
  };

  // The visible sheets with readings below the same titles as a sheet, including this sheet; empty
  // if it is the only one.
  std::vector<std::string> alike(const Chosen& chosen) const {
    const std::string titles = titles_of(chosen.sheet);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < sheets_.size() && !titles.empty(); ++i)
      if (i == chosen.index || (!sheets_[i].is_hidden && titles_of(read(i)) == titles))
        names.push_back(sheets_[i].name);
    return names.size() > 1 ? names : std::vector<std::string>();
  }

  Chosen choose(const std::optional<SheetChoice>& wanted, SheetFor purpose) const {
    if (wanted) {
      const std::size_t index = numbered(*wanted);
      return {index, read(index), false};
    }
    std::optional<Chosen> with_number, with_few;
    for (const bool hidden : {false, true}) {
      for (std::size_t i = 0; i < sheets_.size(); ++i) {
        if (sheets_[i].is_hidden != hidden) continue;
        Worksheet sheet = read(i);
        if (purpose != SheetFor::words && sheet.rows_of_readings >= usual_readings) return {i, std::move(sheet), true};
        if (purpose != SheetFor::words && !with_few && sheet.rows_of_readings >= fewest_readings)
          with_few = {i, std::move(sheet), true};
        else if (!with_number && sheet.numbers + sheet.numeric_words > 0)
          with_number = {i, std::move(sheet), false};
        if (with_number && purpose == SheetFor::words) break;
      }
      if (with_few) return std::move(*with_few);
      if (with_number) return std::move(*with_number);
    }
    throw InputError({.problem = fmt::format("There are no rows of numbers on the sheet{} {}",
                                             sheets_.size() == 1 ? "" : "s", listed(names())),
                      .remedy = "save the table with the measurement in the workbook"});
  }

 private:
  // The words above the readings, including a row of units if the row above has as many words.
  static std::string titles_of(const Worksheet& sheet) {
    const std::size_t first = sheet.first_reading;
    if (sheet.rows_of_readings < fewest_readings || first < 2 || sheet.cells.is_blank(first - 2)) return "";
    const std::string last(sheet.cells.text(first - 2));
    const bool are_two = first > 2 && sheet.cells.cells(first - 3).size() == sheet.cells.cells(first - 2).size();
    return are_two ? fmt::format("{}\n{}", sheet.cells.text(first - 3), last) : last;
  }

  Worksheet read(std::size_t index) const {
    try {
      SheetReader sheet(strings_, styles_, dates_from_1904_);
      parse(archive_, sheets_[index].part,
            {[&](std::string_view name, const XmlAttributes& attributes) { sheet.begin(name, attributes); },
             [&](std::string_view name) { sheet.end(name); }, [&](std::string_view piece) { sheet.text(piece); }});
      return sheet.take();
    } catch (const InputError& error) {
      InputFault fault = error.fault;
      fault.field =
          fmt::format("sheet {}{}{}", in_quotes(sheets_[index].name), fault.field.empty() ? "" : ", ", fault.field);
      throw InputError(fault);
    }
  }

  std::size_t numbered(const SheetChoice& wanted) const {
    const std::string* name = std::get_if<std::string>(&wanted);
    for (std::size_t i = 0; name != nullptr && i < sheets_.size(); ++i)
      if (sheets_[i].name == *name) return i;
    const std::string number = name != nullptr ? *name : std::to_string(std::get<std::size_t>(wanted));
    for (std::size_t i = 0; i < sheets_.size(); ++i)
      if (std::to_string(i + 1) == number) return i;
    const bool is_name =
        std::any_of(sheets_.begin(), sheets_.end(), [&](const ListedSheet& each) { return each.name == number; });
    throw InputError({.field = "--sheet",
                      .problem = fmt::format("There is no sheet {}; the workbook has {}",
                                             name != nullptr ? in_quotes(*name) : number, listed(names())),
                      .remedy = is_name           ? fmt::format("write the name as text: {}", in_quotes(number))
                                : name != nullptr ? did_you_mean(*name, names())
                                                  : "",
                      .key = "record.sheet"});
  }

  [[noreturn]] void refuse_other(const std::string& main) const {
    static const std::string remedy = "open it, and save it as .xlsx, or the sheet with the measurement as CSV";
    if (archive_.has("content.xml") && archive_.has("mimetype")) refuse_kind("an OpenDocument (.ods)", remedy);
    if (main.ends_with(".bin")) refuse_kind("a binary workbook (.xlsb)", remedy);
    if (archive_.has("Index/Document.iwa")) refuse_kind("a spreadsheet of Numbers", remedy);
    refuse_kind("an archive without a workbook", "unpack it, and pass the file with the measurement");
  }

  ZipArchive archive_;
  std::vector<std::string> strings_;
  std::vector<CellKind> styles_;
  std::vector<ListedSheet> sheets_;
  bool dates_from_1904_ = false;
};

std::vector<std::string> notes_on(const Worksheet& sheet) {
  std::vector<std::string> notes;
  if (!sheet.lines.empty())
    notes.emplace_back(
        "all cells are words in one column: read as the text file that it was before it was opened as a workbook");
  else if (sheet.numbers > 0 && sheet.numeric_words > 0)
    notes.push_back(fmt::format("numbers that are kept as words: {}, the first in row {}", sheet.numeric_words,
                                sheet.first_numeric_word));
  if (!sheet.hidden.empty())
    notes.push_back(fmt::format("{} {} hidden{}, and read as all others are: {}",
                                sheet.hidden.size() == 1 ? "one row" : fmt::format("{} rows", sheet.hidden.size()),
                                sheet.hidden.size() == 1 ? "is" : "are", sheet.has_filter ? " by a filter" : "",
                                on_lines(sheet.hidden)));
  if (sheet.without_value > 0)
    notes.push_back(
        fmt::format("{} formulas have no stored value and count as empty: open the workbook in a "
                    "spreadsheet program and save it",
                    sheet.without_value));
  return notes;
}

}  // namespace

bool is_packed(std::string_view bytes) {
  return bytes.starts_with(zip_mark) || bytes.starts_with(empty_zip_mark) ||
         bytes.starts_with(office_mark.substr(0, 4));
}

CellKind kind_of_format(std::size_t number, std::string_view code) {
  if (code.empty()) return built_in(number);
  const std::string letters = letters_of(folded(code));
  const auto has = [&](std::string_view some) { return letters.find_first_of(some) != std::string::npos; };
  const bool has_clock = has("hs"), has_date = has("yd");
  if (has_clock) return has_date ? CellKind::date_and_clock : CellKind::clock;
  return has_date || has("m") ? CellKind::date : CellKind::number;
}

WorkbookSheet read_sheet(std::string_view bytes, const std::optional<SheetChoice>& wanted, SheetFor purpose) {
  if (bytes.starts_with(office_mark.substr(0, 4))) refuse_office_document(bytes);
  const Workbook workbook(bytes);
  auto chosen = workbook.choose(wanted, purpose);
  std::vector<std::string> alike;
  if (!wanted && purpose != SheetFor::words) alike = workbook.alike(chosen);
  auto& [index, sheet, has_readings] = chosen;
  if (purpose != SheetFor::words && sheet.without_value >= usual_readings)
    throw InputError({.field = "sheet " + in_quotes(workbook.names()[index]),
                      .problem = fmt::format("{} formulas have no stored value", sheet.without_value),
                      .remedy = "open the workbook in a spreadsheet program and save it"});
  WorkbookSheet out{.name = workbook.names()[index],
                    .sheets = workbook.names(),
                    .alike = std::move(alike),
                    .cells = std::move(sheet.cells),
                    .text = {},
                    .which = {},
                    .notes = notes_on(sheet)};
  if (!sheet.lines.empty()) out.text = std::move(sheet.lines);
  if (out.sheets.size() > 1) {
    out.which =
        wanted ? fmt::format("the sheet is {}, as stated", in_quotes(out.name))
               : fmt::format("the sheet is {}, the first of {} with {}; another is read with --sheet NAME",
                             in_quotes(out.name), listed(out.sheets), has_readings ? "a table of numbers" : "a number");
    out.notes.insert(out.notes.begin(), out.which);
  }
  return out;
}

}  // namespace flexslip
