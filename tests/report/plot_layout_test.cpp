#include "report/plot_layout.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>

#include <doctest/doctest.h>

#include "report/draw.h"
#include "report/marks.h"
#include "report/plot_json.h"
#include "report/plot_script.h"
#include "tests/has.h"
#include "tests/report/some_campaign.h"

namespace flexslip {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Plot with(std::vector<Panel> panels, std::size_t columns = 1) {
  return {
      .name = "plot",
      .title = "A plot",
      .caption = "",
      .width = two_columns,
      .height = 80,
      .data = {{"table", {"x", "y", "high", "to x", "to y"}, {{1, 2, 3, 2, 4}, {}, {2, 1, nan, 3, 2}, {4, 4, 5, 5, 5}}},
               {"none", {"x", "y", "high", "to x", "to y"}}},
      .panels = std::move(panels),
      .columns = columns};
}

std::vector<Mark> every_kind(const std::string& table) {
  const Style style = styles::symbols(Colour::blue, Symbol::circle, 3);
  return {marks::line(table, {0, 1}, styles::stroke(Colour::black, 1, Dash::dotted), "line"),
          marks::line(table, {0, 1}, style, "line *with* symbols_0"),
          marks::points(table, {0, 1}, style, "points"),
          marks::only(marks::points(table, {0, 1}, style), {{0, 2}}),
          marks::band(table, {0, 1, 2}, styles::fill(Colour::grey, 0.3), "band"),
          marks::area(table, {0, 1}, styles::fill(Colour::sky, 0.5), "area"),
          marks::bars(table, {0, 1, 2}, style, "bars"),
          marks::spans(table, {0, 3, 1}, style, "spans"),
          marks::arrows(table, {0, 1, 3, 4}, style, "arrows"),
          marks::pixels(table, {0, 3, 1, 4, 2}, style),
          marks::horizontal({2}, style, "rule"),
          marks::vertical({2}, style, "{other} rule's"),
          marks::rectangle({-marks::edge, 2, 1, marks::edge}, styles::fill(Colour::green, 0.2), "rectangle"),
          marks::label(-marks::edge, 2, "at an edge"),
          marks::label(2, 2, "in the middle\ntwo lines"),
          marks::key_line(style, "key"),
          marks::key_points(style, "key"),
          marks::key_fill(style, "key")};
}

}  // namespace

TEST_CASE("outside: gnuplot draws every kind of mark, and an empty panel where there are no data") {
  const Folder folder;
  for (const bool logarithmic : {false, true})
    for (const char* table : {"table", "none"}) {
      INFO(table, logarithmic);
      const Axis axis{"*F*_0", "mN", 0.5, 6, logarithmic};
      const Plot plot = with({{.x = axis, .y = axis, .marks = every_kind(table), .colour = {"colour", "", 0, 6}},
                              {.x = axis, .y = axis, .marks = {}}});
      if (draw(plot, folder.path, {"svg", "png", "pdf"}) == DrawStatus::no_gnuplot) return;
      CHECK(has(text_of(folder.path + "/plot.svg"), "in the middle"));
      CHECK(has(json_with_data(plot).dump(), "\"table\":{\"x\":[1.0,null,2.0,4.0]"));
    }
}

TEST_CASE("plot, contract: a mark of a table that is not there") {
  CHECK_THROWS_AS(layout_of(with({{.x = {}, .y = {}, .marks = {marks::line("spam", {0, 1}, {})}}})),
                  std::invalid_argument);
}

TEST_CASE("plot, identity: an axis has the data, and ticks within") {
  const PlotLayout layout =
      layout_of(with({{.x = {"x"}, .y = {"y", "", 0}, .marks = {marks::bars("table", {0, 1, 2}, {})}}}));
  const AxisLayout &x = layout.panels[0].x, &y = layout.panels[0].y;
  CHECK(x.from == doctest::Approx(1 - 0.04 * 3));
  CHECK(x.to == doctest::Approx(4 + 0.04 * 3));
  CHECK(y.from == 0);
  CHECK(y.to == doctest::Approx(5 + 0.04 * 5));
  for (const Tick& tick : y.ticks) CHECK((tick.at >= y.from && tick.at <= y.to));
}

TEST_CASE("plot, by hand: ticks of long and of short logarithmic axes, and numbers in print") {
  const auto texts = [](double from, double to) {
    std::string out;
    const PlotLayout layout = layout_of(with({{.x = {"x", "", from, to, true}, .y = {"y"}, .marks = {}}}));
    for (const Tick& tick : layout.panels[0].x.ticks)
      if (!tick.text.empty()) out += tick.text + " ";
    return out;
  };
  CHECK(texts(2, 30) == "2 3 4 6 8 10 20 30 ");
  CHECK(texts(1e-3, 300) == "0.001 0.003 0.01 0.03 0.1 0.3 1 3 10 30 100 300 ");
  CHECK(texts(1e-9, 1e9) == "10^{−8} 10^{−6} 10^{−4} 10^{−2} 10^{0} 10^{2} 10^{4} 10^{6} 10^{8} ");
  CHECK(texts(2.2, 2.9) == "2.2 2.25 2.3 2.35 2.4 2.45 2.5 2.55 2.6 2.65 2.7 2.75 2.8 2.85 2.9 ");
  const auto ticks = layout_of(with({{.x = {"x", "", -2e-6, 2e-6}, .y = {"y"}, .marks = {}}})).panels[0].x.ticks;
  CHECK(ticks.front().text == "−2·10^{−6}");
}

TEST_CASE("plot, identity: neighbours with the same axis share its numbers and its label, and a whole figure a label") {
  const Axis x{"x", "", 0, 1}, y{"y", "", 0, 1}, other{"y", "", 0, 2};
  const auto below = layout_of(with({{.x = x, .y = y, .marks = {}}, {.x = x, .y = other, .marks = {}}})).panels;
  CHECK(below[0].x.label.empty());
  CHECK_FALSE(below[0].x.has_numbers);
  CHECK(below[1].x.label == "x");
  CHECK(below[0].lower.x == below[1].lower.x);
  CHECK(below[0].y_label.x == below[1].y_label.x);
  const PlotLayout grid = layout_of(
      with({{.x = x, .y = y, .marks = {}}, {.x = x, .y = y, .marks = {}}, {.x = x, .y = other, .marks = {}}}, 2));
  CHECK(grid.x == "x");
  CHECK(grid.y == "y");
  CHECK_FALSE(grid.panels[1].y.has_numbers);
  CHECK(grid.panels[2].y.has_numbers);
  for (const PanelLayout& panel : grid.panels) {
    CHECK(panel.x.label.empty());
    CHECK((0 < panel.lower.x && panel.lower.x < panel.upper.x && panel.upper.x < 1));
    CHECK((0 < panel.lower.y && panel.lower.y < panel.upper.y && panel.upper.y < 1));
  }
}

TEST_CASE("plot, identity: a key leaves out what there is nothing of") {
  const auto key = [](const char* table) {
    return layout_of(with({{.x = {"x"}, .y = {"y"}, .marks = {marks::line(table, {0, 1}, {}, "a line")}}}))
        .panels[0]
        .key_rows;
  };
  CHECK(key("table") == 1);
  CHECK(key("none") == 0);
  CHECK(has(script_of(with({{.x = {"x"}, .y = {"y"}, .marks = {marks::line("none", {0, 1}, {}, "a line")}}})),
            "plot NaN notitle"));
}

TEST_CASE("plot, by hand: markup") {
  const auto pieces = text_pieces("−*k*_c^{−1} \\*a\\_b\\\\*");
  REQUIRE(pieces.size() == 5);
  CHECK((pieces[1].style == TextPiece::italic && pieces[1].text == "k"));
  CHECK((pieces[2].style == TextPiece::below && pieces[2].text == "c"));
  CHECK((pieces[3].style == TextPiece::above && pieces[3].text == "−1"));
  CHECK((pieces[4].style == TextPiece::plain && pieces[4].text == " *a_b\\"));
  const std::string awkward = "*_^\\{}é";
  CHECK(text_pieces(as_it_is(awkward)).front().text == awkward);
}

TEST_CASE("plot, by hand: round steps") {
  CHECK(round_step(1) == 1);
  CHECK(round_step(1.01) == 2);
  CHECK(round_step(0.3) == doctest::Approx(0.5));
  CHECK(round_step(60) == 100);
}

}  // namespace flexslip
