#include "instruments/column_words.h"

#include <string>
#include <vector>

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

TEST_CASE("column_words: titles of the machines' manuals and dictionaries mean what they say") {
  for (const char* name : {"Time", "Running Time", "Prüfzeit", "PRÜFZEIT", "Temps", "Elapsed", "時間", "Tiempo"})
    CHECK_MESSAGE(role_of(name) == ColumnRole::time, name);
  for (const char* name : {"Load", "Axial Force", "Standardkraft", "Prüfkraft", "Charge", "Carga", "kuvvet", "試験力",
                           "荷重", "F", "Flexure load", "Last", "Obciążenie", "载荷", "하중"})
    CHECK_MESSAGE(role_of(name) == ColumnRole::force, name);
  for (const char* name : {"Crosshead", "Stroke", "Traverse absolue", "Standardweg", "Standard travel", "Traversenweg",
                           "ストローク", "w_s"})
    CHECK_MESSAGE(role_of(name) == ColumnRole::crosshead, name);
  for (const char* name : {"Deflection", "Durchbiegung", "Flèche", "FLÈCHE", "Flexure", "たわみ", "挠度", "w0"})
    CHECK_MESSAGE(role_of(name) == ColumnRole::deflection, name);
  for (const char* name : {"Displacement", "Extension", "Position Run #1", "Ch 1 LVDT", "Weg", "Allongement", "uzama",
                           "変位", "Flexure extension", "Przemieszczenie", "Corsa", "位移", "Elongation", "Distance"})
    CHECK_MESSAGE(role_of(name) == ColumnRole::displacement, name);
  for (const char* name :
       {"Strain", "Flexure stress", "Crosshead speed", "Ch 2 Torque", "Dehnung", "Load rate", "Size", "Cycle"})
    CHECK_MESSAGE(role_of(name) == ColumnRole::other, name);
  for (const char* name :
       {"Load rate", "Preload", "Friction force", "Axial cmd", "Load err", "Sollwert Kraft", "Valeur de consigne"})
    CHECK_MESSAGE(names_other_quantity(name), name);
  for (const char* name : {"Size", "Load", "ch0", "Messwert"}) CHECK_MESSAGE(!names_other_quantity(name), name);
}

TEST_CASE("column_words: numbered channels and abbreviations mean what the words mean that they stand for") {
  for (const char* name : {"Force1", "Load 2", "LOAD3", "Kraft1"})
    CHECK_MESSAGE(role_of(name) == ColumnRole::force, name);
  for (const char* name : {"Disp", "Disp 1", "Displ.", "Desplaz.", "Dépl.", "Depl.", "LVDT2", "LVDT30mm", "Position2"})
    CHECK_MESSAGE(role_of(name) == ColumnRole::displacement, name);
  CHECK(role_of("Defl.") == ColumnRole::deflection);
  CHECK(role_of("Time1") == ColumnRole::time);
  for (const char* name : {"Display", "Dispersion", "Disp. rate", "Loads cell", "Sometimes", "Work1", "1load"})
    CHECK_MESSAGE(role_of(name) == ColumnRole::other, name);
}

TEST_CASE("column_words: a title and its unit, as the machines write them") {
  const auto parts = [](std::string_view title) { return title_parts(title).name + "|" + title_parts(title).unit; };
  CHECK(parts("Position (m) Run #1") == "Position Run #1|m");
  CHECK(parts("Force [kN]") == "Force|kN");
  CHECK(parts("Force [Q]") == "Force|Q");
  CHECK(parts("Load (Standard)") == "Load (Standard)|");
  CHECK(parts("Displacement_mm") == "Displacement|mm");
  CHECK(parts("Time_S") == "Time|s");
  CHECK(parts("w_s_m") == "w_s|m");
  CHECK(parts("F_N") == "F|N");
  CHECK(parts("Time sec") == "Time|sec");
  CHECK(parts("Load mm") == "Load mm|");  // not the unit of a load
  CHECK(parts("Force (1)") == "Force (1)|");
}

TEST_CASE("column_words: titles on one line without separators, as MTS 793 and text files have them") {
  using Titles = std::vector<std::string>;
  CHECK(split_titles("Ch 1 Displacement Ch 1 Force Time", 3) == Titles{"Ch 1 Displacement", "Ch 1 Force", "Time"});
  CHECK(split_titles("Time sec   Load N", 2) == Titles{"Time sec", "Load N"});
  CHECK(split_titles("w_s [m] F [N]", 2) == Titles{"w_s [m]", "F [N]"});
  CHECK(split_titles("no such thing here", 3).empty());
}

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
