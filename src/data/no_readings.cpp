#include "data/no_readings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "numerics/statistics.h"

namespace flexslip {
namespace {

constexpr std::size_t longest_spike = 3;  // [points]
constexpr double errors = 6;

class Spikes {
 public:
  Spikes(const Record& record, double stiffness) : stage_(record.stage), force_(record.force) {
    const std::vector<double> smooth = smooth_steps(record);
    std::vector<double> beside, rises;
    double steepest = 0;
    for (std::size_t i = 0; i < smooth.size(); ++i) {
      const double travel = stage_[i + 1] - stage_[i];
      beside.push_back(std::abs(force_[i + 1] - force_[i] - smooth[i]));
      if (travel > 0) steepest = std::max(steepest, smooth[i] / travel);
    }
    noise_ = errors * std::max(StepNoise(record, smooth).over(1), deviation_by_median * median_of(beside));
    constexpr double of_steepest = 3;
    stiffness_ = std::isfinite(stiffness) ? stiffness : of_steepest * steepest;
  }

  std::vector<std::size_t> found() const {
    std::vector<std::size_t> spikes;
    for (std::size_t i = 1; i < force_.size(); ++i) {
      if (can_follow(i - 1, i)) continue;
      std::size_t first = i, last = end_of_peak(i);
      if (last == i) {
        first = begin_of_dip(i);
        last = i;
      }
      for (std::size_t k = first; k < last; ++k) spikes.push_back(k);
      i = std::max(i, last);
    }
    std::sort(spikes.begin(), spikes.end());
    spikes.erase(std::unique(spikes.begin(), spikes.end()), spikes.end());
    constexpr std::size_t of_points = 20;
    if (of_points * spikes.size() > force_.size()) spikes.clear();
    return spikes;
  }

 private:
  // True if the load train allows the rise of the force between the two points.
  bool can_follow(std::size_t before, std::size_t after) const {
    const double travel = std::max(stage_[after] - stage_[before], 0.0);
    return force_[after] - force_[before] <= stiffness_ * travel + noise_;
  }

  // The first point, soon after the rise, that can follow the point before it; otherwise the rise.
  std::size_t end_of_peak(std::size_t rise) const {
    for (std::size_t end = rise + 1; end < force_.size() && end - rise <= longest_spike; ++end)
      if (can_follow(rise - 1, end) && force_[end - 1] - force_[end] > noise_) return end;
    return rise;
  }

  // The first point below the later force before a rise; the rise itself if there is none.
  std::size_t begin_of_dip(std::size_t rise) const {
    for (std::size_t begin = rise - 1; begin > 0 && rise - begin <= longest_spike; --begin)
      if (can_follow(begin - 1, rise) && force_[begin - 1] - force_[begin] > noise_) return begin;
    return rise;
  }

  const std::vector<double>& stage_;
  const std::vector<double>& force_;
  double noise_, stiffness_;  // [N] allowed difference of a step; [N/m]
};

}  // namespace

std::vector<std::size_t> find_spikes(const Record& record, double stiffness) {
  return Spikes(record, stiffness).found();
}

namespace {

class StrayPositions {
 public:
  StrayPositions(std::span<const double> stage, std::span<const double> force) : stage_(stage), force_(force) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < stage.size(); ++i)
      if (stage[i] != stage[i - 1]) steps.push_back(std::abs(stage[i] - stage[i - 1]));
    typical_step_ = steps.empty() ? 0 : median_of(std::move(steps));
  }

  std::vector<std::size_t> found() const {
    std::vector<std::size_t> stray, in_words;
    for (std::size_t i = 1; i + 1 < stage_.size(); ++i) {
      if (!jumps_to(i)) continue;
      const std::size_t end = end_of_stray(i), end_of_word = end > i ? end : end_of_one_word(i);
      for (std::size_t k = i; k < end; ++k) stray.push_back(k);
      for (std::size_t k = end; k < end_of_word; ++k) in_words.push_back(k);
      i = std::max(i, std::max(end_of_word, i + 1) - 1);
    }
    constexpr std::size_t of_points = 20, of_words = 2;
    if (of_points * stray.size() > stage_.size()) stray.clear();
    if (of_words * in_words.size() > stage_.size()) in_words.clear();
    stray.insert(stray.end(), in_words.begin(), in_words.end());
    std::sort(stray.begin(), stray.end());
    return stray;
  }

 private:
  static constexpr double min_jump = 20;  // [typical step]

  double step_to(std::size_t i) const { return i == 0 ? 0.0 : std::abs(stage_[i] - stage_[i - 1]); }

  bool jumps_to(std::size_t i) const {
    return typical_step_ > 0 && step_to(i) > min_jump * std::max(typical_step_, step_to(i - 1));
  }

  // True if the stage is where it was before the jump, or where typical steps lead since.
  bool is_back(std::size_t jump, std::size_t point) const {
    constexpr double slack = 3;
    return std::abs(stage_[point] - stage_[jump - 1]) <= slack * typical_step_ * static_cast<double>(point + 1 - jump);
  }

  // The point at which it returns soon; the jump itself if it does not.
  std::size_t end_of_stray(std::size_t jump) const {
    for (std::size_t end = jump + 1; end < stage_.size() && end - jump <= longest_spike; ++end)
      if (is_back(jump, end)) return end;
    return jump;
  }

  // The point at which it returns after a run of equal values. The force must lie between its
  // values before and after, extended by a tenth.
  std::size_t end_of_one_word(std::size_t jump) const {
    std::size_t end = jump;
    while (end < stage_.size() && stage_[end] == stage_[jump]) ++end;
    if (end == stage_.size() || !jumps_back_at(end, jump)) return jump;
    constexpr double beyond = 0.1;
    const auto [least, most] = std::minmax(force_[jump - 1], force_[end]);
    const double by = beyond * std::max(std::abs(least), std::abs(most));
    for (std::size_t i = jump; i < end; ++i)
      if (force_[i] < least - by || force_[i] > most + by) return jump;
    return end;
  }

  bool jumps_back_at(std::size_t end, std::size_t jump) const {
    return step_to(end) > min_jump * typical_step_ && is_back(jump, end);
  }

  std::span<const double> stage_, force_;
  double typical_step_;  // median
};

}  // namespace

std::vector<std::size_t> find_stray_positions(std::span<const double> stage, std::span<const double> force) {
  return StrayPositions(stage, force).found();
}

std::vector<std::size_t> find_halts(const std::vector<double>& stage) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < stage.size(); ++i)
    if (stage[i] != stage[i - 1]) steps.push_back(std::abs(stage[i] - stage[i - 1]));
  if (steps.empty()) return {};
  const double one_place = median_of(std::move(steps)) / 200;
  std::vector<std::size_t> begins{0};  // first row of each position
  for (std::size_t i = 1; i < stage.size(); ++i)
    if (std::abs(stage[i] - stage[begins.back()]) > one_place) begins.push_back(i);
  begins.push_back(stage.size());
  std::vector<double> counts;
  for (std::size_t place = 0; place + 1 < begins.size(); ++place)
    counts.push_back(static_cast<double>(begins[place + 1] - begins[place]));
  constexpr double at_least = 5, of_usual = 3;
  const double many = std::max(at_least, of_usual * median_of(counts) + 1);
  std::vector<std::size_t> halts;
  for (std::size_t place = 0; place + 1 < begins.size(); ++place) {
    if (counts[place] < many) continue;
    for (std::size_t i = begins[place] + 1; i < begins[place + 1]; ++i) halts.push_back(i);
  }
  return halts;
}

namespace {

// The interval in which the force stays at its maximum.
struct Plateau {
  std::size_t first, last;
  double band;  // [N] allowed range of the force
};

// True if the earlier slope predicts a rise far above the band and a hundredth of the maximum.
bool would_have_risen(const Record& record, const Plateau& plateau, std::size_t points_before) {
  const auto& [stage, deflection, force] = record;
  if (plateau.first < points_before) return false;
  const std::size_t before = plateau.first - points_before;
  const double travel = stage[plateau.first] - stage[before];
  const double slope = (force[plateau.first] - force[before]) / travel;
  constexpr double by_far = 8, part = 0.01;
  const double least = std::max(by_far * plateau.band, part * force[plateau.first]);
  return travel > 0 && slope * (stage[plateau.last] - stage[plateau.first]) > least;
}

}  // namespace

std::size_t points_before_wrap(std::span<const double> force) {
  constexpr double nearly = 0.9;
  double far = 0;
  for (const double each : force) far = std::max(far, nearly * std::abs(each));
  constexpr std::size_t before = 3;  // points that approach the limit: a glitch has none
  for (std::size_t i = before; i < force.size(); ++i) {
    if (!(std::min(std::abs(force[i - 1]), std::abs(force[i])) > far && force[i - 1] * force[i] < 0)) continue;
    const auto lead = force.subspan(i - before, before);
    if (std::all_of(lead.begin(), lead.end(), [&](double each) { return each * force[i] < -0.5 * far * far; }))
      return i;
  }
  return force.size();
}

std::size_t points_before_overload(const Record& record) {
  const std::vector<double>& force = record.force;
  const auto greatest = std::max_element(force.begin(), force.end());
  if (force.size() < least_noise_points) return force.size();
  if (const std::size_t points = points_before_wrap(force); points < force.size()) return points;
  const auto first = static_cast<std::size_t>(greatest - force.begin());
  double resolution = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i <= first; ++i)
    if (force[i] != force[i - 1]) resolution = std::min(resolution, std::abs(force[i] - force[i - 1]));
  // Noise rarely puts five readings so close to the maximum. A yielding specimen keeps its noise.
  constexpr std::size_t min_points = 5;
  constexpr double noise_share = 0.5, nearly = 0.9;
  const auto rise = static_cast<std::size_t>(
      std::find_if(force.begin(), force.end(), [&](double each) { return each > nearly * *greatest; }) - force.begin());
  const double band = noise_share * force_noise(rise >= least_noise_points ? first_points(record, rise) : record);
  Plateau plateau{first, first, std::max(band, resolution)};
  while (plateau.first > 0 && force[plateau.first - 1] >= *greatest - band) --plateau.first;
  while (plateau.last + 1 < force.size() && force[plateau.last + 1] >= *greatest - band) ++plateau.last;
  const std::size_t count = plateau.last + 1 - plateau.first;
  // Compared with the slope over an interval that is short relative to a smooth maximum.
  const bool ends = count >= min_points && would_have_risen(record, plateau, std::max(min_points, count / 4));
  return ends ? plateau.first + 1 : force.size();
}

}  // namespace flexslip
