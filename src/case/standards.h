// The results of the bending standards for a measured test, and the effect of supports and friction
// on them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/measurement.h"
#include "data/small_deflection.h"

namespace flexslip {

// As small_deflection, with the load-train uncertainty of the case or the default.
SmallDeflection small_deflection_of(const Measurement& measurement, const std::optional<ForceWindow>& window = {});

// [1] least <= most.
struct ShareRange {
  double least, most;
};

// The default friction range: dry metals, glass, ceramics and plastics on steel.
inline constexpr ShareRange usual_friction{0.1, 0.5};

// A range from one or two words, "0.3" or "0.1" and "0.5"; empty without words.
// Domain:     at most two words.
// Fails:      InputError for --friction, unless the values do not decrease and lie between 0 and
//             largest_q_on_supports.
std::optional<ShareRange> friction_range_of(const std::vector<std::string>& words);

// [1] The effect of friction in a range on the results.
struct FrictionGain {
  ShareRange friction;
  ShareRange modulus;   // relative change; below 0: a decrease
  ShareRange strength;  // relative change of the stress at the maximum force
  ShareRange work;      // friction share of the work up to the maximum force
  bool is_stated;       // true if the call or [friction] mu0 states it
  bool turns;           // true if rollers turn on their pins below the maximum friction
};

struct SupportsGain {
  // [1] The part of the modulus due to rollers and thickness without friction, between the
  // deflections of the chord or of the linear region. Empty without a span, or for knife edges and
  // no thickness.
  std::optional<double> alone{};
  std::optional<FrictionGain> friction{};  // empty without a section, and beyond the range of the map
};

// Domain:     results for the record of the measurement, with status ok.
// Fails:      InputError as supports_of.
// Max error:  1e-9 of the difference of two forces, for an elastic specimen with uniform friction.
SupportsGain supports_gain(const Measurement& measurement, const SmallDeflection& numbers,
                           const std::optional<ShareRange>& stated = {});

}  // namespace flexslip
