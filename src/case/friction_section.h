// What a case says of friction: [friction], and [friction.other].
#pragma once

#include "case/case_file.h"
#include "case/keys.h"

namespace flexslip {

// Fails:      InputError with file, line and key: no such model, keys of another model, waves that would make friction negative.
FrictionInput read_friction(const Keys& keys, const Case& input);

}  // namespace flexslip
