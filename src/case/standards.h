// The numbers of the bending standards of a measured test, and what its supports and friction on them can have done to those.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/measurement.h"
#include "data/small_deflection.h"

namespace flexslip {

// As small_deflection, of a load train as certain as the case says, or as is usual.
SmallDeflection small_deflection_of(const Measurement& measurement, const std::optional<ForceWindow>& window = {});

// [1] least <= most.
struct ShareRange {
  double least, most;
};

// The friction of a standard's specimen where none is stated: dry metals, glass, ceramics and plastics on steel.
inline constexpr ShareRange usual_friction{0.1, 0.5};

// As one or two words say it, "0.3" or "0.1" and "0.5"; none of none.
// Domain:     at most two words.
// Fails:      InputError that names the flag --friction, unless they do not fall and lie between 0 and largest_q_on_supports.
std::optional<ShareRange> friction_range_of(const std::vector<std::string>& words);

// What friction in a range does to what is read off, [1].
struct FrictionGain {
  ShareRange friction;
  ShareRange modulus;   // added, of that without friction; less than 0: taken away
  ShareRange strength;  // added to the stress at the greatest force, likewise
  ShareRange work;      // share of the work up to there that went into friction
  bool is_stated;       // by the call, or as [friction] mu0
  bool turns;           // rollers on pins turn before friction gets to the greatest
};

struct SupportsGain {
  // [1] What rollers and thickness add to the modulus without friction: between the deflections of the chord, or of the straight part. None without a
  // span, or where the supports of the case have neither.
  std::optional<double> alone{};
  std::optional<FrictionGain> friction{};  // none without a section, and beyond what the map has
};

// Domain:     numbers of the record of the measurement, with status ok.
// Fails:      InputError as supports_of.
// Max error:  1e-9 of the difference of two forces; for an elastic specimen with the same friction all along.
SupportsGain supports_gain(const Measurement& measurement, const SmallDeflection& numbers,
                           const std::optional<ShareRange>& stated = {});

}  // namespace flexslip
