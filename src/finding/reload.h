// What a specimen that was loaded again says of its stiffness, whether friction can be told of it or not.
#pragma once

#include <optional>
#include <string>

#include "case/fitted.h"
#include "finding/finding.h"

namespace flexslip {

// By the initial slopes of its loadings; of a test with an answer as it was judged.
ReloadChange reload_of(const FittedTest& test);

// It is softer than it can be without damage; or, else, it has changed by more than its error.
std::optional<Finding> softer_reload(const FittedTest& test);
std::optional<Finding> changed_reload(const FittedTest& test);

// What a reload and the loops say beside the first loading; empty where the specimen was loaded once.
std::string reload_in_words(const FittedTest& test);

}  // namespace flexslip
