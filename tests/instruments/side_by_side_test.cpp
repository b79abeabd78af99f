#include "instruments/side_by_side.h"

#include <doctest/doctest.h>

using namespace flexslip;

namespace {

std::vector<std::vector<std::size_t>> columns_of(const std::vector<std::string>& titles) {
  std::vector<std::vector<std::size_t>> columns;
  for (const ColumnGroup& group : side_by_side(titles)) columns.push_back(group.columns);
  return columns;
}

using Groups = std::vector<std::vector<std::size_t>>;

}  // namespace

TEST_CASE("table: specimens beside each other") {
  CHECK(columns_of({"Extension (mm)", "Load (N)", "Extension (mm)", "Load (N)"}) == Groups{{0, 1}, {2, 3}});
  CHECK(columns_of({"Time", "Weg", "Kraft", "", "Time", "Weg", "Kraft", "", "Time", "Weg", "Kraft"}) ==
        Groups{{0, 1, 2}, {4, 5, 6}, {8, 9, 10}});
  CHECK(columns_of({"Time (s)", "Extension", "Load", "Extension", "Load"}) == Groups{{0, 1, 2}, {0, 3, 4}});
  CHECK(side_by_side(std::vector<std::string>{"t", "Weg", "Kraft", "Weg", "Kraft"})[1].first == 3);
}

TEST_CASE("table: what is one specimen") {
  CHECK(columns_of({"Time", "Extension", "Load"}).empty());
  CHECK(columns_of({"Load", "Load"}).empty());                              // two load cells
  CHECK(columns_of({"Extension", "Load", "Extension", "Force"}).empty());   // not the same titles
  CHECK(columns_of({"Voltage", "Current", "Voltage", "Current"}).empty());  // nothing measured
  CHECK(columns_of({"Extension", "Load", "Extension", "Load", "Extra"}).empty());
  CHECK(columns_of({}).empty());
}
