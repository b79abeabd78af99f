#include "instruments/trace_file.h"

#include <fstream>
#include <string>

#include <doctest/doctest.h>

#include "tests/has.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

namespace flexslip {
namespace {

std::string fixture(const std::string& name) {
  return std::string(FLEXSLIP_SOURCE_DIR) + "/tests/instruments/fixtures/" + name;
}

// What a trace of these lines is refused with; empty if it is read.
std::string refusal(const std::string& head, const std::string& row, const TraceOptions& options = {}, int rows = 70) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "trace.csv").string();
  std::ofstream file(path);
  file << head;
  for (int i = 0; i < rows; ++i) {
    std::string line = row;
    for (auto at = line.find('#'); at != std::string::npos; at = line.find('#')) line.replace(at, 1, std::to_string(i));
    file << line << '\n';
  }
  file.close();
  return message_of([&] { read_trace(path, options); });
}

}  // namespace

TEST_CASE("trace file: one profile in five dialects, by hand as Gwyddion and others write it (table)") {
  const TraceFile plain = read_trace(fixture("gwyddion_plain.txt"), {});
  CHECK(plain.position == "x");
  CHECK(plain.height == "y");
  REQUIRE(plain.trace.height.size() == 80);
  CHECK(plain.trace.step == doctest::Approx(1.96078e-8).epsilon(1e-5));
  TraceOptions alone;
  alone.step = 1.96078e-8;
  for (const TraceFile& other :
       {read_trace(fixture("gwyddion_gnuplot.txt"), {}), read_trace(fixture("gwyddion_comma.csv"), {}),
        read_trace(fixture("profilometer.csv"), {}), read_trace(fixture("heights_alone.txt"), alone)}) {
    REQUIRE(other.trace.height.size() == 80);
    CHECK(other.trace.step == doctest::Approx(plain.trace.step).epsilon(1e-3));  // rounded to 0.1 nm of 1.55 µm
    for (std::size_t i = 0; i < 80; ++i)
      CHECK(std::abs(other.trace.height[i] - plain.trace.height[i]) < 6e-13);  // to six digits, and to 1 pm
  }
  CHECK(read_trace(fixture("profilometer.csv"), {}).position == "Lateral");
  CHECK(read_trace(fixture("profilometer.csv"), {}).height == "Height");
}

TEST_CASE("trace file: columns by name, number and unit as a user says them (table)") {
  TraceOptions options;
  options.height = "3";
  CHECK(read_trace(fixture("profilometer.csv"), options).height == "Raw");
  options.height = "Raw [um]";
  CHECK(read_trace(fixture("profilometer.csv"), options).height == "Raw");
  options.height = "Raw [nm]";
  CHECK(has(message_of([&] { read_trace(fixture("profilometer.csv"), options); }),
            "The unit in the file is 'um', not 'nm'"));
  options.height = "Hight";
  CHECK(has(message_of([&] { read_trace(fixture("profilometer.csv"), options); }), "Did you mean 'Height'?"));
  CHECK(refusal("a,b\n", "#,1#", {.position = "a [um]", .height = "b [nm]"}).empty());
}

TEST_CASE("trace file: bad input is refused with place and remedy (limit)") {
  CHECK(has(refusal("x [um],z [um]\n", "#,1", {}, 20), "The trace has 20 heights; at least 64 are needed"));
  CHECK(has(refusal("x,z\n", "#,1"), "Write height = \"z [um]\" into [friction]"));
  CHECK(has(refusal("x [um],z [N]\n", "#,1"), "column 'z': A unit of length is needed, but the column has 'N'"));
  CHECK(
      has(refusal("x [um],z [um]\n0,5\n3,5\n", "#,1"), "trace.csv:4: column 'x': Positions must increase throughout"));
  CHECK(has(refusal("x [um],z [um]\n", "#,\n"), "trace.csv"));
  CHECK(has(refusal("z [um]\n", "#"), "Write trace_step = \"0.1 um\" into [friction]"));
  CHECK(has(refusal("a [um],b [um],c [um]\n", "#,1,2"), "Write position = "));
  CHECK(has(refusal("x [um],b [um],c [um]\n", "#,1,2"), "Write height = "));
  TraceOptions twice;
  twice.position = twice.height = "1";
  CHECK(has(refusal("x [um],z [um]\n", "#,1", twice), "'x' is chosen for both"));
  CHECK(has(message_of([] { read_trace("/no/such/file.csv", {}); }), "no/such/file.csv"));
}

}  // namespace flexslip
