// The file that a sweep ends in, as the commands `sweep` and `merge` make it.
#pragma once

#include <span>
#include <string>

#include "cli/output.h"
#include "design/sweep_parts.h"

namespace flexslip {

// The path as it is.
// Fails:      InputError if it is empty or standard output.
std::string file_to_write(const std::string& path);

// Announces the file (CallFiles), before anything is read.
void announce_sweep(const std::string& path);

// Joins the parts in a file, and says what came of it on standard output. The file is safe on the disk when this returns.
// Fails:      InputError if the file cannot be written; CalculationFailed, naming the parts, if some are missing or damaged.
void join_parts(std::span<const SweepParts> folders, const std::string& path, const Output& output);

}  // namespace flexslip
