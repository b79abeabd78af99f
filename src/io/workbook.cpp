#include "io/workbook.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "io/worksheet.h"
#include "io/xml_stream.h"
#include "io/zip_archive.h"

namespace flexslip {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view zip_mark = "PK\x03\x04"sv, empty_zip_mark = "PK\x05\x06"sv;
constexpr std::string_view office_mark = "\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"sv;
constexpr std::size_t fewest_readings =
    3;  // rows: a calibration or a sheet of settings has one or two with numbers alone

[[noreturn]] void refuse_kind(std::string found, std::string remedy) {
  throw InputError({.expected = "an Excel workbook (.xlsx) or a table as text",
                    .found = std::move(found),
                    .remedy = std::move(remedy)});
}

// Office documents from before 2007 are files of a file system of their own; so is a workbook that was encrypted, whose parts have names
// in UTF-16.
[[noreturn]] void refuse_office_document(std::string_view bytes) {
  std::string encrypted;
  for (const char c : "EncryptedPackage"sv) encrypted.append({c, '\0'});
  if (bytes.find(encrypted) != std::string_view::npos)
    refuse_kind("a workbook with a password", "save it without a password, or the sheet with the measurement as CSV");
  refuse_kind("a workbook of Excel 97 to 2003 (.xls), or another office document of that time",
              "open it, and save it as .xlsx, or the sheet with the measurement as CSV");
}

struct Relation {
  std::string kind;  // "worksheet", the last word of its type
  std::string part;
};

// What a part refers to, by identifier.
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
    relations.insert_or_assign(
        std::string(attributes.find("Id").value_or("")),
        Relation{std::string(type.substr(type.rfind('/') + 1)), to.lexically_normal().generic_string()});
  };
  XmlStream xml({begin, [](std::string_view) {}, [](std::string_view) {}});
  archive.read(file.generic_string(), [&](std::string_view piece) { xml.feed(piece); });
  xml.finish();
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
    const auto begin = [&](std::string_view name, const XmlAttributes& attributes) {
      if (name == "workbookPr") {
        const std::string_view from_1904 = attributes.find("date1904").value_or("0");
        dates_from_1904_ = from_1904 == "1" || from_1904 == "true";
      }
      if (name != "sheet") return;
      const auto relation = relations.find(std::string(attributes.find("id").value_or("")));
      if (relation == relations.end() || relation->second.kind != "worksheet") return;  // a chart
      sheets_.push_back({std::string(attributes.find("name").value_or("")), relation->second.part,
                         attributes.find("state").value_or("visible") != "visible"});
    };
    XmlStream xml({begin, [](std::string_view) {}, [](std::string_view) {}});
    archive_.read(main, [&](std::string_view piece) { xml.feed(piece); });
    xml.finish();
    if (sheets_.empty()) refuse_kind("a workbook without a sheet of cells", "save the table in one");
  }

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const ListedSheet& sheet : sheets_) names.push_back(sheet.name);
    return names;
  }

  bool dates_from_1904() const { return dates_from_1904_; }

  struct Chosen {
    std::size_t index;
    Worksheet sheet;
    bool has_readings;
  };

  Chosen choose(const std::optional<SheetChoice>& wanted, SheetFor purpose) const {
    if (wanted) {
      const std::size_t index = numbered(*wanted);
      return {index, read(index), false};
    }
    std::optional<Chosen> with_number;
    for (const bool hidden : {false, true}) {
      for (std::size_t i = 0; i < sheets_.size(); ++i) {
        if (sheets_[i].is_hidden != hidden) continue;
        Worksheet sheet = read(i);
        if (purpose == SheetFor::readings && sheet.rows_of_readings >= fewest_readings)
          return {i, std::move(sheet), true};
        if (!with_number && sheet.numbers + sheet.numeric_words > 0) with_number = {i, std::move(sheet), false};
        if (with_number && purpose == SheetFor::words) break;
      }
      if (with_number) return std::move(*with_number);
    }
    throw InputError({.expected = "rows of numbers",
                      .found = sheets_.size() == 1 ? fmt::format("none on the sheet {}", in_quotes(sheets_[0].name))
                                                   : "none on the sheets " + listed(names()),
                      .remedy = "save the table with the measurement in the workbook"});
  }

 private:
  Worksheet read(std::size_t index) const {
    try {
      return read_worksheet(archive_, sheets_[index].part, strings_, styles_);
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
    const std::string meant = name != nullptr ? nearest(*name, names()) : "";
    const bool is_name =
        std::any_of(sheets_.begin(), sheets_.end(), [&](const ListedSheet& each) { return each.name == number; });
    throw InputError(
        {.field = "--sheet",
         .expected = (sheets_.size() == 1 ? "the sheet " : "one of the sheets ") + listed(names()) + ", or its number",
         .found = shown(wanted),
         .remedy = is_name         ? fmt::format("write the name as text: {}", in_quotes(number))
                   : meant.empty() ? ""
                                   : "did you mean " + in_quotes(meant) + "?",
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
  if (sheet.one_column)
    notes.emplace_back(
        "all cells are words in one column: read as the text file that it was before it was opened as a workbook");
  else if (sheet.numbers > 0 && sheet.numeric_words > 0)
    notes.push_back(fmt::format("numbers that are kept as words: {}, the first in row {}", sheet.numeric_words,
                                sheet.first_numeric_word));
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

std::string shown(const SheetChoice& sheet) {
  const std::string* name = std::get_if<std::string>(&sheet);
  return name != nullptr ? in_quotes(*name) : std::to_string(std::get<std::size_t>(sheet));
}

InputError WorkbookSheet::dated(const std::string& file, std::size_t row, std::size_t column, double days,
                                std::string_view expected) const {
  const CellKind kind = kinds.at(row, column);
  const char* what = kind == CellKind::clock ? "clock time" : kind == CellKind::date ? "date" : "date and clock time";
  return InputError({.file = file,
                     .line = row,
                     .field = fmt::format("sheet {}, cell {}", in_quotes(name), cell_name(row, column)),
                     .expected = std::string(expected),
                     .found = fmt::format("the {} {}", what, shown_days(days, kind, dates_from_1904)),
                     .remedy = "format the cell as a number and type it again, or delete the row",
                     .part = TablePart::cell});
}

InputError with_other_sheets(const InputError& error, const std::string& name, const std::vector<std::string>& sheets) {
  if (sheets.size() < 2 || error.fault.part == TablePart::cell) return error;
  std::vector<std::string> others;
  for (const std::string& each : sheets)
    if (each != name) others.push_back(each);
  InputFault fault = error.fault;
  fault.remedy += fmt::format("{}this is the sheet {}, and there {} also {}: read another with --sheet \"{}\"",
                              fault.remedy.empty() ? "" : "; ", in_quotes(name), others.size() == 1 ? "is" : "are",
                              listed(others), others.front());
  return InputError(fault);
}

WorkbookSheet read_sheet(std::string_view bytes, const std::optional<SheetChoice>& wanted, SheetFor purpose) {
  if (bytes.starts_with(office_mark.substr(0, 4))) refuse_office_document(bytes);
  const Workbook workbook(bytes);
  auto [index, sheet, has_readings] = workbook.choose(wanted, purpose);
  WorkbookSheet out{workbook.names()[index], workbook.names(), {}, SheetHolds::numbers, notes_on(sheet)};
  if (sheet.numeric_words > sheet.numbers) out.holds = SheetHolds::words;
  if (sheet.one_column) out.holds = SheetHolds::lines_of_text;
  out.text = std::move(sheet.text);
  out.kinds = std::move(sheet.kinds);
  out.dates_from_1904 = workbook.dates_from_1904();
  out.is_chosen = wanted.has_value();
  if (out.sheets.size() > 1)
    out.notes.insert(out.notes.begin(),
                     wanted ? fmt::format("the sheet is {}, as stated", in_quotes(out.name))
                            : fmt::format("the sheet is {}, the first of {} with {}; another is read with --sheet NAME",
                                          in_quotes(out.name), listed(out.sheets),
                                          has_readings ? "a table of numbers" : "a number"));
  return out;
}

}  // namespace flexslip
