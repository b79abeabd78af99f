// Height profiles as microscopes, profilometers and their programs write them: Gwyddion's text exports, tables of two columns, heights alone.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "instruments/export.h"
#include "io/quantity.h"
#include "surface/height_trace.h"

namespace flexslip {

// What a user decides about a trace; all else is found.
struct TraceOptions {
  ExportOptions file{};                        // encoding, separator, decimal mark, thousands
  std::string position{}, height{};            // columns: name, number, or name with its unit in brackets, "z [nm]"
  std::string position_unit{}, height_unit{};  // of columns that state none
  std::optional<double> step{};                // [m] between heights, of a file without positions
};

// The same in words, as those of an export, and "position", "height", "position-unit", "height-unit", "step".
// Fails:      InputError that names the flag.
TraceOptions trace_options_of(const ReadingWords& words);

struct TraceFile {
  std::string source;
  std::string position, height;    // the columns taken, as the file calls them; no position where a step was stated
  std::vector<std::size_t> lines;  // of the file, from 1, of each height of the trace, unless that is interpolated
  Sampled sampled;                 // [m]
  std::vector<std::string> notes;  // what was decided
};

// Reads a trace; "-" is standard input. Numbers without a unit where the kind is that of plain numbers, as in reduced cases.
// Method:     of two columns of numbers the first is the position. Of more, those whose words say so: x, s, position, distance, lateral; z, y, height, topography.
// Fails:      InputError with file, line, column and remedy: no numbers, columns that cannot be told apart, units that are missing or of another kind, a
//             position that does not rise, too few heights.
TraceFile read_trace(const std::string& path, const TraceOptions& options, const Kind& kind = kind::length);

}  // namespace flexslip
