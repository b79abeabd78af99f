// What a case says of its measured record, [record]. Units: those of a physical case (case_file.h).
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "io/table.h"

namespace flexslip {

// Columns of a table, named: two of the three are there; each is a title as read_table takes it, "F_N [N]".
struct TableColumns {
  std::optional<std::string> stage, deflection, force;
  char decimal;                         // '.' or ','
  std::optional<std::string> length{};  // pulled in over both supports, as imaged: beside the others
  bool operator==(const TableColumns&) const = default;
};

// What the displacement of an export is one of.
enum class DisplacementOf {
  crosshead,   // the stage: the load train gives way as well
  deflection,  // the specimen's midpoint
};

// An export of a testing machine, whose columns are found by what they are called.
struct ExportColumns {
  std::optional<DisplacementOf> displacement{};               // none: as the words of the file say
  std::optional<std::string> displacement_column{}, force{};  // name or number of a column that is not found
  std::optional<std::size_t> specimen{};                      // counted from 1; none: there is only one
  std::optional<std::string> calibration{};                   // of a force in volts, "222 N/V"
  std::optional<char> decimal{};
  bool operator==(const ExportColumns&) const = default;
};

// What is done to a record before it is evaluated, or left undone.
struct ToFind {
  bool operator==(const ToFind&) const = default;
};
struct ToKeep {
  bool operator==(const ToKeep&) const = default;
};
struct AtFirstRow {
  bool operator==(const AtFirstRow&) const = default;
};
struct WhereFree {
  bool operator==(const WhereFree&) const = default;
};

enum class SignRule { find, keep, reverse };
using ForceZeroRule = std::variant<ToFind, ToKeep, double>;  // [N] to be taken off
using ContactRule =
    std::variant<WhereFree, ToFind, AtFirstRow, double>;  // to be found if rows lie before it, or in any
                                                          // case; or [m] displacement at first contact
// Where a record begins or ends: a row of the file, counted from 1, or where the stage or the deflection, as the file counts them, is there.
struct AtRow {
  std::size_t row;
  bool operator==(const AtRow&) const = default;
};
struct AtStage {
  double position;  // [m]
  bool operator==(const AtStage&) const = default;
};
struct AtDeflection {
  double position;  // [m]
  bool operator==(const AtDeflection&) const = default;
};
using PlaceInRecord = std::variant<AtRow, AtStage, AtDeflection>;

struct RecordInput {
  std::string file;                    // relative to the working directory
  std::optional<SheetChoice> sheet{};  // of a workbook; none: the first with a table of numbers
  std::variant<TableColumns, ExportColumns> columns;
  SignRule sign = SignRule::find;
  ForceZeroRule zero = ToFind{};
  ContactRule contact = WhereFree{};
  bool find_failure = true;
  std::optional<PlaceInRecord> first{};  // where the record begins; none: with its first row
  std::optional<PlaceInRecord> until{};  // where it ends, before failure
  // What a call holds in memory instead of a file: the columns named, in SI and in their order here; `file` is a name for messages.
  std::shared_ptr<const Table> given{};
  bool operator==(const RecordInput&) const = default;
};

}  // namespace flexslip
