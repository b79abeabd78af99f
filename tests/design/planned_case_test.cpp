#include "design/planned_case.h"

#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include <doctest/doctest.h>

#include "design/design_result.h"
#include "io/input_error.h"
#include "tests/design/some_design.h"
#include "tests/has.h"

namespace flexslip {
namespace {

// A rod of glass on steel, of which friction is not known.
const std::string rod = R"([specimen]
diameter = "0.5 mm"
modulus = "70 GPa"
material = "glass"
[rig]
span = "10 mm"
stiffness = "5 N/mm"
support_material = "steel"
[stage]
program = ["0 mm", "4 mm"]
)";

std::vector<std::string> refusals_of(const std::string& text) try {
  planned_case(text, "case.toml");
  return {};
} catch (const InputError& error) {
  return error.lines();
}

const AxisRange& range(const OpenNumber& open) { return std::get<AxisRange>(open.axis.values); }

}  // namespace

TEST_CASE("planned case: a complete case is read unchanged") {
  const PlannedCase planned = planned_case(spicule, "case.toml");
  CHECK(planned.open.empty());
  CHECK(planned.loading.friction == loading_of(spicule).friction);
}

TEST_CASE("planned case: friction that is not stated has ranges that fit materials and thickness") {
  const PlannedCase planned = planned_case(rod, "case.toml");
  REQUIRE(planned.open.size() == 3);
  CHECK(planned.open[0].axis.parameter.name == "mu0");
  CHECK(range(planned.open[0]).from == 0.5);
  CHECK(range(planned.open[0]).to == 0.721);
  CHECK(has(planned.open[0].reason, "Tomlinson 1929"));
  CHECK(planned.open[2].axis.parameter.name == "wavelength");
  CHECK(range(planned.open[2]).from == doctest::Approx(5e-6));
  CHECK(range(planned.open[2]).to == doctest::Approx(50e-6));
  CHECK(value_of(planned.loading, "mu0") == doctest::Approx(0.5 * (0.5 + 0.721)));
  CHECK(value_of(planned.loading, "wavelength") == doctest::Approx(std::sqrt(5e-6 * 50e-6)));

  const PlannedCase part =
      planned_case(rod + "[friction]\nmodel = \"constant\"\n", "case.toml", {"specimen.material=maize"});
  REQUIRE(part.open.size() == 1);
  CHECK(range(part.open[0]).to == 0.5);  // nothing in the literature
}

TEST_CASE("planned case: all that is missing is asked for at once, with proposals that fit what is stated") {
  const std::vector<std::string> lines = refusals_of("[specimen]\ndiameter = \"0.5 mm\"\n");
  const auto said = [&](const std::string& key, const std::string& words) {
    for (const std::string& line : lines)
      if (has(line, key)) return has(line, words);
    return false;
  };
  CHECK(lines.size() == 8);
  CHECK(said("[specimen] modulus", "modulus = \"… GPa\""));
  CHECK(said("[rig] span", "\"8 mm\""));
  CHECK(said("[rig] stiffness", "displacement control"));
  CHECK(said("[stage] program", "\"5 mm\""));
  CHECK(said("[friction] wavelength", "from \"5 um\" to \"50 um\""));
  CHECK(refusals_of("").size() == 9);
  CHECK(refusals_of("reduced = true\n").size() == 6);
}

TEST_CASE("planned case: a wrong value, and a gap without a range, are refused as ever") {
  std::string wrong = rod;
  wrong.replace(wrong.find("5 N/mm"), 6, "5 mm");
  REQUIRE(refusals_of(wrong).size() == 1);
  CHECK(has(refusals_of(wrong)[0], "stiffness"));
  const auto rough = refusals_of(rod + "[friction]\nmodel = \"rough\"\n");
  REQUIRE(!rough.empty());
  CHECK(has(rough.back(), "rms"));
  CHECK(!refusals_of(rod + "[friction]\nmodel = \"rough\"\nrms = 0.1\ncorrelation_length = \"5 um\"\nseed = 1\n")
             .empty());
}

}  // namespace flexslip
