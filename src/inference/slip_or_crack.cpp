#include "inference/slip_or_crack.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "data/names.h"
#include "fibre/state_table.h"
#include "inference/verdict_coefficients.h"
#include "numerics/elementary.h"
#include "numerics/interpolant.h"
#include "numerics/minimum.h"
#include "numerics/polynomial.h"
#include "numerics/root.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

constexpr double impossible = 1e9;         // of minus ln L
constexpr double first_rise_error = 0.05;  // [1] of its stiffness, beforehand
constexpr double min_w = 0.06, max_w = 0.43;

// A function of one number as a Chebyshev series from `least` to `greatest`, straight on beyond.
constexpr std::size_t terms = 14;
using Polynomial = Interpolant<terms - 1>;
using Nodes = Polynomial::Values;

struct Series {
  double least, greatest;
  Nodes coefficients;

  ValueAndSlope at(double x) const {
    const double inside = std::clamp(x, least, greatest), half_width = 0.5 * (greatest - least);
    const auto [value, by_t] = series_slope_at(coefficients, (inside - 0.5 * (least + greatest)) / half_width);
    const double slope = by_t / half_width;
    return {value + slope * (x - inside), slope};
  }

  // Where it has a value, if it rises.
  double where(double value) const {
    constexpr double close = 1e-8;
    const auto miss = [&](double x) { return ValueAndSlope{at(x).value - value, at(x).slope}; };
    return zero_between(miss, least, greatest, 0.5 * (least + greatest), close);
  }
};

// One such function for each row, of which compilers make vectors: the same sums as those of each alone.
class SeriesOfRows {
 public:
  void add(const Series& series) {
    const std::size_t lane = size_++ % lanes;
    if (lane == 0) blocks_.emplace_back();
    Block& block = blocks_.back();
    block.least[lane] = series.least;
    block.greatest[lane] = series.greatest;
    for (std::size_t k = 0; k < terms; ++k) block.coefficients[k][lane] = series.coefficients[k];
    for (std::size_t more = lane + 1; more < lanes; ++more) block.greatest[more] = 1;  // of no row
  }

  Series of(std::size_t row) const {
    const Block& block = blocks_[row / lanes];
    const std::size_t lane = row % lanes;
    Series series{block.least[lane], block.greatest[lane], {}};
    for (std::size_t k = 0; k < terms; ++k) series.coefficients[k] = block.coefficients[k][lane];
    return series;
  }

  // At a number for each row. Domain: x, values and slopes as long as padded(rows).
  void at(const std::vector<double>& x, std::vector<double>& values, std::vector<double>& slopes) const {
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      const Block& block = blocks_[b];
      Lanes inside, half_width, t, b1{}, b2{}, d1{}, d2{};
      for (std::size_t i = 0; i < lanes; ++i) {
        inside[i] = std::clamp(x[b * lanes + i], block.least[i], block.greatest[i]);
        half_width[i] = 0.5 * (block.greatest[i] - block.least[i]);
        t[i] = (inside[i] - 0.5 * (block.least[i] + block.greatest[i])) / half_width[i];
      }
      for (std::size_t k = terms - 1; k > 0; --k)
        for (std::size_t i = 0; i < lanes; ++i) {
          const double c = block.coefficients[k][i];
          d2[i] = std::exchange(d1[i], static_cast<double>(k) * c + 2 * t[i] * d1[i] - d2[i]);
          b2[i] = std::exchange(b1[i], c + 2 * t[i] * b1[i] - b2[i]);
        }
      for (std::size_t i = 0; i < lanes; ++i) {
        const double slope = d1[i] / half_width[i];
        slopes[b * lanes + i] = slope;
        values[b * lanes + i] =
            block.coefficients[0][i] + t[i] * b1[i] - b2[i] + slope * (x[b * lanes + i] - inside[i]);
      }
    }
  }

  static std::size_t padded(std::size_t rows) { return (rows + lanes - 1) / lanes * lanes; }

 private:
  static constexpr std::size_t lanes = 8;
  using Lanes = std::array<double, lanes>;
  struct Block {
    Lanes least{}, greatest{};
    std::array<Lanes, terms> coefficients{};
  };
  std::vector<Block> blocks_;
  std::size_t size_ = 0;
};

Nodes nodes_between(double least, double greatest) {
  Nodes nodes{};
  for (std::size_t j = 0; j < terms; ++j) nodes[j] = std::lerp(least, greatest, 0.5 + 0.5 * Polynomial::node(j));
  return nodes;
}

// A fibre at the deflection of a row.
struct Row {
  double w, F;      // [L], [EI/L^2]
  double q;         // [1] friction that gives the force
  double along;     // from -1 to 1 over all rows, as the length at usual friction
  double to_stage;  // [1] what an error of the force at given deflection is at given stage position
  std::size_t rise;
  double drops_before;
};

// Ψ at the deflection of each row.
struct Expanded {
  SeriesOfRows force;     // [EI/L^2] by friction
  SeriesOfRows friction;  // [1] by force
  SeriesOfRows length;    // [L] by force
};

// By friction from min_q to max_q, where the branch reaches max_w, and by force.
Expanded expand(const std::vector<Row>& rows, const Fibre& fibre) {
  constexpr double min_q = -0.2, max_q = 2;
  const Nodes nodes = nodes_between(min_q, max_q);
  std::vector<double> S, q;
  for (const Row& row : rows)
    for (const double node : nodes) {
      S.push_back(1 + 2.4 * row.w * row.w);
      q.push_back(node);
    }
  for (int iteration = 0; iteration < 8; ++iteration) {
    const auto at = fibre.tabulated_states_slopes({S, q});
    double farthest = 0;
    for (std::size_t i = 0; i < S.size(); ++i) {  // Newton in w², which is nearly straight in S
      const double w = rows[i / terms].w;
      const double step = std::clamp((w * w - at.w[i] * at.w[i]) / (2 * at.w[i] * at.w_S[i]), -0.5 * (S[i] - 1), 0.1);
      S[i] += step;
      farthest = std::max(farthest, std::abs(step));
    }
    constexpr double negligible = 1e-9;  // [L]: the step after is its square
    if (farthest < negligible) break;
  }
  const auto states = fibre.tabulated_states({S, q});
  Expanded expanded;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const auto by_friction = [&](const std::vector<double>& values) {
      Nodes of_row{};
      std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(r * terms), terms, of_row.begin());
      return Series{min_q, max_q, Polynomial::chebyshev(of_row)};
    };
    const Series force = by_friction(states.F), length = by_friction(S);
    const double least = force.at(min_q).value, most = force.at(max_q).value;
    Nodes friction = nodes_between(least, most), lengths{};
    for (std::size_t k = 0; k < terms; ++k) {
      friction[k] = force.where(friction[k]);
      lengths[k] = length.at(friction[k]).value;
    }
    expanded.force.add(force);
    expanded.friction.add({least, most, Polynomial::chebyshev(friction)});
    expanded.length.add({least, most, Polynomial::chebyshev(lengths)});
  }
  return expanded;
}

// So many rows are taken as one, their mean: with more than some hundred, what friction does within a rise, which neither slips nor cracks
// explain here, outweighs their noise.
std::size_t rows_as_one(std::span<const Drop> drops) {
  constexpr std::size_t enough = 300;
  return std::max<std::size_t>((drops.back().after - drops.front().before) / enough, 1);
}

// Rows between the drops; of what lies before the first and after the last at most so many as tell of the same.
std::vector<Row> rows_of(const ReducedRecord& record, std::span<const Drop> drops) {
  const std::size_t as_one = rows_as_one(drops);
  const std::size_t max_outside = 15 * as_one;
  constexpr std::size_t min_rows = 3;
  std::vector<Row> rows;
  std::size_t rise = 0;
  for (std::size_t c = 0; c <= drops.size(); ++c) {
    const std::size_t first = c > 0 ? drops[c - 1].after : drops[0].before - std::min(drops[0].before, max_outside - 1);
    const std::size_t last =
        c < drops.size() ? drops[c].before : std::min(drops[c - 1].after + max_outside - 1, record.force.size() - 1);
    std::vector<Row> of_rise;
    for (std::size_t i = first; i + as_one <= last + 1; i += as_one) {
      Row row{};
      for (std::size_t k = i; k < i + as_one; ++k) {
        row.w += record.deflection[k] / static_cast<double>(as_one);
        row.F += record.force[k] / static_cast<double>(as_one);
      }
      row.rise = rise;
      row.drops_before = static_cast<double>(c);
      if (row.w > min_w && row.w < max_w) of_rise.push_back(row);
    }
    if (of_rise.size() < min_rows) continue;
    rows.insert(rows.end(), of_rise.begin(), of_rise.end());
    ++rise;
  }
  return rows;
}

constexpr std::size_t slow_terms = 5;  // of the friction of cracks that varies slowly

// Legendre's polynomials P_k(x).
std::array<double, slow_terms> legendre_polynomials(double x) {
  std::array<double, slow_terms> P{1, x};
  for (std::size_t k = 1; k + 1 < slow_terms; ++k) {
    const auto degree = static_cast<double>(k);
    P[k + 1] = ((2 * degree + 1) * x * P[k] - degree * P[k - 1]) / (degree + 1);
  }
  return P;
}

using Starts = std::vector<std::vector<double>>;

Least least_of(const FunctionOfNumbers& f, const Starts& starts, const std::vector<double>& steps) {
  return least_from(f, starts, {.steps = steps, .close_in_value = 0.02, .close_in_numbers = 1e-3, .max_calls = 220});
}

// The rows of one test and what explains them.
class Rises {
 public:
  Rises(const ReducedRecord& record, const Rig& rig, std::span<const Drop> drops) : rows_(rows_of(record, drops)) {
    if (rows_.empty()) return;
    psi_ = expand(rows_, rig.fibre);
    n_ = rows_.size();
    for (std::size_t i = 0; i < n_; ++i)
      if (i == 0 || rows_[i].rise != rows_[i - 1].rise) begin_.push_back(i);
    std::vector<double> S, q;
    for (std::size_t i = 0; i < n_; ++i) {
      Row& row = rows_[i];
      constexpr double usual = 0.5;
      const Series force = psi_.force.of(i), length = psi_.length.of(i);
      const auto length_at = [&](double mu) { return length.at(force.at(mu).value).value; };
      row.q = psi_.friction.of(i).at(row.F).value;
      row.along = length_at(usual);
      q.push_back(std::clamp(row.q, 0.0, 1.2));
      S.push_back(length_at(q.back()));
    }
    const double least = rows_.front().along, most = rows_.back().along;
    const auto slopes = rig.fibre.tabulated_states_slopes({S, q});
    for (std::size_t i = 0; i < n_; ++i) {
      rows_[i].along = (2 * rows_[i].along - least - most) / (most - least);
      const double tangent = slopes.F_S[i] / slopes.w_S[i];  // dF/dw at constant friction
      rows_[i].to_stage = 1 / (1 + std::max(tangent, -0.5 * rig.stiffness) / rig.stiffness);
    }
    legendre_.reserve(n_);
    for (const Row& row : rows_) legendre_.push_back(legendre_polynomials(row.along));
    for (auto* series : {&x_, &y_, &z_, &by_row_, &at_row_, &slope_}) series->resize(SeriesOfRows::padded(n_));
  }

  std::size_t size() const { return begin_.size(); }

  std::size_t after_drops() const {
    return static_cast<std::size_t>(
        std::count_if(begin_.begin(), begin_.end(), [&](std::size_t i) { return rows_[i].drops_before > 0; }));
  }

  // What explains the rises, and how well.
  SlipOrCrack explained() {
    SlipOrCrack out{};
    const auto m = static_cast<double>(size());
    constexpr auto terms_of_slow = static_cast<double>(slow_terms);
    variance_ = 0.03 * 0.03;
    // μ, ρ
    const FunctionOfNumbers constant = [&](std::span<const double> p) { return cracks(p.first(1), p[1]); };
    Least at_constant;
    for (int round = 0; round < 2; ++round)
      at_constant = settled(constant, {{0.3, 0.3}, {0.8, 0.3}, {0.05, 0.3}}, {0.2, 0.2});
    out.cracks_constant = explanation(constant, at_constant, m + 3);
    const double mu = at_constant.at[0], rho = at_constant.at[1];
    out.features.rises = size();
    out.features.given_back = given_back(mu);
    out.features.friction_needed = mu;
    // friction, ρ
    const FunctionOfNumbers slow = [&](std::span<const double> p) {
      return cracks(p.first(slow_terms), p[slow_terms]);
    };
    const Least at_slow =
        polished(slow, {{mu, 0, 0, 0, 0, rho}, {0.6, 0.15, 0, 0, 0, 0.6}, {0.6, -0.1, 0.05, 0, 0, 0.3}},
                 {0.15, 0.1, 0.1, 0.08, 0.08, 0.15});
    out.cracks = explanation(slow, at_slow, m + terms_of_slow + 2);
    const double arrested_variance = variance_;
    // friction, ρ, mean and logarithm of the spread of the slopes of e within a rise
    const FunctionOfNumbers running = [&](std::span<const double> p) { return running_cracks(p); };
    std::vector<double> arrested = at_slow.at;
    arrested.back() = std::max(arrested.back() - 0.2, 0.05);
    arrested.insert(arrested.end(), {0.3, -1});
    out.cracks_running = explanation(
        running, polished(running, {arrested, {mu, 0, 0, 0, 0, 0.3, 1, 1}}, {0.15, 0.1, 0.1, 0.08, 0.08, 0.15, 0.7, 1}),
        m + terms_of_slow + 4);
    // e0 - 1, ρ, logarithm of the spread of b_j; loss at each drop
    const double of_slips = std::min(arrested_variance, 0.05 * 0.05);
    variance_ = of_slips;
    const FunctionOfNumbers slips = [&](std::span<const double> p) { return slip(p[0], p[1], p[2], 0); };
    out.slip = explanation(slips, polished(slips, {{0, 0.3, 0}, {0, 0.3, 2}, {0.03, 0.6, -2}}, {0.03, 0.2, 1}), m + 4);
    variance_ = of_slips;
    const FunctionOfNumbers both = [&](std::span<const double> p) { return slip(p[0], p[1], p[2], p[3]); };
    out.slip_and_cracks = explanation(
        both, polished(both, {{0, 0.3, 0, 0.01}, {0, 0.3, 2, 0.002}, {0.03, 0.6, -2, 0.03}}, {0.03, 0.2, 1, 0.01}),
        m + 5);
    return out;
  }

 private:
  // The least from some starts, and what the variance of a row is there.
  Least settled(const FunctionOfNumbers& f, const Starts& starts, const std::vector<double>& steps) {
    Least best = least_of(f, starts, steps);
    f(best.at);
    variance_ = squares_ / static_cast<double>(n_);
    return best;
  }
  // The same, and twice again from where that is.
  Least polished(const FunctionOfNumbers& f, Starts starts, const std::vector<double>& steps) {
    Least best;
    for (int round = 0; round < 3; ++round) {
      best = settled(f, starts, steps);
      starts = {best.at};
    }
    return best;
  }
  RiseExplanation explanation(const FunctionOfNumbers& f, const Least& best, double numbers) {
    f(best.at);  // for what is left of EI there
    return {2 * best.value + numbers * elementary::log(static_cast<double>(n_)), left_};
  }

  // The rows of a series made independent of those before, within each rise.
  void whiten(std::vector<double>& series, double rho) const {
    for (std::size_t j = size(); j-- > 0;) {
      for (std::size_t i = end(j); i-- > begin_[j] + 1;) series[i] -= rho * series[i - 1];
      series[begin_[j]] *= std::sqrt(1 - rho * rho);
    }
  }
  std::size_t end(std::size_t rise) const { return rise + 1 < begin_.size() ? begin_[rise + 1] : n_; }
  double sum(const std::vector<double>& a, const std::vector<double>& b, std::size_t rise) const {
    double total = 0;
    for (std::size_t i = begin_[rise]; i < end(rise); ++i) total += a[i] * b[i];
    return total;
  }
  double minus_log_likelihood(double squares, double rho, double more) const {
    const auto n = static_cast<double>(n_);
    return 0.5 * n * (elementary::log(squares / n) + 1) -
           0.5 * static_cast<double>(size()) * elementary::log(1 - rho * rho) + more;
  }

  // The force of a fibre whose friction is such a series in the length, what it is measured against, and whether friction is possible.
  bool forces(std::span<const double> friction, double rho) {
    constexpr double greatest = 1.3;
    if (!(rho >= 0 && rho < 0.99)) return false;
    for (std::size_t i = 0; i < n_; ++i) {
      double q = 0;
      for (std::size_t k = 0; k < friction.size(); ++k) q += friction[k] * legendre_[i][k];
      if (!(q >= 0 && q <= greatest)) return false;
      by_row_[i] = q;
    }
    psi_.force.at(by_row_, at_row_, slope_);
    for (std::size_t i = 0; i < n_; ++i) {
      x_[i] = at_row_[i] * rows_[i].to_stage;
      z_[i] = rows_[i].F * rows_[i].to_stage;
    }
    return true;
  }

  // Levels of the rises that never rise, of least squares, and what is left.
  double never_rising(double rho, double more) {
    struct Block {
      double product, square;
      std::size_t rises;
    };
    std::vector<Block> blocks, rises;
    blocks.reserve(size()), rises.reserve(size());
    double left_over = 0;
    for (std::size_t j = 0; j < size(); ++j) {
      left_over += sum(z_, z_, j);
      Block block{sum(x_, z_, j), sum(x_, x_, j), 1};
      rises.push_back(block);
      if (j == 0) {
        const double known = variance_ / (first_rise_error * first_rise_error);
        block.product += known;
        block.square += known;
      }
      while (!blocks.empty() && block.product * blocks.back().square > blocks.back().product * block.square) {
        block.product += blocks.back().product;
        block.square += blocks.back().square;
        block.rises += blocks.back().rises;
        blocks.pop_back();
      }
      blocks.push_back(block);
    }
    const double first = blocks.front().product / blocks.front().square;
    left_ = blocks.back().product / blocks.back().square / first;
    std::size_t j = 0;
    squares_ = left_over;
    for (const Block& block : blocks) {
      const double e = block.product / block.square;
      for (std::size_t k = 0; k < block.rises; ++k, ++j) squares_ += e * (e * rises[j].square - 2 * rises[j].product);
    }
    const double away = (first - 1) / first_rise_error;
    return minus_log_likelihood(squares_, rho, 0.5 * away * away + more);
  }

  double cracks(std::span<const double> friction, double rho) {
    if (!forces(friction, rho)) return impossible;
    whiten(x_, rho);
    whiten(z_, rho);
    return never_rising(rho, 0);
  }

  // Slopes of e within each rise, N(-c, spread²), integrated out.
  double running_cracks(std::span<const double> p) {
    const double rho = p[slow_terms], c = p[slow_terms + 1], log_spread = p[slow_terms + 2];
    if (!(c >= 0 && c < 40 && log_spread > -6 && log_spread < 4) || !forces(p.first(slow_terms), rho))
      return impossible;
    for (std::size_t j = 0; j < size(); ++j) {
      double middle = 0;
      for (std::size_t i = begin_[j]; i < end(j); ++i) middle += rows_[i].w / static_cast<double>(end(j) - begin_[j]);
      for (std::size_t i = begin_[j]; i < end(j); ++i) {
        const double along = rows_[i].w - middle;
        y_[i] = x_[i] * along;
        x_[i] *= 1 - c * along;
      }
    }
    whiten(x_, rho);
    whiten(y_, rho);
    whiten(z_, rho);
    const double log_determinant = blur(elementary::exp(2 * log_spread) / variance_, y_, {&x_, &z_});
    return never_rising(rho, log_determinant);
  }

  // Series whitened of one more term, a multiple of `of` in each rise with so much more variance than a row has.
  double blur(double ratio, const std::vector<double>& of, std::initializer_list<std::vector<double>*> series) {
    double log_determinant = 0;
    for (std::size_t j = 0; j < size(); ++j) {
      const double square = sum(of, of, j);
      const double grown = 1 + ratio * square;
      log_determinant += 0.5 * elementary::log(grown);
      if (!(square > 0)) continue;
      const double share = (1 - 1 / std::sqrt(grown)) / square;
      for (auto* each : series) {
        const double part = share * sum(of, *each, j);
        for (std::size_t i = begin_[j]; i < end(j); ++i) (*each)[i] -= part * of[i];
      }
    }
    return log_determinant;
  }

  // Friction of each rise free in level, its slope about one slope.
  double slip(double by, double rho, double log_spread, double loss) {
    const double e0 = 1 + by;
    if (!(e0 > 0.7 && e0 < 1.4 && rho >= 0 && rho < 0.99 && log_spread > -6 && log_spread < 5 && loss >= 0 &&
          loss < 0.2))
      return impossible;
    std::vector<double>&S = x_, &y = y_, &level = z_;
    constexpr double greatest = 1.5;
    double e = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      const Row& row = rows_[i];
      if (i == 0 || row.drops_before != rows_[i - 1].drops_before)
        e = e0 * elementary::exp(row.drops_before * elementary::log(1 - loss));
      level[i] = e * row.to_stage;
      by_row_[i] = row.F / e;
    }
    psi_.friction.at(by_row_, y, slope_);
    for (std::size_t i = 0; i < n_; ++i) {
      if (loss > 0 && y[i] > std::max(greatest, rows_[i].q)) return impossible;
      level[i] /= slope_[i];
      y[i] *= level[i];
    }
    psi_.length.at(by_row_, S, slope_);
    left_ = elementary::exp((rows_.back().drops_before - rows_.front().drops_before) * elementary::log(1 - loss));
    for (std::size_t j = 0; j < size(); ++j) {
      double middle = 0;
      for (std::size_t i = begin_[j]; i < end(j); ++i) middle += S[i] / static_cast<double>(end(j) - begin_[j]);
      for (std::size_t i = begin_[j]; i < end(j); ++i) S[i] = (S[i] - middle) * level[i];
    }
    whiten(S, rho);
    whiten(y, rho);
    whiten(level, rho);
    // The term that is integrated out goes last from its own series.
    const std::vector<double> slope = S;
    const double log_determinant = blur(elementary::exp(2 * log_spread) / variance_, slope, {&S, &y, &level});
    double slope_product = 0, slope_square = 0, squares = 0;
    for (std::size_t j = 0; j < size(); ++j) {
      const double square = sum(level, level, j);
      const double of_y = sum(level, y, j) / square, of_S = sum(level, S, j) / square;
      for (std::size_t i = begin_[j]; i < end(j); ++i) {
        y[i] -= of_y * level[i];
        S[i] -= of_S * level[i];
      }
      slope_product += sum(S, y, j);
      slope_square += sum(S, S, j);
      squares += sum(y, y, j);
    }
    squares_ = squares - (slope_square > 1e-12 ? slope_product * slope_product / slope_square : 0);
    const double away = elementary::log(e0) / first_rise_error;
    return minus_log_likelihood(squares_, rho, 0.5 * away * away + log_determinant);
  }

  // The share of the apparent stiffness that the drops take and the rises give back, at a friction, by a straight line through its logarithm
  // in each rise.
  double given_back(double friction) const {
    constexpr double least_given_back = -1, most_given_back = 2;  // drops that hardly matter say no more
    double gained = 0, lost = 0, before = 0;
    for (std::size_t j = 0; j < size(); ++j) {
      const std::size_t n = end(j) - begin_[j];
      const auto row = [&](std::size_t i) -> const Row& { return rows_[begin_[j] + i]; };
      const auto deflection = [&](std::size_t i) { return row(i).w; };
      const auto logarithm = [&](std::size_t i) {
        constexpr double nothing = 1e-6;  // of a specimen that broke
        const double force = psi_.force.of(begin_[j] + i).at(friction).value;
        return elementary::log(std::max(row(i).F / force, nothing));
      };
      const Line line = line_through(n, deflection, logarithm);
      const auto at = [&](std::size_t i) { return line.mean_y + line.slope * (row(i).w - line.mean_x); };
      gained += at(n - 1) - at(0);
      if (j > 0) lost += before - at(0);
      before = at(n - 1);
    }
    return lost > 0 ? std::clamp(gained / lost, least_given_back, most_given_back) : most_given_back;
  }

  std::vector<Row> rows_;
  Expanded psi_;
  std::vector<std::array<double, slow_terms>> legendre_;  // of each row
  std::vector<std::size_t> begin_;                        // of each rise
  std::size_t n_ = 0;
  double variance_ = 0;                                      // of a row, as far as it is known from the round before
  double squares_ = 0, left_ = 1;                            // of the last evaluation
  std::vector<double> x_, y_, z_, by_row_, at_row_, slope_;  // padded: what is beyond n_ is of no row
};

double squashed(double x) {  // tanh
  constexpr double far = 20;
  return 1 - 2 / (1 + elementary::exp(2 * std::clamp(x, -far, far)));
}

bool is_like_calibrated(const ReducedRecord& record, const Rig& rig) {
  namespace fitted = verdict_coefficients;
  const double deepest = *std::max_element(record.deflection.begin(), record.deflection.end());
  return record.force.size() >= fitted::fewest_rows && record.force.size() <= fitted::most_rows &&
         rig.stiffness >= fitted::softest_train && rig.stiffness <= fitted::stiffest_train &&
         deepest >= fitted::shallowest;
}

}  // namespace

std::string_view name_of(CrackVerdict verdict) {
  return name_in_order<CrackVerdict::cannot_be_told>(verdict, {"not_by_cracks_alone", "cracks", "cannot_be_told"});
}

CrackVerdict verdict_of(double cracks_alone) {
  constexpr double sure = 0.95;
  return cracks_alone > sure       ? CrackVerdict::cracks
         : cracks_alone < 1 - sure ? CrackVerdict::not_by_cracks_alone
                                   : CrackVerdict::cannot_be_told;
}

double cracks_alone(const RiseFeatures& features) {
  namespace fitted = verdict_coefficients;
  const double of_a_rise =
      fitted::constant +
      fitted::of_given_back * squashed((features.given_back - fitted::given_back_middle) / fitted::given_back_width) +
      fitted::of_friction_needed *
          squashed((features.friction_needed - fitted::friction_needed_middle) / fitted::friction_needed_width) +
      fitted::of_margin * squashed(features.margin / fitted::margin_width) +
      fitted::of_loss_margin * squashed(features.loss_margin / fitted::loss_margin_width);
  const double rises = std::sqrt(static_cast<double>(std::min(features.rises, fitted::rises_that_count)));
  return 1 / (1 + elementary::exp(-rises * of_a_rise));
}

SlipOrCrack slip_or_crack(const ReducedRecord& record, const Rig& rig, std::span<const Drop> drops) {
  SlipOrCrack out{};
  constexpr std::size_t least = 3;
  if (drops.size() < least) return out;
  Rises rises(record, rig, drops);
  if (rises.after_drops() < least) return out;
  out = rises.explained();
  out.judged = true;
  out.features.margin = std::min({out.cracks.bic, out.cracks_constant.bic, out.cracks_running.bic}) -
                        std::min(out.slip.bic, out.slip_and_cracks.bic);
  out.features.loss_margin = out.slip.bic - out.slip_and_cracks.bic;
  out.cracks_alone = is_like_calibrated(record, rig) ? cracks_alone(out.features) : not_a_number;
  out.verdict = verdict_of(out.cracks_alone);
  return out;
}

}  // namespace flexslip
