// What a load-unload-reload test says, as JSON.
#pragma once

#include <cstddef>

#include "cases/fitted_test.h"
#include "io/json.h"

namespace flexslip {

// Row of the file, counted from 1, at which a point of the cyclic record begins. Domain: test.cycles is given.
std::size_t cyclic_row(const FittedTest& test, std::size_t point);

std::string name_of(CyclesStatus status);
std::string name_of(DamageVerdict verdict);

// Units:      as fit_json; contacts count from the zero that the stage has in it.
// Fails:      never: null for a test that was not unloaded; where the loops say nothing, what depends on them is null or empty,
//             and "status" says why.
Json cycles_json(const FittedTest& test);

}  // namespace flexslip
