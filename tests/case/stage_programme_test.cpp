#include <string>

#include <doctest/doctest.h>

#include "case/mechanics.h"
#include "tests/approximately.h"
#include "tests/has.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

namespace flexslip {
namespace {

StageProgramme programme(const std::string& stage, const std::string& path = "case.toml") {
  return programme_of(read_case(
      "[specimen]\ndiameter = \"40 um\"\nmodulus = \"30 GPa\"\n[rig]\nspan = \"1 mm\"\nstiffness = \"90 N/m\"\n"
      "[friction]\nmodel = \"constant\"\nmu0 = 0.5\n[stage]\n" +
          stage + "\n",
      path));
}

}  // namespace

TEST_CASE("stage_programme: turning points exactly, or every reading of steps") {
  const auto exact = programme("program = [\"0 um\", \"300 um\", \"100 um\"]\nstep = \"continuous\"");
  CHECK(!exact.in_steps);
  CHECK(!exact.measured);
  REQUIRE(exact.positions.size() == 3);
  CHECK(exact.positions[2] == to(1e-15, 1e-4));
  CHECK(exact.farthest == to(1e-15, 3e-4));
  const auto steps = programme("program = [\"0 um\", \"300 um\", \"100 um\"]\nstep = \"50 um\"");
  CHECK(steps.in_steps);
  REQUIRE(steps.positions.size() == 11);  // 0, 50, …, 300, 250, …, 100
  CHECK(steps.positions[6] == to(1e-14, 3e-4));
  CHECK(steps.positions.back() == to(1e-14, 1e-4));
}

TEST_CASE("stage_programme: a measured one is that of its file") {
  const TemporaryFolder folder;
  folder.file("stage.csv", "w_s [um]\n0\n40\n90\n20\n");
  const auto read = programme("file = \"" + folder.path().string() + "/stage.csv\"\nstage = \"w_s\"");
  CHECK(read.measured);
  CHECK(read.farthest == to(1e-15, 9e-5));
  CHECK(read.positions.size() == 4);
}

TEST_CASE("stage_programme: what is none is refused by its key (limit)") {
  CHECK(has(message_of([] { programme("program = [\"0 um\", \"0 um\"]"); }), "[stage] program[2]"));
  CHECK(has(message_of([] { programme("program = [\"0 um\", \"1 m\"]"); }), "[stage] program[2]"));
}

}  // namespace flexslip
