#include "instruments/column_decisions.h"

#include <random>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "tests/has.h"
#include "tests/refusal.h"

using namespace flexslip;

namespace {

// What is said of a force beside a channel in volts; empty if both are taken as they are.
std::string said_of(const std::vector<double>& force, const std::vector<double>& volts,
                    const std::string& name = "Aux") {
  std::string text = "Stroke [mm],Load [N]," + name + " [V]\n";
  for (std::size_t i = 0; i < force.size(); ++i)
    text += std::to_string(0.01 * static_cast<double>(i)) + "," + std::to_string(force[i]) + "," +
            std::to_string(volts[i]) + "\n";
  return message_of([&] { export_in(text, "e.csv"); });
}

}  // namespace

TEST_CASE(
    "column decisions: a second load cell and a force of noise are found, an unrelated channel is not, by "
    "construction") {
  std::mt19937 random(1);
  std::normal_distribution<double> noise;
  std::vector<double> ramp, cell, scatter, hum;
  for (int i = 0; i < 500; ++i) {
    ramp.push_back(i + 2 * noise(random));
    cell.push_back(-0.01 * i + 0.02 * noise(random));
    scatter.push_back(noise(random));
    hum.push_back(noise(random));
  }
  CHECK(has(said_of(ramp, cell), "column 'Aux' in V, which follows 'Load' (correlation -"));
  CHECK(has(said_of(scatter, cell), "column 'Aux' in V, while 'Load' holds only noise"));
  CHECK(said_of(ramp, hum).empty());
  for (const char* name : {"Axial cmd", "Command", "Sollwert", "Temperature"}) CHECK(said_of(ramp, cell, name).empty());
  CHECK(has(message_of([&] { export_in("Stroke [mm],Aux [V]\n0.1,0.5\n0.2,0.6\n0.3,0.7\n", "e.csv"); }),
            "column 'Aux' in V. If it is the force, state its calibration"));
}

TEST_CASE("column decisions: of two times the one counts whose unit is stated, and nothing is asked of the other") {
  const Export file =
      export_in("Elapsed,Scan Time,Stroke,Load\n,s,mm,N\n0,0.0,0.1,0.2\n1,0.5,0.2,0.3\n2,1.0,0.3,0.4\n", "e.csv");
  const ExportedSpecimen& specimen = file.specimens.front();
  CHECK(column_with(file, specimen, ColumnRole::time).name == "Scan Time");
  CHECK(specimen.asks.empty());
  CHECK(has(specimen.repeat_with, "--time 2"));
  CHECK(file.notes.back() == "column 'Elapsed' is a time, too: 'Scan Time' is used");
}

TEST_CASE("column decisions: columns of one name are told apart by their numbers") {
  const Export file = export_in("Stroke [mm],Load [N],Load [N]\n0.1,0.2,0.5\n0.2,0.3,0.6\n", "e.csv");
  CHECK(file.specimens.front().asks.front().words == "which of the columns 'Load' (numbers 2, 3) is the force?");
}

TEST_CASE("column decisions: of one way in two columns the finer is used, of two ways none but as their titles say") {
  // The crosshead goes down from 1190.5 mm, written with six digits; the travel of the test has another zero.
  const auto asked_of = [](double bend) {
    std::string text = "Time [s],Crosshead absolute [mm],Standard force [N],Standard travel [mm]\n";
    for (int i = 0; i < 60; ++i) {
      const double way = 0.0033 * i;
      text += fmt::format("{:.1f},{:.2f},{:.3f},{:.5f}\n", 0.1 * i, 1190.5 - way, 20 * way, way + bend * way * way);
    }
    return export_in(text, "e.txt");
  };
  const Export one = asked_of(0);
  CHECK(one.specimens.front().asks.empty());
  CHECK(column_with(one, one.specimens.front(), ColumnRole::crosshead).name == "Standard travel");
  REQUIRE(!one.notes.empty());
  CHECK(
      has(one.notes.back(), "'Crosshead absolute' is 'Standard travel' rounded to 0.01 mm: 'Standard travel' is used"));
  const Export two = asked_of(0.3);  // by 12 µm at the end
  REQUIRE(two.specimens.front().asks.size() == 1);
  CHECK(two.specimens.front().asks.front().words ==
        "which of the columns 'Crosshead absolute' and 'Standard travel' is the crosshead?");
}

TEST_CASE("column decisions: a force in a unit of another kind is asked about, and is what is said of it") {
  const std::string text = "Deflection [mm],Force [g]\n0.1,10\n0.2,20\n0.3,30\n";
  const Export file = export_in(text, "e.csv");
  REQUIRE(file.specimens.front().asks.size() == 1);
  CHECK(file.specimens.front().asks.front().words == "what is the unit of 'Force', which says 'g': gf?");
  const auto said = [&](const std::string& force) {
    ExportOptions options;
    options.columns[ColumnRole::force] = force;
    return export_in(text, "e.csv", options);
  };
  const Export told = said("Force [gf]");
  CHECK(told.specimens.front().asks.empty());
  CHECK(column_with(told, told.specimens.front(), ColumnRole::force).unit == "gf");
  CHECK(has(message_of([&] { said("Force"); }), "as in \"Force [gf]\""));
}
