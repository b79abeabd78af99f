#include "inference/beginning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "bending_test/equilibrium.h"
#include "numerics/beam.h"
#include "numerics/dense.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

constexpr double deepest_beginning = 0.2;  // [L] limit of the deflections examined

// [1] Candidate frictions at the beginning.
constexpr std::array begin_frictions{0.0, 0.2, 0.4, 0.6, 0.8, 1.0};

// F/w [EI/L^3] of a specimen that slides with one friction, at evenly spaced deflections.
class Rise {
 public:
  explicit Rise(double q) {
    constexpr int knots = 64;
    const auto curve = sliding_up_to(deepest_beginning, q, 4 * knots);
    for (int i = 1; i <= knots; ++i) {
      const double w = deepest_beginning * i / knots;
      const double F = force_at(curve, w);
      over_.push_back(std::isfinite(F) ? F / w : over_.back());
    }
    over_.insert(over_.begin(), 2 * over_[0] - over_[1]);
  }

  struct Value {
    double force, slope;
  };
  // [EI/L^2], [EI/L^3] at a deflection [L]; zero before the contact.
  Value at(double w) const {
    if (w <= 0) return {0, 0};
    const auto last = static_cast<double>(over_.size() - 1);
    const double place = std::min(w / deepest_beginning, 1.0) * last;
    const auto i = std::min(static_cast<std::size_t>(place), over_.size() - 2);
    const double rate = over_[i + 1] - over_[i];
    const double over = over_[i] + rate * (place - static_cast<double>(i));
    return {w * over, over + w * rate * last / deepest_beginning};
  }

 private:
  std::vector<double> over_;
};

// The examined readings, with deflections in spans.
struct Looked {
  std::vector<double> stage, deflection, force;
};

// One candidate for the beginning.
struct Seat {
  double force;  // [N] at which the seat has settled to 1 - 1/e; 0: no settling
};

struct Fitted {
  double contact = 0, log_stiffness = 0, offset = 0, depth = 0;  // [L], of e [N], [N], [L] of the seat
  double contact_variance = 0, depth_variance = 0;
  double loss = std::numeric_limits<double>::infinity();  // -2 ln of the probability, up to a constant
  double log_volume = 0;                                  // ½ ln det of the covariance
  double scatter = 0;                                     // [N] robust scatter of the residuals
  std::vector<double> residuals;

  double settled() const { return contact + depth; }
};

constexpr double usual_depth = 0.012;  // [L] prior standard deviation of the settling

class BeginningFit {
 public:
  BeginningFit(const Looked& looked, const BeginningOf& test, const Fitted& first, double noise)
      : looked_(looked), first_(first), compliance_(1 / (test.load_train_stiffness * test.span)), noise_(noise) {
    if (test.bending_stiffness) weight_of_stiffness_ = 1 / square(std::max(test.bending_stiffness_error, 1e-6));
  }

  // From a contact [L] and ln e; the offset of the force is known to `offset_error` [N].
  Fitted fit(const Rise& rise, Fitted start, Seat seat, double offset_error, double scatter) const {
    const bool has_seat = seat.force > 0;
    Fitted at = std::move(start);
    at.scatter = scatter;
    Slopes about = slopes_at(at, rise, seat);
    constexpr int steps = 40;
    for (int step = 0; step < steps; ++step) {
      if (scatter == 0) at.scatter = std::max(noise_, deviation_by_median * median_of_sizes(at.residuals));
      at.loss = loss_of(at, has_seat, offset_error);
      const double scale = square(at.scatter);
      Eigen::Matrix4d normal = Eigen::Matrix4d::Zero(), curved = Eigen::Matrix4d::Zero();
      Eigen::Vector4d gradient = Eigen::Vector4d::Zero();
      for (std::size_t i = 0; i < about.size(); ++i) {
        const double excess = square(at.residuals[i]) / far;
        const double weight = 1 / (scale + excess), bend = (scale - excess) * weight;
        for (Eigen::Index a = 0; a < 4; ++a) {
          const double weighed = weight * about[i][a];
          gradient[a] += at.residuals[i] * weighed;
          for (Eigen::Index b = 0; b < 4; ++b) {
            normal(a, b) += weighed * about[i][b];
            curved(a, b) += bend * weighed * about[i][b];
          }
        }
      }
      const auto known = prior_of(at, has_seat, offset_error);
      for (Eigen::Index i = 0; i < 4; ++i) {
        normal(i, i) += known[static_cast<std::size_t>(i)].weight;
        curved(i, i) += known[static_cast<std::size_t>(i)].weight;
        gradient[i] -= known[static_cast<std::size_t>(i)].weight * known[static_cast<std::size_t>(i)].away;
      }
      normal.diagonal() *= 1 + 1e-9;
      const Symmetric solver(normal);
      // Newton's step if it decreases the loss. Distant readings can make the curvature negative;
      // then a step of reweighted least squares.
      Eigen::Vector4d move = Symmetric(curved).solved(gradient);
      if (!(move.dot(gradient) > 0)) move = solver.solved(gradient);
      const Eigen::MatrixXd& covariance = solver.inverse();
      at.depth_variance = covariance(3, 3);
      at.contact_variance = covariance(0, 0) + covariance(3, 3) + 2 * covariance(0, 3);
      at.log_volume =
          -0.5 * solver.log_determinant() + (has_seat ? -elementary::log(usual_depth) : 0.5 * elementary::log(exactly));
      if (!move.allFinite()) return {};
      if (std::abs(move[0]) < 1e-8 && std::abs(move[1]) < 1e-6 && std::abs(move[3]) < 1e-8) break;
      // Halve the step until the loss does not grow.
      constexpr int halvings = 10;
      double part = 1 / std::max({1.0, std::abs(move[0]) / 0.02, std::abs(move[1]) / 0.3, std::abs(move[3]) / 0.02});
      bool is_better = false;
      for (int halving = 0; halving < halvings && !is_better; ++halving, part /= 2) {
        Fitted next = at;
        next.contact += part * move[0];
        next.log_stiffness += part * move[1];
        next.offset += part * move[2];
        next.depth += part * move[3];
        Slopes there = slopes_at(next, rise, seat);
        is_better = loss_of(next, has_seat, offset_error) <= at.loss;
        if (!is_better) continue;
        at = std::move(next);
        about = std::move(there);
      }
      if (!is_better) break;
    }
    return at;
  }

 private:
  static constexpr double far = 9;         // [scatter²] beyond which a reading has little weight
  static constexpr double exactly = 1e18;  // the weight of an exactly known value

  // Minus the derivatives of each residual in contact, ln e, offset and depth.
  using Slopes = std::vector<Eigen::Vector4d>;

  // At a fit, whose residuals it sets.
  Slopes slopes_at(Fitted& at, const Rise& rise, Seat seat) const {
    at.residuals.clear();
    const double e = elementary::exp(at.log_stiffness);
    Slopes rows;
    rows.reserve(looked_.force.size());
    for (std::size_t i = 0; i < looked_.force.size(); ++i) {
      const double force = looked_.force[i] - at.offset;
      const double yields = seat.force > 0 ? -elementary::exp_less_one(-std::max(force, 0.0) / seat.force) : 0;
      const auto [F, slope] = rise.at(looked_.deflection[i] + compliance_ * at.offset - at.contact - at.depth * yields);
      at.residuals.push_back(force - e * F);
      rows.emplace_back(-e * slope, e * F, 1 + e * slope * compliance_, -e * slope * yields);
    }
    return rows;
  }

  struct Known {
    double away, weight;
  };
  std::array<Known, 4> prior_of(const Fitted& at, bool has_seat, double offset_error) const {
    constexpr double somewhere = 100;  // [1/L²] weak prior about the start
    return {{{at.contact - first_.contact, somewhere},
             {at.log_stiffness - first_.log_stiffness, weight_of_stiffness_},
             {at.offset, 1 / square(offset_error)},
             {at.depth, has_seat ? 1 / square(usual_depth) : exactly}}};
  }

  double loss_of(const Fitted& at, bool has_seat, double offset_error) const {
    const double unit = 1 / (far * square(at.scatter));
    elementary::LogProduct sum;
    for (const double residual : at.residuals) sum.multiply(1 + unit * square(residual));
    double loss = far * sum.value();
    for (const Known& known : prior_of(at, has_seat, offset_error)) loss += known.weight * square(known.away);
    return loss;
  }

  static double square(double x) { return x * x; }
  static double median_of_sizes(std::vector<double> values) {
    for (double& value : values) value = std::abs(value);
    return median_of(std::move(values));
  }

  const Looked& looked_;
  Fitted first_;
  double compliance_;                 // [L/N]
  double noise_;                      // [N]
  double weight_of_stiffness_ = 0.1;  // a weak prior
};

// The running median of three readings, which removes outliers.
std::vector<double> without_spikes(std::span<const double> readings) {
  std::vector<double> calm(readings.begin(), readings.end());
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const std::size_t middle = std::clamp<std::size_t>(i, 1, readings.size() - 2);
    const auto [low, high] = std::minmax(readings[middle - 1], readings[middle + 1]);
    calm[i] = std::clamp(readings[middle], low, high);
  }
  return calm;
}

// The number of first rows until the force exceeds a share of its maximum; at least `fewest`.
Looked looked_at(const Record& record, std::span<const double> calm, double share, double span) {
  constexpr std::size_t fewest = 12;
  const double most = *std::max_element(calm.begin(), calm.end());
  std::size_t last = 0;
  while (last < calm.size() && calm[last] <= share * most) ++last;
  last = std::min(std::max(last, fewest), calm.size());
  Looked looked;
  for (std::size_t i = 0; i < last; ++i) {
    looked.stage.push_back(record.stage[i] / span);
    looked.deflection.push_back(record.deflection[i] / span);
    looked.force.push_back(record.force[i]);
  }
  return looked;
}

// The scatter of the readings about the best curve, and the factor for correlated neighbours.
struct Scatter {
  double size = 0, alike = 1;  // [N], [1]
};

struct Told {
  double offset = 0, variance = 0;  // [L], [L²] of the contact after settling
  double log_evidence = -std::numeric_limits<double>::infinity();
  double depth = 0, depth_variance = 0;  // of the seat
  Fitted likeliest{};
  Scatter scatter{};
};

// The average over all frictions and seats, weighed by their evidence. Without a scatter, the
// scatter of the best one is used.
// Fails:      an evidence of 0 if none fits.
Told told_by(const BeginningFit& fit, std::span<const Rise> rises, std::span<const Seat> seats, const Fitted& start,
             double offset_error, Scatter scatter = {}) {
  std::vector<Fitted> fits;
  double least = std::numeric_limits<double>::infinity();
  for (const Seat seat : seats)
    for (const Rise& rise : rises) {
      fits.push_back(fit.fit(rise, start, seat, offset_error, scatter.size));
      if (fits.back().scatter > 0) least = std::min(least, fits.back().scatter);
    }
  Told told{.scatter = scatter};
  if (!std::isfinite(least)) return told;
  if (scatter.size == 0) {
    told.scatter.size = least;
    for (std::size_t i = 0; i < fits.size(); ++i)  // the same scatter for all candidates
      fits[i] = fit.fit(rises[i % rises.size()], fits[i], seats[i / rises.size()], offset_error, least);
  }
  for (const Fitted& each : fits)
    if (each.loss < told.likeliest.loss) told.likeliest = each;
  constexpr double max_correlation = 0.8;  // a higher value belongs to a curve that does not fit
  if (scatter.size == 0)
    told.scatter.alike = std::max(1.0, effective_deviation(told.likeliest.residuals, 3, 0, max_correlation) / least);
  const double inflation = told.scatter.alike * told.scatter.alike;
  double sum = 0, mean = 0, square = 0, depths = 0;
  for (const Fitted& each : fits) {
    const double weight = elementary::exp(0.5 * (told.likeliest.loss - each.loss) / inflation + each.log_volume -
                                          told.likeliest.log_volume);
    if (!(weight > 0)) continue;
    sum += weight;
    mean += weight * each.settled();
    square += weight * (inflation * each.contact_variance + each.settled() * each.settled());
    told.depth += weight * each.depth;
    depths += weight * (inflation * each.depth_variance + each.depth * each.depth);
  }
  told.offset = mean / sum;
  told.variance = std::max(square / sum - told.offset * told.offset, 0.0);
  told.depth /= sum;
  told.depth_variance = std::max(depths / sum - told.depth * told.depth, 0.0);
  told.log_evidence = elementary::log(sum / static_cast<double>(seats.size())) + told.likeliest.log_volume -
                      0.5 * told.likeliest.loss / inflation;
  return told;
}

}  // namespace

Contact find_contact(const Record& record, const BeginningOf& test) {
  constexpr std::size_t fewest = 11;  // to determine a noise
  if (record.force.size() < fewest) return {ContactStatus::too_few_points};
  const std::vector<double> calm = without_spikes(record.force);
  const double most = *std::max_element(calm.begin(), calm.end());
  if (!(most > 0)) return {ContactStatus::not_rising};
  constexpr double short_range = 0.15, long_range = 0.3;  // [maximum force]
  const Looked looked = looked_at(record, calm, short_range, test.span);
  const double noise = std::max(force_noise(record), 1e-9 * most);

  // Start with a line through the upper part of the readings.
  const std::size_t n = looked.force.size();
  const std::size_t half = n - std::max<std::size_t>(n / 3, 5);
  const std::vector<double> deflection = without_spikes(looked.deflection);
  const Line line = line_through(std::span(deflection).subspan(half), std::span(calm).subspan(half, n - half));
  if (!(line.slope > 0)) return {ContactStatus::not_rising};
  Fitted start;
  start.contact = line.mean_x - line.mean_y / line.slope;
  start.log_stiffness = elementary::log(test.bending_stiffness ? *test.bending_stiffness / (test.span * test.span)
                                                               : line.slope / beam_stiffness);

  std::vector<Rise> rises;
  constexpr double of_rollers = 5.6;  // [1/L] the friction with the same effect as a roller radius
  for (const double mu : begin_frictions) rises.emplace_back(mu + of_rollers * test.support_radius / test.span);
  constexpr std::array firm{Seat{0}};
  const BeginningFit fit(looked, test, start, noise);
  double offset_error = noise;
  Told told = told_by(fit, rises, firm, start, offset_error);
  if (!std::isfinite(told.log_evidence)) return {ContactStatus::not_rising};
  constexpr std::ptrdiff_t enough = 3;  // rows to determine the zero of the force
  const auto before = std::count_if(looked.stage.begin(), looked.stage.end(),
                                    [&](double at) { return at < told.offset - std::sqrt(told.variance); });
  if (before >= enough) {
    constexpr double free = 1e3;
    offset_error = free * noise;
    told = told_by(fit, rises, firm, start, offset_error);
  }

  // Compare the evidence with and without settling over a longer range.
  const Looked longer = looked_at(record, calm, long_range, test.span);
  const BeginningFit longer_fit(longer, test, start, noise);
  const std::array seats{Seat{0.01 * most},  Seat{0.02 * most}, Seat{0.03 * most},
                         Seat{0.045 * most}, Seat{0.06 * most}, Seat{0.08 * most}};
  const Told seated = told_by(longer_fit, rises, seats, told.likeliest, offset_error);
  const Told plain = told_by(longer_fit, rises, firm, told.likeliest, offset_error, seated.scatter);
  const double for_seat = seated.log_evidence - plain.log_evidence;
  const double share =
      std::isfinite(for_seat) && seated.depth > 0 ? 1 / (1 + elementary::exp(-std::clamp(for_seat, -100.0, 100.0))) : 0;
  double error = std::sqrt(told.variance);
  if (share > 0) {
    const double away = seated.offset - told.offset;
    error = std::sqrt((1 - share) * told.variance + share * seated.variance + share * (1 - share) * away * away);
    told.offset += share * away;
  }
  if (!std::isfinite(told.offset) || !std::isfinite(error)) return {ContactStatus::not_rising};
  const double offset = test.span * told.offset;
  return {.status = ContactStatus::found,
          .offset = normal_estimate(offset, test.span * elementary::length(error, least_contact_error)),
          .slope = beam_stiffness * elementary::exp(told.likeliest.log_stiffness) / test.span,
          .points_before = static_cast<std::size_t>(
              std::count_if(record.stage.begin(), record.stage.end(), [=](double at) { return at < offset; })),
          .seat = share,
          .settles = share > 0.5 && seated.depth * seated.depth > 4 * seated.depth_variance};
}

Contact counted_from(double place, Contact contact) {
  for (double* value : {&contact.offset.value, &contact.offset.low, &contact.offset.high}) *value -= place;
  return contact;
}

}  // namespace flexslip
