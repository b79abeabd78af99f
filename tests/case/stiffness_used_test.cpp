#include <cmath>
#include <string>

#include <doctest/doctest.h>

#include "case/mechanics.h"
#include "tests/approximately.h"
#include "tests/has.h"
#include "tests/refusal.h"

namespace flexslip {
namespace {

Test rod(const std::string& modulus, const std::string& rig = "") {
  return read_case("[specimen]\ndiameter = \"40 um\"\n" + modulus + "\n[rig]\nspan = \"1.2 mm\"\n" + rig +
                       "\n[friction]\nmodel = \"constant\"\nmu0 = 0.5\n[stage]\nprogram = [\"0 um\", \"100 um\"]\n",
                   "rod.toml");
}

}  // namespace

TEST_CASE("stiffness_used: E I of a rod, with the uncertainty stated or assumed (formula)") {
  const double EI = 30e9 * std::acos(-1.0) / 64 * std::pow(40e-6, 4);
  const auto stated = bending_stiffness_of(
      rod("modulus = { value = \"30 GPa\", uncertainty = \"1.5 GPa\" }", "stiffness = \"90 N/m\""));
  CHECK(stated.value == to(1e-14, EI));
  CHECK(stated.relative_error == to(1e-14, 0.05));
  CHECK(stated.source == StiffnessSource::stated);
  const auto assumed = bending_stiffness_of(rod("modulus = \"30 GPa\"", "stiffness = \"90 N/m\""));
  CHECK(assumed.relative_error == 0.03);
  CHECK(assumed.source == StiffnessSource::assumed_error);
  const Test open = rod("", "stiffness = \"90 N/m\"");
  CHECK(!states_stiffness(open));
  CHECK(has(message_of([&] { bending_stiffness_of(open); }), "modulus"));
}

TEST_CASE("stiffness_used: load train and supports are springs in line, and taken apart again (identity)") {
  const Test soft = rod("modulus = \"30 GPa\"", "stiffness = \"90 N/m\"\nsupport_stiffness = \"200 N/m\"");
  CHECK(load_train_stiffness_of(soft) == 90);
  CHECK(support_compliance_of(soft) == to(1e-15, 1 / 400.0));  // each support carries half the force
  CHECK(rig_stiffness_of(soft) == to(1e-15, 1 / (1 / 90.0 + 1 / 400.0)));
  CHECK(without_supports(rig_stiffness_of(soft), support_compliance_of(soft)) == to(1e-13, 90.0));
  CHECK(with_supports(INFINITY, 1 / 400.0) == to(1e-15, 400.0));
  CHECK(std::isinf(without_supports(400, 1 / 400.0)));
  CHECK(rig_stiffness_of(rod("", "stiffness = \"90 N/m\"")) == 90);
}

}  // namespace flexslip
