// How a file became the record, step by step, as JSON.
#pragma once

#include "cases/preparation.h"
#include "io/json.h"

namespace flexslip {

// [{step, changed, done, value, uncertainty, unit, rows, key, flag}]: values in SI, rows counted from 1 in the file, null where
// a step has none.
Json preparation_json(const Preparation& preparation);

}  // namespace flexslip
