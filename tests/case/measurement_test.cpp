#include "case/measurement.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "tests/approximately.h"

using namespace flexslip;

namespace {

// A test as a machine sees it: a way before the contact, a rise that stays below a straight line, a break.
struct Machine {
  double contact = 0.3e-3;  // [m] of the stage
  double tare = 0;          // [N] what the load cell shows before
  double noise = 0.05;      // [N]
  double stiffness = 2e4;   // [N/m] of the specimen and
  double load_train = 1e5;  //       of the load train
  int displacement_sign = 1, force_sign = 1;
};

constexpr int rows = 400;
constexpr int last_before_failure = 360;  // counted from 1

struct Columns {
  std::vector<double> stage, deflection, force;
};

Columns columns_of(const Machine& machine) {
  std::mt19937 random(11);
  std::normal_distribution<double> unit(0, 1);
  Columns columns;
  const double series = machine.stiffness * machine.load_train / (machine.stiffness + machine.load_train);
  for (int i = 0; i < rows; ++i) {
    const double stage = 1e-5 * i;
    const double force = i >= last_before_failure ? 0 : series * std::max(0.0, stage - machine.contact);
    const double shown = force + machine.tare + machine.noise * unit(random);
    columns.stage.push_back(machine.displacement_sign * stage);
    columns.deflection.push_back(machine.displacement_sign * (stage - force / machine.load_train));
    columns.force.push_back(machine.force_sign * shown);
  }
  return columns;
}

class Folder {
 public:
  Folder() : path_(std::filesystem::temp_directory_path() / fmt::format("flexslip-measurement-{}", ++count)) {
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  // Reads the test of a machine; `lines` are added to [record].
  Measurement measured(const Machine& machine, const std::string& lines = "",
                       const std::string& rig = "stiffness = '1e5 N/m'") const {
    return measured(columns_of(machine), lines, rig);
  }

  Measurement measured(const Columns& columns, const std::string& lines,
                       const std::string& rig = "stiffness = '1e5 N/m'") const {
    std::ofstream data(path_ / "test.csv");
    data << "stage [m],deflection [m],force [N]\n";
    for (std::size_t i = 0; i < columns.stage.size(); ++i)
      data << fmt::format("{},{},{}\n", columns.stage[i], columns.deflection[i], columns.force[i]);
    data.close();
    const bool names_columns =
        lines.find("stage =") != std::string::npos || lines.find("deflection =") != std::string::npos;
    const std::string text = fmt::format("[rig]\nspan = '40 mm'\n{}\n[record]\nfile = 'test.csv'\n{}{}", rig,
                                         names_columns ? "" : "stage = 'stage'\nforce = 'force'\n", lines);
    return read_measurement(read_case(text, (path_ / "case.toml").string()), {.points = 30});
  }

  // Reads an export of a bar that bends by 50 µm a row under 1 N more, with what stands above its rows, and in some of them another force.
  Measurement exported(const std::string& above, const std::string& lines,
                       const std::map<int, std::string>& says = {}) const {
    std::ofstream data(path_ / "test.csv");
    data << above;
    for (int row = 0; row < 60; ++row) {
      const auto said = says.find(row);
      data << fmt::format("{:.1f},{:.3f},{}\n", 0.5 * row, 0.05 * row,
                          said == says.end() ? fmt::format("{:.2f}", 1.0 * row) : said->second);
    }
    data.close();
    const std::string text =
        fmt::format("[rig]\nspan = '40 mm'\nstiffness = 'inf'\n[record]\nfile = 'test.csv'\n{}", lines);
    return read_measurement(read_case(text, (path_ / "case.toml").string()), {.points = 11});
  }

 private:
  static inline int count = 0;
  std::filesystem::path path_;
};

const PreparationStep* step_of(const Measurement& measurement, std::string_view name) {
  for (const PreparationStep& step : measurement.preparation)
    if (step.name == name) return &step;
  return nullptr;
}

bool same(const Record& a, const Record& b) {
  return a.stage == b.stage && a.deflection == b.deflection && a.force == b.force;
}

std::string complaint(const std::function<void()>& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("measurement: contact, failure, compliance and tare of a simulated machine (truth)") {
  const Folder folder;
  const Measurement found = folder.measured({.tare = 2.5});
  CHECK(found.contact == ContactSource::found);
  CHECK(std::abs(found.contact_offset - 0.3e-3) < 4 * found.contact_error);
  CHECK(found.end == MeasurementEnd::failure);
  CHECK(file_row(found, found.record.force.size() - 1) == last_before_failure);
  const PreparationStep* zero = step_of(found, "zero");
  REQUIRE(zero);
  CHECK(zero->changed);
  CHECK(std::abs(zero->value->value - 2.5) < 4 * *zero->value->error);
  for (std::size_t i = 0; i < found.record.force.size(); i += 10)
    CHECK(found.record.deflection[i] == to(1e-9, found.record.stage[i] - found.record.force[i] / 1e5).scale(1e-6));
}

TEST_CASE("measurement: which way the machine counts makes no difference (identity)") {
  const Folder folder;
  const Measurement straight = folder.measured({.tare = 0.4});
  CHECK_FALSE(step_of(straight, "sign")->changed);
  for (const int displacement : {1, -1})
    for (const int force : {1, -1}) {
      const Measurement other = folder.measured({.tare = 0.4, .displacement_sign = displacement, .force_sign = force});
      CHECK(same(other.record, straight.record));
      CHECK(step_of(other, "sign")->changed == (displacement < 0 || force < 0));
    }
  const Measurement reversed =
      folder.measured({.tare = 0.4, .displacement_sign = -1, .force_sign = -1}, "sign = 'reverse'\n");
  CHECK(same(reversed.record, straight.record));
}

TEST_CASE("measurement: stage and deflection that count downwards (identity)") {
  const Folder folder;
  const std::string lines = "stage = 'stage'\ndeflection = 'deflection'\n";
  const Measurement up = folder.measured(Machine{}, lines);
  const Measurement down = folder.measured({.displacement_sign = -1}, lines);
  CHECK(same(up.record, down.record));
}

TEST_CASE("measurement: a tare that is stated, or taken off before, is the one found (identity)") {
  const Folder folder;
  const Measurement found = folder.measured({.tare = 2.5});
  const double tare = step_of(found, "zero")->value->value;
  const Measurement stated = folder.measured({.tare = 2.5}, fmt::format("zero = '{} N'\n", tare));
  CHECK(same(stated.record, found.record));
  const Measurement kept = folder.measured({.tare = 0.0}, "zero = 'keep'\n");
  const Measurement none = folder.measured({.tare = 0.0});
  CHECK(same(kept.record, none.record));  // noise about zero is not taken off
  CHECK_FALSE(step_of(none, "zero")->changed);
  CHECK(step_of(none, "zero")->value.has_value());
}

TEST_CASE("bad input: an `until` before the first row that counts") {
  const Folder folder;
  Columns columns = columns_of(Machine{});
  for (std::size_t i = 0; i < 60; ++i) columns.stage[i] = columns.stage[60], columns.force[i] = columns.force[60];
  CHECK(complaint([&] {
          folder.measured(columns, "first = 5\nuntil = 40\n");
        }).find("rows lie before the stated end, row 40; at least") != std::string::npos);
}

TEST_CASE("bad input: a stage that stands still, and rows out of order") {
  const Folder folder;
  Columns still = columns_of(Machine{});
  for (double& stage : still.stage) stage = still.stage.front();
  CHECK(complaint([&] { folder.measured(still, ""); }).find("the stage: The displacement stays at") !=
        std::string::npos);
  Columns shuffled = columns_of(Machine{});
  std::shuffle(shuffled.stage.begin(), shuffled.stage.end(), std::mt19937_64(1));
  CHECK(complaint([&] { folder.measured(shuffled, ""); }).find("the order of time") != std::string::npos);
}

TEST_CASE("measurement: every step can be switched (table)") {
  const Folder folder;
  const Machine machine{.tare = 2.5, .displacement_sign = -1, .force_sign = -1};
  CHECK(complaint([&] { folder.measured(machine, "sign = 'keep'\n"); }) != "");  // a stage that runs backwards
  CHECK(folder.measured(machine, "failure = 'none'\n").end == MeasurementEnd::last_row);
  CHECK(folder.measured(machine, "until = 100\n").end == MeasurementEnd::until);
  const Measurement first_row = folder.measured(machine, "contact = 'first row'\n");
  CHECK(first_row.contact_offset == 0);
  CHECK(first_row.first == 0);
  CHECK(folder.measured(machine, "contact = '1 mm'\n").first == 100);
  CHECK(folder.measured(machine, "zero = 'keep'\n").record.force.back() ==
        to(1e-12,
           folder.measured(machine).record.force.back() + step_of(folder.measured(machine), "zero")->value->value));
  const Measurement stiff = folder.measured(machine, "", "stiffness = 'inf'");
  CHECK(stiff.record.stage == stiff.record.deflection);
}

TEST_CASE(
    "measurement: a record that begins under a force counts from its own contact, unless another is stated (truth)") {
  const Folder folder;
  const Machine machine{.contact = -0.2e-3};  // preloaded: the record begins 0.2 mm after the contact
  for (const char* rule : {"", "contact = 'find'\n"}) {
    const Measurement found = folder.measured(machine, rule);
    CHECK(found.contact == ContactSource::found);
    CHECK(std::abs(found.contact_offset + 0.2e-3) < 4 * found.contact_error);
    CHECK(found.begins_under > 0);
    CHECK(found.first == 0);
  }
  CHECK(folder.measured(machine, "contact = 'first row'\n").contact == ContactSource::stated);
  const Measurement tared = folder.measured(Machine{.contact = 0});
  CHECK(tared.begins_under == 0);
  CHECK(std::abs(tared.contact_offset) < 2 * tared.contact_error);
}

TEST_CASE(
    "measurement: a toe is taken off where the record tells no friction, and its straight part is the initial slope "
    "(truth)") {
  const Folder folder;
  const auto settling = [](double settles_within, double step) {
    Columns columns = columns_of({});
    for (int i = 0; i < rows; ++i) {
      const auto row = static_cast<std::size_t>(i);
      const double w = step * i, rise = w < settles_within ? w * w / (2 * settles_within) : w - 0.5 * settles_within;
      columns.stage[row] = w;
      columns.force[row] = 2e4 * rise + 0.002 * std::sin(1.0 * i * i);
    }
    return columns;
  };
  constexpr const char* rigid = "stiffness = 'inf'";
  const Measurement found = folder.measured(settling(0.5e-3, 4e-6), "", rigid);
  CHECK(found.straight_is_initial);
  CHECK(step_of(found, "contact")->done.find("begins with a toe") != std::string::npos);
  CHECK(std::abs(found.contact_offset - 0.25e-3) < 0.01e-3);
  CHECK(found.straight->slope.value == to(0.01, 2e4));
  CHECK(std::abs(found.straight->origin) < 1e-12);  // counted from there
  CHECK(file_row(found, found.straight->first) > 110);
  CHECK(folder.measured(settling(0.5e-3, 4e-6), "contact = 'first row'\n", rigid).contact_offset == 0);
  CHECK(folder.measured(settling(0.01e-3, 4e-6), "", rigid).contact_offset == 0);  // within what is usual
  // A preload: the record begins 0.1 mm after the contact.
  Columns preloaded = settling(1e-9, 4e-6);
  for (double& force : preloaded.force) force += 2e4 * 0.1e-3;
  const Measurement loaded = folder.measured(preloaded, "", rigid);
  CHECK(loaded.contact == ContactSource::found);
  CHECK(std::abs(loaded.contact_offset + 0.1e-3) < 4 * loaded.contact_error);
  CHECK(loaded.first == 0);
  // Bent to a tenth of the span, where friction may steepen it as much.
  CHECK_FALSE(folder.measured(settling(0.5e-3, 12e-6), "", rigid).straight_is_initial);
}

TEST_CASE("measurement: a stage that trembles is held, one that runs back is refused (limit)") {
  const Folder folder;
  Columns columns = columns_of({.contact = 0});
  columns.stage[200] -= 1.5e-5;  // below the one before, by 0.1 % of the travel
  const Measurement held = folder.measured(columns, "");
  CHECK(std::is_sorted(held.record.stage.begin(), held.record.stage.end()));
  REQUIRE(step_of(held, "stage"));
  CHECK(step_of(held, "stage")->value->value == to(1e-9, 0.5e-5));
  columns.stage[200] -= 3e-5;  // and now by 1 %
  CHECK(complaint([&] { folder.measured(columns, ""); }).find("The stage moves back from 1.99 mm to") !=
        std::string::npos);
}

TEST_CASE("measurement: a stage read many times on its way trembles by its resolution, and is held (limit)") {
  const Folder folder;
  Columns columns = columns_of({.contact = 0});
  std::mt19937 random(3);
  std::uniform_int_distribution<int> tremble(-1, 1);
  // In steps of 0.3 % of the travel, as of a short way: a reading falls back by up to two of them.
  constexpr double resolution = 1.2e-5;
  for (double& stage : columns.stage) stage = resolution * (std::round(stage / resolution) + tremble(random));
  const Measurement held = folder.measured(columns, "");
  CHECK(std::is_sorted(held.record.stage.begin(), held.record.stage.end()));
  REQUIRE(step_of(held, "stage"));
  CHECK(step_of(held, "stage")->value->value == to(1e-9, 2 * resolution));
  // No tremble, and no turn, which is 2 %.
  columns.stage[200] = *std::max_element(columns.stage.begin(), columns.stage.begin() + 200) - 6.3 * resolution;
  CHECK(complaint([&] { folder.measured(columns, ""); }).find("the stage: The stage moves back from ") !=
        std::string::npos);
}

TEST_CASE("measurement: all that a file leaves open is asked at once, in the words of what evaluates it (table)") {
  const Folder folder;
  const auto asked = [&](const std::string& above, const std::string& lines) {
    return complaint([&] { folder.exported(above, lines); });
  };
  const std::string many = asked("Time,Extension,Load\nS,MM,KN\n", "");
  for (const char* part :
       {"3 more inputs are needed:\n  write displacement = \"crosshead|deflection\" into [record]  ",
        "  Was 'Extension' measured at the crosshead or at the specimen's midpoint?\n",
        "\n  write displacement_column = \"Extension [mm]\" into [record]  ",
        "  What is the unit of 'Extension', which says 'MM': mm?\n", "\n  write force = \"Load [kN]\" into [record]  "})
    CHECK(many.find(part) != std::string::npos);
  CHECK(asked("Time [s],Deflection [mm],Load\n", "").find("unit: write force = \"Load [N]\" into [record]") !=
        std::string::npos);
  CHECK(asked("Time,Extension,Load\nS,MM,KN\n",
              "displacement = 'crosshead'\ndisplacement_column = 'Extension [mm]'\nforce = 'Load [kN]'\n") == "");
}

TEST_CASE("measurement: a displacement that is stated to be another than its name says is taken for it by name alone") {
  const Folder folder;
  const std::string above = "Time [s],Deflection [mm],Load [N]\n";
  const std::string told = complaint([&] { folder.exported(above, "displacement = 'crosshead'\n"); });
  CHECK(
      told.find(
          "column 'Deflection': The column is titled as deflection, but it is stated as crosshead. Write displacement "
          "= \"deflection\" into [record]; or write displacement_column = \"Deflection\" into [record] too") !=
      std::string::npos);
  CHECK(complaint(
            [&] { folder.exported(above, "displacement = 'crosshead'\ndisplacement_column = 'Deflection'\n"); }) == "");
}

TEST_CASE("measurement: readings that are missing are left out, and said in a step of their own (limit)") {
  const Folder folder;
  const std::string above = "Time [s],Crosshead [mm],Load [N]\n";
  const Measurement whole = folder.exported(above, "");
  CHECK(step_of(whole, "missing") == nullptr);
  const Measurement some = folder.exported(above, "", {{20, "NaN"}, {41, "---"}, {42, ""}});
  REQUIRE(step_of(some, "missing") != nullptr);
  CHECK(step_of(some, "missing")->done ==
        "3 rows without a number in 'Load' are left out: lines 22, 43, 44 hold 'NaN'");
  CHECK(some.rows == whole.rows);
  CHECK(some.missing == 3);
  const std::string refusal = complaint([&] { folder.exported(above, "", {{20, "OVER"}}); });
  CHECK(refusal.find("test.csv:22: column 'Load': The sensor was overloaded ('OVER' on line 22)") != std::string::npos);
  CHECK(complaint([&] { folder.exported(above, "until = 20\n", {{20, "OVER"}}); }) == "");
}

TEST_CASE("measurement: a stage without a load-train stiffness is refused, a deflection needs none (limit)") {
  const Folder folder;
  const std::string refusal = complaint([&] { folder.measured(Machine{}, "", ""); });
  CHECK(refusal.find("stiffness of the load train") != std::string::npos);
  CHECK(refusal.find("\"inf\"") != std::string::npos);
  CHECK(refusal.find("Write stiffness = \"… N/m\" into [rig]") != std::string::npos);
  CHECK(refusal.find("90.65") == std::string::npos);
  const Measurement measured = folder.measured(Machine{}, "deflection = 'deflection'\nforce = 'force'\n", "");
  CHECK(measured.record.stage == measured.record.deflection);
}

TEST_CASE("measurement: a record steeper than its load train is refused with the numbers that contradict it (limit)") {
  const Folder folder;
  // Specimen and load train together are as stiff as 16.67 kN/m: on a softer load train the specimen would bend upwards.
  const Machine machine{.contact = 0, .noise = 0};
  const std::string refusal = complaint([&] { folder.measured(machine, "", "stiffness = '1e3 N/m'"); });
  CAPTURE(refusal);
  CHECK(refusal.find("case.toml:3: [rig] stiffness: The load train of 1 N/mm yields by 59.83 mm under 59.83 N, but the "
                     "stage moved only 3.59 mm. Check it and the units of stage and force") != std::string::npos);
  CHECK(complaint([&] { folder.measured(machine, "", "stiffness = '16.6e3 N/m'"); }) != "");
  CHECK(complaint([&] { folder.measured(machine, "", "stiffness = '16.7e3 N/m'"); }) == "");
}

TEST_CASE("measurement: the steps are in their documented order, each with the flag of its key (table)") {
  const Folder folder;
  const Measurement found = folder.measured({.tare = 2.5});
  std::string names;
  for (const PreparationStep& step : found.preparation) names += std::string(step.name) + " ";
  CHECK(names == "columns sign zero compliance end contact ");
  CHECK(step_of(found, "sign")->otherwise->in_case() == "[record] sign = \"reverse\"");
  CHECK(step_of(found, "sign")->otherwise->flag() == "--sign reverse");
  CHECK(!step_of(found, "columns")->otherwise);
  CHECK(step_of(found, "end")->rows->first == last_before_failure + 1);
  CHECK(step_of(found, "end")->rows->last == rows);
}
