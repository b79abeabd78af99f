#include "data/failure.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "numerics/statistics.h"

namespace flexslip {
namespace {

// A fall from a peak of the force to the next trough.
struct Fall {
  std::size_t peak, trough;
  double at_once;  // [N] largest loss within 1.5 % of the travel
};

// A loading up to its largest stage position.
class Loading {
 public:
  explicit Loading(const Record& record) : stage_(record.stage), force_(record.force) {
    const auto farthest = std::max_element(stage_.begin(), stage_.end()) - stage_.begin();
    points_ = static_cast<std::size_t>(farthest) + 1;
    const auto highest = std::max_element(force_.begin(), force_.begin() + farthest + 1);
    max_force_ = *highest;
    travel_ = stage_[static_cast<std::size_t>(highest - force_.begin())] - stage_[0];
    noise_ = noise();
    if (max_force_ > 0) find_falls();
  }

  Failure failure() const {
    const std::size_t all = force_.size();
    std::size_t first = first_of_steps();
    if (first == falls_.size()) first = first_of_break();
    if (first == falls_.size()) return {FailureStatus::none, all, all};
    const std::size_t points = begin_of(falls_[first]);
    if (points == all) return {FailureStatus::none, all, all};
    return {FailureStatus::found, points, falls_[first].trough};
  }

 private:
  static constexpr double a_twentieth = 0.05, a_tenth = 0.1, much = 1.0 / 6, half = 0.5;  // [maximum force]
  static constexpr double window = 0.015, reach = 0.07, rest = 0.006;                     // [travel]

  double highest_from(std::size_t point) const {
    return *std::max_element(force_.begin() + static_cast<std::ptrdiff_t>(point),
                             force_.begin() + static_cast<std::ptrdiff_t>(points_));
  }

  // [N] noise of one reading, from second differences, most of them due to noise.
  double noise() const {
    if (points_ < 3) return 0;
    std::vector<double> bends;
    for (std::size_t i = 1; i + 1 < points_; ++i)
      bends.push_back(std::abs(force_[i + 1] - 2 * force_[i] + force_[i - 1]));
    return deviation_by_median * median_of(bends) / std::sqrt(6.0);
  }

  void find_falls() {
    const double min_fall = std::max(0.003 * max_force_, 4 * noise_);
    std::size_t peak = 0, trough = 0;
    bool falls = false;
    const auto add = [&] {
      std::size_t bottom = peak;  // the end of the fall, before any later noise
      while (force_[bottom] > force_[trough] + min_fall) ++bottom;
      falls_.push_back({peak, bottom, lost_at_once(peak, bottom)});
    };
    for (std::size_t i = 1; i < points_; ++i) {
      if (falls && force_[i] - force_[trough] > min_fall) {
        add();
        falls = false;
        peak = i;
      } else if (falls) {
        if (force_[i] < force_[trough]) {
          trough = i;
        } else if (stage_[i] - stage_[trough] > rest * travel_) {  // what falls later is another fall
          add();
          falls = false;
          peak = i;
        }
      } else if (force_[i] >= force_[peak]) {
        peak = i;
      } else if (force_[peak] - force_[i] > min_fall) {
        falls = true;
        trough = i;
      }
    }
    if (falls) add();
  }

  // [N] The loss within 1.5 % of the travel after a point, or up to the next point.
  double lost_from(std::size_t point, std::size_t trough) const {
    double lost = 0;
    for (std::size_t i = point + 1; i <= trough; ++i) {
      if (i > point + 1 && stage_[i] - stage_[point] > window * travel_) break;
      lost = std::max(lost, force_[point] - force_[i]);
    }
    return lost;
  }

  double lost_at_once(std::size_t peak, std::size_t trough) const {
    double largest = 0;
    for (std::size_t i = peak; i < trough; ++i) largest = std::max(largest, lost_from(i, trough));
    return largest;
  }

  // [N] The loss in a fall that as a whole falls as steeply as a step of a break; 0 in a decline.
  double lost_steeply(const Fall& fall) const {
    const double lost = force_[fall.peak] - force_[fall.trough];
    const double steps = std::max(1.0, (stage_[fall.trough] - stage_[fall.peak]) / (window * travel_));
    return lost >= a_twentieth * max_force_ * steps ? lost : 0;
  }

  bool is_for_good(const Fall& fall) const { return highest_from(fall.trough) < force_[fall.peak]; }

  bool stands_out(std::size_t fall, double min_share) const {
    double before = 0;
    for (std::size_t k = 0; k < fall; ++k) before = std::max(before, falls_[k].at_once);
    return falls_[fall].at_once >= std::max(min_share * max_force_, 4 * before);
  }

  // The first of the steps in which a laminate loses its plies one after another; falls_.size() if
  // the specimen does not break so. No step takes half the maximum, all steps together do, the force
  // ends below half, and the first step is four times the largest earlier loss.
  std::size_t first_of_steps() const {
    double largest = 0, together = 0;
    for (const Fall& fall : falls_) largest = std::max(largest, fall.at_once);
    if (largest >= half * max_force_ || force_[points_ - 1] >= half * max_force_) return falls_.size();
    std::size_t first = 0;
    while (first < falls_.size() && !(is_for_good(falls_[first]) && stands_out(first, a_twentieth))) ++first;
    for (std::size_t k = first; k < falls_.size(); ++k) together += lost_steeply(falls_[k]);
    return together >= half * max_force_ ? first : falls_.size();
  }

  // The first fall of a break: the last fall, or one shortly before it; falls_.size() if there is none.
  std::size_t first_of_break() const {
    std::size_t first = last_fall();
    for (std::size_t k = first; first < falls_.size() && k-- > 0;) {
      if (stage_[falls_[first].peak] - stage_[falls_[k].trough] > reach * travel_) break;
      if (is_for_good(falls_[k]) && (falls_[k].at_once >= much * max_force_ || stands_out(k, a_twentieth))) first = k;
    }
    return first;
  }

  // True if the record ends here, or less than half the maximum follows at once.
  bool carries_less_than_half() const {
    for (std::size_t i = points_; i < force_.size() && stage_[points_ - 1] - stage_[i] <= window * travel_; ++i)
      if (force_[i] < half * max_force_) return true;
    return points_ == force_.size();
  }

  // The fall after which the force stays below half its maximum, or which ends the record;
  // falls_.size() if there is none.
  std::size_t last_fall() const {
    std::size_t low = points_;
    while (low > 0 && force_[low - 1] < half * max_force_) --low;
    if (low < points_) {
      const auto through = std::find_if(falls_.begin(), falls_.end(),
                                        [low](const Fall& fall) { return fall.peak < low && low <= fall.trough; });
      if (through == falls_.end()) return falls_.size();
      std::size_t before = low - 1;
      while (before > through->peak && stage_[low] - stage_[before - 1] <= window * travel_) --before;
      const auto fall = static_cast<std::size_t>(through - falls_.begin());
      const double lost = lost_from(before, through->trough);
      return lost >= a_twentieth * max_force_ &&
                     (leaves_almost_no_force(fall) || lost >= 1.5 * largest_loss_before(fall))
                 ? fall
                 : falls_.size();
    }
    constexpr std::size_t next_to_the_end = 3;
    const bool ends_so = !falls_.empty() && carries_less_than_half() &&
                         points_ - falls_.back().trough <= next_to_the_end && stands_out(falls_.size() - 1, a_tenth);
    return ends_so ? falls_.size() - 1 : falls_.size();
  }

  // True if a fall, with those that follow at once, leaves almost no force. A slip leaves more.
  bool leaves_almost_no_force(std::size_t fall) const {
    const std::size_t trough = falls_[fall].trough;
    for (std::size_t i = trough; i < points_ && stage_[i] - stage_[trough] <= reach * travel_; ++i)
      if (force_[i] < a_tenth * max_force_) return true;
    return false;
  }

  // [N] The largest loss before the range in which a break in steps may lie.
  double largest_loss_before(std::size_t fall) const {
    double largest = 0;
    for (std::size_t k = 0; k < fall; ++k)
      if (stage_[falls_[fall].peak] - stage_[falls_[k].trough] > reach * travel_)
        largest = std::max(largest, falls_[k].at_once);
    return largest;
  }

  // The last point before the main fall, extended over points that have lost almost no force.
  std::size_t begin_of(const Fall& fall) const {
    const double loses = std::min(a_twentieth * max_force_, fall.at_once);
    std::size_t begin = fall.peak;
    while (begin < fall.trough && lost_from(begin, fall.trough) < loses) ++begin;
    const double level = force_[begin] - std::max(0.003 * max_force_, 4 * noise_);
    std::size_t last = begin;
    while (last < fall.trough && force_[last + 1] > level) ++last;
    return last + 1;
  }

  const std::vector<double>& stage_;
  const std::vector<double>& force_;
  std::size_t points_;
  // travel up to the maximum force, that force, noise of a reading
  double travel_, max_force_, noise_;
  std::vector<Fall> falls_;
};

}  // namespace

Failure find_failure(const Record& record) {
  const std::size_t all = record.force.size();
  return all < 2 ? Failure{FailureStatus::none, all, all} : Loading(record).failure();
}

}  // namespace flexslip
