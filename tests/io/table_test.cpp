#include "io/table.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <rapidcheck.h>

#include "io/input_error.h"
#include "io/text.h"
#include "tests/has.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

using namespace flexslip;

namespace {

const std::vector<WantedColumn> stage_and_force{{"w_s_m [m]", kind::length}, {"F_N [N]", kind::force}};
const std::vector<WantedColumn> x_and_y{{"x", kind::number}, {"y", kind::number}};

Table read(const std::string& text, const std::vector<WantedColumn>& wanted = x_and_y, char decimal = '.') {
  return table_in(text, "t.csv", wanted, decimal);
}

std::string complaint(const std::string& text, const std::vector<WantedColumn>& wanted = x_and_y, char decimal = '.') {
  try {
    read(text, wanted, decimal);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string complaint_about_file(const std::string& path, const std::vector<WantedColumn>& wanted, char decimal) {
  try {
    read_table(path, wanted, decimal);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

using Values = std::vector<double>;

using Rows = std::vector<std::vector<Cell>>;

NextRow rows_of(Rows rows) {
  return [rows = std::move(rows), i = std::size_t{0}](std::vector<Cell>& cells) mutable {
    if (i == rows.size()) return false;
    cells = rows[i++];
    return true;
  };
}

}  // namespace

TEST_CASE("table: the wanted columns in the wanted order, in SI, whatever else the file holds") {
  const Table table = read("w_s_m,note,F_N\n0,start,0\n2e-06,\"a, b\",4.5e-05\n",
                           {{"F_N [mN]", kind::force}, {"w_s_m [mm]", kind::length}});
  REQUIRE(table.columns.size() == 2);
  CHECK(table.columns[0].name == "F_N");
  CHECK(table.columns[0].values == Values{0, 4.5e-5 / 1e3});
  CHECK(table.columns[1].values == Values{0, 2e-6 / 1e3});
  CHECK(table.rows() == 2);
}

TEST_CASE("table: every way of separating cells and ending lines gives the same numbers") {
  const Table expected = read("x,y\n1,2\n3,4.5\n");
  CHECK(expected.columns[0].values == Values{1, 3});
  CHECK(expected.columns[1].values == Values{2, 4.5});
  const std::vector<std::string> same{
      "\xEF\xBB\xBFx,y\n1,2\n3,4.5\n",  // byte order mark
      "x,y\r\n1,2\r\n3,4.5\r\n",        // Windows
      "x,y\r1,2\r3,4.5\r",              // old Macintosh
      std::string("\xFF\xFEx\0,\0y\0\n\0"
                  "1\0,\0"
                  "2\0\n\0"
                  "3\0,\0"
                  "4\0.\0"
                  "5\0\n\0",
                  30),                          // UTF-16
      "x,y\n1,2\n3,4.5",                        // no line ending at the end
      "x;y\n1;2\n3;4.5\n",                      //
      "x\ty\n1\t2\n3\t4.5\n",                   //
      "  x   y\n 1 2 \n3 \t 4.5\n",             // aligned with spaces
      "\"x\",\"y\"\n\"1\",\"2\"\n\"3\",4.5\n",  // quoted
      "\"x\" \"y\"\n\"1\" 2\n3 \"4.5\"\n",      //
      "# made by hand\n\nx,y\n\n1,2\n# middle\n3,4.5\n\n",
      "x , y\n 1 ,\t2\n+3 , 45e-1 \n",
      "x,y,\n1,2,\n3,4.5,\n",     // a delimiter at the end of each line
      "x,y\n1,2\n3,4.5\n,\n,\n",  // empty rows of a spreadsheet
      "x,y\n1,2,,\n3,4.5,,\n",
  };
  for (const std::string& text : same) {
    const Table table = read(text);
    CHECK_MESSAGE(table.columns[0].values == expected.columns[0].values, text);
    CHECK_MESSAGE(table.columns[1].values == expected.columns[1].values, text);
  }
  CHECK(read("x;y\n1;2\n3;4,5\n", x_and_y, ',').columns[1].values == expected.columns[1].values);
  CHECK(read("x,y\n\"1\",\"2\"\n\"3\",\"4,5\"\n", x_and_y, ',').columns[1].values == expected.columns[1].values);
}

TEST_CASE("table: the unit may stand in the header, in a line of units, or in what is asked for") {
  const std::vector<WantedColumn> bare{{"w", kind::length}, {"F", kind::force}};
  const std::vector<WantedColumn> full{{"w [mm]", kind::length}, {"F [kN]", kind::force}};
  for (const char* text :
       {"w [mm],F [kN]\n1,2\n", "w (mm),F (kN)\n1,2\n", "w [mm] F [kN]\n1 2\n", "w,F\n(mm),(kN)\n1,2\n",
        "w,F\n[mm],[kN]\n1,2\n", "w,F\nmm,kN\n1,2\n", "w F\nmm kN\n1 2\n", "w [mm],F [kN]\nmm,kN\n1,2\n"}) {
    CHECK_MESSAGE(read(text, bare).columns[0].values == Values{1e-3}, text);
    CHECK_MESSAGE(read(text, bare).columns[1].values == Values{2e3}, text);
    CHECK_MESSAGE(read(text, full).columns[1].values == Values{2e3}, text);
  }
  CHECK(read("w,F\n1,2\n", full).columns[0].values == Values{1e-3});
  CHECK(read("Position (m) Run #1,F\n1,2\n", {{"Position (m) Run #1 [m]", kind::length}}).columns[0].values ==
        Values{1});
  CHECK(read("mu [1],s [-]\n1,2\n", {{"mu", kind::number}, {"s", kind::number}}).columns[1].values == Values{2});
}

TEST_CASE("table: a unit may be the end of a column's name, and it is said so") {
  const Table table =
      read("w_s_m,F_mN,n_1\n1,2,3\n", {{"w_s_m", kind::length}, {"F_mN", kind::force}, {"n_1", kind::number}});
  CHECK(table.columns[0].values == Values{1});
  CHECK(table.columns[1].values == Values{2e-3});
  CHECK(table.columns[2].values == Values{3});
  REQUIRE(table.notes.size() == 2);
  CHECK(table.notes[1] == "the unit of 'F_mN' is the end of its name, mN");
  // The name without it will do, where it is that of one column, and another unit is not asked for.
  CHECK(read("w_s_mm,F_mN\n1,2\n", {{"w_s", kind::length}, {"F", kind::force}}).columns[0].values == Values{1e-3});
  CHECK(read("F_N,F_mN\n1,2\n", {{"F_mN", kind::force}}).columns[0].values == Values{2e-3});
  CHECK(complaint("F_N,F_mN\n1,2\n", {{"F", kind::force}}) ==
        "t.csv:1: column 'F': 2 columns have this name. Rename them.");
  for (const char* other : {"w_s [m]", "w"})
    CHECK(complaint("w_s_mm,F_mN\n1,2\n", {{other, kind::length}}).find("the file has 'w_s_mm' and 'F_mN'") !=
          std::string::npos);
  CHECK(read("w_m\nmm\n1\n", {{"w_m", kind::length}}).columns[0].values == Values{1e-3});  // stated elsewhere
  CHECK(has(complaint("w_s,F\n1,2\n", {{"w_s", kind::length}}), "No unit is stated, but a unit of length is needed"));
  CHECK(complaint("F_N,w_m\n1,2\n", {{"F_N", kind::length}}) ==
        "t.csv:1: column 'F_N': The name ends in 'N', which is not a unit of length. If it is a length all the same, "
        "name it with its unit, such as \"F_N [m]\".");
}

TEST_CASE("table: units that are missing, wrong or at odds are refused") {
  CHECK(complaint("w,F\n1,2\n", {{"w", kind::length}}) ==
        "t.csv:1: column 'w': No unit is stated, but a unit of length is needed. Name it with its unit, such as \"w "
        "[m]\".");
  CHECK(complaint("w [N],F\n1,2\n", {{"w", kind::length}}) ==
        "t.csv:1: column 'w': The unit 'N' measures a force, but a unit of length is needed. Write \"nm\", \"um\", "
        "\"mm\" or \"m\".");
  CHECK(complaint("w [mm],F\n1,2\n", {{"w [m]", kind::length}}) ==
        "t.csv:1: column 'w': The units 'm' and 'mm' contradict each other. The file and the title asked for must "
        "agree.");
  CHECK(has(complaint("w,F\nmm,V\n1,2\n", {{"F", kind::force}}), "'V' is not a unit"));
  CHECK(
      has(complaint("w [m],F\n1,2\n", {{"w", kind::number}}), "The unit 'm' measures a length, but no unit is needed"));
  CHECK(has(complaint("w,F\n1,2\n", {{"w [parsec]", kind::length}}), "'parsec' is not a unit"));
}

TEST_CASE("table: bad cells are refused with line and column") {
  CHECK(complaint("w_s_m;F_N\n0;0\n0;12,5\n", stage_and_force) ==
        "t.csv:3: column 'F_N': '12,5' is not a number. Write decimal points, or pass --decimal ,");
  CHECK(complaint("x,y\n1,2\n\n# note\n3,nan\n") ==
        "t.csv:5: column 'y': 'nan' is not a finite number. Delete the line.");
  CHECK(has(complaint("x,y\n1,-inf\n"), "t.csv:2: column 'y': '-inf' is not a finite number"));
  CHECK(has(complaint("x,y\n1,1e999\n"), "'1e999' is not a finite number"));
  CHECK(has(complaint("x,y\n1,2\n,3\n"), "t.csv:3: column 'x': The cell is empty"));
  CHECK(has(complaint("x,y\n1,2\n3,12 mm\n"), "t.csv:3: column 'y': '12 mm' is not a number"));
  CHECK(has(complaint("x,y\n1,2\n3,\"1,234.5\"\n"), "Write no thousands separators"));
  CHECK(has(complaint("x;y\n1;1,000,292\n", x_and_y, ','), "Write no thousands separators"));
  CHECK(has(complaint("x;y\n1;1.234,5\n", x_and_y, ','), "Write no thousands separators"));
  CHECK(has(complaint("x;y\n1;1.234\n", x_and_y, ','), "Write decimal commas, or leave out --decimal ,"));
  CHECK(complaint("x,y\n1,2\n0,5,1,5\n") ==
        "t.csv:3: The line has 4 cells, but the header on line 1 has 2. If these are decimal commas, write decimal "
        "points, or separate cells by ; and pass --decimal ,");
  CHECK(has(complaint("x,y\n1,2\n3\n"), "t.csv:3: The line has 1 cell, but the header on line 1 has 2"));
  CHECK(has(complaint("x,y\n1,\"2\n3,4\n"), "t.csv:2: Cell 2 holds a stray quote"));
  CHECK(has(complaint("x,y\n1,\"2\"3\n"), "Cell 2 holds a stray quote"));
}

TEST_CASE("table: what is no table is refused as what it is") {
  CHECK(complaint("") == "t.csv: The file is empty.");
  CHECK(complaint("\xEF\xBB\xBF") == "t.csv: The file is empty.");
  CHECK(has(complaint("# only a comment\n\n"), "No line of the file has content"));
  CHECK(complaint("x,y\n") == "t.csv:1: The file has a header only, and no rows of numbers.");
  CHECK(has(complaint("x,y\nmm,mm\n", {{"x", kind::length}}), "The file has a header only"));
  CHECK(has(complaint("1,2\n3,4\n"), "t.csv:1: This line holds numbers, where the names of the columns are needed"));
  CHECK(has(complaint(std::string("x,y\n1,2\n\0\0\0", 11)), "t.csv:3: The file holds binary data"));
  CHECK(has(complaint(std::string("\x89PNG\r\n\x1a\n\0\0", 10)), "binary data"));
}

TEST_CASE("table: a column that is not there is refused with those that are") {
  CHECK(complaint("w_s_m,w0_m,F_N\n0,0,0\n", {{"F_M [N]", kind::force}}) ==
        "t.csv:1: column 'F_M': No column has this name; the file has 'w_s_m', 'w0_m' and 'F_N'. Did you mean 'F_N'?");
  CHECK(has(complaint("x,x,y\n1,2,3\n"), "column 'x': 2 columns have this name"));
  CHECK(has(complaint("x,y\n1,2\n", {{"x", kind::number}, {"x", kind::number}}), "The same column is asked for twice"));
}

TEST_CASE("outside: files, folders and files that are not there") {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "a.csv").string();
  std::ofstream(path) << "x,y\n1,2\n";
  CHECK(read_table(path, x_and_y).columns[1].values == Values{2});
  CHECK_THROWS_WITH_AS(read_table(folder.path().string(), x_and_y),
                       (folder.path().string() + ": This is a directory, not a file.").c_str(), InputError);
  CHECK_THROWS_WITH_AS(
      read_table(path + "x", x_and_y),
      (path + "x: The file cannot be read: No such file or directory. Did you mean '" + path + "'?").c_str(),
      InputError);
  const std::string beside = (folder.path() / "other.toml").string();
  CHECK_THROWS_WITH_AS(read_table(beside, x_and_y),
                       (beside + ": The file cannot be read: No such file or directory. It was looked for in '" +
                        folder.path().string() + "'.")
                           .c_str(),
                       InputError);
  CHECK_THROWS_AS(write_table((folder.path() / "none" / "b.csv").string(), {"x"}, rows_of({})), InputError);
}

TEST_CASE("limit: one point is a table; whether it is a test is for others to say") {
  CHECK(read("x,y\n1,2\n").rows() == 1);
}

TEST_CASE("oracle: the line of every row, against a count by hand") {
  CHECK(read("# c\nx,y\n\n1,2\n3,4\n#\n\n5,6\n7,8\n").lines == std::vector<std::size_t>{4, 5, 8, 9});
}

TEST_CASE("limit: a table much longer than the lines by which its cells are estimated") {
  const TemporaryFolder folder;
  std::string text = "x,y\n";
  const std::size_t rows = 300'000;
  for (std::size_t i = 0; i < rows; ++i) text += std::to_string(i) + "," + std::to_string(i) + ".25\n";
  const Table table = read_table(folder.file("a.csv", text), x_and_y);
  REQUIRE(table.rows() == rows);
  bool same = true;
  for (std::size_t i = 0; i < rows; ++i)
    same = same && table.columns[0].values[i] == static_cast<double>(i) &&
           table.columns[1].values[i] == static_cast<double>(i) + 0.25;
  CHECK(same);
  CHECK(table.lines.back() == rows + 1);
}

TEST_CASE("identity: what is written is read back to the last bit") {
  CHECK(rc::check("read(write(x)) = x", [](const Values& values) {
    RC_PRE(!values.empty());
    std::ostringstream out;
    Rows rows;
    for (const double value : values) rows.push_back({value, value});
    write_table(out, {"x", "y"}, rows_of(rows));
    RC_ASSERT(read(out.str()).columns[1].values == values);
  }));
  const Values hard{5e-324, 2.2250738585072014e-308, 1.7976931348623157e308, 0.1, -0.0, 1.0 / 3, 4503599627370497.5};
  std::ostringstream out;
  Rows rows;
  for (const double value : hard) rows.push_back({value});
  write_table(out, {"F [N]"}, rows_of(rows));
  CHECK(read(out.str(), {{"F", kind::force}}).columns[0].values == hard);
}

TEST_CASE("table: the text of a written table") {
  std::ostringstream out;
  write_table(out, {"F [N]", "motion"}, rows_of({{0.0, "stick"}, {0.1, "slip, in"}, {std::nan(""), "say \"snap\""}}));
  CHECK(out.str() == "F [N],motion\n0,stick\n0.1,\"slip, in\"\nnan,\"say \"\"snap\"\"\"\n");
  CHECK_THROWS_AS(write_table(out, {"a", "b"}, rows_of({{1.0}})), std::invalid_argument);
  std::ostringstream comma;
  write_table(comma, {"F [N]", "motion"}, rows_of({{0.1, "slip, in"}, {std::nan(""), "in; out"}}), {.decimal = ','});
  CHECK(comma.str() == "F [N];motion\n0,1;slip, in\nnan;\"in; out\"\n");
}

TEST_CASE("table: titles of columns") {
  CHECK(parse_column_title("F_N [N]").name == "F_N");
  CHECK(parse_column_title("F_N [N]").unit == "N");
  CHECK(parse_column_title(" w ").name == "w");
  CHECK(parse_column_title("w (old)").name == "w (old)");
  for (const char* bad : {"", "[N]", "F []", "F [wrong]"}) CHECK_THROWS_AS(parse_column_title(bad), InputError);
}

TEST_CASE("outside: measured data, if the folder beside the repository has them") {
  const std::string folder = FLEXSLIP_SOURCE_DIR "/../shared/data/";
  if (!std::filesystem::exists(folder)) {
    MESSAGE("skipped: no campaign data");
    return;
  }
  const Table spicule = read_table(folder + "spicules/ss/SS14.csv", stage_and_force);
  CHECK(spicule.columns[0].values[1] == 1.993e-06);
  CHECK(spicule.columns[1].values[1] == 4.178397031e-05);

  const std::vector<WantedColumn> bluehill{{"Extension", kind::length}, {"Load", kind::force}};
  const Table blade = read_table(folder + "instruments/bluehill_blades/cyclic_Specimen_RawData_1.csv", bluehill);
  CHECK(blade.columns[0].values[0] == 1.25560 / 1e3);
  CHECK(blade.columns[1].values[0] == 5.16404);

  const std::vector<WantedColumn> universal{{"Displacement", kind::length}, {"Force", kind::force}};
  const std::string comma = folder + "instruments/bluehill_decimal_comma/Tensile_test_PE.csv";
  CHECK(complaint_about_file(comma, universal, '.')
            .ends_with("Tensile_test_PE.csv:3: column 'Displacement': '0,1366' is not a number. Write decimal points, "
                       "or pass --decimal ,"));
  // Where the displacement passes 1000 mm the machine itself wrote a thousands separator that is also its decimal mark.
  CHECK(complaint_about_file(comma, universal, ',')
            .ends_with("Tensile_test_PE.csv:5998: column 'Displacement': '1,000,292' is not a number. Write no "
                       "thousands separators."));

  const Table brass = read_table(folder + "instruments/pasco_brass/LA4_brass_file.csv",
                                 {{"Position (m) Run #1 [m]", kind::length}, {"Force (N) Run #1 [N]", kind::force}});
  CHECK(brass.columns[0].values[0] == 4.40547e-8);
  CHECK_THROWS_AS(read_table(folder + "instruments/mts_testsuite_empty/EMPTY_BOM_ONLY_DAQ_Timed2.txt", bluehill),
                  InputError);
}

TEST_CASE("table: words, quotes, comments, a mark of byte order, rows shorter than the header") {
  const TemporaryFolder folder;
  const auto file = folder.file(
      "table.csv",
      "\xEF\xBB\xBF# kept by hand\nname;span [um];note\r\n\"a;b\";1278;\"he said \"\"no\"\"\"\n\n# b;1;2\nc\n");
  const auto table = read_text_table(file);
  CHECK(table.titles == std::vector<std::string>{"name", "span [um]", "note"});
  CHECK(table.header_line == 2);
  REQUIRE(table.rows.size() == 2);
  CHECK(table.rows[0].line == 3);
  CHECK(table.rows[0].cells == std::vector<std::string>{"a;b", "1278", "he said \"no\""});
  CHECK(table.rows[1].line == 6);
  CHECK(table.rows[1].cells == std::vector<std::string>{"c", "", ""});
}

TEST_CASE("identity: words are read back as they were, and no spreadsheet takes them for a formula") {
  const TemporaryFolder folder;
  for (const std::string words : {"=cmd", "+1", "-1", "@x", "'=cmd", "''-1", "=", "'", "''", "'a", "a=b", "1", ""}) {
    INFO(words);
    const std::string written = without_formula(words);
    CHECK((written.empty() || std::string("=+-@").find(written.front()) == std::string::npos));
    CHECK(read_text_table(folder.file("table.csv", "name,end\n" + written + ",x\n")).rows.front().cells.front() ==
          words);
  }
  CHECK(without_formula("=cmd") == "'=cmd");
  CHECK(without_formula("SS14") == "SS14");
  CHECK(read_text_table(folder.file("table.csv", "a,b\n-1,+2.5 mm\n")).rows.front().cells ==
        std::vector<std::string>{"-1", "+2.5 mm"});
}

TEST_CASE("table: a title in brackets that is no unit is found without it, and asked for the unit that is meant") {
  const std::string text = "w (mm),Force (KN)\n1,2\n2,3\n";
  CHECK(read(text, {{"w", kind::length}, {"Force [kN]", kind::force}}).columns[1].values[0] == 2000);
  CHECK(has(complaint(text, {{"w", kind::length}, {"Force", kind::force}}),
            "'KN' is not a unit of force. If kN is meant, name it with its unit, such as \"Force [kN]\""));
}

TEST_CASE("table: what is no such table is refused with its line") {
  const auto says = [](const std::string& content) {
    const TemporaryFolder folder;
    return message_of([&] { read_text_table(folder.file("table.csv", content)); });
  };
  CHECK(says("").find("The file is empty") != std::string::npos);
  CHECK(says("a,b\n1,2,3\n").find(":2: The line has 3 cells, but the header has 2") != std::string::npos);
  CHECK(says("a,a\n").find(":1: The title 'a' occurs twice") != std::string::npos);
  CHECK(says("a,,b\n").find(":1: A column has no title") != std::string::npos);
  CHECK(says("a,b\n\"x,y\n").find(":2: Cell 1 holds a stray quote") != std::string::npos);
}
