#include "case/case_changes.h"

#include <string>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>

#include "case/toml.h"
#include "tests/has.h"
#include "tests/refusal.h"

using namespace flexslip;

namespace {

constexpr std::string_view some_case = "[rig]\nspan = '1 mm'\nstiffness = '90 N/m'\nsupports = 'edges'\n";

toml::table changed(const std::vector<std::string>& changes) {
  return with_changes(parse_toml(some_case, "case.toml"), changes);
}

}  // namespace

TEST_CASE("identity: a change says what the file would") {
  struct Row {
    std::vector<std::string> changes;
    std::string_view file;
  };
  for (const Row& row : {
           Row{{}, some_case},
           Row{{"rig.stiffness=100 N/m"}, "[rig]\nspan = '1 mm'\nstiffness = '100 N/m'\nsupports = 'edges'\n"},
           Row{{" rig.stiffness = 'inf' "}, "[rig]\nspan = '1 mm'\nstiffness = 'inf'\nsupports = 'edges'\n"},
           Row{{"rig.stiffness=7", "rig.stiffness=8"}, "[rig]\nspan = '1 mm'\nstiffness = 8\nsupports = 'edges'\n"},
           Row{{"rig.stiffness.uncertainty=1 %"},
               "[rig]\nspan = '1 mm'\nstiffness = { value = '90 N/m', uncertainty = '1 %' }\nsupports = 'edges'\n"},
           Row{{"rig.roller_radius=1 mm"}, "[rig]\nspan = '1 mm'\nstiffness = '90 N/m'\nroller_radius = '1 mm'\n"},
           Row{{"stage.program=[0, '2 mm']", "reduced=true"},
               "reduced = true\n[rig]\nspan = '1 mm'\nstiffness = '90 N/m'\nsupports = 'edges'\n"
               "[stage]\nprogram = [0, '2 mm']\n"},
           Row{{"sweep.axes.mu0=[0.3, 0.5]"},
               "[rig]\nspan = '1 mm'\nstiffness = '90 N/m'\nsupports = 'edges'\n[sweep.axes]\nmu0 = [0.3, 0.5]\n"},
       }) {
    CAPTURE(row.file);
    CHECK((changed(row.changes) == parse_toml(row.file, "case.toml")));
  }
}

TEST_CASE("table: the key of a change, or why it is none") {
  CHECK(changed_key("rig.stiffness=90 N/m") == "rig.stiffness");
  CHECK(changed_key(" rig.stiffness.uncertainty = 1 %") == "rig.stiffness.uncertainty");
  CHECK(changed_key("reduced=true") == "reduced");
  struct Row {
    std::string change, says;
  };
  for (const Row& row : {Row{"rig.stiffness", "SECTION.KEY=VALUE"}, Row{"rig.stifness=3", "rig.stiffness"},
                         Row{"stiffness=3", "rig.stiffness"}, Row{".span=3", "flexslip keys"},
                         Row{"rig.=3", "flexslip keys"}, Row{"rig.nose_radius.uncertainty=1 %", "flexslip keys"}}) {
    CAPTURE(row.change);
    const std::string told = message_of([&] { changed_key(row.change); });
    CHECK(has(told, "--set"));
    CHECK(has(told, row.says));
  }
  CHECK(has(message_of([] { changed({"rig.span="}); }), "Write a value after the ="));
}
