// Starting gnuplot is not written for Windows: it counts as not found, and figures remain scripts and
// data.
#include "platform/child_process.h"

namespace flexslip {

ChildResult run_child(const std::vector<std::string>&, const ChildOptions&) { return {ChildStatus::not_found, 0, ""}; }

}  // namespace flexslip
