// What a fitted test says, in words and formatted numbers: the one content that the text on a terminal and the report lay out.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "case/fitted.h"
#include "report/printed.h"

namespace flexslip {

// What the literature gives for the materials that the case states.
std::optional<LiteratureFriction> literature_of(const FittedTest& test);

// The answer in a sentence or two.
std::string answer_of(const FittedTest& test);

struct ParameterRow {
  std::string name;    // as in JSON
  std::string symbol;  // "λ"; empty for the second wave
  std::string meaning;
  std::string value;     // with its standard error, digits to match
  std::string interval;  // of 95 %
  std::string remark;    // why the error is not to be trusted, or what the value depends on; mostly empty
};

// Domain of all below: analysis.status is ok.
std::vector<ParameterRow> parameter_rows(const FittedTest& test);

PrintedTable explanation_table(const FittedTest& test);  // what the answer averages over, likeliest first
PrintedTable drop_table(const FittedTest& test);         // the drops measured, as slips
PrintedTable snap_table(const FittedTest& test);         // the snaps of the mean run forward
PrintedTable energy_table(const FittedTest& test);

// "roughness", or "'sinusoid', the paper's": what was fitted, in words.
std::string model_in_words(ProfileModel model);

// "0.36 ± 0.02", or "at most 0.22".
std::string mean_friction(const FrictionFit& fit);

// Sentences, each complete in itself.
std::string friction_in_words(const FittedTest& test);  // of the specimen as tested: its mean, and how it varies
std::string wave_in_words(const FittedTest& test);      // whether friction repeats along the specimen
std::string sides_in_words(
    const FittedTest& test);  // what its lengths are if one side slides at a time; "" without any
std::vector<std::string> checks_in_words(const FittedTest& test);  // those that failed begin with "Failed"
std::string friction_in_literature(const FittedTest& test);

// What is to be said before the friction and the energies of a specimen that lost stiffness; else nothing.
std::string caution_of(const FittedTest& test);

// How far the specimen was strained; nothing without a section.
std::string strain_in_words(const FittedTest& test);
std::string slips_in_words(const FittedTest& test);
std::string snaps_in_words(const FittedTest& test);
std::string suspicion_in_words(const FittedTest& test);
std::string replay_in_words(const FittedTest& test);
std::vector<std::string> assumptions_of(const FittedTest& test);

}  // namespace flexslip
