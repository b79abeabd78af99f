// What `keys --json` tells of a key of case files.
#pragma once

#include "case/case_keys.h"
#include "result/fields.h"

namespace flexslip {

Fields<CaseKey> key_fields();

}  // namespace flexslip
