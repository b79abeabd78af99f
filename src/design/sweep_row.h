// A row of a sweep: the numbers that make a design, and what its test will show.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "design/design_case.h"
#include "design/sweep_plan.h"
#include "io/hdf5.h"

namespace flexslip {

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
  // Fails:      InputError as DesignCase.
  explicit RowComputer(const SweepPlan& plan);

  // The outcomes of a row, one for each of their columns; NaN, and counts 0, where there is no design.
  std::vector<double> operator()(std::span<const double> inputs);

 private:
  std::vector<DesignParameter> parameters_;
  DesignCase case_;
};

}  // namespace flexslip
