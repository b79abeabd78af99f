#include "report/plot.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>

#include <doctest/doctest.h>

#include "io/text_file.h"
#include "report/draw.h"
#include "tests/has.h"
#include "tests/report/some_campaign.h"
#include "tests/temporary_folder.h"

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
  const Style style = styles::mark(Symbol::circle, colours::blue, 3);
  return {
      {Mark::line, table, {0, 1}, {colours::black, 1, Dash::dotted}, "line"},
      {Mark::line, table, {0, 1}, style, "line *with* symbols_0"},
      {Mark::points, table, {0, 1}, style, "points"},
      {Mark::points, table, {0, 1}, style, "", {{0, 2}}},
      {Mark::band, table, {0, 1, 2}, styles::fill(colours::grey, 0.3), "band"},
      {Mark::area, table, {0, 1}, styles::fill(colours::sky, 0.5), "area"},
      {Mark::bars, table, {0, 1, 2}, style, "bars"},
      {Mark::spans, table, {0, 3, 1}, style, "spans"},
      {Mark::arrows, table, {0, 1, 3, 4}, style, "arrows"},
      {Mark::pixels, table, {0, 3, 1, 4, 2}, style},
      {.style = style, .title = "{other} line's", .at = {-edge, 2, edge, 2}},
      {.kind = Mark::points, .style = style, .title = "a point", .at = {2, 2}},
      {.kind = Mark::area, .style = styles::fill(colours::green, 0.2), .title = "corners", .at = {-edge, 1, 2, edge}},
      {.kind = Mark::label, .title = "at an edge", .at = {-edge, 2}},
      {.kind = Mark::label, .title = "in the middle\ntwo lines", .at = {2, 2}},
      {.style = style, .title = "key"},
      {.kind = Mark::points, .style = style, .title = "key"},
      {.kind = Mark::area, .style = style, .title = "key"}};
}

}  // namespace

TEST_CASE("outside: gnuplot draws every kind of mark, and an empty panel where there are no data") {
  const TemporaryFolder folder;
  for (const bool logarithmic : {false, true})
    for (const char* table : {"table", "none"}) {
      INFO(table, logarithmic);
      const Axis axis{"*F*_0", "mN", 0.5, 6, logarithmic};
      const Plot plot = with({{.x = axis, .y = axis, .marks = every_kind(table), .colour = {"colour", "", 0, 6}},
                              {.x = axis, .y = axis, .marks = {}}});
      if (!draw(plot, folder.path(), {"svg", "png", "pdf"}).is_done()) return;
      CHECK(has(bytes_of(folder.path() / "plot.svg"), "in the middle"));
      const Json panel = json_of(laid_out(plot)).at("panels").at(0);
      CHECK(panel.at("marks").size() ==
            (std::string(table) == "table" ? 16 : 6));  // labels are texts, and marks of nothing left out
      CHECK(panel.at("texts").size() == 3);
    }
}

TEST_CASE("plot, contract: a mark refers to a missing table") {
  CHECK_THROWS_AS(laid_out(with({{.x = {}, .y = {}, .marks = {{Mark::line, "spam", {0, 1}}}}})), std::invalid_argument);
}

TEST_CASE("plot, identity: an axis contains its data and its ticks") {
  const Plot layout = laid_out(with({{.x = {"x"}, .y = {"y", "", 0}, .marks = {{Mark::bars, "table", {0, 1, 2}}}}}));
  const Axis &x = layout.panels[0].x, &y = layout.panels[0].y;
  CHECK(x.from == doctest::Approx(1 - 0.04 * 3));
  CHECK(x.to == doctest::Approx(4 + 0.04 * 3));
  CHECK(y.from == 0);
  CHECK(y.to == doctest::Approx(5 + 0.04 * 5));
  for (const Tick& tick : y.ticks) CHECK((tick.at >= y.from && tick.at <= y.to));
}

TEST_CASE("plot, limit: an axis that counts has whole numbers only, however short it is") {
  for (const auto& [from, to] : {std::pair{10.0, 12.0}, {0.0, 3.0}, {0.4, 40.0}}) {
    Axis x{"Test", "", from, to};
    x.counts = true;
    const auto ticks = laid_out(with({{.x = x, .y = {"y"}, .marks = {}}})).panels[0].x.ticks;
    CHECK(ticks.size() >= 3);
    for (const Tick& tick : ticks) CHECK(tick.at == std::round(tick.at));
  }
}

TEST_CASE("plot, by hand: ticks of long and of short logarithmic axes, and numbers in print") {
  const auto texts = [](double from, double to) {
    std::string out;
    const Plot layout = laid_out(with({{.x = {"x", "", from, to, true}, .y = {"y"}, .marks = {}}}));
    for (const Tick& tick : layout.panels[0].x.ticks)
      if (!tick.text.empty()) out += tick.text + " ";
    return out;
  };
  CHECK(texts(2, 30) == "2 3 4 6 8 10 20 30 ");
  CHECK(texts(1e-3, 300) == "0.001 0.003 0.01 0.03 0.1 0.3 1 3 10 30 100 300 ");
  CHECK(texts(1e-9, 1e9) == "10^{−8} 10^{−6} 10^{−4} 10^{−2} 10^{0} 10^{2} 10^{4} 10^{6} 10^{8} ");
  CHECK(texts(2.2, 2.9) == "2.2 2.25 2.3 2.35 2.4 2.45 2.5 2.55 2.6 2.65 2.7 2.75 2.8 2.85 2.9 ");
  const auto ticks = laid_out(with({{.x = {"x", "", -2e-6, 2e-6}, .y = {"y"}, .marks = {}}})).panels[0].x.ticks;
  CHECK(ticks.front().text == "−2·10^{−6}");
}

TEST_CASE("plot, identity: neighbours with the same axis share numbers and label, and a whole figure shares a label") {
  const Axis x{"x", "", 0, 1}, y{"y", "", 0, 1}, other{"y", "", 0, 2};
  const auto below = laid_out(with({{.x = x, .y = y, .marks = {}}, {.x = x, .y = other, .marks = {}}})).panels;
  CHECK(below[0].x.title.words.empty());
  CHECK_FALSE(below[0].x.has_numbers);
  CHECK(below[1].x.title.words == "x");
  CHECK(below[0].left == below[1].left);
  CHECK(below[0].y.title.x == below[1].y.title.x);
  const Plot grid = laid_out(
      with({{.x = x, .y = y, .marks = {}}, {.x = x, .y = y, .marks = {}}, {.x = x, .y = other, .marks = {}}}, 2));
  REQUIRE(grid.texts.size() == 2);
  CHECK(grid.texts[0].words == "x");
  CHECK(grid.texts[1].words == "y");
  CHECK_FALSE(grid.panels[1].y.has_numbers);
  CHECK(grid.panels[2].y.has_numbers);
  for (const Panel& panel : grid.panels) {
    CHECK(panel.x.title.words.empty());
    CHECK((0 < panel.left && 0 < panel.width && panel.left + panel.width < grid.width));
    CHECK((0 < panel.bottom && 0 < panel.height && panel.bottom + panel.height < grid.height));
  }
}

TEST_CASE("plot, identity: a key omits marks without data") {
  const auto key = [](const char* table) {
    return laid_out(with({{.x = {"x"}, .y = {"y"}, .marks = {{Mark::line, table, {0, 1}, {}, "a line"}}}}))
        .panels[0]
        .key_rows;
  };
  CHECK(key("table") == 1);
  CHECK(key("none") == 0);
}

TEST_CASE("plot, identity: edges are the ends of the panel, and positions follow the axes") {
  const Axis axis{"x", "", 2, 6};
  const Panel panel =
      laid_out(
          with({{.x = axis,
                 .y = axis,
                 .marks = {{.at = {-edge, 3, edge, edge}}, {.kind = Mark::label, .title = "middle", .at = {4, 4}}}}}))
          .panels[0];
  CHECK(panel.marks.at(0).at == std::vector<double>{2, 3, 6, 6});
  CHECK(panel.texts.at(0).x == doctest::Approx(panel.left + panel.width / 2));
  CHECK(panel.texts.at(0).y == doctest::Approx(panel.bottom + panel.height / 2));
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

TEST_CASE("plot, by hand: an axis has at least two numbers, even in a low panel") {
  const auto ticks = laid_out(with({{.x = {"x"}, .y = {"y"}, .share = 3}, {.x = {"x"}, .y = {"y", "", -0.036, 0.036}}}))
                         .panels[1]
                         .y.ticks;
  std::string texts;
  for (const Tick& tick : ticks) texts += tick.text + " ";
  CHECK(texts == "−0.025 0 0.025 ");
}

TEST_CASE("plot, identity: an axis uses a readable unit") {
  const PlotUnit force = plot_unit(0.012, kind::force, false, "EI/L²");
  CHECK(force.unit == "mN");
  CHECK(force(0.012) == doctest::Approx(12).epsilon(1e-15));  // one rounding each
  CHECK(force.column("force") == "force [mN]");
  CHECK(force.axis("Force", 0, 0.012).to == force(0.012));
  CHECK(plot_unit(0.012, kind::force, true, "EI/L²").factor == 1);
}

TEST_CASE("plot, identity: reduced variables are plotted in the units of their scales") {
  const PlotUnits units{Scales(1278e-6, 2.13e-9), false};
  const PlotUnit w = units.length(0.3);
  CHECK(w.unit == "µm");
  CHECK(w(0.3) == doctest::Approx(383.4).epsilon(1e-12));
  CHECK(units.force(9).unit == "mN");
  CHECK(PlotUnits{units.scales, true}.force(9).unit == "EI/L²");
  CHECK(PlotUnits{units.scales, false, true}.length(0.3).unit == "in");
}

TEST_CASE("figures for a column: wide ones become narrower, panels move below each other, letters stay") {
  const std::vector<Panel> panels(4, Panel{.x = {"*x*"}, .y = {"*y*"}, .marks = every_kind("table")});
  const Plot wide = with(panels, 4), narrow = in_width(wide, one_column);
  CHECK(narrow.width == one_column);
  CHECK(narrow.columns == 2);
  CHECK(narrow.height == 2 * wide.height);
  CHECK(in_width(wide, two_columns).columns == 4);
  Plot small = wide;
  small.width = 100;
  CHECK(in_width(small, two_columns).width == 100);
  CHECK(in_width(small, one_column).width == one_column);
  CHECK(in_width(wide, 200).width == 200);
}

}  // namespace flexslip
