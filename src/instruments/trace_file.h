// Height profiles as microscopes, profilometers and their programs write them: Gwyddion's text exports, tables of two columns, heights alone.
#pragma once

#include <optional>
#include <string>

#include "contact/height_trace.h"
#include "instruments/export.h"
#include "io/quantity.h"

namespace flexslip {

// What a user decides about a trace, by keys of [friction]; all else is found.
struct TraceOptions {
  std::string position{}, height{};  // columns: name, number, or name with its unit in brackets, "z [nm]"
  std::optional<double> step{};      // [m] between heights, of a file without positions
};

struct TraceFile {
  std::string source;
  std::string position, height;  // the columns taken, as the file calls them; no position where a step was stated
  HeightTrace trace;             // [m]
};

// The fewest heights that make a trace.
inline constexpr std::size_t fewest_heights = 64;

// Reads a trace; "-" is standard input. Numbers without a unit where the kind is that of plain numbers, as in reduced cases.
// Method:     of two columns of numbers the first is the position. Of more, those whose words say so: x, s, position, distance, lateral; z, y, height, topography.
// Fails:      InputError with file, line, column and remedy: no numbers, columns that cannot be told apart, units that are missing or of another kind, a
//             position that does not rise, too few heights.
TraceFile read_trace(const std::string& path, const TraceOptions& options, const Kind& kind = kind::length);

}  // namespace flexslip
