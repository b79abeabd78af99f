// A sweep: designs on a grid or a Latin hypercube of parameters (docs/sweeps.md). A row is one
// design: its parameters and the outcome of its test. Each row follows from the plan alone and uses
// only operations of IEEE 754, so every computer computes the same bits.
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

// Every combination of the values of all axes; the last axis changes fastest.
struct Grid {};

// Each axis is divided into as many strata as there are samples; each stratum contains one sample.
struct LatinHypercube {
  std::uint64_t samples;
  std::uint64_t seed;
};

struct SweepPlan {
  Test loading;  // as one_loading_of returns it
  // at least one, in the order of the file; axes from `changes` come last
  std::vector<DesignAxis> axes;
  std::variant<Grid, LatinHypercube> method;
  std::uint64_t rows;  // at least 1
};

// Reads a case with a section [sweep]. Every value of the axes must be valid for the case.
// Fails:      throws InputError with file, line and key.
SweepPlan read_sweep(std::string_view text, const std::string& source, const std::vector<std::string>& changes = {});

// The same for a file; "-" is standard input.
SweepPlan read_sweep(const std::string& path, const std::vector<std::string>& changes = {});

// The parameters of a row, one per axis, in the units of the case.
// Domain:     row < plan.rows; std::invalid_argument otherwise.
// Method:     a Latin hypercube finds the stratum of a row by a keyed permutation: a Feistel
//             network, repeated until the result is in range. No table is stored.
std::vector<double> inputs_of(const SweepPlan& plan, std::uint64_t row);

// Consecutive rows of a sweep, counted from 0.
struct RowSpan {
  std::uint64_t first, count;
};

// The designs of some rows, in order. They depend neither on the span nor on the number of threads.
// Domain:     rows of the plan; std::invalid_argument otherwise.
// Cost:       about 0.2 ms per row and thread.
std::vector<DesignPoint> points_of(const SweepPlan& plan, RowSpan rows, unsigned threads);

}  // namespace flexslip
