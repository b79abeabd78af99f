#include "case/standards.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bending_test/standard_reading.h"
#include "case/mechanics.h"
#include "fibre/supported_state.h"
#include "io/input_error.h"
#include "io/quantity.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

// [L] From the origin of the linear region, for any contact of the record.
std::optional<LoadingRead> loading_read(const Measurement& measurement, const SmallDeflection& numbers,
                                        const Scales& scales) {
  const auto counted = [&](std::size_t point) {
    return measurement.first_curve.record.deflection[point] - numbers.origin;
  };
  const double from = reports_chord(numbers) ? numbers.chord->deflection_from : counted(numbers.first);
  const double to = reports_chord(numbers) ? numbers.chord->deflection_to : counted(numbers.last - 1);
  const LoadingRead read{.from = std::max(scales.reduced_length(from), 0.0),
                         .to = scales.reduced_length(to),
                         .greatest = scales.reduced_length(std::max(to, numbers.greatest.deflection))};
  if (!(read.to > std::max(read.from, min_stage) && read.to <= deepest_on_supports)) return std::nullopt;
  return read;
}

// Of both supports, as stated for a simulation.
std::optional<ShareRange> stated_friction(const Test& test) {
  if (!test.friction || !test.friction->mu0) return std::nullopt;
  const double mu = *test.friction->mu0;
  const double other = test.other ? test.other->mu0.value_or(mu) : mu;
  return ShareRange{std::min(mu, other), std::max(mu, other)};
}

// The supports of a case; if not stated, knife edges and rollers of the usual radius; [L] of a
// span.
std::vector<Supports> possible_supports(const Test& test, const Scales& scales) {
  std::vector<Supports> possible{supports_of(test, scales)};
  if (const auto usual = standard_roller_radius(geometry_of(test))) {
    possible.push_back(possible.front());
    possible.back().radius = scales.reduced_length(*usual);
  }
  return possible;
}

// For the friction of the case or the usual range, by the map of the specimen on its supports.
Steepening steepening_of(const Test& test) {
  return [&test](DeflectionRange earlier, DeflectionRange later) {
    const BeamGeometry geometry = geometry_of(test);
    const Scales scales(*geometry.span, 1);
    const double most =
        std::min(stated_friction(test).value_or(usual_friction).most, pin_limit_of(test).value_or(infinity));
    const auto read = [&](const DeflectionRange& range) {
      return LoadingRead{.from = std::max(scales.reduced_length(range.from), 0.0),
                         .to = scales.reduced_length(range.to),
                         .greatest = scales.reduced_length(std::max(earlier.to, later.to))};
    };
    double steeper = 0;
    for (const Supports& supports : possible_supports(test, scales)) {
      const bool is_supported = supports.radius > 0 || supports.half_depth > 0;
      const Fibre fibre = is_supported ? Fibre(supports) : Fibre();
      for (const double friction : {0.0, most}) {
        const auto before = standard_reading(fibre, friction, read(earlier)),
                   after = standard_reading(fibre, friction, read(later));
        if (!before || !after) return max_steepening(geometry, std::midpoint(later.from, later.to));
        steeper = std::max(steeper, after->modulus / before->modulus - 1);
      }
    }
    return steeper;
  };
}

constexpr ShareRange none_yet{infinity, -infinity};
void widen(ShareRange& range, double share) { range = {std::min(range.least, share), std::max(range.most, share)}; }

}  // namespace

SmallDeflection small_deflection_of(const Measurement& measurement, const std::optional<ForceWindow>& window) {
  const Test& test = measurement.test;
  const BeamGeometry geometry = geometry_of(test);
  SmallDeflectionOptions options{.window = window};
  if (measurement.is_derived) options.load_train_error = rig_errors_of(measurement).load_train;
  if (test.reduced) options.greatest_modulus = infinity;
  const Record& record = measurement.first_curve.record;
  options.halts = measurement.sampling.halts_among(measurement.first_curve.points);
  options.steepening = steepening_of(test);
  if (measurement.contact == ContactSource::stated) options.contact = normal_estimate(0, measurement.contact_error);
  return small_deflection(record, window ? find_linear_region(record, geometry, options) : measurement.straight,
                          geometry, options);
}

std::optional<ShareRange> friction_range_of(const std::vector<std::string>& words) {
  if (words.empty()) return std::nullopt;
  const auto friction = [](const std::string& text) {
    return quantity_of_flag("--friction", text, kind::number, Range::non_negative);
  };
  const ShareRange range{friction(words.front()), friction(words.back())};
  if (range.least <= range.most && range.most <= largest_q_on_supports) return range;
  throw InputError(
      {.field = "--friction",
       .problem = fmt::format("One value, or two in increasing order, between 0 and {:g} can be given, not {}",
                              largest_q_on_supports, fmt::join(words, " and "))});
}

SupportsGain supports_gain(const Measurement& measurement, const SmallDeflection& numbers,
                           const std::optional<ShareRange>& stated) {
  const Test& test = measurement.test;
  SupportsGain gain;
  if (!test.rig || !test.rig->span) return gain;
  const Scales scales(*test.rig->span, 1);
  const auto read = loading_read(measurement, numbers, scales);
  const Supports supports = supports_of(test, scales);
  const bool is_supported = supports.radius > 0 || supports.half_depth > 0;
  const bool is_known = section_of(test).has_value();
  if (!read || !(is_supported || is_known)) return gain;
  const Fibre fibre = is_supported ? Fibre(supports) : Fibre();
  const auto without = standard_reading(fibre, 0, *read);
  if (!without) return gain;
  if (is_supported) gain.alone = without->modulus - 1;
  if (!is_known) return gain;

  const auto said = stated ? stated : stated_friction(test);
  const ShareRange range = said.value_or(usual_friction);
  const double pins = pin_limit_of(test).value_or(infinity);
  FrictionGain gained{.friction = range,
                      .modulus = none_yet,
                      .strength = none_yet,
                      .work = none_yet,
                      .is_stated = said.has_value(),
                      .turns = pins < range.most};
  // Interior points too: with friction, before the surface slides back in, strength decreases with
  // friction.
  constexpr int frictions = 3;
  for (int i = 0; i < frictions; ++i) {
    const double friction = std::lerp(range.least, range.most, i / (frictions - 1.0));
    const auto with = standard_reading(fibre, std::min(friction, pins), *read);
    if (!with) return gain;
    widen(gained.modulus, with->modulus / without->modulus - 1);
    widen(gained.strength, with->stress / without->stress - 1);
    widen(gained.work, with->work);
  }
  gain.friction = gained;
  return gain;
}

}  // namespace flexslip
