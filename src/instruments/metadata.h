// Statements of an export about its test, other than the readings.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/number_format.h"
#include "io/sheet.h"

namespace flexslip {

struct Metadatum {
  std::string name, value;  // as in the file
  std::size_t line;
};

// Properties of the test, apart from its curve; empty if the file does not state them.
struct ExportedTest {
  std::optional<double> span, diameter, width, thickness;  // [m]
  std::optional<double> rate;                              // [m/s]
  bool operator==(const ExportedTest&) const = default;
};

// The data on a line of a preamble: "Name: value", cells with the name first, or names and numbers
// alternately. The # of a comment is skipped.
// Lines count from 0; the line of the datum counts from 1.
std::vector<Metadatum> metadata_on_line(const Sheet& sheet, std::size_t line);

// The values with the words and units of a test. A value that is stated twice differently is
// unknown.
ExportedTest test_in(std::span<const Metadatum> metadata, const NumberFormat& format);

// True for the maximum force of a test.
bool states_maximum_force(const Metadatum& datum);

// [N] The maximum force that the file states, "Maximum Load, 6.95912, N".
struct StatedForce {
  double value;
  const Metadatum* where;
};
std::optional<StatedForce> stated_maximum(std::span<const Metadatum> metadata, const NumberFormat& format);

// The name of the specimen in the file; empty if the file gives no name.
std::string specimen_name(std::span<const Metadatum> metadata);

}  // namespace flexslip
