// Compiled once for each instruction set (Highway's foreach_target.h).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fibre/cell_table.cpp"
#include "fibre/cell_table.h"

#include <cstddef>
#include <vector>

#include <hwy/foreach_target.h>  // must come before highway.h

#include "fibre/cell_row-inl.h"
#include "fibre/lanes-inl.h"

#ifndef FLEXSLIP_FIBRE_CELL_TABLE_CPP_
#define FLEXSLIP_FIBRE_CELL_TABLE_CPP_
namespace flexslip {

// A cell in memory: a polynomial of degree 7 in x and y, the coordinates in [-1, 1] along x and q.
// Each of eight rows belongs to a power of y. It has the coefficients of 1, x, ..., x^7 for the
// first quantity, then for the second. A row fills vectors of any width (cell_row-inl.h).
struct CellLayout {
  static constexpr std::size_t terms = terms_of_row;  // of each polynomial
  static constexpr std::size_t row = 2 * terms;
  static constexpr std::size_t cell = terms * row;
};

struct CellGrid {
  const std::atomic<const double*>* cells;
  double x_scale, q_scale, q_least, x_cells, q_cells;
};

// The positions of points in the table: the cell number and the coordinates within the cell.
inline constexpr std::size_t block = 64;
struct Places {
  alignas(64) double along[block];
  alignas(64) double x[block];
  alignas(64) double y[block];
  alignas(64) double cell[block];
};

}  // namespace flexslip
#endif

HWY_BEFORE_NAMESPACE();
namespace flexslip::HWY_NAMESPACE {

// Converts the argument to the coordinate, and g and dg/dx to the slope of X = x g.
struct OfLength {
  template <class T>
  static HWY_INLINE T coordinate(T S) {
    return sqrt(S - 1.0);
  }
  static HWY_INLINE double slope(double sigma, double g, double g_sigma) {
    return 0.5 * (g / sigma + g_sigma);  // dσ/dS = 1/(2σ)
  }
};
struct OfCoordinate {
  template <class T>
  static HWY_INLINE T coordinate(T x) {
    return x;
  }
  static HWY_INLINE double slope(double x, double g, double g_x) { return g + x * g_x; }
};

// For one point, or one point per lane.
template <class T>
struct Place {
  T along, x, y, cell;
};
template <class Of, class T>
HWY_INLINE Place<T> place_of(const CellGrid& grid, T given, T friction) {
  const T coordinate = Of::coordinate(given);
  const T along = coordinate * grid.x_scale, across = (friction - grid.q_least) * grid.q_scale;
  const T i_x = floor(along), i_q = floor(across);
  const auto inside = (T(0.0) < along) & (along < T(grid.x_cells)) & (T(-1.0) < i_q) & (i_q < T(grid.q_cells));
  return {coordinate, 2.0 * (along - i_x) - 1.0, 2.0 * (across - i_q) - 1.0,
          choose(inside, i_x * grid.q_cells + i_q, T(grid.x_cells * grid.q_cells))};
}

template <class Of>
HWY_INLINE void find_places(const CellGrid& grid, const double* at, const double* q, std::size_t count,
                            Places& places) {
  if (count == 1) {  // vectors would take five times as long
    const auto [along, x, y, cell] = place_of<Of, double>(grid, at[0], q[0]);
    places.along[0] = along, places.x[0] = x, places.y[0] = y, places.cell[0] = cell;
    return;
  }
  for_each_lanes(at, q, count, [&](std::size_t i, std::size_t n, Lanes given, Lanes frictions) HWY_ATTR {
    const auto [along, x, y, cell] = place_of<Of, Lanes>(grid, given, frictions);
    store(along, places.along + i, n);
    store(x, places.x + i, n);
    store(y, places.y + i, n);
    store(cell, places.cell + i, n);
  });
}

// The polynomial at y, in powers of x.
HWY_INLINE Row at_y(const double* rows, InEachLane y) {
  Row sum = load_row(rows + (CellLayout::terms - 1) * CellLayout::row);
  for (std::size_t r = CellLayout::terms - 1; r-- > 0;) sum = times_plus(sum, y, load_row(rows + r * CellLayout::row));
  return sum;
}

// The same with the derivative in y.
struct RowSlope {
  Row value, slope;
};
HWY_INLINE RowSlope at_y_with_slope(const double* rows, InEachLane y) {
  Row sum = load_row(rows + (CellLayout::terms - 1) * CellLayout::row);
  Row slope = sum;
  sum = times_plus(sum, y, load_row(rows + (CellLayout::terms - 2) * CellLayout::row));
  for (std::size_t r = CellLayout::terms - 2; r-- > 0;) {
    slope = times_plus(slope, y, sum);
    sum = times_plus(sum, y, load_row(rows + r * CellLayout::row));
  }
  return {sum, slope};
}

HWY_INLINE const double* cell_at(const CellGrid& grid, const Places& places, std::size_t i) {
  return grid.cells[static_cast<std::size_t>(places.cell[i])].load(std::memory_order_acquire);
}

// Calls f(i, places, j) for each point i, whose position is places[j].
template <class Of, class Function>
HWY_INLINE void for_each_place(const CellGrid& grid, const double* at, const double* q, std::size_t count,
                               const Function& f) {
  Places places;
  for (std::size_t i = 0; i < count; i += block) {
    const std::size_t n = count - i < block ? count - i : block;
    find_places<Of>(grid, at + i, q + i, n, places);
    for (std::size_t j = 0; j < n; ++j) f(i + j, places, j);
  }
}

template <class Of>
HWY_INLINE void interpolate(const CellGrid& grid, const double* at, const double* q, std::size_t count, double* first,
                            double* second) {
  const Powers powers;
  for_each_place<Of>(grid, at, q, count, [&](std::size_t i, const Places& places, std::size_t j) HWY_ATTR {
    const double* rows = cell_at(grid, places, j);
    const InEachLane y = in_each_lane(places.y[j]);
    const Row x = powers.of(places.x[j]);
    first[i] = places.along[j] * dot(at_y(rows, y), x);
    second[i] = places.along[j] * dot(at_y(rows + CellLayout::terms, y), x);
  });
}

template <class Of>
HWY_INLINE void interpolate_slopes(const CellGrid& grid, const double* at, const double* q, std::size_t count,
                                   double* const* columns) {
  const Powers powers;
  for_each_place<Of>(grid, at, q, count, [&](std::size_t i, const Places& places, std::size_t j) HWY_ATTR {
    const double* rows = cell_at(grid, places, j);
    const InEachLane y = in_each_lane(places.y[j]);
    const Row x = powers.of(places.x[j]);
    const Row dx = powers.slopes_of(places.x[j]);
    const double along = places.along[j];
    for (std::size_t k = 0; k < 2; ++k) {
      const RowSlope polynomial = at_y_with_slope(rows + k * CellLayout::terms, y);
      const double value = dot(polynomial.value, x);  // g of X = x g
      columns[k][i] = along * value;
      columns[2 + 2 * k][i] = Of::slope(along, value, 2 * grid.x_scale * dot(polynomial.value, dx));
      columns[3 + 2 * k][i] = along * (2 * grid.q_scale) * dot(polynomial.slope, x);
    }
  });
}

void at_lengths(const CellGrid& grid, const double* at, const double* q, std::size_t n, double* first, double* second) {
  interpolate<OfLength>(grid, at, q, n, first, second);
}
void at_coordinates(const CellGrid& grid, const double* at, const double* q, std::size_t n, double* first,
                    double* second) {
  interpolate<OfCoordinate>(grid, at, q, n, first, second);
}
void slopes_at_lengths(const CellGrid& grid, const double* at, const double* q, std::size_t n, double* const* columns) {
  interpolate_slopes<OfLength>(grid, at, q, n, columns);
}
void slopes_at_coordinates(const CellGrid& grid, const double* at, const double* q, std::size_t n,
                           double* const* columns) {
  interpolate_slopes<OfCoordinate>(grid, at, q, n, columns);
}

}  // namespace flexslip::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "numerics/effort.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

HWY_EXPORT(at_lengths);
HWY_EXPORT(at_coordinates);
HWY_EXPORT(slopes_at_lengths);
HWY_EXPORT(slopes_at_coordinates);
constexpr std::size_t terms = CellLayout::terms;
static_assert(terms == CellTable::nodes_across);
using Matrix = std::array<std::array<double, terms>, terms>;

double cosine(double x) { return elementary::sine_and_cosine(x).cosine; }

double node(std::size_t j) { return cosine(std::numbers::pi * (static_cast<double>(j) + 0.5) / terms); }

// The matrix from values at the Chebyshev nodes to the coefficients of powers.
Matrix powers_from_values() {
  Matrix chebyshev{};  // T_k in powers
  chebyshev[0][0] = 1;
  chebyshev[1][1] = 1;
  for (std::size_t k = 2; k < terms; ++k)
    for (std::size_t p = 0; p < terms; ++p)
      chebyshev[k][p] = (p > 0 ? 2 * chebyshev[k - 1][p - 1] : 0) - chebyshev[k - 2][p];
  Matrix result{};
  for (std::size_t p = 0; p < terms; ++p)
    for (std::size_t j = 0; j < terms; ++j)
      for (std::size_t k = 0; k < terms; ++k)
        result[p][j] += chebyshev[k][p] * (k == 0 ? 1.0 : 2.0) / terms *
                        cosine(std::numbers::pi * static_cast<double>(k) * (static_cast<double>(j) + 0.5) / terms);
  return result;
}

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix result{};
  for (std::size_t i = 0; i < terms; ++i)
    for (std::size_t k = 0; k < terms; ++k)
      for (std::size_t j = 0; j < terms; ++j) result[i][j] += a[i][k] * b[k][j];
  return result;
}

Matrix transposed(const Matrix& a) {
  Matrix result{};
  for (std::size_t i = 0; i < terms; ++i)
    for (std::size_t j = 0; j < terms; ++j) result[j][i] = a[i][j];
  return result;
}

const std::vector<double> nothing(CellLayout::cell, not_a_number);

CellGrid grid_of(const CellTable::Axes& axes, const std::atomic<const double*>* cells) {
  const auto real = [](std::size_t n) { return static_cast<double>(n); };
  return {cells,
          real(axes.x_cells) / axes.x_most,
          real(axes.q_cells) / (axes.q_most - axes.q_least),
          axes.q_least,
          real(axes.x_cells),
          real(axes.q_cells)};
}

}  // namespace

CellTable::CellTable(Along along, const Axes& axes, Source source)
    : along_(along), axes_(axes), source_(std::move(source)), cells_(axes.x_cells * axes.q_cells + 1) {
  for (auto& cell : cells_) cell.store(nothing.data(), std::memory_order_relaxed);
}

std::vector<double> CellTable::coefficients_of(std::size_t x_cell, std::size_t q_cell) const {
  static const Matrix to_powers = powers_from_values();
  const CellGrid grid = grid_of(axes_, nullptr);
  const auto at = [](std::size_t cell, double x, double scale) {
    return (static_cast<double>(cell) + 0.5 * (1 + x)) / scale;
  };
  std::vector<double> x, q;
  for (std::size_t a = 0; a < terms; ++a)
    for (std::size_t b = 0; b < terms; ++b) {
      x.push_back(at(x_cell, node(a), grid.x_scale));
      q.push_back(at(q_cell, node(b), grid.q_scale) + axes_.q_least);
    }
  const double far = at(x_cell, 1, grid.x_scale), least = at(q_cell, -1, grid.q_scale) + axes_.q_least;
  if (std::isnan(source_({&far, 1}, {&least, 1}).first.front())) return nothing;
  const Pair pair = source_(x, q);
  std::vector<double> cell(CellLayout::cell);
  for (std::size_t k = 0; k < 2; ++k) {
    const std::vector<double>& values = k == 0 ? pair.first : pair.second;
    Matrix per_x{};
    for (std::size_t a = 0; a < terms; ++a)
      for (std::size_t b = 0; b < terms; ++b) per_x[a][b] = values[a * terms + b];
    const Matrix coefficients = product(to_powers, transposed(product(to_powers, per_x)));
    for (std::size_t r = 0; r < terms; ++r)
      std::copy(coefficients[r].begin(), coefficients[r].end(),
                cell.begin() + static_cast<std::ptrdiff_t>(r * CellLayout::row + k * terms));
  }
  return cell;
}

// Builds the cell of a point; false if the point is outside the axes.
bool CellTable::build(double at, double q) const {
  const CellGrid grid = grid_of(axes_, nullptr);
  const double along = (along_ == Along::length ? std::sqrt(at - 1) : at) * grid.x_scale;
  const double across = (q - grid.q_least) * grid.q_scale;
  if (!(along > 0 && along < grid.x_cells && across >= 0 && across < grid.q_cells)) return false;
  const auto x_cell = static_cast<std::size_t>(along), q_cell = static_cast<std::size_t>(across);
  auto& cell = cells_[x_cell * axes_.q_cells + q_cell];
  const std::scoped_lock lock(building_);
  if (cell.load(std::memory_order_relaxed) == nothing.data()) {
    built_.push_back(std::make_unique<const std::vector<double>>(coefficients_of(x_cell, q_cell)));
    cell.store(built_.back()->data(), std::memory_order_release);
  }
  return true;
}

// Builds cells for points without a value and returns those within the axes.
std::vector<std::size_t> CellTable::built_for(const double* at, const double* q, std::span<const double> values) const {
  std::vector<std::size_t> built;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isnan(values[i]) && build(at[i], q[i])) built.push_back(i);
  return built;
}

void CellTable::values(const double* at, const double* q, std::size_t count, double* first, double* second) const {
  effort_spent += count;
  const auto interpolated = [&](const double* x, const double* y, std::size_t n, double* a, double* b) {
    const CellGrid grid = grid_of(axes_, cells_.data());
    if (along_ == Along::length)
      HWY_DYNAMIC_DISPATCH(at_lengths)(grid, x, y, n, a, b);
    else
      HWY_DYNAMIC_DISPATCH(at_coordinates)(grid, x, y, n, a, b);
  };
  interpolated(at, q, count, first, second);
  for (const std::size_t i : built_for(at, q, {first, count})) interpolated(at + i, q + i, 1, first + i, second + i);
}

void CellTable::slopes(const double* at, const double* q, std::size_t count,
                       const std::array<double*, 6>& columns) const {
  effort_spent += count;
  const auto interpolated = [&](const double* x, const double* y, std::size_t n, double* const* to) {
    const CellGrid grid = grid_of(axes_, cells_.data());
    if (along_ == Along::length)
      HWY_DYNAMIC_DISPATCH(slopes_at_lengths)(grid, x, y, n, to);
    else
      HWY_DYNAMIC_DISPATCH(slopes_at_coordinates)(grid, x, y, n, to);
  };
  interpolated(at, q, count, columns.data());
  for (const std::size_t i : built_for(at, q, {columns[0], count})) {
    std::array<double*, 6> there = columns;
    for (double*& column : there) column += i;
    interpolated(at + i, q + i, 1, there.data());
  }
}

}  // namespace flexslip

#endif  // HWY_ONCE
