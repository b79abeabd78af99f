// The findings as the page is fed them (studio/tests/words_test.mjs): every one there is, as `fit --json` tells it. FLEXSLIP_FREEZE=1 writes them anew.
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include <doctest/doctest.h>

#include "answers/fit_fields.h"
#include "tests/finding/situations.h"

namespace flexslip {

TEST_CASE("findings in JSON are those that the page's test is fed") {
  const std::string path = FLEXSLIP_SOURCE_DIR "/tests/outside/golden/findings.json";
  Json all = Json::array();
  for (const Situation& each : situations()) {
    const Json fit = fit_json(each.test);
    Json findings = Json::array();
    for (Json finding : fit["findings"]) {
      finding.erase("numbers");  // the page shows none of them
      findings.push_back(finding);
    }
    all.push_back({{"found", each.code}, {"verdict", fit["verdict"]}, {"findings", findings}, {"next", fit["next"]}});
  }
  const std::string now = all.dump(1) + "\n";
  if (std::getenv("FLEXSLIP_FREEZE")) std::ofstream(path) << now;
  std::stringstream frozen;
  frozen << std::ifstream(path).rdbuf();
  CHECK(frozen.str() == now);
}

}  // namespace flexslip
