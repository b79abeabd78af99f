// Two quantities tabulated over a coordinate x and the mobilised friction q, in cells that are
// filled on demand.
//
// The table interpolates X/x by polynomials of degree 7 in x and q. X/x is smooth down to the
// straight specimen, where X vanishes in proportion to x. Reduced variables. Thread-safe.
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
  // The argument: the coordinate itself, or a length S with the coordinate √(S - 1). Slopes are
  // with respect to the argument.
  enum class Along { coordinate, length };

  struct Axes {
    double x_most;  // x from 0 to x_most
    std::size_t x_cells;
    double q_least, q_most;
    std::size_t q_cells;
  };

  struct Pair {
    std::vector<double> first, second;
  };
  // X/x of both quantities at points x[i], q[i]; NaN without a state. Within a cell, each x is
  // paired with nodes_across successive q.
  static constexpr std::size_t nodes_across = 8;
  using Source = std::function<Pair(std::span<const double> x, std::span<const double> q)>;

  // A cell is empty if the source lacks one of its nodes, or the far corner at the smallest q.
  CellTable(Along along, const Axes& axes, Source source);

  // Values at `count` points; NaN outside the axes, at x = 0, and in empty cells.
  void values(const double* at, const double* q, std::size_t count, double* first, double* second) const;

  // Values and slopes: first, second, the slopes of first (along and in q), the slopes of second.
  void slopes(const double* at, const double* q, std::size_t count, const std::array<double*, 6>& columns) const;

 private:
  using Cells = std::vector<std::atomic<const double*>>;

  std::vector<double> coefficients_of(std::size_t x_cell, std::size_t q_cell) const;
  bool build(double at, double q) const;
  std::vector<std::size_t> built_for(const double* at, const double* q, std::span<const double> values) const;

  Along along_;
  Axes axes_;
  Source source_;
  mutable Cells cells_;  // the last is all NaN: for points outside the axes, and initially for all
  mutable std::mutex building_;
  mutable std::vector<std::unique_ptr<const std::vector<double>>> built_;
};

}  // namespace flexslip
