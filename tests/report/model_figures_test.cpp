#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "report/figures.h"
#include "tests/approximately.h"
#include "tests/design/some_design.h"
#include "tests/refusal.h"

namespace flexslip {
namespace {

bool has_title(const Plot& plot, const std::string& title) {
  for (const Panel& panel : plot.panels)
    for (const Mark& mark : panel.marks)
      if (mark.title == title) return true;
  return false;
}

}  // namespace

TEST_CASE("design figure, identity: the record ends at the travel, and the number of drops is the one counted") {
  const auto answer = answer_of(loading_of(spicule));
  const Plot figure = design_figure(answer);
  CHECK(table_of(figure, "record").rows.back().at(0) == to(1e-12, 700));  // µm
  const auto& drops = table_of(figure, "drops").rows;
  const auto gaps = std::count_if(drops.begin(), drops.end(), [](const auto& row) { return row.empty(); });
  CHECK(static_cast<std::size_t>(gaps) + 1 == answer.outcome.drops);
}

TEST_CASE("design figure, limit: displacement control has no line") {
  CHECK(has_title(design_figure(answer_of(loading_of(spicule))), "This load train"));
  const auto stiff = answer_of(loading_of(with("90.65 N/m", "inf")));
  CHECK(!has_title(design_figure(stiff), "This load train"));
}

TEST_CASE("design map figure, identity: the border separates designs that snap from designs that do not") {
  const Test input = loading_of(spicule);
  const std::vector<DesignAxis> axes{map_axis(input, "stiffness=100 N/m:1000 N/m:9", 2),
                                     map_axis(input, "mu0=0.2:0.8:7", 2)};
  const auto points = design_map(input, axes, 1);
  const Plot figure = design_map_figure(input, axes, points);
  CHECK(table_of(figure, "designs").rows.size() == 63);
  for (const auto& row : table_of(figure, "border").rows) {
    if (row.empty()) continue;
    // The column of the map on either side of this point of the border: one snaps and the other does not.
    Test there = input;
    set(there, "mu0", row[1]);
    const auto snaps_at = [&](double stiffness) {
      set(there, "stiffness", stiffness);
      return result_of(there).outcome.value().snaps > 0;
    };
    const double cell = std::pow(10, 0.13);  // 0.125 in the logarithm
    CHECK(snaps_at(row[0] / cell) != snaps_at(row[0] * cell));
  }
}

TEST_CASE("design map figure, identity: colours are for snaps only, not for smooth falls of the force") {
  const Test input = loading_of(spicule);
  const std::vector<DesignAxis> axes{map_axis(input, "stiffness=100 N/m:1000 N/m:5", 2),
                                     map_axis(input, "mu0=0:0.8:5", 2)};
  const auto points = design_map(input, axes, 1);
  const Plot figure = design_map_figure(input, axes, points);
  const auto& rows = table_of(figure, "designs").rows;
  std::size_t smooth = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const DesignOutcome& outcome = points[i].result.outcome.value();
    CHECK(std::isnan(rows[i].back()) == (outcome.snaps == 0));
    smooth += outcome.snaps == 0 && outcome.drops > 0;
  }
  CHECK(smooth > 0);
}

TEST_CASE("design figure, identity: what is not known is a band around the record") {
  const Test input = loading_of(spicule);
  DesignAnswer answer = answer_of(input);
  CHECK(!has_title(laid_out(design_figure(answer)), "Unknown phase"));
  answer.open = open_study(input, {}, 1);
  const Plot figure = design_figure(answer);
  CHECK(has_title(figure, "Unknown phase"));
  for (const auto& row : table_of(figure, "unknown").rows) CHECK(row[1] <= row[2]);
}

TEST_CASE("design map figure, contract: one axis or two") {
  CHECK(message_of([] { design_map_figure(loading_of(spicule), {}, {}); }).find("one axis or two") !=
        std::string::npos);
}

}  // namespace flexslip
