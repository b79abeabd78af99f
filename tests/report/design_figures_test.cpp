#include "report/design_figures.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "tests/approximately.h"
#include "tests/design/some_design.h"
#include "tests/refusal.h"

namespace flexslip {
namespace {

const FigureData& data_named(const Figure& figure, const std::string& name) {
  return *std::find_if(figure.data.begin(), figure.data.end(),
                       [&](const FigureData& data) { return data.name == name; });
}

}  // namespace

TEST_CASE("design figure, identity: the record ends at the travel, and the drops drawn are as many as counted") {
  const auto answer = answer_of(design_of(spicule));
  const Figure figure = design_figure(answer);
  CHECK(data_named(figure, "record").rows.back().at(0) == to(1e-12, 700));  // µm
  const auto& drops = data_named(figure, "drops").rows;
  const auto gaps = std::count_if(drops.begin(), drops.end(), [](const auto& row) { return row.empty(); });
  CHECK(static_cast<std::size_t>(gaps) + 1 == answer.outcome.drops);
}

TEST_CASE("design figure, limit: displacement control has no line of its own") {
  CHECK(design_figure(answer_of(design_of(spicule))).script.find("This load train") != std::string::npos);
  const auto stiff = answer_of(design_of(with("90.65 N/m", "inf")));
  CHECK(design_figure(stiff).script.find("This load train") == std::string::npos);
}

TEST_CASE("design map figure, identity: the border runs where neighbours snap and do not") {
  const DesignCase input = design_of(spicule);
  const std::vector<DesignAxis> axes{map_axis(input, "stiffness=100 N/m:1000 N/m:9", 2),
                                     map_axis(input, "mu0=0.2:0.8:7", 2)};
  const auto points = design_map(input, axes, 1);
  const Figure figure = design_map_figure(input, axes, points);
  CHECK(data_named(figure, "designs").rows.size() == 63);
  for (const auto& row : data_named(figure, "border").rows) {
    if (row.empty()) continue;
    // The column of the map on either side of this point of the border: one snaps and the other does not.
    DesignCase there = input;
    there.set(DesignParameter::mu0, row[1]);
    const auto snaps_at = [&](double log_stiffness) {
      there.set(DesignParameter::stiffness, std::pow(10, log_stiffness));
      return result_of(there).outcome.value().snaps > 0;
    };
    CHECK(snaps_at(row[0] - 0.13) != snaps_at(row[0] + 0.13));  // a cell is 0.125 wide
  }
}

TEST_CASE("design map figure, contract: one axis or two") {
  CHECK(message_of([] { design_map_figure(design_of(spicule), {}, {}); }).find("one axis or two") != std::string::npos);
}

}  // namespace flexslip
