// A campaign as JSON: the form that scripts read.
#pragma once

#include "cases/campaign_test.h"
#include "io/json.h"

namespace flexslip {

// {tests: [{name, status, category, suspect, parameters, …}], categories: {NAME: {tests, mu0: {mean, min, max, n}, …,
// with_suspects: {…}}}, failures: [{name, reason, …}], shared: [{name, value, …}], units}. Categories leave suspects out, as the
// paper does, and hold them under with_suspects.
// Units:      SI and radians.
// Fails:      never: what does not exist is null.
Json campaign_json(const Campaign& campaign);

}  // namespace flexslip
