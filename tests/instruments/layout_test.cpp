#include "instruments/layout.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "instruments/export.h"
#include "tests/has.h"
#include "tests/refusal.h"

using namespace flexslip;

namespace {

constexpr int rows = 20;

// A bar whose force [N] is 20 times its deflection [mm], read at 2 Hz.
double time_of(int row) { return 0.5 * row; }
double deflection_of(int row) { return 0.05 * row; }
double force_of(int row) { return deflection_of(row) * 20; }

using RowText = std::function<std::string(int row)>;

std::string table(const std::string& above, const RowText& text) {
  std::string all = above + "\n";
  for (int row = 0; row < rows; ++row) all += text(row) + "\n";
  return all;
}

// Time, force and deflection, each behind the separator but the first.
RowText cells(const std::string& separator, const std::string& before = "", const std::string& behind = "") {
  return [=](int row) {
    return fmt::format("{3}{0:.1f}{5}{1:.3f}{5}{2:.3f}{4}", time_of(row), force_of(row), deflection_of(row), before,
                       behind, separator);
  };
}

RowText counted(const std::string& separator) {
  return [=](int row) { return fmt::format("{}{}{}", row + 1, separator, cells(separator)(row)); };
}

bool is_one(const ExportColumn& column, const std::string& unit, double (*value)(int)) {
  bool are_all = column.unit == unit && column.values.size() == rows;
  for (int row = 0; are_all && row < rows; ++row)
    are_all = std::abs(column.values[static_cast<std::size_t>(row)] - value(row)) < 1e-9;  // of decimals that are exact
  return are_all;
}

// Does a file say which column is the force, and which the deflection, in N and mm?
bool is_understood(const std::string& text) {
  const Export file = export_in(text, "e.csv");
  const ExportedSpecimen& specimen = file.specimens.back();
  return specimen.asks.empty() && is_one(column_with(file, specimen, ColumnRole::force), "N", force_of) &&
         is_one(column_with(file, specimen, ColumnRole::deflection), "mm", deflection_of);
}

// What is said of a file of whose columns nothing is known; empty if something is.
std::string asked_of(const std::string& text) {
  const Export file = export_in(text, "e.csv");
  for (const ExportColumn& column : file.specimens.front().columns)
    if (column.role != ColumnRole::other) return "";
  return fmt::format("{}", file.row_notes.empty() ? "" : file.row_notes.back());
}

}  // namespace

TEST_CASE("layout: titles are told to columns by the separator of the rows alone (table)") {
  const std::string words = "Elapsed time [s]\tForce of the cell [N]\tDeflection at midspan [mm]";
  CHECK(is_understood(table(words, cells("\t"))));
  CHECK(is_understood(table(words, cells("\t", "", "\t"))));
  CHECK(is_understood(table(words + "\t", cells("\t", "", "\t"))));
  CHECK(is_understood(table("Time (s),Load cell (N),Deflection (mm)", cells(",", "", ","))));
  CHECK(is_understood(table("Time,Load cell,Deflection\ns,N,mm", cells(",", "", ","))));
  CHECK(is_understood(table("Zeit [s];Kraft [N];Durchbiegung [mm]", cells(";", "", ";"))));
  CHECK(is_understood(table("Time (s),Force (N),Deflection (mm)", cells("\t"))));
}

TEST_CASE("layout: a last title without cells is no column (table)") {
  CHECK(is_understood(table("Time (s)\tForce (N)\tDeflection (mm)\tComment", cells("\t"))));
  CHECK(is_understood(table("Time\tForce\tDeflection\tBemerkung\ns\tN\tmm\t", cells("\t"))));
  CHECK(is_understood(table("X_Value\tForce [N]\tDeflection [mm]\tComment", cells("\t"))));
}

TEST_CASE("layout: names and numbers of rows need no title (table)") {
  CHECK(is_understood(table("Time_s Force_N Deflection_mm", counted(" "))));
  CHECK(is_understood(table("Time Force Deflection\ns N mm", counted(" "))));
  CHECK(is_understood(table("\"Time (s)\" \"Force (N)\" \"Deflection (mm)\"", counted(" "))));
  CHECK(is_understood(table("Force [N] Elapsed time [s] Deflection [mm]", [](int row) {
    return fmt::format("{} {:.3f} {:.1f} {:.3f}", row + 1, force_of(row), time_of(row), deflection_of(row));
  })));
  CHECK(is_understood(table("Time (s),Force (N),Deflection (mm)",
                            [](int row) { return fmt::format("bar{},{}", row, cells(",")(row)); })));
}

TEST_CASE("layout: titles that cannot be told to columns are said and none is used, never moved (table)") {
  CHECK(has(asked_of(table("No.,Time (s),Force (N),Deflection (mm)", cells(","))), "line 1 has 4 titles"));
  CHECK(has(asked_of(table("No.,Time (s),Force (N),Deflection (mm)", cells(",", "", ","))), "line 1 has 4 titles"));
  CHECK(has(asked_of(table("Time (s),Strain (%),Force (N),Deflection (mm)", cells(","))), "above rows of 3 cells"));
  CHECK(has(asked_of(table("Time (s),Force (N)", cells(","))), "line 1 has 2 titles"));
  CHECK(has(asked_of(table("Force\tDeflection\tComment",
                           [](int row) { return fmt::format("\t{:.3f}\t{:.3f}", force_of(row), deflection_of(row)); })),
            "line 1 has 3 titles"));
}

TEST_CASE("layout: lines of settings above the titles are no specimen (table)") {
  const std::string settings = "beam 7\nA7;beam;50.000;40.000;0.0;0.0\n";
  const std::string titles = "Index;Element;Marker;Time;Kraft;Durchbiegung\n;;;s;N;mm";
  const Export file = export_in(
      table(settings + titles, [](int row) { return fmt::format("{};1;1;{}", row + 1, cells(";")(row)); }), "e.txt");
  REQUIRE(file.specimens.size() == 1);
  CHECK(file.specimens.front().lines.size() == rows);
  CHECK(is_one(column_with(file, file.specimens.front(), ColumnRole::force), "N", force_of));
  const std::string labview =
      "Channels\t2\t\t\nSamples\t20\t20\t\nDate\t2024/01/01\t2024/01/01\t\nX0\t0.0E+0\t0.0E+0\t\nDelta_X\t0.5\t0.5\t\n";
  const Export unclear =
      export_in(table(labview + "Force [N]\tDeflection [mm]\tComment",
                      [](int row) { return fmt::format("\t{:.3f}\t{:.3f}", force_of(row), deflection_of(row)); }),
                "e.lvm");
  CHECK(has(unclear.unplaced, "has 3 titles"));
  CHECK(unclear.specimens.size() == 1);
  CHECK(unclear.specimens.front().lines.size() == rows);
  CHECK(is_understood(table(labview + "X_Value\tForce [N]\tDeflection [mm]\tComment", cells("\t"))));
}

TEST_CASE("layout: a number before titles is that of the specimen (table)") {
  for (const std::string before : {"", "1"}) {
    std::string text;
    for (const int specimen : {1, 2})
      text += table(fmt::format("{},Time,Force,Deflection\n,(s),(N),(mm)", specimen),
                    cells(",", before.empty() ? "," : fmt::format("{},", specimen)));
    const Export file = export_in(text, "e.csv");
    REQUIRE(file.specimens.size() == 2);
    CHECK(file.specimens[0].name == "1");
    CHECK(file.specimens[1].name == "2");
    CHECK(is_understood(text));
  }
}

TEST_CASE("layout: labels before titles and units are neither (table)") {
  CHECK(is_understood(table("Channel name,Time,Force,Deflection\nUnit,s,N,mm", cells(",", ","))));
  CHECK(is_understood(table("Channel name,Time,Force,Deflection\nUnit,s,N,mm", cells(","))));
  CHECK(is_understood(table("Kanalname:;Zeit;Kraft;Durchbiegung\nEinheit:;s;N;mm", counted(";"))));
  CHECK(is_understood(table("Channel name,Force,Channel name,Deflection\nUnit,N,Unit,mm", [](int row) {
    return fmt::format("{0:.1f},{1:.3f},{0:.1f},{2:.3f}", time_of(row), force_of(row), deflection_of(row));
  })));
}

TEST_CASE("layout: a first row on the line of the titles, or of the units, is left out and said (table)") {
  const auto without_end = [](std::string text) { return text.erase(text.find('\n', text.find("mm")), 1); };
  for (const std::string above : {"Time (s)\tForce (N)\tDeflection (mm)", "Time\tForce\tDeflection\ns\tN\tmm"}) {
    const Export file = export_in(without_end(table(above, cells("\t"))), "e.csv");
    CHECK(file.specimens.front().lines.size() == rows - 1);
    CHECK(file.specimens.front().asks.empty());
    CHECK(has(file.row_notes.back(), "has titles and the first row"));
  }
}

TEST_CASE("layout: numbers beside the units of a table are none (table)") {
  const std::string text = table("Time\tForce\tDeflection\t\t\nSec\tN\tmm\t-0.081\t-5.86",
                                 [](int row) { return cells("\t")(row) + "\t\t"; });
  CHECK(is_understood(text));
  for (const ExportColumn& column : export_in(text, "e.csv").specimens.front().columns)
    CHECK(column.unit.find('.') == std::string::npos);
}

TEST_CASE("layout: words of the preamble between blocks of rows are no row with one number (table)") {
  std::string text = "Counts\t0\t\nTime\tForce\tDeflection\ns\tN\tmm\n";
  for (int row = 0; row < rows; ++row) {
    if (row == 8 || row == 16) text += "Counts\t0\t\n";
    text += cells("\t")(row) + "\n";
  }
  CHECK(is_understood(text));
  const Export file = export_in(text, "e.csv");
  CHECK(has(file.row_notes.back(), "do not have 3 cells: lines 12, 21"));
  // A sensor that failed is a row.
  const std::size_t at = text.find("Counts", 10);
  CHECK(export_in(text.replace(at, 6, "Failed"), "e.csv").specimens.front().lines.size() == rows + 1);
}

TEST_CASE("layout: rows go on behind a remark, or their titles once more (table)") {
  const std::string titles = "Time [s];Force [N];Deflection [mm]";
  const auto with = [&](const std::string& between, double pause) {
    std::string text = titles + "\n";
    for (int row = 0; row < rows; ++row) {
      if (row == rows * 3 / 4) text += between;
      text += fmt::format("{:.1f};{:.3f};{:.3f}\n", time_of(row) + (row < rows * 3 / 4 ? 0 : pause), force_of(row),
                          deflection_of(row));
    }
    return export_in(text, "e.csv");
  };
  for (const std::string& between : {std::string("Pause\n"), std::string("Comment;paused by the operator\n"),
                                     titles + "\n", "Pause\n\n" + titles + "\nresumed\n"}) {
    INFO(between);
    const Export file = with(between, 100);
    REQUIRE(file.specimens.size() == 1);
    CHECK(is_one(column_with(file, file.specimens.front(), ColumnRole::force), "N", force_of));
    CHECK(std::any_of(file.notes.begin(), file.notes.end(),
                      [](const std::string& note) { return has(note, "left out, because they do not have 3 cells"); }));
  }
  const Export other = with("Time [s];Position [mm];Stress [MPa]\n", 100);
  CHECK(other.specimens.front().columns.front().values.size() == rows * 3 / 4);
}

TEST_CASE(
    "layout: titles once more above rows that begin anew are of another specimen, though a clock runs on (table)") {
  const std::string titles = "Time [s];Force [N];Deflection [mm]";
  std::string text;
  for (int specimen = 0; specimen < 2; ++specimen) {
    text += titles + "\n";
    for (int row = 0; row < rows; ++row)
      text += fmt::format("{:.1f};{:.3f};{:.3f}\n", time_of(row + specimen * rows), force_of(row), deflection_of(row));
  }
  CHECK(export_in(text, "e.csv").specimens.size() == 2);
  std::string back;  // each goes back to where it began
  for (int specimen = 0; specimen < 2; ++specimen) {
    back += titles + "\n";
    for (int row = 0; row < 2 * rows; ++row)
      back += fmt::format("{:.1f};{:.3f};{:.3f}\n", time_of(row + 2 * specimen * rows),
                          force_of(row < rows ? row : 2 * rows - 1 - row),
                          deflection_of(row < rows ? row : 2 * rows - 1 - row));
  }
  CHECK(export_in(back, "e.csv").specimens.size() == 2);
}
