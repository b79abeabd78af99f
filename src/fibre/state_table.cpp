// Compiled once for each instruction set (Highway's foreach_target.h).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fibre/state_table.cpp"
#include "fibre/state_table.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include <hwy/foreach_target.h>  // must come before highway.h

#include "fibre/lanes-inl.h"

#ifndef FLEXSLIP_FIBRE_STATE_TABLE_CPP_
#define FLEXSLIP_FIBRE_STATE_TABLE_CPP_
namespace flexslip {

// The table in memory. A cell is a polynomial of degree 7 in each of x and y, its coordinates in [-1, 1] along σ and q: eight rows, one for
// each power of y, of the coefficients of 1, x, ..., x^7 for w/σ and then those for F/σ. A row fills vectors of any width.
struct TableLayout {
  static constexpr std::size_t sigma_cells = 32;
  static constexpr std::size_t q_cells = 48;
  static constexpr std::size_t terms = 8;  // of each polynomial
  static constexpr std::size_t row = 2 * terms;
  static constexpr std::size_t cell = terms * row;
  static constexpr double sigma_scale = sigma_cells / table_sigma;
  static constexpr double q_scale = q_cells / (table_q.greatest - table_q.least);
  static constexpr std::size_t no_cell = sigma_cells * q_cells;  // the last, all NaN: of states beyond the table
};

// Where states lie in the table: the number of the cell, and the coordinates in it.
inline constexpr std::size_t block = 64;
struct Places {
  alignas(64) double sigma[block];
  alignas(64) double x[block];
  alignas(64) double y[block];
  alignas(64) double cell[block];
};

}  // namespace flexslip
#endif

HWY_BEFORE_NAMESPACE();
namespace flexslip::HWY_NAMESPACE {

// As many vectors as hold a row's coefficients of one quantity.
using RowTag = hn::CappedTag<double, TableLayout::terms>;
using RowVector = hn::Vec<RowTag>;
constexpr RowTag row_tag;
constexpr std::size_t row_vectors = TableLayout::terms / hn::MaxLanes(row_tag);
struct Row {
  RowVector part[row_vectors];
};

HWY_INLINE Row load_row(const double* from) {
  Row row;
  for (std::size_t i = 0; i < row_vectors; ++i) row.part[i] = hn::LoadU(row_tag, from + i * hn::MaxLanes(row_tag));
  return row;
}

// a y + b
HWY_INLINE Row times_plus(const Row& a, RowVector y, const Row& b) {
  Row row;
  for (std::size_t i = 0; i < row_vectors; ++i) row.part[i] = hn::Add(hn::Mul(a.part[i], y), b.part[i]);
  return row;
}

// The sum of a vector's lanes, upper half upon lower half until one is left: in the same order whatever the width.
template <class D>
HWY_INLINE double folded([[maybe_unused]] D tag, hn::Vec<D> vector) {
#if HWY_TARGET != HWY_SCALAR
  if constexpr (hn::MaxLanes(tag) > 1) {
    const hn::Half<D> half;
    return folded(half, hn::Add(hn::LowerHalf(half, vector), hn::UpperHalf(half, vector)));
  }
#endif
  return hn::GetLane(vector);
}

HWY_INLINE Row times(const Row& a, const Row& b) {
  Row product;
  for (std::size_t i = 0; i < row_vectors; ++i) product.part[i] = hn::Mul(a.part[i], b.part[i]);
  return product;
}

HWY_INLINE double dot(const Row& a, const Row& b) {
  Row product = times(a, b);
  for (std::size_t n = row_vectors / 2; n > 0; n /= 2)
    for (std::size_t i = 0; i < n; ++i) product.part[i] = hn::Add(product.part[i], product.part[i + n]);
  return folded(row_tag, product.part[0]);
}

// Powers of x up to the seventh, put together from x, x^2 and x^4 by the bits of the exponents.
class Powers {
 public:
  HWY_INLINE explicit Powers(const double (&exponents)[TableLayout::terms]) {
    const Row all = load_row(exponents);
    for (std::size_t i = 0; i < row_vectors; ++i) {
      const auto bits = hn::ConvertTo(hn::RebindToSigned<RowTag>(), all.part[i]);
      for (std::size_t bit = 0; bit < 3; ++bit) {
        const auto value = hn::Set(hn::RebindToSigned<RowTag>(), std::int64_t{1} << bit);
        has_[bit][i] = hn::RebindMask(row_tag, hn::Eq(hn::And(bits, value), value));
      }
    }
  }

  HWY_INLINE Row of(double x) const {
    const RowVector one = hn::Set(row_tag, 1.0);
    const RowVector x1 = hn::Set(row_tag, x);
    const RowVector x2 = hn::Mul(x1, x1);
    const RowVector x4 = hn::Mul(x2, x2);
    Row row;
    for (std::size_t i = 0; i < row_vectors; ++i)
      row.part[i] = hn::Mul(hn::Mul(hn::IfThenElse(has_[0][i], x1, one), hn::IfThenElse(has_[1][i], x2, one)),
                            hn::IfThenElse(has_[2][i], x4, one));
    return row;
  }

 private:
  hn::Mask<RowTag> has_[3][row_vectors];  // whether the exponent has this bit
};

HWY_INLINE void find_places(const double* S, const double* q, std::size_t count, Places& places) {
  for_each_lanes(S, q, count, [&](std::size_t i, std::size_t n, Lanes lengths, Lanes frictions) HWY_ATTR {
    const Lanes sigma = sqrt(lengths - 1.0);
    const Lanes along = sigma * TableLayout::sigma_scale;
    const Lanes across = (frictions - table_q.least) * TableLayout::q_scale;
    const Lanes i_sigma(hn::Floor(along.v));
    const Lanes i_q(hn::Floor(across.v));
    const auto inside = (Lanes(0.0) < along) & (along < Lanes(double{TableLayout::sigma_cells})) & (Lanes(-1.0) < i_q) &
                        (i_q < Lanes(double{TableLayout::q_cells}));
    store(sigma, places.sigma + i, n);
    store(2.0 * (along - i_sigma) - 1.0, places.x + i, n);
    store(2.0 * (across - i_q) - 1.0, places.y + i, n);
    store(choose(inside, i_sigma * double{TableLayout::q_cells} + i_q, Lanes(double{TableLayout::no_cell})),
          places.cell + i, n);
  });
}

// One polynomial at y, in powers of x.
HWY_INLINE Row at_y(const double* rows, RowVector y) {
  Row sum = load_row(rows + (TableLayout::terms - 1) * TableLayout::row);
  for (std::size_t r = TableLayout::terms - 1; r-- > 0;)
    sum = times_plus(sum, y, load_row(rows + r * TableLayout::row));
  return sum;
}

// The same with its derivative in y.
struct RowSlope {
  Row value, slope;
};
HWY_INLINE RowSlope at_y_with_slope(const double* rows, RowVector y) {
  Row sum = load_row(rows + (TableLayout::terms - 1) * TableLayout::row);
  Row slope = sum;
  sum = times_plus(sum, y, load_row(rows + (TableLayout::terms - 2) * TableLayout::row));
  for (std::size_t r = TableLayout::terms - 2; r-- > 0;) {
    slope = times_plus(slope, y, sum);
    sum = times_plus(sum, y, load_row(rows + r * TableLayout::row));
  }
  return {sum, slope};
}

HWY_INLINE const double* cell_at(const double* table, const Places& places, std::size_t i) {
  return table + static_cast<std::size_t>(places.cell[i]) * TableLayout::cell;
}

// Calls f(i, places, j) for each state i, whose place is the j-th of some.
template <class Function>
HWY_INLINE void for_each_place(const double* S, const double* q, std::size_t count, const Function& f) {
  Places places;
  for (std::size_t i = 0; i < count; i += block) {
    const std::size_t n = count - i < block ? count - i : block;
    find_places(S + i, q + i, n, places);
    for (std::size_t j = 0; j < n; ++j) f(i + j, places, j);
  }
}

// NaN where the table has nothing.
void interpolate(const double* table, const double* S, const double* q, std::size_t count, double* w, double* F) {
  const Powers powers({0, 1, 2, 3, 4, 5, 6, 7});
  for_each_place(S, q, count, [&](std::size_t i, const Places& places, std::size_t j) HWY_ATTR {
    const double* rows = cell_at(table, places, j);
    const RowVector y = hn::Set(row_tag, places.y[j]);
    const Row x = powers.of(places.x[j]);
    w[i] = places.sigma[j] * dot(at_y(rows, y), x);
    F[i] = places.sigma[j] * dot(at_y(rows + TableLayout::terms, y), x);
  });
}

void interpolate_slopes(const double* table, const double* S, const double* q, std::size_t count,
                        double* const* columns) {
  const Powers powers({0, 1, 2, 3, 4, 5, 6, 7});
  const Powers lower_powers({0, 0, 1, 2, 3, 4, 5, 6});
  HWY_ALIGN constexpr double exponents[] = {0, 1, 2, 3, 4, 5, 6, 7};
  const Row factors = load_row(exponents);
  for_each_place(S, q, count, [&](std::size_t i, const Places& places, std::size_t j) HWY_ATTR {
    const double* rows = cell_at(table, places, j);
    const RowVector y = hn::Set(row_tag, places.y[j]);
    const Row x = powers.of(places.x[j]);
    const Row dx = times(factors, lower_powers.of(places.x[j]));
    const double sigma = places.sigma[j];
    for (std::size_t k = 0; k < 2; ++k) {
      const RowSlope polynomial = at_y_with_slope(rows + k * TableLayout::terms, y);
      const double value = dot(polynomial.value, x);  // g of X = σ g
      const double g_sigma = 2 * TableLayout::sigma_scale * dot(polynomial.value, dx);
      columns[k][i] = sigma * value;
      columns[2 + 2 * k][i] = 0.5 * (value / sigma + g_sigma);  // dσ/dS = 1/(2σ)
      columns[3 + 2 * k][i] = sigma * (2 * TableLayout::q_scale) * dot(polynomial.slope, x);
    }
  });
}

}  // namespace flexslip::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "fibre/elastica.h"

namespace flexslip {
namespace {

HWY_EXPORT(interpolate);
HWY_EXPORT(interpolate_slopes);

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t terms = TableLayout::terms;
using Matrix = std::array<std::array<double, terms>, terms>;

double node(std::size_t j) { return std::cos(std::numbers::pi * (static_cast<double>(j) + 0.5) / terms); }

// From values at the Chebyshev nodes to the coefficients of powers.
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
                        std::cos(std::numbers::pi * static_cast<double>(k) * (static_cast<double>(j) + 0.5) / terms);
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

// Cells whose far corner the branch does not reach are left NaN.
std::vector<double> build_table() {
  const Matrix to_powers = powers_from_values();
  const auto at = [](std::size_t cell, double x, double scale) {
    return (static_cast<double>(cell) + 0.5 * (1 + x)) / scale;
  };
  std::vector<double> table((TableLayout::no_cell + 1) * TableLayout::cell, not_a_number);
  std::vector<double> S(terms * terms);
  std::vector<double> q(terms * terms);
  for (std::size_t i = 0; i < TableLayout::sigma_cells; ++i) {
    const double sigma_end = at(i, 1, TableLayout::sigma_scale);
    for (std::size_t j = 0; j < TableLayout::q_cells; ++j) {
      const double q_least = at(j, -1, TableLayout::q_scale) + table_q.least;
      if (fibre_state(1 + sigma_end * sigma_end, q_least).status != FibreStatus::ok) continue;
      for (std::size_t a = 0; a < terms; ++a)
        for (std::size_t b = 0; b < terms; ++b) {
          const double sigma = at(i, node(a), TableLayout::sigma_scale);
          S[a * terms + b] = 1 + sigma * sigma;
          q[a * terms + b] = at(j, node(b), TableLayout::q_scale) + table_q.least;
        }
      const StateArrays states = fibre_states({S, q});
      double* cell = table.data() + (i * TableLayout::q_cells + j) * TableLayout::cell;
      for (std::size_t k = 0; k < 2; ++k) {
        const std::vector<double>& values = k == 0 ? states.w : states.F;
        Matrix per_sigma{};
        for (std::size_t a = 0; a < terms; ++a)
          for (std::size_t b = 0; b < terms; ++b)
            per_sigma[a][b] = values[a * terms + b] / std::sqrt(S[a * terms + b] - 1);
        const Matrix coefficients = product(to_powers, transposed(product(to_powers, per_sigma)));
        for (std::size_t r = 0; r < terms; ++r)
          std::copy(coefficients[r].begin(), coefficients[r].end(), cell + r * TableLayout::row + k * terms);
      }
    }
  }
  return table;
}

const double* table() {
  static const std::vector<double> coefficients = build_table();
  return coefficients.data();
}

// States of which the table has nothing.
struct Rest {
  std::vector<std::size_t> index;
  std::vector<double> S, q;
  Rest(const FibrePoints& points, const std::vector<double>& w) {
    for (std::size_t i = 0; i < w.size(); ++i) {
      if (!std::isnan(w[i])) continue;
      index.push_back(i);
      S.push_back(points.lengths()[i]);
      q.push_back(points.frictions()[i]);
    }
  }
};

}  // namespace

StateArrays tabulated_states(const FibrePoints& points) {
  StateArrays states(points.size());
  HWY_DYNAMIC_DISPATCH(interpolate)
  (table(), points.lengths(), points.frictions(), points.size(), states.w.data(), states.F.data());
  const Rest rest(points, states.w);
  const StateArrays exact = fibre_states({rest.S, rest.q});
  for (std::size_t j = 0; j < rest.index.size(); ++j) {
    states.w[rest.index[j]] = exact.w[j];
    states.F[rest.index[j]] = exact.F[j];
  }
  return states;
}

SlopeArrays tabulated_states_slopes(const FibrePoints& points) {
  SlopeArrays states(points.size());
  const auto columns = states.columns();
  HWY_DYNAMIC_DISPATCH(interpolate_slopes)
  (table(), points.lengths(), points.frictions(), points.size(), columns.data());
  const Rest rest(points, states.w);
  SlopeArrays exact = fibre_states_slopes({rest.S, rest.q});
  const auto from = exact.columns();
  for (std::size_t k = 0; k < columns.size(); ++k)
    for (std::size_t j = 0; j < rest.index.size(); ++j) columns[k][rest.index[j]] = from[k][j];
  return states;
}

}  // namespace flexslip

#endif  // HWY_ONCE
