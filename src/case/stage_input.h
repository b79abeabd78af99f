// What a case says of the loading, [stage]. Units: those of a physical case (case_file.h).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bending_test/motion.h"

namespace flexslip {

// Positions between which the stage moves straight on; one that is repeated is a halt.
struct TurningPoints {
  std::vector<double> positions;  // [m] at least two
  std::uint64_t cycles;           // how often all after the first is gone through
  std::optional<double> step;     // [m] none: continuous, with exact snaps
  bool operator==(const TurningPoints&) const = default;
};

// Positions row by row from a table. Titles of columns as read_table takes them.
struct MeasuredProgramme {
  std::string file;  // relative to the working directory
  std::string stage;
  std::optional<std::string> time;  // must not run back
  char decimal;                     // '.' or ','
  bool operator==(const MeasuredProgramme&) const = default;
};

struct StageInput {
  std::variant<TurningPoints, MeasuredProgramme> programme;
  SnapRest snaps = SnapRest::nearest_stable;
  bool operator==(const StageInput&) const = default;
};

}  // namespace flexslip
