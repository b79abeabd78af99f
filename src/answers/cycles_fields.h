// What a load-unload-reload test is told as: every number of `cycles` in `fit --json`, described once.
#pragma once

#include <cstddef>
#include <string_view>

#include "case/fitted.h"
#include "result/fields.h"

namespace flexslip {

// Row of the file, counted from 1, at which a point of the cyclic record begins. Domain: test.cycles is given.
std::size_t cyclic_row(const FittedTest& test, std::size_t point);

std::string_view name_of(CyclesStatus status);
std::string_view name_of(DamageVerdict verdict);
std::string_view name_of(LoadingStatus status);

// Contacts count from the zero that the stage has in it. Where the loops say nothing, what depends on them is null or empty, and "status"
// says why.
// Domain:     test.cycles is given.
Fields<FittedTest> cycles_fields();

}  // namespace flexslip
