// What a fitted test says, sentence by sentence: the one content that the text on a terminal and the report lay out.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "case/fitted.h"
#include "finding/printed.h"

namespace flexslip {

// What the literature gives for the materials that the case states.
std::optional<LiteratureFriction> literature_of(const FittedTest& test);

// Why a test has no answer, and what to look at; "" if it has one.
std::string why_no_answer(const FittedTest& test);

// Domain of all below: analysis.status is ok.

// "roughness", or "'sinusoid', the paper's": what was fitted, in words.
std::string model_in_words(ProfileModel model);

// Sentences, each complete in itself.
std::string friction_in_words(const FittedTest& test);  // of the specimen as tested: its mean, and how it varies
std::string wave_in_words(const FittedTest& test);      // whether friction repeats along the specimen
std::string sides_in_words(
    const FittedTest& test);  // what its lengths are if one side slides at a time; "" without any
std::string friction_in_literature(const FittedTest& test);

// How far the specimen was strained; nothing without a section.
std::string strain_in_words(const FittedTest& test);
std::string slips_in_words(const FittedTest& test);
std::string snaps_in_words(const FittedTest& test);
std::string suspicion_in_words(const FittedTest& test);
std::string replay_in_words(const FittedTest& test);
std::vector<std::string> assumptions_of(const FittedTest& test);

}  // namespace flexslip
