// Exports of testing machines: the numbers of a file, the titles, meanings and units of its
// columns, and its statements about the test. Any program's export is accepted.
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

// Choices of the user. Everything else is detected.
struct ExportOptions {
  SheetOptions file{};
  std::optional<char> decimal{};                // '.' or ','
  std::optional<char> thousands{};              // '.', ',', ' ' or '\''; '\0' for none
  std::map<ColumnRole, std::string> columns{};  // name or number (from 1) of the column with this role
  std::map<ColumnRole, std::string> units{};    // overrides the unit of a column; "222 N/V" for a force in volts
  std::optional<ColumnRole> displacement{};     // crosshead or deflection, for a column whose title does not say
};

// The same choices as text, by the names of flags: {"sheet", "Data"}, {"force-unit", "N"}. A
// missing or empty text is no choice. "sheet-number" is a number, not a name.
using ReadingWords = std::map<std::string, std::string, std::less<>>;
std::string said(const ReadingWords& words, std::string_view name);  // empty if nothing is said

// Fails:      InputError that names the flag.
ExportOptions options_of(const ReadingWords& words);

struct CellWithoutNumber {
  std::size_t row;   // of the specimen, from 0
  std::string says;  // text of the cell
};

struct ExportColumn {
  std::string name;  // as in the file, in UTF-8
  std::string unit;  // as in the file; empty without a unit
  ColumnRole role;
  std::vector<double> values;                // [unit]; NaN if the cell holds no number
  std::size_t number;                        // of the column in the file, from 1
  std::vector<std::string> words{};          // the cells of a column of words; otherwise empty
  std::vector<CellWithoutNumber> missing{};  // in a column of numbers, by row
};

// A key of the section [record] and its value: a text in quotes, or a number.
struct RecordKey {
  std::string_view name;
  std::string value;
};

// An input that an evaluation needs and the file does not state.
struct OpenQuestion {
  std::string words;                 // "which column is the force?"
  std::string with_read;             // flags of `read` that answer it
  std::vector<RecordKey> with_test;  // keys that answer it in a test; empty if an evaluation does not need it
};

struct ExportedSpecimen {
  std::string name{};                   // empty if the file gives no name
  std::vector<ExportColumn> columns{};  // of one length
  std::vector<std::size_t> lines{};     // line of each row in the file, counted from 1
  std::vector<Metadatum> metadata{};    // of this specimen only
  // [N/m] of the load train, of a file that holds the stage's displacement and the deflection
  std::optional<double> load_train{};
  std::vector<OpenQuestion> asks{};  // open questions
  std::string repeat_with{};         // flags of `read` that repeat the decisions
};

struct Export {
  SheetOrigin origin{};
  std::string format{};  // "Instron Bluehill", ..., "table"
  NumberFormat marks{};
  bool has_marks = false;  // true if numbers are stored as words, to which the marks apply
  bool quoted = false;
  std::vector<ExportedSpecimen> specimens{};  // at least one, with at least one row
  std::vector<Metadatum> metadata{};
  ExportedTest test{};
  std::vector<std::string> notes{};      // decisions and omissions that a user should know
  std::string unplaced{};                // titles that match no column; also one of the notes
  std::vector<std::string> row_notes{};  // notes on rows and titles that an evaluation repeats; included in notes
};

// The test as the file describes it; for one specimen, with its own metadata.
std::vector<Metadatum> all_metadata(const Export& file);

// Recognises the content of a file from its bytes.
// Fails:      InputError with file, line and remedy: an empty file, no numbers, indistinguishable
//             columns.
Export export_in(std::string bytes, const std::string& source, const ExportOptions& options = {});

// Reads a file; "-" is standard input.
Export read_export(const std::string& path, const ExportOptions& options = {});

// The values of a column in SI; NaN if a cell holds no number.
// Fails:      InputError for a missing unit or a unit of another kind, such as a force in volts.
//             `remedy` returns the remedy for a unit; by default it is the flag of the role.
std::vector<double> in_si(const Export& file, const ExportColumn& column, const Kind& kind);
std::vector<double> in_si(const Export& file, const ExportColumn& column, const Kind& kind, std::string_view usual_unit,
                          const std::function<std::string(std::string_view unit)>& remedy);

// Rows in which a used column has no number, and the note on them; empty without such rows.
struct RowsLeftOut {
  std::vector<std::size_t> rows;  // from 0, ascending
  std::string words;
};

// Fails:      InputError with the lines if over a tenth of the rows have no number, or if a cell
//             reports an overload (says_overload) and readings follow in its column.
RowsLeftOut rows_without_numbers(const Export& file, const ExportedSpecimen& specimen,
                                 const std::vector<const ExportColumn*>& columns, std::size_t rows_used);

// The questions that columns leave open.
std::vector<OpenQuestion> questions_of(const std::vector<ExportColumn>& columns);

// True if a title is the name of a column, or its name with its unit: "Force", "Force [kN]", "Force (kN)", "Force_kN".
bool is_called(const ExportColumn& column, std::string_view title);

// The index of the column that a flag names: by number as in repeat_with, by name, or by name and
// unit.
// Fails:      InputError if no column or several columns have this name.
std::size_t column_named(const Export& file, const ExportedSpecimen& specimen, std::string_view wanted,
                         std::string_view flag);

// The column with a role. The default remedy is the flag of the role.
// Fails:      InputError if no column or several columns have the role.
const ExportColumn& column_with(const Export& file, const ExportedSpecimen& specimen, ColumnRole role,
                                std::string remedy = "");

}  // namespace flexslip
