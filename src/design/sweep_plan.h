// A sweep: a test some of whose numbers go through a grid or a Latin hypercube (docs/sweeps.md). A row is one design: the numbers that make it, and
// what its test will show.
//
// Every row follows from the plan alone, so that any computer can compute any of them: with the operations of IEEE 754
// only, which give the same bits on all.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "case/case_file.h"
#include "design/design_axis.h"
#include "design/design_result.h"
#include "io/hdf5.h"

namespace flexslip {

// Every value of an axis with every value of the others; the last axis changes fastest.
struct Grid {};

// Every axis is cut into as many strata as there are samples, and each stratum is met once.
struct LatinHypercube {
  std::uint64_t samples;
  std::uint64_t seed;
};

struct SweepPlan {
  Test input;
  std::string text;                  // the whole file
  std::vector<std::string> changes;  // of it, from the command line
  std::vector<DesignAxis> axes;      // at least one, as the file orders them; those that only the changes have, last
  std::variant<Grid, LatinHypercube> method;
  std::uint64_t rows;  // at least 1
};

// Reads a case with a section [sweep].
// Fails:      InputError with file, line and key.
SweepPlan read_sweep(std::string_view text, const std::string& source, const std::vector<std::string>& changes = {});

// The same from a file; "-" is standard input. All that the axes hold is checked to be a number that the case may have.
SweepPlan read_sweep(const std::string& path, const std::vector<std::string>& changes = {});

// [1] points of each axis of a grid; empty for a Latin hypercube.
std::vector<std::uint64_t> shape_of(const SweepPlan& plan);

// The numbers of a row, one for each axis: SI or reduced, as the case.
// Domain:     row < plan.rows; std::invalid_argument otherwise.
// Method:     for a Latin hypercube, the stratum of a row is that of a keyed permutation, a Feistel network walked along its
//             cycles until it is back in range; so no table of the permutation is held.
std::vector<double> inputs_of(const SweepPlan& plan, std::uint64_t row);

// The outcomes of a row from its inputs.
using RowFunction = std::function<std::vector<double>(std::span<const double> inputs)>;

// The i-th of some rows from all over the sweep, however few are taken.
// Method:     the fractional parts of multiples of the golden ratio.
std::uint64_t row_from_all_over(const SweepPlan& plan, std::uint64_t i);

// Rows are computed, kept and counted out to computers in chunks of this many; the last one may have fewer.
std::uint64_t rows_in_chunk(const SweepPlan& plan);
std::uint64_t chunks_of(const SweepPlan& plan);

struct RowSpan {
  std::uint64_t first, count;
};
RowSpan rows_of_chunk(const SweepPlan& plan, std::uint64_t chunk);

struct SweepColumn {
  std::string path;         // in the HDF5 file, "/outcomes/snaps"
  std::string units;        // "N"; "EI/L^2" if the case is reduced; "1" of a plain number
  std::string description;  // a sentence without its full stop
  StoredAs stored_as;
};

// The inputs, in the order of the axes, and after them the outcomes.
std::vector<SweepColumn> columns_of(const SweepPlan& plan);

// The column whose values are ResultStatus.
std::size_t status_column(const SweepPlan& plan);

// Computes rows; what it answers does not depend on what it was asked before.
class RowComputer {
 public:
  // Fails:      InputError as one_loading_of.
  explicit RowComputer(const SweepPlan& plan);

  // The outcomes of a row, one for each of their columns; NaN, and counts 0, where there is no design.
  std::vector<double> operator()(std::span<const double> inputs);

 private:
  std::vector<std::string_view> parameters_;
  Test loading_;
};

// Of all that the numbers of a sweep follow from, as 64 hexadecimal digits: the case with the content of its files, the axes,
// the version of the program; and of some of the numbers, which tell programs of one version apart that compute others.
// Comments, layout and file names are not in it.
// Fails:      InputError if a file of the case cannot be read.
// Cost:       that of a few designs.
std::string digest_of_sweep(const SweepPlan& plan);

// The same for outcomes that are computed so.
std::string digest_of_sweep(const SweepPlan& plan, const RowFunction& outcomes_of);

}  // namespace flexslip
