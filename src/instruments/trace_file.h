// Height profiles of microscopes and profilometers: text exports of Gwyddion, tables of two
// columns, heights alone.
#pragma once

#include <optional>
#include <string>

#include "contact/height_trace.h"
#include "instruments/export.h"
#include "io/quantity.h"

namespace flexslip {

// Choices of the user for a height profile, by keys of [friction]. Everything else is detected.
struct TraceOptions {
  std::string position{}, height{};  // columns: name, number, or name with its unit in brackets, "z [nm]"
  std::optional<double> step{};      // [m] spacing of the heights, for a file without positions
};

struct TraceFile {
  std::string source;
  std::string position, height;  // the columns used, by their names in the file; no position if the spacing is stated
  HeightTrace trace;             // [m]
};

// The minimum number of heights.
inline constexpr std::size_t fewest_heights = 64;

// Reads a height profile; "-" is standard input. For plain numbers, as in reduced cases, columns
// have no unit.
// Method:     of two columns of numbers, the first is the position. Of more, the titles decide: x,
//             s, position, distance, lateral; z, y, height, topography.
// Fails:      InputError with file, line, column and remedy: no numbers, indistinguishable columns,
//             missing or wrong units, positions that do not increase, too few heights.
TraceFile read_trace(const std::string& path, const TraceOptions& options, const Kind& kind = kind::length);

}  // namespace flexslip
