#include "report/table.h"

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <doctest/doctest.h>

using namespace flexslip;

namespace {

struct Part {
  std::size_t first, last;
  double length;
  std::optional<double> share;
  std::string verdict;
};

struct Whole {
  std::vector<Part> parts;
  bool has_group;
};

Fields<Whole> fields() {
  const auto part = Fields<Part>()
                        .row("first", "first row", &Part::first)
                        .row("last", "last row", &Part::last)
                        .number("length", kind::length, "of the part", &Part::length)
                        .number("share", "of the whole", &Part::share)
                        .estimate("estimate", kind::length, "of the length",
                                  [](const Part& each) { return normal_estimate(each.length, 0.01); })
                        .words("verdict", "good or not", &Part::verdict)
                        .yes_no("flag", "no column", [](const Part&) { return true; });
  return Fields<Whole>()
      .list("parts", "of the whole", part, &Whole::parts)
      .group("group", "that may be missing", Fields<Whole>().list("parts", "of the whole", part, &Whole::parts),
             [](const Whole& whole) { return whole.has_group ? &whole : nullptr; })
      .count("count", "no list", [](const Whole& whole) { return whole.parts.size(); });
}

const Whole whole{{{0, 4, 0.5, 0.25, "good"}, {5, 9, 0.125, std::nullopt, "bad"}}, false};
const std::vector<Shown> columns{{"No.", ""},
                                 {.heading = "Rows", .field = "first", .last = "last"},
                                 {"Length", "length", 3},
                                 {.heading = "Share (%)", .field = "share", .digits = 2, .factor = 100},
                                 {"Estimate", "estimate"},
                                 {.heading = "Verdict", .field = "verdict", .in_words = {{"bad", "not good"}}}};

}  // namespace

TEST_CASE("table: a column of each shape, by hand, in the units of a test of 2 mm") {
  const Frame frame{.scales = Scales(2e-3, 1)};
  const PrintedTable table = shown(fields(), whole, frame, "parts", columns);
  CHECK(table.head == std::vector<std::string>{"No.", "Rows", "Length (mm)", "Share (%)", "Estimate", "Verdict"});
  CHECK(table.rows[0] == std::vector<std::string>{"1", "1–5", "1.00", "25", "1.000 ± 0.020 mm", "good"});
  CHECK(table.rows[1] == std::vector<std::string>{"2", "6–10", "0.25", "", "250 ± 20 µm", "not good"});
}

TEST_CASE("table: a reduced test has no units") {
  const PrintedTable table =
      shown(fields(), whole, {.scales = Scales(1, 1), .reduced = true}, "parts", {{"Length", "length", 3}});
  CHECK(table.head == std::vector<std::string>{"Length"});
  CHECK(table.rows[1] == std::vector<std::string>{"0.125"});
}

TEST_CASE("limit: a missing group and an empty list have no rows") {
  CHECK(shown(fields(), whole, {}, "group.parts", columns).rows.empty());
  CHECK(shown(fields(), Whole{{}, true}, {}, "group.parts", columns).rows.empty());
  CHECK(shown(fields(), Whole{whole.parts, true}, {}, "group.parts", columns).rows.size() == 2);
}

TEST_CASE("table: a group with its descriptions, without missing values") {
  const Whole with_group{whole.parts, true};
  const auto of_group = Fields<Whole>().group(
      "group", "what it is of; null without it",
      Fields<Part>()
          .number("length", kind::length, "of the part", &Part::length)
          .number("share", "of the whole", &Part::share)
          .estimate("estimate", kind::length, "its length; null if not known",
                    [](const Part& each) { return normal_estimate(each.length, 0.01); })
          .words("verdict", "good or not", &Part::verdict)
          .yes_no("flag", "it holds", [](const Part&) { return true; }),
      [](const Whole& of) -> const auto& { return of.parts[1]; });
  const PrintedTable table = group_table(of_group, with_group, {.scales = Scales(2e-3, 1)}, "group");
  CHECK(table.head == std::vector<std::string>{"group", "Value", "95 % interval", "what it is of"});
  CHECK(table.rows == std::vector<std::vector<std::string>>{{"length", "250 µm", "", "of the part"},
                                                            {"estimate", "250 ± 20 µm", "211 to 289 µm", "its length"},
                                                            {"verdict", "bad", "", "good or not"},
                                                            {"flag", "yes", "", "whether it holds"}});
  CHECK_THROWS_AS(group_table(of_group, with_group, {}, "troop"), std::invalid_argument);
}

TEST_CASE("table: columns of numbers are right-aligned, and columns without values are left out") {
  const PrintedTable table{{"Name", "Value", "Range", "Words", "Nothing"},
                           {{"1", "−5 N", "at most 0.3", "1 of 2", ""}, {"2", "", "± 0.2", "none", ""}}};
  CHECK_FALSE(is_of_numbers(table, 0));
  CHECK(is_of_numbers(table, 1));
  CHECK(is_of_numbers(table, 2));
  CHECK_FALSE(is_of_numbers(table, 3));
  CHECK_FALSE(is_of_numbers(table, 4));
  CHECK(picked(table).head == std::vector<std::string>{"Name", "Value", "Range", "Words"});
  CHECK(picked(table).rows[1] == std::vector<std::string>{"2", "", "± 0.2", "none"});
  CHECK(picked(table, {4, 3, 0}).rows[1] == std::vector<std::string>{"none", "2"});
}

TEST_CASE("bad input: an unknown list or field, or a field that is no column") {
  CHECK_THROWS_AS(shown(fields(), whole, {}, "pieces", columns), std::invalid_argument);
  CHECK_THROWS_AS(shown(fields(), whole, {}, "parts", {{"", "lenght"}}), std::invalid_argument);
  CHECK_THROWS_AS(shown(fields(), whole, {}, "parts", {{"", "flag"}}), std::invalid_argument);
}
