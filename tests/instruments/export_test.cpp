#include "instruments/export.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "instruments/export_fields.h"
#include "io/input_error.h"
#include "io/text_file.h"
#include "tests/has.h"
#include "tests/instruments/export_files.h"
#include "tests/refusal.h"

using namespace flexslip;

namespace {

using enum ColumnRole;

struct ExpectedColumn {
  std::string name, unit;
  ColumnRole role;
  double first, last;  // [unit]; not looked at for words
};

struct ExpectedExport {
  std::string file, format;
  Encoding encoding;
  char separator, decimal;
  std::size_t rows, first_line;
  std::vector<ExpectedColumn> columns;
};

std::string complaint(const std::string& bytes, const ExportOptions& options = {}) {
  try {
    export_in(bytes, "e.csv", options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool same_bits(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

void check(const Export& found, const ExpectedExport& wanted) {
  CAPTURE(wanted.file);
  CHECK(found.format == wanted.format);
  CHECK(found.origin.encoding == wanted.encoding);
  CHECK(found.origin.separator == wanted.separator);
  CHECK(found.marks.decimal == wanted.decimal);
  const ExportedSpecimen& specimen = found.specimens.front();
  CHECK(specimen.lines.size() == wanted.rows);
  CHECK(specimen.lines.front() == wanted.first_line);
  REQUIRE(specimen.columns.size() == wanted.columns.size());
  for (std::size_t i = 0; i < wanted.columns.size(); ++i) {
    const ExportColumn& column = specimen.columns[i];
    CAPTURE(wanted.columns[i].name);
    CHECK(column.name == wanted.columns[i].name);
    CHECK(column.unit == wanted.columns[i].unit);
    CHECK(column.role == wanted.columns[i].role);
    if (!column.words.empty()) continue;
    CHECK(same_bits(column.values.front(), wanted.columns[i].first));
    CHECK(same_bits(column.values.back(), wanted.columns[i].last));
  }
}

std::string canonical(const Export& file, std::size_t specimen = 0) {
  std::ostringstream out;
  write_canonical(out, file, file.specimens[specimen]);
  return out.str();
}

// Written, read and written again: the same columns and bits, the same bytes.
void check_round_trip(const Export& file) {
  CAPTURE(file.origin.source);
  for (std::size_t i = 0; i < file.specimens.size(); ++i) {
    const std::string written = canonical(file, i);
    ExportOptions options;
    for (const ExportColumn& column : file.specimens[i].columns)
      if (column.role == force) options.columns[force] = column.name;  // or a second load cell would be asked for again
    const Export again = export_in(written, "canonical", options);
    REQUIRE(again.specimens.size() == 1);
    REQUIRE(again.specimens.front().columns.size() == file.specimens[i].columns.size());
    for (std::size_t c = 0; c < file.specimens[i].columns.size(); ++c) {
      const ExportColumn& a = file.specimens[i].columns[c];
      const ExportColumn& b = again.specimens.front().columns[c];
      CHECK(a.name == b.name);
      CHECK(a.unit == b.unit);
      CHECK(a.words == b.words);
      REQUIRE(a.values.size() == b.values.size());
      bool same = true;
      for (std::size_t row = 0; row < a.values.size(); ++row) same = same && same_bits(a.values[row], b.values[row]);
      CHECK(same);
    }
    CHECK(canonical(again) == written);
  }
}

const std::string curve_as_csv = "Time [s],Stroke [mm],Load [N]\n0.0,0.00,1.5\n0.1,0.01,2.5\n0.2,0.02,3.25\n";

// Of the curve in make_fixtures.py: its last row.
constexpr double t39 = 3.9, d39 = 0.78, f39 = 1407.9;

const std::vector<ExpectedExport> made{
    {"shimadzu.csv",
     "Shimadzu Trapezium",
     Encoding::shift_jis,
     ',',
     '.',
     40,
     17,
     {{"時間", "s", ColumnRole::time, 0, t39},
      {"試験力", "N", force, 0, f39},
      {"ストローク", "mm", crosshead, 0, d39}}},
    {"zwick.csv",
     "Zwick testXpert",
     Encoding::cp1252,
     ';',
     ',',
     40,
     69,
     {{"Prüfzeit", "s", ColumnRole::time, 0, t39},
      {"Standardkraft", "N", force, 0, f39},
      {"Traversenweg", "mm", crosshead, 0, d39}}},
    {"utf16le.txt",
     "table",
     Encoding::utf16le,
     '\t',
     ',',
     40,
     2,
     {{"Zeit", "s", ColumnRole::time, 0, t39},
      {"Traversenweg", "mm", crosshead, 0, d39},
      {"Kraft", "N", force, 0, f39}}},
    {"utf16be.txt",
     "table",
     Encoding::utf16be,
     '\t',
     ',',
     40,
     2,
     {{"Zeit", "s", ColumnRole::time, 0, t39},
      {"Traversenweg", "mm", crosshead, 0, d39},
      {"Kraft", "N", force, 0, f39}}},
    {"utf16le_without_mark.txt",
     "table",
     Encoding::utf16le,
     '\t',
     ',',
     40,
     2,
     {{"Zeit", "s", ColumnRole::time, 0, t39},
      {"Traversenweg", "mm", crosshead, 0, d39},
      {"Kraft", "N", force, 0, f39}}},
    {"utf16be_without_mark.txt",
     "table",
     Encoding::utf16be,
     '\t',
     ',',
     40,
     2,
     {{"Zeit", "s", ColumnRole::time, 0, t39},
      {"Traversenweg", "mm", crosshead, 0, d39},
      {"Kraft", "N", force, 0, f39}}},
    {"bluehill_universal.csv",
     "Instron Bluehill",
     Encoding::utf8,
     ',',
     '.',
     40,
     8,
     {{"Time", "s", ColumnRole::time, 0, t39},
      {"Displacement", "mm", displacement, -0.0, -d39},
      {"Force", "kN", force, -0.0, -1.4079}}},
    {"bluehill_thousands.csv",
     "Instron Bluehill",
     Encoding::utf8,
     ',',
     '.',
     40,
     3,
     {{"Time", "s", ColumnRole::time, 0, t39},
      {"Extension", "mm", displacement, 0, d39},
      {"Load", "N", force, 0, f39}}},
    {"mts_testsuite.txt",
     "MTS TestSuite",
     Encoding::utf8,
     '\t',
     '.',
     40,
     9,
     {{"Running Time", "sec", ColumnRole::time, 0, t39},
      {"Crosshead", "mm", crosshead, -0.0, -d39},
      {"Load", "kN", force, -0.0, -1.4079}}},
    {"mts_blocks.dat",
     "MTS 793",
     Encoding::utf8,
     ' ',
     '.',
     40,
     7,
     {{"Ch 1 Displacement", "mm", displacement, 0, d39},
      {"Ch 1 Force", "N", force, 0, f39},
      {"Time", "Sec", ColumnRole::time, 0, t39}}},
    {"force_gauge.csv",
     "table",
     Encoding::utf8,
     ',',
     '.',
     40,
     1,
     {{"column_1", "s", ColumnRole::time, 0, t39}, {"column_2", "N", force, 0, f39}}},
    {"force_gauge_columns.csv",
     "table",
     Encoding::utf8,
     ',',
     '.',
     40,
     1,
     {{"column_1", "N", force, 0, f39}, {"column_3", "", other, 0, d39}, {"column_4", "", other, 0, 39}}},
    {"texture_analyser.txt",
     "table",
     Encoding::utf8,
     ' ',
     '.',
     40,
     7,
     {{"Time", "sec", ColumnRole::time, 0, t39},
      {"Deflection", "mm", deflection, 0, d39},
      {"Load", "N", force, 0, f39}}},
    {"wintest.csv",
     "table",
     Encoding::utf8,
     ',',
     '.',
     40,
     22,
     {{"Points", "", other, 1, 40},
      {"Elapsed Time", "Sec", ColumnRole::time, 0, t39},
      {"Disp", "mm", displacement, 0, d39},
      {"Load", "N", force, 0, f39},
      {"Axial cmd", "V", other, 0, 0.078}}},
    {"no_header.csv",
     "table",
     Encoding::utf8,
     ',',
     '.',
     40,
     1,
     {{"column_1", "", other, 0, t39}, {"column_2", "", other, 0, d39}, {"column_3", "", other, 0, f39}}},
};

// Rows counted with wc, first and last values read off with head and tail.
const std::vector<ExpectedExport> published{
    {"bluehill3_maize/1267_Specimen_RawData_1.csv",
     "Instron Bluehill",
     Encoding::utf8,
     ',',
     '.',
     1133,
     11,
     {{"Time", "s", ColumnRole::time, 0, 113.117},
      {"Extension", "mm", displacement, 0, 1.88478},
      {"Load", "N", force, 0.37230, 6.60741}}},
    {"bluehill3_maize/1267_Specimen_RawData_2.csv",
     "Instron Bluehill",
     Encoding::utf8,
     ',',
     '.',
     1882,
     11,
     {{"Time", "s", ColumnRole::time, 0, 187.598},
      {"Extension", "mm", displacement, 0.00383, 3.12973},
      {"Load", "N", force, 0.20694, 5.45618}}},
    {"bluehill_blades/WSR8001_july25_lateral.csv",
     "Instron Bluehill",
     Encoding::utf8,
     ',',
     '.',
     3004,
     5,
     {{"Time", "s", ColumnRole::time, 0, 30.022},
      {"Extension", "mm", displacement, 0, 5.00001},
      {"Load", "N", force, 2.75764, 610.74622}}},
    {"bluehill_blades/cyclic_Specimen_RawData_1.csv",
     "Instron Bluehill",
     Encoding::utf8,
     ',',
     '.',
     222,
     3,
     {{"Time", "s", ColumnRole::time, 0, 21.926},
      {"Extension", "mm", displacement, 1.25560, 2.38013},
      {"Load", "N", force, 5.16404, -0.00675}}},
    {"mts793_pla/1_3D850_s1.dat",
     "MTS 793",
     Encoding::utf8,
     ' ',
     '.',
     6305,
     9,
     {{"Ch 1 Displacement", "mm", displacement, 0.00015497208, -4.1043639},
      {"Ch 1 Force", "kN", force, -1.6205013e-05, 0.00035503181},
      {"Time", "Sec", ColumnRole::time, 0.034179688, 123.15918}}},
    {"mts793_pla/4_3Devo_s1.dat",
     "MTS 793",
     Encoding::utf8,
     ' ',
     '.',
     7267,
     9,
     {{"Ch 1 Displacement", "mm", displacement, 0.00048279762, -4.7325583},
      {"Ch 1 Force", "kN", force, 3.7427526e-05, 0.00049469527},
      {"Time", "Sec", ColumnRole::time, 0.053710938, 141.96777}}},
    {"mts793_pla/7_CR10_s1.dat",
     "MTS 793",
     Encoding::utf8,
     ' ',
     '.',
     12050,
     9,
     {{"Ch 1 Displacement", "mm", displacement, 0.00021159649, -7.8439116},
      {"Ch 1 Force", "kN", force, 0.0004938338, -0.028674968},
      {"Time", "Sec", ColumnRole::time, 0.029296875, 235.36133}}},
    {"mts793_tensile/Acrylic.dat",
     "MTS 793",
     Encoding::utf8,
     '\t',
     '.',
     164,
     6,
     {{"Time", "s", ColumnRole::time, 0.109375, 16.345703},
      {"Ch 1 LVDT", "mm", displacement, 0.013103485, 1.3644004},
      {"Ch 1 Force", "N", force, 2.5660357, 8.1572886}}},
    {"cellscale_femur/A023Data.csv",
     "CellScale",
     Encoding::utf8,
     ',',
     '.',
     38,
     2,
     {{"SetName", "", other, 0, 0},
      {"Cycle", "", other, 0, 0},
      {"Time", "s", ColumnRole::time, 0, 7.4},
      {"Size", "mm", other, 28.999, 28.649},
      {"Displacement", "mm", displacement, -0.0, 0.35},
      {"Force", "N", force, 0.237, 0.143}}},
    {"pasco_brass/LA4_brass_file.csv",
     "PASCO Capstone",
     Encoding::utf8,
     ',',
     '.',
     1150,
     2,
     {{"Position Run #1", "m", displacement, 4.40547e-8, 0.00467}, {"Force Run #1", "N", force, -0.2, -104.0}}},
    {"zwick_tra/Allong_1.TRA",
     "Zwick testXpert",
     Encoding::cp1252,
     ',',
     '.',
     2184,
     13,
     {{"Temps", "s", ColumnRole::time, 5.4937, 44.4337},
      {"Traverse absolue", "mm", crosshead, -794.864, -794.591},
      {"Force standard", "N", force, 146.366, -44.3443},
      {"Course standard", "mm", crosshead, 0, 0.24226}}},
};

}  // namespace

TEST_CASE("export: the made fixtures, of which every number is known, are read as they were written") {
  for (const ExpectedExport& wanted : made) check(export_in(bytes_of(fixtures / wanted.file), wanted.file), wanted);
}

TEST_CASE("export: published exports of real machines against rows counted and values seen without this reader") {
  if (!std::filesystem::exists(campaign_exports)) {
    MESSAGE("skipped: no campaign data");
    return;
  }
  for (const ExpectedExport& wanted : published) check(read_export((campaign_exports / wanted.file).string()), wanted);
}

TEST_CASE("export: every file comes back from its canonical form with the same bits, and is written again the same") {
  for (const ExpectedExport& wanted : made) check_round_trip(export_in(bytes_of(fixtures / wanted.file), wanted.file));
  if (!std::filesystem::exists(campaign_exports)) {
    MESSAGE("skipped: no campaign data");
    return;
  }
  for (const ExpectedExport& wanted : published)
    check_round_trip(read_export((campaign_exports / wanted.file).string()));
}

TEST_CASE(
    "export: decimal commas that a spreadsheet has taken for separators of thousands are refused where they begin") {
  const std::string kept = "Time;Displacement\ns;mm\n0;0,9966\n0,02;10,043\n0,1;1,01\n";
  CHECK(complaint(kept) == "");
  const std::string said = complaint(kept + "0,12;1,000,292\n");
  CHECK(has(said, "e.csv:6: A number has several decimal commas"));
  CHECK(has(said, "without opening it in a spreadsheet"));
  CHECK(has(complaint(kept, {.decimal = ',', .thousands = ','}),
            "The decimal mark and the mark between thousands are both ','"));
  const auto path = campaign_exports / "bluehill_decimal_comma/Tensile_test_PE.csv";
  if (std::filesystem::exists(path))
    CHECK_THROWS_WITH_AS(read_export(path.string()), doctest::Contains("several decimal commas"), InputError);
}

TEST_CASE("export: the file with a byte order mark and nothing else is refused as empty") {
  CHECK(has(complaint("\xEF\xBB\xBF"), "The file holds a byte order mark and nothing else"));
  CHECK(has(complaint(""), "The file is empty"));
  CHECK(has(complaint(" \r\n\t\n"), "The file is empty"));
  CHECK(has(complaint("Time,Load\nno,numbers\n"), "No line of the file holds numbers"));
}

TEST_CASE("export: a force in volts is refused until it is calibrated, and never replaced by another silently") {
  const std::string volts = bytes_of(fixtures / "voltage.csv");
  CHECK(has(complaint(volts), "--force 3 --calibration"));
  ExportOptions options;
  options.columns[force] = "3";
  CHECK(has(complaint(volts, options), "--calibration"));
  options.units[force] = "N";
  CHECK(has(complaint(volts, options), "--calibration"));
  options.units[force] = "222 N/V";
  const Export file = export_in(volts, "v.csv", options);
  const ExportColumn& column = column_with(file, file.specimens.front(), force);
  CHECK(column.unit == "N");
  CHECK(column.values.back() == doctest::Approx(1407.9).epsilon(1e-6));  // the file has six decimals of 6.3 V
}

TEST_CASE("export: the published file with a load cell on an auxiliary input is refused unless one of both is chosen") {
  const auto path = campaign_exports / "mts_testsuite_femur/C18-L-M-RF.txt";
  if (!std::filesystem::exists(path)) {
    MESSAGE("skipped: no campaign data");
    return;
  }
  const std::string bytes = bytes_of(path);
  CHECK(has(complaint(bytes), "column 'Aux Input 5' in V"));
  CHECK(has(complaint(bytes), "--calibration"));
  ExportOptions options;
  options.columns[force] = "Aux Input 5";
  CHECK(has(complaint(bytes, options), "--calibration"));
  options.units[force] = "73.1 N/V";
  check(export_in(bytes, "femur", options),
        {"femur",
         "MTS TestSuite",
         Encoding::utf8,
         '\t',
         '.',
         81,
         9,
         {{"Ch 1 Displacement", "mm", displacement, -0.00835359060147312, -0.368025910574943},
          {"Ch 1 Force", "kN", other, -0.00141854977607727, -0.000265414714813232},
          {"Ch 2 Torque", "kN·mm", other, 0.000344647996826097, -0.000504412048030645},
          {"Aux Input 5", "N", force, -0.0174984335899353 * 73.1, 0.00321224331855774 * 73.1},
          {"Running Time", "sec", ColumnRole::time, 0.0205078125, 2.0517578125}}});
  const Export frame = export_in(bytes, "femur", {.columns = {{force, "Ch 1 Force"}}});
  CHECK(frame.specimens.front().columns[1].role == force);
  CHECK(frame.specimens.front().name == "C18-L-M-RF");
}

TEST_CASE("export: dimensions and rate stated in the file, in SI") {
  const ExportedTest zwick = export_in(bytes_of(fixtures / "zwick.csv"), "z").test;
  constexpr double ulp = 3e-16;  // relative: to_si rounds once
  CHECK(zwick.span.value() == doctest::Approx(0.064).epsilon(ulp));
  CHECK(zwick.thickness.value() == doctest::Approx(4.02e-3).epsilon(ulp));
  CHECK(zwick.width.value() == doctest::Approx(10.05e-3).epsilon(ulp));
  CHECK(zwick.rate.value() == doctest::Approx(2e-3 / 60).epsilon(ulp));
  const ExportedTest analyser = export_in(bytes_of(fixtures / "texture_analyser.txt"), "t").test;
  CHECK(analyser.span.value() == doctest::Approx(0.017).epsilon(ulp));
  CHECK_FALSE(analyser.diameter.has_value());
}

TEST_CASE("export: the specimens of a file, each with its own name, numbers and dimensions") {
  const Export file = export_in(bytes_of(fixtures / "shimadzu.csv"), "s");
  REQUIRE(file.specimens.size() == 2);
  CHECK(file.specimens[0].name == "1 _ 1");
  CHECK(file.specimens[1].name == "1 _ 2");
  CHECK(file.specimens[1].columns[1].values.back() == 2 * f39);
  CHECK(test_in(file.specimens[1].metadata, {}).thickness.value() == doctest::Approx(2.1e-3).epsilon(3e-16));
  const Export blocks = export_in(bytes_of(fixtures / "mts_blocks.dat"), "m");
  REQUIRE(blocks.specimens.size() == 2);
  CHECK(blocks.specimens[1].columns[1].values.back() == 2 * f39);
  const Export named = export_in("SetName,Time [s],Load [N]\na,0.0,1.5\na,0.1,2.5\nb,0.0,3.5\n", "n");
  REQUIRE(named.specimens.size() == 2);
  CHECK(named.specimens[1].name == "b");
  CHECK(named.specimens[1].lines == std::vector<std::size_t>{4});
}

TEST_CASE("export: what the file does not say is asked for with the flag that says it") {
  const auto asks = [](const std::string& text, const ExportOptions& options = {}) {
    std::string all;
    const Export file = export_in(text, "e.csv", options);
    for (const OpenQuestion& question : file.specimens.front().asks)
      all += question.words + " " + question.with_read + "\n";
    return all;
  };
  CHECK(asks(curve_as_csv).empty());
  CHECK(
      has(asks("Time [s],Extension [mm],Load [N]\n0.0,0.1,0.2\n0.1,0.2,0.3\n"), "--displacement crosshead|deflection"));
  CHECK(asks("Time [s],Extension [mm],Load [N]\n0.0,0.1,0.2\n", {.displacement = deflection}).empty());
  CHECK(has(asks("Stroke,Load [N]\n0.1,0.2\n0.2,0.3\n"), "--displacement-unit"));
  CHECK(has(asks("Stroke [mm],Load [Q]\n0.1,0.2\n0.2,0.3\n"), "'Q'? --force-unit"));
  CHECK(has(asks("Stroke [mm],Load A [N],Load B [N]\n0.1,0.2,0.5\n0.2,0.3,0.6\n"), "--force 2"));
  CHECK(has(asks("0.1,0.2\n0.2,0.3\n"), "--force COLUMN"));
}

TEST_CASE(
    "export: a unit that is not stated, not known or of another kind is refused in use, and that named which is "
    "meant") {
  const auto refused = [](const std::string& text) {
    try {
      const Export file = export_in(text, "e.csv");
      in_si(file, file.specimens.front().columns[1], kind::force);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(has(refused("Stroke [mm],Load\n0.1,0.2\n0.2,0.3\n"), "but the column has none. State it with --force-unit"));
  CHECK(has(refused("Stroke [mm],Load [Q]\n0.1,0.2\n0.2,0.3\n"), "'Q', which is unknown"));
  CHECK(has(refused("Stroke [mm],Load (Q)\n0.1,0.2\n0.2,0.3\n"), "the column has none: 'Q' is not a unit"));
  CHECK(has(refused("Stroke [mm],Load [kg]\n0.1,0.2\n0.2,0.3\n"), "the column has 'kg'. If kgf is meant, state it"));
  CHECK(has(refused("Stroke [mm],Load [KN]\n0.1,0.2\n0.2,0.3\n"), "as in --force-unit kN"));
  CHECK(refused("Stroke [mm],Load [N]\n0.1,0.2\n0.2,0.3\n").empty());
}

TEST_CASE("export: rows without a number are left out and said, few of them, and where no sensor was at its end") {
  const auto left_out = [](const std::vector<std::string>& forces, std::size_t used = 1000) {
    std::string text = "Stroke [mm],Load [N]\n";
    for (std::size_t row = 0; row < forces.size(); ++row)
      text += fmt::format("{:.2f},{}\n", 0.01 * static_cast<double>(row), forces[row]);
    const Export file = export_in(text, "e.csv");
    const ExportedSpecimen& specimen = file.specimens.front();
    return rows_without_numbers(file, specimen, {&specimen.columns[1]}, used);
  };
  std::vector<std::string> forces;
  for (int row = 0; row < 40; ++row) forces.push_back(fmt::format("{:.1f}", 0.5 * row));
  CHECK(left_out(forces).words.empty());
  for (const std::string says : {"NaN", "---", "", "#ERR", "?"}) {
    std::vector<std::string> some = forces;
    some[9] = some[10] = says;
    CHECK(left_out(some).rows == std::vector<std::size_t>{9, 10});
    CHECK(has(left_out(some).words, "2 rows without a number in 'Load' are left out: lines 11, 12"));
    for (std::size_t row = 20; row < 24; ++row) some[row] = says;
    CHECK(has(message_of([&] { left_out(some); }), "6 of 40 rows have no number here"));
  }
  for (const std::string says : {"OVER", "+OL", ">>>", "Overflow", "> 50"}) {
    std::vector<std::string> some = forces;
    some[9] = says;
    CHECK(has(message_of([&] { left_out(some); }), "e.csv:11: column 'Load': The sensor was overloaded"));
    CHECK(left_out(some, 9).rows == std::vector<std::size_t>{9});  // the record ends before
    some = forces;
    some.back() = says;
    CHECK(left_out(some).rows == std::vector<std::size_t>{39});
  }
}

TEST_CASE("export: a name with a unit in brackets states the unit of its column, unless the file states another") {
  const std::string text = "Stroke [mm],Load,Aux [N]\n0.1,0.2,1\n0.2,0.3,2\n";
  const Export file = export_in(text, "e.csv", {.columns = {{force, "Load [kN]"}}});
  CHECK(column_with(file, file.specimens.front(), force).unit == "kN");
  CHECK(has(file.specimens.front().repeat_with, "--force \"2 [kN]\""));
  CHECK(has(message_of([&] {
              export_in(text, "e.csv", {.columns = {{force, "Aux [kN]"}}});
            }),
            "The unit of 'Aux' is 'N' in the file, not 'kN'"));
  CHECK(has(message_of([&] { export_in(text, "e.csv", {.columns = {{force, "Load [mm]"}}}); }), "a unit such as N"));
}

TEST_CASE("export: the questions are about the specimen that was chosen") {
  std::string text = "Stroke [mm],Load\n";
  for (int row = 0; row < 12; ++row) text += fmt::format("{:.1f},{:.1f}\n", 0.1 * row, 0.3 * row);
  text += "Stroke [mm],Load [N]\n";
  for (int row = 0; row < 12; ++row) text += fmt::format("{:.1f},{:.1f}\n", 0.1 * row, 0.3 * row);
  const Export file = export_in(text, "e.csv");
  REQUIRE(file.specimens.size() == 2);
  CHECK(file.specimens[0].asks.size() == 1);
  CHECK(file.specimens[1].asks.empty());
}

TEST_CASE("export: contradictions are refused: units of title and row, and a stated maximum against the numbers") {
  CHECK(has(complaint("Stroke (mm),Load (N)\nmm,kN\n0.1,0.2\n0.2,0.3\n"),
            "The units 'kN' and 'N' contradict each other"));
  const std::string body = "Time,Extension,Load\n(s),(mm),(kN)\n\"0.1\",\"0.1\",\"2.5\"\n\"0.2\",\"0.2\",\"6.5\"\n";
  CHECK(has(complaint("Maximum Load : Maximum Load,\"6.5\",N\n\n" + body), ":1: column 'Load'"));
  CHECK(complaint("Maximum Load : Maximum Load,\"6.5\",kN\n\n" + body).empty());
}

TEST_CASE("export: rows of another length are left out and said; many of them, and the file is refused") {
  std::string text = "Stroke [mm],Load [N]\n";
  for (int i = 0; i < 40; ++i) text += "0." + std::to_string(10 + i) + ",0.5\n";
  const Export good = export_in(text + "0.9,", "e.csv");
  CHECK(good.specimens.front().lines.size() == 41);  // the last force is missing, and is a NaN
  const Export cut = export_in(text + "0.9", "e.csv");
  CHECK(cut.specimens.front().lines.size() == 40);
  CHECK(has(cut.notes.front(), "ends in the middle of a row"));
  const Export middle = export_in(text + "0.9\n" + "0.95,0.5\n", "e.csv");
  CHECK(middle.specimens.front().lines.size() == 41);
  CHECK(has(middle.notes.front(), "line 42"));
  std::string bad = text;
  for (int i = 0; i < 10; ++i) bad += "0.9\n0.9,0.5\n";
  CHECK(has(complaint(bad), "lines do not have 2 cells"));
}

TEST_CASE("export: a row that says of every cell that it is missing ends no table") {
  const std::string text =
      "Stroke [mm],Load [N]\n0.1,0.5\n0.2,0.6\n0.3,0.7\nnan,n/a\n0.4,0.8\n0.5,0.9\n0.6,1.0\n0.7,1.1\n";
  const Export read = export_in(text, "e.csv");
  REQUIRE(read.specimens.size() == 1);
  CHECK(read.specimens.front().lines.size() == 8);
  CHECK(read.specimens.front().columns.back().values.back() == 1.1);
}

TEST_CASE("export: the flags that repeat the decisions make the same of the file") {
  for (const ExpectedExport& wanted : made) {
    const std::string bytes = bytes_of(fixtures / wanted.file);
    const Export file = export_in(bytes, wanted.file);
    ExportOptions options{.file = {.encoding = file.origin.encoding, .separator = file.origin.separator},
                          .decimal = file.marks.decimal,
                          .thousands = file.marks.thousands};
    const Export again = export_in(bytes, wanted.file, options);
    CHECK(again.specimens.front().repeat_with == file.specimens.front().repeat_with);
    CHECK(canonical(again) == canonical(file));
  }
}

TEST_CASE(
    "export: a unit decides a role that no title has, unless two columns have it or the title names another quantity") {
  const auto roles_of = [](const std::string& titles) {
    std::string text = titles + "\n";
    for (int i = 0; i < 20; ++i) text += fmt::format("{0},{1},{2}\n", i, 2 * i, 3 * i);
    std::vector<ColumnRole> roles;
    for (const ExportColumn& column : export_in(text, "test.csv").specimens.front().columns)
      roles.push_back(column.role);
    return roles;
  };
  using enum ColumnRole;
  CHECK(roles_of("Alfa [s],Beta [mm],Gamma [N]") == std::vector{time, displacement, force});
  CHECK(roles_of("Alfa [s],Beta [N],Gamma [N]") == std::vector{time, other, other});
  CHECK(roles_of("Alfa [mm],Preload [N],Gamma [N]") == std::vector{displacement, other, force});
  CHECK(roles_of("Alfa [mm],Preload [N],Gamma [mm]") == std::vector{other, other, other});
}

TEST_CASE("export: a remark behind the last column is no cell, and units may stand far above the titles") {
  std::string text =
      "LabVIEW Measurement\nY_Unit_Label\tVolts\tVolts\nX0\t0.0\t0.0\nX_Value\tDev2/ai0\tDev2/ai1\tComment\n";
  for (int i = 0; i < 20; ++i)
    text += fmt::format("\t{}\t{}{}\n", 0.1 * i, 0.2 * i, i == 7 ? "\tForce Coeff: 50.0" : "");
  const Export file = export_in(text, "test.lvm");
  const ExportedSpecimen& specimen = file.specimens.front();
  CHECK(specimen.lines.size() == 20);
  REQUIRE(specimen.columns.size() == 2);
  CHECK(specimen.columns[0].name == "Dev2/ai0");
  CHECK(specimen.columns[1].unit == "Volts");
}
