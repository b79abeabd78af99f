#include "io/input_error.h"

#include <string>
#include <vector>

#include <doctest/doctest.h>

using namespace flexslip;

TEST_CASE("table: an error is one line made of its parts, and those that are not there leave no trace") {
  const InputError full({.file = "ss14.csv",
                         .line = 17,
                         .field = "column 'F_N'",
                         .problem = "'12,5' is not a number",
                         .remedy = "write decimal points, or pass --decimal ,"});
  CHECK(std::string(full.what()) ==
        "ss14.csv:17: column 'F_N': '12,5' is not a number. Write decimal points, or pass --decimal ,");
  CHECK(std::string(InputError({.file = "a.csv", .problem = "this is a directory"}).what()) ==
        "a.csv: This is a directory.");
  CHECK(std::string(InputError({.file = "a\nb", .problem = "x\ty"}).what()) == R"(a\x0ab: X\x09y.)");
  CHECK(std::string(InputError({.line = 3, .problem = "is this it?"}).what()) == "line 3: Is this it?");
  CHECK(std::string(InputError({.field = "--span", .problem = "a unit is missing", .remedy = "add one"}).what()) ==
        "--span: A unit is missing. Add one.");
  CHECK(std::string(unreadable("a.csv", "Permission denied").what()) ==
        "a.csv: The file cannot be read: Permission denied.");
}

TEST_CASE("identity: locating an error fills in its place and changes nothing else") {
  const InputError error({.problem = "'x' is not a length", .remedy = "write one"});
  const InputError there = located(error, "case.toml", 4, "[rig] span");
  CHECK(std::string(there.what()) == "case.toml:4: [rig] span: " + std::string(error.what()));
}

TEST_CASE("table: what a user's file holds is fit for a message") {
  CHECK(in_quotes("12,5") == "'12,5'");
  CHECK(in_quotes("34.8 µm") == "'34.8 µm'");
  CHECK(in_quotes("a\nb\x1b[31m") == R"('a\x0ab\x1b[31m')");
  CHECK(in_quotes("\xff\xc3") == R"('\xff\xc3')");  // broken UTF-8
  CHECK(in_quotes("\xc0\xaf") == R"('\xc0\xaf')");  // an overlong form
  CHECK(in_quotes("\xc2\x9b") == R"('\xc2\x9b')");  // a control character beyond ASCII
  CHECK(in_quotes(std::string(1000, 'x')).size() < 100);
  CHECK(listed({"a", "b", "c"}) == "'a', 'b' and 'c'");
  CHECK(listed({"a"}) == "'a'");
  CHECK(listed(std::vector<std::string>(100, "a")).ends_with("'a' and 88 more"));
}

TEST_CASE("table: the nearest name is the one that a slip of the finger explains, or none") {
  const std::vector<std::string> names{"diameter", "width", "height", "modulus", "F_N"};
  CHECK(nearest("diamter", names) == "diameter");  // left out
  CHECK(nearest("widht", names) == "width");       // swapped
  CHECK(nearest("Modulus", names) == "modulus");   // case
  CHECK(nearest("F_M", names) == "F_N");           // substituted
  CHECK(nearest("stiffness", names).empty());
  CHECK(did_you_mean("F_M", names) == "did you mean 'F_N'?");
  CHECK(did_you_mean("stiffness", names, "leave it out") == "leave it out");
  CHECK(nearest("q", {"S"}).empty());  // nothing in common
  CHECK(nearest(std::string(1 << 20, 'x'), names).empty());
}
