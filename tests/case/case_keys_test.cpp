// Every key as it is described is read, and only those; changes from the command line say what a file would.
#include "case/case_keys.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "case/case_file.h"
#include "tests/refusal.h"

namespace flexslip {
namespace {

constexpr std::string_view physical = R"([specimen]
diameter = "34.8 um"
modulus = "29.6 GPa"
[rig]
span = "1278 um"
stiffness = "90 N/m"
[friction]
model = "sinusoid"
mu0 = 0.5
amplitude = 0.15
wavelength = "10.9 um"
[friction.other]
model = "constant"
mu0 = 0.4
[stage]
program = ["0 um", "700 um"]
[record]
file = "test.csv"
stage = "stage [um]"
force = "force [mN]"
)";

// What goes with a key where it alone is no case.
std::vector<std::string> beside(const CaseKey& key) {
  const std::string_view name = key.name;
  if (key.section == "rig" && (name.starts_with("pin_") || name == "rollers"))
    return {"rig.span=64 mm", "rig.roller_radius=5 mm", "rig.rollers=pinned", "rig.pin_radius=1 mm",
            "rig.pin_friction=0.1"};
  if (key.section == "friction") {
    if (name == "file" || name == "length" || name == "mu")
      return {"friction.model=table", "friction.file=trace.csv", "friction.length=S [um]"};
    if (name == "rms" || name == "correlation_length" || name == "seed")
      return {"friction.model=rough", "friction.rms=0.1", "friction.correlation_length=5 um", "friction.seed=1"};
    if (name == "reference") return {"friction.drift=0.2 1/mm"};
  }
  return {};
}

// Keys that exclude what the case above has.
bool is_another_case(const CaseKey& key) {
  const std::string_view name = key.name;
  if (key.section == "specimen") return name == "width" || name == "height" || name == "bending_stiffness";
  if (key.section == "friction")
    return name == "waves" || name == "static_excess" || name == "file" || name == "length" || name == "mu" ||
           name == "rms" || name == "correlation_length" || name == "seed" || name.starts_with("trace") ||
           name == "position" || name == "height" || name == "direction" || name == "level" || name == "cutoff" ||
           name == "edge_radius";
  if (key.section == "stage") return name == "file" || name == "stage" || name == "time" || name == "decimal";
  return key.section == "record" && (name == "deflection" || name.starts_with("displacement") || name == "specimen" ||
                                     name == "calibration" || name == "speed");
}

}  // namespace

TEST_CASE("case keys, identity: the example of each is read as it stands, and so is each of its words") {
  int read = 0;
  for (const CaseKey& key : case_keys()) {
    const std::string name = fmt::format("{}.{}", key.section, key.name);
    CAPTURE(name);
    CHECK(case_key(key.section, key.name) == &key);
    if (key.section.empty() || key.section.find('.') != std::string_view::npos || key.holds == Holds::section ||
        key.holds == Holds::axes || is_another_case(key))
      continue;
    std::vector<std::string> changes = beside(key);
    changes.push_back(fmt::format("{}={}", name, key.example));
    CHECK_NOTHROW(read_case(physical, "case.toml", changes));
    ++read;
    if (key.holds != Holds::word || name == "friction.model") continue;
    for (const std::string_view word : words_of(key)) {
      changes.back() = fmt::format("{}={}", name, word);
      if (name == "rig.rollers" || changes.back() == "rig.supports=rollers")
        changes = {"rig.roller_radius=5 um", changes.back()};
      if (changes.back() != "rig.rollers=pinned") CHECK_NOTHROW(read_case(physical, "case.toml", changes));
    }
  }
  CHECK(read > 30);
}

TEST_CASE("case keys, identity: a changed case is the one that says so itself") {
  const Test changed = read_case(physical, "case.toml",
                                 {"rig.stiffness=200 N/m", "friction.mu0 = 0.4", "friction.other.mu0=0.3",
                                  "stage.program=[\"0 um\", \"1 mm\"]", "record.contact=find"});
  CHECK(changed.rig->stiffness == 200.0);
  CHECK(changed.friction->mu0 == 0.4);
  CHECK(changed.other->mu0 == 0.3);
  CHECK(changed.stage->program.back() == 1e-3);
  CHECK(changed.record->contact == ContactRule{ContactWord::find});
  CHECK(read_case(to_toml(changed), "case.toml").rig == changed.rig);
  CHECK(std::isinf(*read_case(physical, "case.toml", {"rig.stiffness=inf"}).rig->stiffness));
  const char* const plain = "[specimen]\n[rig]\nstiffness = 5\n";
  CHECK(read_case(plain, "case.toml", {"reduced=true"}).reduced);
}

TEST_CASE("case keys, bad input: a change that is none, of a key that is none, or to what it cannot hold") {
  const auto complaint = [](const std::string& change) {
    return message_of([&] { read_case(physical, "case.toml", {change}); });
  };
  CHECK(complaint("rig.stiffness").find("--set: 'rig.stiffness' has no =. Write SECTION.KEY=VALUE") !=
        std::string::npos);
  CHECK(complaint("rig.stifness=90 N/m").find("Did you mean 'rig.stiffness'?") != std::string::npos);
  CHECK(complaint("stiffness=90 N/m").find("Did you mean 'rig.stiffness'?") != std::string::npos);
  CHECK(complaint("rig.stiffness=").find("Write a value after the =") != std::string::npos);
  CHECK(complaint("rig.stiffness=90 um").find("--set: rig.stiffness: '90 um' is a length, not a stiffness") !=
        std::string::npos);
  CHECK(complaint("rig.stiffness=90").find("--set: rig.stiffness") != std::string::npos);
  CHECK(complaint("sweep.mehtod=grid").find("Did you mean 'sweep.method'?") != std::string::npos);
  CHECK(complaint("specimen.cracks.deflection=1 um").find("Did you mean 'specimen.cracks'?") == std::string::npos);
  for (const char* none : {".reduced=true", "sweep.axes.=1", "reduced.=true", "=1"})
    CHECK(complaint(none).find("--set: No key is called") != std::string::npos);
  CHECK(complaint("reduced=perhaps").find("reduced: This is true or false, not") != std::string::npos);
}

TEST_CASE("case keys: the supports that a change states take the place of those of the case") {
  const auto with_supports = [](std::string_view supports, const std::vector<std::string>& changes) {
    std::string text(physical);
    text.insert(text.find("[friction]"), supports);
    return *read_case(text, "case.toml", changes).rig;
  };
  const RigInput rolls = with_supports("supports = \"edges\"\n", {"rig.roller_radius=5 um"});
  CHECK(rolls.roller_radius == std::optional(Known{5e-6}));
  CHECK(rolls.supports != SupportKind::edges);
  const std::string pinned =
      "roller_radius = \"50 um\"\nrollers = \"pinned\"\npin_radius = \"10 um\"\npin_friction = 0.1\n";
  const RigInput edges = with_supports(pinned, {"rig.supports=edges"});
  CHECK(edges.supports == SupportKind::edges);
  CHECK(!edges.roller_radius);
  CHECK(edges.rollers == Rollers::fixed);
  CHECK(!edges.pin_radius);
  // Changes that contradict each other are refused, as a case would be.
  CHECK(message_of([&] {
          with_supports("", {"rig.supports=edges", "rig.roller_radius=5 um"});
        }).find("The supports are \"edges\", but a roller_radius is stated") != std::string::npos);
}

}  // namespace flexslip
