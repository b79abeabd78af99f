// Two quantities of the fibre tabulated over a coordinate x and the mobilised friction q, cell by cell, where they are asked for.
//
// What is interpolated is X/x, smooth down to the straight fibre, where X vanishes as x does: by polynomials of degree 7 in each of x and q.
// Reduced variables. A table may be asked from several threads at once.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace flexslip {

class CellTable {
 public:
  // What is given: the coordinate itself, or a length S of which it is √(S - 1). Slopes are those in what is given.
  enum class Along { coordinate, length };

  struct Axes {
    double x_most;  // from 0
    std::size_t x_cells;
    double q_least, q_most;
    std::size_t q_cells;
  };

  struct Pair {
    std::vector<double> first, second;
  };
  // X/x of both quantities at points x[i], q[i]; NaN where there is no state. Of a cell, each x stands with so many q, one after the other.
  static constexpr std::size_t nodes_across = 8;
  using Source = std::function<Pair(std::span<const double> x, std::span<const double> q)>;

  // Cells of which the source has not all nodes, nor the far corner at the least q, have nothing.
  CellTable(Along along, const Axes& axes, Source source);

  // At `count` points; NaN beyond the axes (x = 0 among what is beyond) and where a cell has nothing.
  void values(const double* at, const double* q, std::size_t count, double* first, double* second) const;

  // The same with slopes: first, second, then the slopes of the first along and in q, and those of the second.
  void slopes(const double* at, const double* q, std::size_t count, const std::array<double*, 6>& columns) const;

 private:
  using Cells = std::vector<std::atomic<const double*>>;

  std::vector<double> coefficients_of(std::size_t x_cell, std::size_t q_cell) const;
  bool build(double at, double q) const;
  std::vector<std::size_t> built_for(const double* at, const double* q, std::span<const double> values) const;

  Along along_;
  Axes axes_;
  Source source_;
  mutable Cells cells_;  // the last, all NaN: of points beyond the axes, and at first of all
  mutable std::mutex building_;
  mutable std::vector<std::unique_ptr<const std::vector<double>>> built_;
};

}  // namespace flexslip
