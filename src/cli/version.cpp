#include "cli/version.h"

#ifndef FLEXSLIP_COMMIT
#define FLEXSLIP_COMMIT ""
#endif

namespace flexslip {

std::string version_in_words() { return "flexslip " FLEXSLIP_VERSION FLEXSLIP_COMMIT; }

}  // namespace flexslip
