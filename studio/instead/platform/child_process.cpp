// A page cannot start other programs; every program is reported as not found.
#include "platform/child_process.h"

namespace flexslip {

ChildResult run_child(const std::vector<std::string>&, const ChildOptions&) { return {ChildStatus::not_found, 0, ""}; }

}  // namespace flexslip
