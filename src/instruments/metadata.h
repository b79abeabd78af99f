// What an export says about its test besides the numbers.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "io/number_format.h"
#include "io/sheet.h"

namespace flexslip {

struct Metadatum {
  std::string name, value;  // as in the file
  std::size_t line;
};

// What is known of the test besides its curve, where the file says so.
struct ExportedTest {
  std::optional<double> span, diameter, width, thickness;  // [m]
  std::optional<double> rate;                              // [m/s]
  bool operator==(const ExportedTest&) const = default;
};

// A line of a preamble: "Name: value", or cells of which the first is the name. A comment is read without its #.
// Lines count from 0; that of the datum from 1.
Metadatum metadatum_on(const Sheet& sheet, std::size_t line);

// The values whose words and units are those of the test; one that is named twice with different values is not known.
ExportedTest test_in(std::span<const Metadatum> metadata, const NumberFormat& format);

// Is it the highest force of a test?
bool states_maximum_force(const Metadatum& datum);

// The highest force that the file states, "Maximum Load, 6.95912, N". [N]
struct StatedForce {
  double value;
  const Metadatum* where;
};
std::optional<StatedForce> stated_maximum(std::span<const Metadatum> metadata, const NumberFormat& format);

// The name that the file gives its specimen; empty if none.
std::string specimen_name(std::span<const Metadatum> metadata);

}  // namespace flexslip
