// What is done, and the time left, on standard error.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "cli/output.h"

namespace flexslip {

// How much of a work is done. May be called on any thread, as often as one likes.
using ProgressFunction = std::function<void(std::uint64_t done, std::uint64_t all)>;

// Shows it a few times a second, or in a log once a minute: "1200 of 5000 designs, 12 s left". Empty if the output is quiet.
ProgressFunction progress_of(const std::string& what, const Output& output);

}  // namespace flexslip
