// The numbers of the bending standards, for people.
#pragma once

#include <string>
#include <vector>

#include "answers/standard_fields.h"
#include "case/fitted.h"
#include "report/document.h"

namespace flexslip {

// All of `modulus`.
std::vector<Chapter> document_of(const StandardTest& test);

// The numbers in the document of a fit, and how they lie to those of the fit.
Chapter small_deflection_chapter(const FittedTest& test);

// What a reader of these numbers should know, sentence by sentence; one that says why if there are none.
std::vector<std::string> small_deflection_in_words(const StandardTest& test);

}  // namespace flexslip
