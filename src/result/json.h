// Answers as JSON, for machines. Keys keep their order; numbers read back to the same bits; what does not exist is null.
#pragma once

#include <string>

#include "result/fields.h"

namespace flexslip {

// Writes indented JSON to a file; "-" is standard output.
// Fails:      InputError if not all could be written.
void write_json(const std::string& path, const Json& json);

}  // namespace flexslip
