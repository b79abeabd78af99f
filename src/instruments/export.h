// Exports of testing machines, whatever the program that wrote them: which numbers a file holds, what its columns are called
// and mean, in which units, and what else it says about the test.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "instruments/column_words.h"
#include "instruments/metadata.h"
#include "io/quantity.h"
#include "io/sheet_file.h"

namespace flexslip {

// What a user decides about a file; all else is found.
struct ExportOptions {
  SheetOptions file{};
  std::optional<char> decimal{};                // '.' or ','
  std::optional<char> thousands{};              // '.', ',', ' ' or '\''; '\0' for none
  std::map<ColumnRole, std::string> columns{};  // name or number (from 1) of the column with this role
  std::map<ColumnRole, std::string> units{};    // of a column, whatever it states; "222 N/V" for a force given in volts
  std::optional<ColumnRole>
      displacement{};  // which displacement a column is whose words do not say: crosshead, deflection
};

// The same in words, by the names of flags: {"sheet", "Data"}, {"force-unit", "N"}. Nothing is said where they are missing or empty; "sheet-number"
// is one that is no name.
using ReadingWords = std::map<std::string, std::string, std::less<>>;
std::string said(const ReadingWords& words, std::string_view name);  // empty if nothing is

// Fails:      InputError that names the flag.
ExportOptions options_of(const ReadingWords& words);

struct CellWithoutNumber {
  std::size_t row;   // of the specimen, from 0
  std::string says;  // what stands in it
};

struct ExportColumn {
  std::string name;  // as in the file, in UTF-8
  std::string unit;  // as in the file; empty if there is none
  ColumnRole role;
  std::vector<double> values;                // [unit]; NaN where the cell holds no number
  std::size_t number;                        // of the column in the file, from 1
  std::vector<std::string> words{};          // of a column without numbers (phases, names): its cells; empty otherwise
  std::vector<CellWithoutNumber> missing{};  // of a column of numbers, by row
};

// A key under [record] of a case, and what to write there: a text in quotes, or a number.
struct RecordKey {
  std::string_view name;
  std::string value;
};

// What a file does not say and an evaluation needs.
struct OpenQuestion {
  std::string words;                 // "which column is the force?"
  std::string with_read;             // what says it: flags of read
  std::vector<RecordKey> with_test;  // keys of all that evaluate a test; empty where they do not need it
};

struct ExportedSpecimen {
  std::string name{};                   // empty if the file names none
  std::vector<ExportColumn> columns{};  // of one length
  std::vector<std::size_t> lines{};     // of the file, counted from 1, on which each row stands
  std::vector<Metadatum> metadata{};    // of this specimen alone
  std::vector<OpenQuestion> asks{};     // what the file does not say of it
  std::string repeat_with{};            // the flags of read that make the same decisions again
};

struct Export {
  SheetOrigin origin{};
  std::string format{};  // "Instron Bluehill", ..., "table"
  NumberFormat marks{};
  bool has_marks = false;  // are there numbers in words, to which these apply?
  bool quoted = false;
  std::vector<ExportedSpecimen> specimens{};  // at least one, with at least one row
  std::vector<Metadatum> metadata{};
  ExportedTest test{};
  std::vector<std::string> notes{};      // what was decided or left out that a reader of the numbers should know
  std::string unplaced{};                // titles that cannot be told to columns; among the notes as well
  std::vector<std::string> row_notes{};  // those on rows and titles that an evaluation repeats; among the notes as well
};

// What a file says of itself; of one specimen, with what it says of that.
std::vector<Metadatum> all_metadata(const Export& file);

// Recognises what the bytes of a file hold.
// Fails:      InputError with file, line and remedy: nothing in it, no numbers, columns that cannot be told apart.
Export export_in(std::string bytes, const std::string& source, const ExportOptions& options = {});

// The same from a file; "-" is standard input.
Export read_export(const std::string& path, const ExportOptions& options = {});

// A column's values in SI; NaN where a cell holds no number.
// Fails:      InputError for a missing unit, or one of another kind (a force in volts). Its remedy is the flag of the column's role, or that given:
//             it ends where the unit follows, "state it with --height-unit ".
std::vector<double> in_si(const Export& file, const ExportColumn& column, const Kind& kind);
std::vector<double> in_si(const Export& file, const ExportColumn& column, const Kind& kind, std::string_view usual_unit,
                          const std::function<std::string(std::string_view unit)>& remedy);

// Rows that cannot be used, as some of the columns used hold no number there, and what is said of them; empty if there are none.
struct RowsLeftOut {
  std::vector<std::size_t> rows;  // of the specimen, from 0, rising
  std::string words;
};

// Fails:      InputError with the lines if they are more than a tenth of the rows, or if a cell says that a sensor was at its end (says_overload)
//             and numbers follow in its column, within the rows used.
RowsLeftOut rows_without_numbers(const Export& file, const ExportedSpecimen& specimen,
                                 const std::vector<const ExportColumn*>& columns, std::size_t rows_used);

// The questions that columns leave open.
std::vector<OpenQuestion> questions_of(const std::vector<ExportColumn>& columns);

// True if a title is the name of a column, or its name with its unit: "Force", "Force [kN]", "Force (kN)", "Force_kN".
bool is_called(const ExportColumn& column, std::string_view title);

// The index of the column of numbers that a user names with a flag: by number, as repeat_with says it, by name, or by name and unit as in the file.
// Fails:      InputError if there is none, or several of this name.
std::size_t column_named(const Export& file, const ExportedSpecimen& specimen, std::string_view wanted,
                         std::string_view flag);

// The column with a role. Without a remedy given, its flag is.
// Fails:      InputError if none has it, or several.
const ExportColumn& column_with(const Export& file, const ExportedSpecimen& specimen, ColumnRole role,
                                std::string remedy = "");

}  // namespace flexslip
