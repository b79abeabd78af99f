// A page starts no other program: none is found, and whoever asked says what is missing.
#include "io/child_process.h"

namespace flexslip {

ChildResult run_child(const std::vector<std::string>&, const ChildOptions&) { return {ChildStatus::not_found, 0, ""}; }

}  // namespace flexslip
