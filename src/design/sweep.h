// A sweep: a test some of whose numbers go through a grid or a Latin hypercube (docs/sweeps.md). A row is one design: the numbers that make it, and
// what its test will show.
//
// Every row follows from the plan alone, so that any computer can compute any of them: with the operations of IEEE 754
// only, which give the same bits on all.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "case/case_file.h"
#include "design/design_axis.h"
#include "design/design_result.h"

namespace flexslip {

// Every value of an axis with every value of the others; the last axis changes fastest.
struct Grid {};

// Every axis is cut into as many strata as there are samples, and each stratum is met once.
struct LatinHypercube {
  std::uint64_t samples;
  std::uint64_t seed;
};

struct SweepPlan {
  Test loading;                  // as one_loading_of gives it
  std::vector<DesignAxis> axes;  // at least one, as the file orders them; those that only the changes have, last
  std::variant<Grid, LatinHypercube> method;
  std::uint64_t rows;  // at least 1
};

// Reads a case with a section [sweep]. Every value of the axes is checked to be one that the case may have.
// Fails:      InputError with file, line and key.
SweepPlan read_sweep(std::string_view text, const std::string& source, const std::vector<std::string>& changes = {});

// The same from a file; "-" is standard input.
SweepPlan read_sweep(const std::string& path, const std::vector<std::string>& changes = {});

// The numbers of a row, one for each axis: SI or reduced, as the case.
// Domain:     row < plan.rows; std::invalid_argument otherwise.
// Method:     for a Latin hypercube, the stratum of a row is that of a keyed permutation, a Feistel network walked along its
//             cycles until it is back in range; so no table of the permutation is held.
std::vector<double> inputs_of(const SweepPlan& plan, std::uint64_t row);

// Consecutive rows of a sweep, counted from 0.
struct RowSpan {
  std::uint64_t first, count;
};

// The designs of some rows, in their order. Each is the same for any span and any number of threads.
// Domain:     rows of the plan; std::invalid_argument otherwise.
// Cost:       about 0.2 ms a row on one thread.
std::vector<DesignPoint> points_of(const SweepPlan& plan, RowSpan rows, unsigned threads);

}  // namespace flexslip
