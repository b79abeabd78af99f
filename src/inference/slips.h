// The drops of a record as slips of the specimen over its supports.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "data/drops.h"
#include "inference/profile.h"

namespace flexslip {

// Can a drop of the force be a slip of the specimen over its supports?
enum class SlipVerdict {
  possible,     // length is drawn in, and friction stays between nothing and what is plausible
  unexplained,  // no friction gives the force before or after
  implausible,  // friction before it would be beyond the limit, by twice its error
  negative,     // friction after it would be below 0, likewise
  moves_out,    // length would be let out, likewise
  too_short,    // what is drawn in is less than its error
};

std::string_view name_of(SlipVerdict verdict);

// Neither possible nor too short to judge.
inline bool is_no_slip(SlipVerdict verdict) {
  return verdict != SlipVerdict::possible && verdict != SlipVerdict::too_short;
}

// One drop of the force as a slip: how far the fibre moved over its supports, and how friction fell.
struct Slip {
  Drop drop;
  SlipVerdict verdict;
  double S_before, S_after;    // [L] NaN where unexplained, as all that follows
  double mu_before, mu_after;  // [1]
  double advance_error;        // [L] standard error of S_after - S_before, by the noise of the force
};

// Each of the drops.
std::vector<Slip> slips_of(const FrictionProfile& profile, std::span<const Drop> drops, const MeasurementErrors& errors,
                           double limit);

// The same drops with lengths and frictions by another profile, that at the bending stiffness of the fit: the verdicts stay, as their limits hold
// for that stated.
std::vector<Slip> told_by(const FrictionProfile& profile, std::span<const Slip> judged,
                          const MeasurementErrors& errors);

// The model-free counterparts of the wavelength and the amplitude of a sawtooth, from the slips that are possible.
struct SlipSummary {
  std::size_t count;
  double
      median_spacing;   // [L] along the fibre, from the beginning of a slip to that of the next; NaN for fewer than two
  double mean_spacing;  // [L] likewise
  double median_fall;   // [1] of μ in a slip; NaN without slips
};
SlipSummary summarise(std::span<const Slip> slips);

}  // namespace flexslip
