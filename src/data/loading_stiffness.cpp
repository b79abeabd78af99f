#include "data/loading_stiffness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "numerics/elementary.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

constexpr double far_enough = 1.0 / 3;       // [greatest force of the first loading] where a reload must get
constexpr double farthest_bent = 2;          // [first loading] where a reload may be at the same force
constexpr std::size_t min_on_a_loading = 6;  // twice what a line with a scatter needs, for the two halves

void require_apart(const Record& record, std::span<const LoadingRange> loadings) {
  const std::size_t rows = record.force.size();
  require_readings(record);
  std::size_t reached = 0;
  for (const auto& [first, last] : loadings) {
    if (first < reached || last <= first || last > rows)
      throw std::invalid_argument("loading from row = " + std::to_string(first) + " is out of range");
    reached = last;
  }
}

struct Slope {
  double value, error;  // [N/m]; value NaN if there is none
};

// dF/dw0 over the rows [first, last), by way of the stage.
Slope slope_of(const Record& record, std::size_t first, std::size_t last) {
  const auto rows = [&](const std::vector<double>& values) { return std::span(values).subspan(first, last - first); };
  const CommonLine line = common_line(rows(record.stage), rows(record.force), rows(record.deflection));
  if (std::isnan(line.slope)) return {not_a_number, not_a_number};
  constexpr double max_correlation = 0.9;
  return {line.slope, slope_error(line, correlation_lost_to_line(line.residuals), max_correlation)};
}

struct Window {
  double from, middle, up_to;  // [N]
};

struct MeasuredLoading {
  LoadingStatus status;
  std::size_t first, last;
  double deflection;  // [m] mean in the window
  Slope whole, lower, upper;
};

// The rows of a rising force between two levels: from the last one below `from` before it first exceeds up_to.
MeasuredLoading measure(const Record& record, const LoadingRange& loading, const Window& window) {
  const Slope none{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  MeasuredLoading result{LoadingStatus::window_not_covered,
                         loading.first,
                         loading.first,
                         std::numeric_limits<double>::quiet_NaN(),
                         none,
                         none,
                         none};
  std::size_t last = loading.first;
  while (last < loading.last && record.force[last] <= window.up_to) ++last;
  std::size_t first = last;
  while (first > loading.first && record.force[first - 1] >= window.from) --first;
  if (last == loading.last || first == loading.first) return result;
  result.first = first;
  result.last = last;
  std::size_t middle = first;
  while (middle < last && record.force[middle] <= window.middle) ++middle;
  result.status = LoadingStatus::too_few_points;
  if (last - first < min_on_a_loading || middle - first < min_on_a_loading / 2 || last - middle < min_on_a_loading / 2)
    return result;

  result.deflection = mean_of(std::span(record.deflection).subspan(first, last - first));
  result.whole = slope_of(record, first, last);
  result.lower = slope_of(record, first, middle);
  result.upper = slope_of(record, middle, last);
  const bool rising = result.whole.value > 0 && result.lower.value > 0 && result.upper.value > 0;
  result.status = rising ? LoadingStatus::ok : LoadingStatus::not_rising;
  return result;
}

// Of the line through the window.
double freedom_of(const MeasuredLoading& loading) {
  return std::max(static_cast<double>(loading.last - loading.first) - 2, 1.0);
}

// What a later loading tells of the stiffness lost since one.
ReloadChange between(const LoadingStiffness& before, const LoadingStiffness& after) {
  const double ratio = after.ratio.value / before.ratio.value;
  const double systematic = elementary::length(after.ratio_systematic, ratio * before.ratio_systematic);
  const double scatter = elementary::length(after.ratio.standard_error, ratio * before.ratio.standard_error);
  ReloadChange change{.loss = 1 - ratio, .loss_error = elementary::length(scatter, systematic) / before.ratio.value};
  constexpr double one_sided_95 = 1.645, worth_saying = 0.05;
  if (change.loss - one_sided_95 * change.loss_error > relevant_loss)
    change.change = StiffnessChange::softer;
  else if (std::abs(change.loss) > std::max(worth_saying, two_sided_95 * change.loss_error))
    change.change = change.loss > 0 ? StiffnessChange::slightly_softer : StiffnessChange::stiffer;
  return change;
}

}  // namespace

std::vector<LoadingStiffness> compare_loadings(const Record& record, std::span<const LoadingRange> loadings) {
  require_apart(record, loadings);
  if (loadings.empty()) return {};
  const auto greatest_force = [&](const LoadingRange& loading) {
    const auto rows = std::span(record.force).subspan(loading.first, loading.last - loading.first);
    return *std::max_element(rows.begin(), rows.end());
  };
  const double most = greatest_force(loadings.front());
  double least = most;
  for (const LoadingRange& loading : loadings)
    if (greatest_force(loading) >= far_enough * most) least = std::min(least, greatest_force(loading));
  const Window window{loading_window_from * least, 0.5 * (loading_window_from + loading_window_up_to) * least,
                      loading_window_up_to * least};
  const double quantile = elementary::gaussian_quantile(loading_confidence);

  const MeasuredLoading reference = measure(record, loadings.front(), window);
  std::vector<LoadingStiffness> result;
  result.reserve(loadings.size());
  for (const LoadingRange& loading : loadings) {
    MeasuredLoading measured = measure(record, loading, window);
    if (greatest_force(loading) < far_enough * most) measured.status = LoadingStatus::loaded_too_little;
    const bool is_reference = result.empty();
    LoadingStiffness stiffness{
        .status = measured.status,
        .first = measured.first,
        .last = measured.last,
        .slope = student_estimate(measured.whole.value, measured.whole.error, freedom_of(measured)),
        .ratio = normal_estimate(1, 0),
        .ratio_systematic = 0,
        .verdict = DamageVerdict::not_damaged};
    const bool comparable = stiffness.status == LoadingStatus::ok && reference.status == LoadingStatus::ok;
    const bool steeper =
        measured.whole.value > reference.whole.value;  // what has lost stiffness is bent farther, too, and less steep
    if (comparable && steeper && measured.deflection > farthest_bent * reference.deflection)
      stiffness.status = LoadingStatus::still_drawn_in;
    if (!is_reference && stiffness.status == LoadingStatus::ok) {
      const double ratio = measured.whole.value / reference.whole.value;
      stiffness.ratio = student_estimate(ratio,
                                         ratio * elementary::length(measured.whole.error / measured.whole.value,
                                                                    reference.whole.error / reference.whole.value),
                                         std::min(freedom_of(measured), freedom_of(reference)));
      stiffness.ratio_systematic =
          0.5 * std::abs(measured.upper.value / reference.upper.value - measured.lower.value / reference.lower.value);
      const double bound = quantile * elementary::length(stiffness.ratio.standard_error, stiffness.ratio_systematic);
      const double loss = 1 - ratio;
      stiffness.verdict = loss - bound > relevant_loss   ? DamageVerdict::damaged
                          : loss + bound < relevant_loss ? DamageVerdict::not_damaged
                                                         : DamageVerdict::undecided;
      if (reference.status != LoadingStatus::ok) stiffness.status = LoadingStatus::no_reference;
    }
    if (stiffness.status != LoadingStatus::ok) {
      constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
      stiffness.ratio = {unknown, unknown, unknown, unknown};
      stiffness.ratio_systematic = unknown;
      stiffness.verdict = DamageVerdict::undecided;
    }
    result.push_back(stiffness);
  }
  return result;
}

bool lost_stiffness(const ReloadChange& reload) { return reload.change == StiffnessChange::softer; }

ReloadChange reload_change(const std::vector<LoadingStiffness>& loadings, std::size_t evaluated) {
  if (evaluated >= loadings.size() || loadings[evaluated].status != LoadingStatus::ok) return {};
  const LoadingStiffness &own = loadings[evaluated], &first = loadings.front();
  for (std::size_t i = loadings.size(); i-- > evaluated + 1;)
    if (loadings[i].status == LoadingStatus::ok) {
      ReloadChange change = between(own, loadings[i]);
      change.comes_after = true;
      return change;
    }
  return evaluated > 0 && first.status == LoadingStatus::ok ? between(first, own) : ReloadChange{};
}

}  // namespace flexslip
