#include "result/fields.h"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "result/table.h"

using namespace flexslip;

namespace {

struct Part {
  double length;  // [L]
};

struct Row {
  std::string name;
  double length;                      // [L]
  double force;                       // [N]
  std::optional<Estimate> stiffness;  // [EI]
  std::vector<Part> parts;
  std::size_t point;
  bool is_there;
};

Fields<Part> part_fields() { return Fields<Part>().number("length", kind::length, "of the part", &Part::length); }

Fields<Row> row_fields() {
  return Fields<Row>()
      .words("name", "of the row", &Row::name)
      .number("length", kind::length, "drawn in", &Row::length)
      .titled("S")
      .own("force", kind::force, "at midspan", &Row::force)
      .row("row", "of the file", &Row::point)
      .only_where(&Row::is_there)
      .estimate("stiffness", kind::bending_stiffness, "EI", &Row::stiffness);
}

const Row some_row{"=a\tb", 2, 3, Estimate{1, 0.1, 0.8, 1.2}, {{1}, {4}}, 7, true};
const Frame frame{.scales = Scales(0.5, 8), .row = [](std::size_t point) { return point + 100; }};

}  // namespace

TEST_CASE("table: one description gives JSON, by hand") {
  const Json json = row_fields().list("parts", "of it", part_fields(), &Row::parts)(some_row, frame);
  CHECK(json.dump() == R"({"name":"=a\tb","length":1.0,"force":3.0,"row":107,)"
                       R"("stiffness":{"value":8.0,"standard_error":0.8,"interval95":[6.4,9.6],"unit":"N m^2"},)"
                       R"("parts":[{"length":0.5},{"length":2.0}]})");
}

TEST_CASE("table: the same description gives a table, by hand") {
  const ResultTable table = tabulated("rows", row_fields(), std::vector{some_row}, frame);
  CHECK(titles_of(table.columns) == std::vector<std::string>{"name", "S [m]", "force [N]", "row", "stiffness [N m^2]",
                                                             "stiffness_standard_error [N m^2]",
                                                             "stiffness_low [N m^2]", "stiffness_high [N m^2]"});
  CHECK(table.rows.front() == std::vector<Cell>{"=a b", 1.0, 3.0, 107.0, 8.0, 0.8, 6.4, 9.6});
  CHECK(titles_of(columns_of(row_fields().descriptions(), true)).at(1) == "S");  // reduced numbers have no unit
}

TEST_CASE("limit: missing values are null, nan, or omitted") {
  Row row = some_row;
  row.stiffness.reset();
  CHECK(row_fields()(row, frame).at("stiffness").is_null());
  row = some_row;
  row.is_there = false;
  CHECK(row_fields()(row, frame).at("stiffness").is_null());
  CHECK(std::isnan(std::get<double>(tabulated("rows", row_fields(), std::vector{row}, frame).rows[0].back())));
  CHECK_FALSE(row_fields()
                  .left_out_where_missing()
                  .words("more", "", [](const Row&) -> std::optional<std::string> { return std::nullopt; })(row, frame)
                  .contains("more"));
}

TEST_CASE("identity: a group gives one column per entry, all of one quantity") {
  const auto fields = Fields<Row>().group("first", "part", part_fields().count("n", "", [](const Part&) { return 2; }),
                                          [](const Row& row) { return &row.parts.front(); });
  const ResultTable table = tabulated("rows", fields, std::vector{some_row}, frame);
  CHECK(titles_of(table.columns) == std::vector<std::string>{"first_length [m]", "first_n"});
  CHECK(table.columns[1].quantity == "first");
  CHECK(table.rows.front() == std::vector<Cell>{0.5, 2.0});
  CHECK_THROWS_AS(columns_of(Fields<Row>().list("parts", "", part_fields(), &Row::parts).descriptions(), false),
                  std::invalid_argument);
}

TEST_CASE("identity: a reduced number of each kind times its unit is the physical one") {
  const Scales scales(0.5, 8);
  struct Unit {
    Kind kind;
    double unit;  // span^a EI^b
  };
  for (const auto& [kind, unit] : {Unit{kind::length, 0.5}, Unit{kind::inverse_length, 2}, Unit{kind::force, 32},
                                   Unit{kind::energy, 16}, Unit{kind::stiffness, 64}, Unit{kind::pressure, 128},
                                   Unit{kind::bending_stiffness, 8}, Unit{kind::number, 1}, Unit{kind::angle, 1}}) {
    CAPTURE(kind.name);
    CHECK(physical(3, kind, scales) == 3 * unit);
    CHECK(unit_of(kind, true).find('m') == std::string_view::npos);
  }
  CHECK_THROWS_AS(unit_of(kind::time, false), std::invalid_argument);
}

TEST_CASE("result fields, identity: the type of a value shows whether it may be missing or a list") {
  struct Answer {
    std::optional<double> perhaps;
    double surely;
    std::vector<std::string> remarks;
    const Row* row;
  };
  const auto fields = Fields<Answer>()
                          .number("perhaps", "a number or none", &Answer::perhaps)
                          .number("surely", "a number", &Answer::surely)
                          .words("remarks", "several", &Answer::remarks)
                          .group("row", "or none", row_fields(), &Answer::row)
                          .group("beside", "of the same", Fields<Answer>().number("surely", "again", &Answer::surely))
                          .only_where([](const Answer& answer) { return answer.surely > 0; })
                          .number("where", "it is positive", &Answer::surely);
  std::string told;
  for (const Description& what : fields.descriptions())
    told += std::string(what.name) + (what.may_be_missing ? "?" : "") + (what.is_several ? "*" : "") + " ";
  CHECK(told == "perhaps? surely remarks* row? beside where? ");
}
