#include <limits>
#include <string>
#include <string_view>

#include <doctest/doctest.h>

#include "report/answer_documents.h"
#include "tests/design/some_design.h"

namespace flexslip {
namespace {

// Of a finer roughness than the example's, for more teeth.
Test fine() { return loading_of(with("40 um", "10.9 um")); }

std::string all_words(const DesignAnswer& answer) { return in_text(document_of(answer), 10'000); }

bool holds(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

}  // namespace

TEST_CASE("table: the answer in a sentence, for every kind of test") {
  const auto with_value = [](std::string_view parameter, double value) {
    Test input = fine();
    set(input, parameter, value);
    return design_in_short(answer_of(input));
  };
  CHECK(design_in_short(answer_of(fine())).starts_with("Yes, you will see a sawtooth: the force drops by up to "));
  CHECK(with_value("travel", 466e-6).starts_with("Yes: the specimen will snap, once."));
  CHECK(with_value("stiffness", 600).starts_with("No sawtooth, but a wavy force"));
  CHECK(with_value("mu0", 0).ends_with("past a smooth peak of the force."));
  CHECK(with_value("travel", 300e-6).ends_with("and the force never falls."));
  Test waves = fine();  // too small to be seen, past the peak of the force
  set(waves, "amplitude", 0.0015);
  set(waves, "wavelength", 400e-9);
  CHECK(design_in_short(answer_of(waves)).starts_with("No visible sawtooth: the specimen will snap "));
  Test coarse = fine();
  set(coarse, "travel", 466e-6);
  set(coarse, "step", 233e-6);
  CHECK(design_in_short(answer_of(coarse)).ends_with("but readings 233 µm apart will not show it."));
}

TEST_CASE("identity: the sentences contain the numbers of the answer") {
  const auto answer = answer_of(fine());
  const std::string all = all_words(answer);
  const auto& scales = answer.scales;
  const auto& outcome = answer.outcome;
  CHECK(holds(all, readable(scales.physical_length(outcome.first_snap.value().stage), kind::length)));
  CHECK(holds(all, "a deflection of " + readable(scales.physical_length(outcome.w_reached), kind::length)));
  CHECK(holds(all, "times, by up to " + readable(scales.physical_force(outcome.largest_drop), kind::force)));
  CHECK(holds(all, std::to_string(outcome.snaps) + " up to the stage position"));
  CHECK(holds(all, "the specimen snaps with each of 24"));
  CHECK(changes_in_words(answer).size() == answer.changes.size());
}

TEST_CASE(
    "identity: the text of a second loading contains its plan and its probabilities, or that there is nothing to "
    "decide") {
  Test input = fine();
  set(input, "travel", 560e-6);
  auto answer = answer_of(input);
  CHECK(!holds(all_words(answer), "Slips or cracks"));
  answer.reload = reload_study(input, {});
  const std::string words = all_words(answer);
  CHECK(holds(words,
              "A second loading will distinguish slips from cracks: load to the stage position 560 µm, unload to "));
  CHECK(holds(words,
              std::to_string(answer.reload->of_travel().drops) + " drops; if they were cracks only, they would cost "));
  CHECK(holds(words, "99 of 100 tests with cracks only"));
  CHECK(holds(words, "pass --noise if it is known"));
  answer.reload->drops = 0;
  CHECK(holds(all_words(answer), "No drops are expected in this loading: there is nothing to decide."));
}

TEST_CASE("limit: infinite and missing values are described in words") {
  Test input = fine();
  set(input, "stiffness", std::numeric_limits<double>::infinity());
  CHECK(holds(all_words(answer_of(input)), "load train      infinite stiffness; "));
  set(input, "mu0", 0);
  const std::string slippery = all_words(answer_of(input));
  CHECK(holds(slippery, "none, however soft, lets the specimen snap"));
  CHECK_FALSE(holds(slippery, "nan"));
  CHECK_FALSE(holds(slippery, " inf "));
}

}  // namespace flexslip
