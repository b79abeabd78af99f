#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "case/mechanics.h"
#include "case/preparing.h"
#include "data/drops.h"
#include "data/failure.h"
#include "io/input_error.h"
#include "numerics/statistics.h"

// The choice of the evaluated loading, and its end.
namespace flexslip {
namespace {

// The row of the file, from 1, before the point with this index.
std::size_t row_before(const Preparing& at, std::size_t points) { return rows_of_points(at.sampling(), points); }

struct Loading {
  Leg leg;
  EvaluatedLoading counted;
  std::string_view why{};
};

// The first loading that reaches almost the largest deflection, or whose force no later loading
// reaches. The specimen of later loadings is damaged.
// Fails:      InputError if the stage only moves back.
Loading loading_to_evaluate(const Preparing& at, const Record& record, const std::vector<Leg>& legs) {
  constexpr double as_far = 0.95;  // of the largest deflection and of the force
  const std::vector<double>& stage = record.stage;
  const auto greatest_force = [&](const Leg& leg) {
    const auto force = std::span(record.force).subspan(leg.first, leg.last - leg.first);
    return *std::max_element(force.begin(), force.end());
  };
  const auto [least, farthest] = std::minmax_element(stage.begin(), stage.end());
  const double far = *least + as_far * (*farthest - *least);
  std::vector<Leg> loadings;
  for (const Leg& leg : legs)
    if (leg.direction == Direction::loading) loadings.push_back(leg);
  Loading evaluated{{0, stage.size(), Direction::loading}, {0, loadings.size()}};
  std::vector<double> later(loadings.size(), -infinity);  // the maximum force of later loadings
  for (std::size_t i = loadings.size(); i-- > 1;) later[i - 1] = std::max(later[i], greatest_force(loadings[i]));
  for (std::size_t i = 0; i < loadings.size() && evaluated.counted.number == 0; ++i) {
    const double end = stage[loadings[i].last - 1];
    if (end < far && as_far * greatest_force(loadings[i]) <= std::max(later[i], 0.0)) continue;
    evaluated.leg = loadings[i];
    evaluated.counted.number = i + 1;
    evaluated.why = end < far         ? "no later one reaches its force again"
                    : end < *farthest ? "the first that goes about as far as any"
                                      : "none goes farther";
  }
  if (legs.empty()) return {evaluated.leg, {}};
  if (evaluated.counted.number > 0) return evaluated;
  throw InputError(
      {.file = at.table().source,
       .line = at.table().lines[0],
       .field = "the stage",
       .problem = "The record contains no loading, only unloading",
       .remedy =
           "if the stage is counted the other way, " +
           instruction_to_set(at.input(),
                              switch_to("sign", at.input().record->sign == SignRule::reverse ? "keep" : "reverse"))});
}

// Fails:      InputError if a loading starts above a fifth of its maximum force and the force falls
//             steadily to almost zero: an unloading, or rows that run backwards.
void require_rise(const Preparing& at, const Record& record, const Leg& leg) {
  const auto force = std::span(record.force).subspan(leg.first, leg.last - leg.first);
  constexpr std::size_t fewest = 30, parts = 20;
  if (force.size() < fewest) return;
  std::array<double, parts> mean;
  for (std::size_t part = 0; part < parts; ++part) {
    const std::size_t begin = part * force.size() / parts, end = (part + 1) * force.size() / parts;
    mean[part] = std::accumulate(force.begin() + static_cast<std::ptrdiff_t>(begin),
                                 force.begin() + static_cast<std::ptrdiff_t>(end), 0.0) /
                 static_cast<double>(end - begin);
  }
  const auto greatest = std::max_element(mean.begin(), mean.end());
  constexpr double little = 0.2, rise = 0.05;  // of the maximum
  const double first = std::min(mean.front(), force_at_start(force));
  if (first < little * *greatest || mean.back() > little * *greatest) return;
  constexpr std::ptrdiff_t at_once = 5;  // a failing specimen loses its force within fewer points
  std::ptrdiff_t between = 0;
  for (auto part = greatest + 1; part != mean.end(); ++part) {
    if (*part > *(part - 1) + rise * *greatest) return;
    if (*part > little * *greatest && *part < (1 - little) * *greatest) ++between;
  }
  if (between < at_once) return;
  const auto in_words = [&](double value) { return readable(value, kind_in(at.input(), kind::force)); };
  throw InputError(
      {.file = at.table().source,
       .line = at.table().lines[at.table().rows_before(at.sampling().rows[leg.first])],
       .field = "the force",
       .problem = fmt::format("The force falls steadily from {} to {}, but bending a specimen makes it rise",
                              in_words(force.front()), in_words(force.back())),
       .remedy = "if the rows run backwards in time, write them in the reverse order; if this is the "
                 "unloading of a test, give the rows of its loading"});
}

// The drops of a loading after a point, which are not evaluated.
std::size_t drops_behind(const Preparing& at, const Leg& loading, std::size_t from) {
  Record record = points_between(at.all, loading.first, loading.last);
  record.stage = advancing(record.stage);
  const Drops found = find_drops(record, {.halts = at.sampling().halts_between(loading.first, loading.last)});
  return static_cast<std::size_t>(std::count_if(found.drops.begin(), found.drops.end(),
                                                [&](const Drop& drop) { return loading.first + drop.before >= from; }));
}

// Under load, a load train deforms by at most the travel of the stage; the rest is deflection.
void require_stiff_enough(const Preparing& at, const Record& record) {
  const Record rise = first_rise(record);
  const double force = rise.force.back() - rise.force.front();
  const double way = rise.stage.back() - rise.stage.front();
  if (!(way > 0) || force / at.stiffness <= way) return;
  const Test& input = at.input();
  throw wrong_value(
      input, "rig.stiffness",
      fmt::format("The load train of {} yields by {} under {}, but the stage moved only {}",
                  readable(at.stiffness, kind_in(input, kind::stiffness)), readable_length(input, force / at.stiffness),
                  readable(force, kind_in(input, kind::force)), readable_length(input, way)),
      "check it and the units of stage and force; write \"inf\" if the displacement was measured "
      "at the specimen's midpoint or is already corrected");
}

}  // namespace

double force_at_start(std::span<const double> force) {
  return force.size() < 3 ? 0 : median_of({force[0], force[1], force[2]});
}

void require_points(const Preparing& at, const Record& record) {
  if (record.force.size() >= at.needs.points) return;
  const std::size_t rows = at.table().lines.size();
  if (at.last_row && at.points < at.needs.points)
    throw wrong_value(at.input(), "record.until",
                      fmt::format("Only {} of {} rows lie before the stated end, row {}; at least {} are needed",
                                  record.force.size(), rows, *at.last_row, at.needs.points),
                      "state a later row, or leave the key out");
  throw InputError({.file = at.table().source,
                    .problem = fmt::format("Only {} of {} rows lie before failure; at least {} are needed",
                                           record.force.size(), rows, at.needs.points),
                    .remedy = rows < at.needs.points
                                  ? ""
                                  : "check that the rows are in the order of time, and the column of the "
                                    "displacement: a loading ends where it goes back"});
}

Done end_where_stated(Preparing& at) {
  at.points = at.all.force.size();
  if (!at.last_row) return {};
  at.points = std::min(at.points, points_before(*at.last_row, at.sampling()));
  at.result.end = MeasurementEnd::until;
  const std::size_t last = *at.last_row, rows = at.result.rows;
  PreparationStep step{.changed = last < rows,
                       .done = fmt::format("the record ends with row {}, as stated", last),
                       .otherwise = KeyChange{"record", "until", fmt::format("{}", rows)}};
  if (step.changed) step.rows = RowRange{last + 1, rows};
  return step;
}

Done choose_loading(Preparing& at) {
  const Record looked_at = first_points(at.all, at.points);
  const std::vector<Leg> legs = find_legs(looked_at.stage);
  const Loading chosen = loading_to_evaluate(at, looked_at, legs);
  require_rise(at, looked_at, chosen.leg);
  at.loading = chosen.leg;
  at.result.loading = chosen.counted;
  for (const Leg& leg : legs)
    if (!at.way_back && leg.first >= at.loading.last) at.way_back = leg;
  if (legs.size() < 2) return {};
  const std::size_t last = row_before(at, at.loading.last);
  const auto& [number, of] = chosen.counted;
  if (of == 1)
    return PreparationStep{.changed = true,
                           .done = fmt::format("the stage turns back after row {}, where the loading ends", last),
                           .rows = RowRange{last + 1, at.result.rows}};
  const std::size_t first = at.sampling().rows[at.loading.first] + 1;
  PreparationStep step{
      .changed = true,
      .done = fmt::format("loading {} of {} is evaluated, rows {} to {}: {}", number, of, first, last, chosen.why),
      .rows = RowRange{first, last}};
  if (number > 1) step.otherwise = KeyChange{"record", "until", fmt::format("{}", row_before(at, legs.front().last))};
  return step;
}

namespace {

// Ends the loading before the failure, which the unloading may reveal.
Done find_end(Preparing& at) {
  if (at.last_row) {
    if (at.result.end != MeasurementEnd::until) return {};
    Leg whole{at.loading.first, at.all.force.size(), Direction::loading};
    for (const Leg& leg : find_legs(at.all.stage))
      if (leg.first == whole.first) whole.last = leg.last;
    at.result.drops_behind = drops_behind(at, whole, at.points);
    return {};
  }
  if (at.input().record->failure == FailureRule::none)
    return PreparationStep{.done = "failure was not looked for, as stated: all rows are used",
                           .otherwise = switch_to("failure", "find")};
  const Failure failure = find_failure(points_between(at.all, at.loading.first, at.way_back.value_or(at.loading).last));
  const std::size_t points = at.loading.first + failure.points;
  if (failure.status != FailureStatus::found || points >= at.loading.last)
    return PreparationStep{.done = "no failure was found: all rows are kept",
                           .otherwise = KeyChange{"record", "until", "…"}};
  at.result.end = MeasurementEnd::failure;
  at.result.drops_behind = drops_behind(at, at.loading, at.loading.first + failure.fallen);
  at.loading.last = points;
  const std::size_t last = row_before(at, points);
  return PreparationStep{.changed = true,
                         .done = fmt::format("the specimen failed after row {}: later rows are left out", last),
                         .rows = RowRange{last + 1, at.result.rows},
                         .otherwise = switch_to("failure", "none")};
}

}  // namespace

Done end_before_failure(Preparing& at) {
  const std::size_t turn = at.loading.last;
  if (turn < at.points) at.result.end = MeasurementEnd::turn;
  const Done done = find_end(at);
  const bool is_whole = at.loading.last == turn;
  const bool has_others = at.way_back || at.loading.first > 0;
  if (has_others && (is_whole || at.loading.first > 0))
    at.result.cycles = first_points(at.all, is_whole ? at.points : at.loading.last);
  at.result.first = at.loading.first;
  at.result.record = points_between(at.all, at.loading.first, at.loading.last);
  require_points(at, at.result.record);
  if (at.readings.has(Reading::stage) && at.readings.has(Reading::force)) require_stiff_enough(at, at.result.record);
  return done;
}

namespace {

// The force drop with a computed stage running back that requires the stiffest load train. The
// stage must run back beyond its noise, and beyond what a load train stiffer by a third explains.
std::optional<LeastTrain> least_train(const Record& record) {
  constexpr double noise_range = 5, of_fall = 0.25;  // [1] of the elongation that the load train releases in the drop
  const double noise = stage_noise(record.stage);
  std::optional<LeastTrain> found;
  std::size_t farthest = 0;
  for (std::size_t i = 1; i < record.stage.size(); ++i) {
    const LeastTrain fall{farthest, record.force[farthest] - record.force[i],
                          record.deflection[i] - record.deflection[farthest]};
    const double back = record.stage[farthest] - record.stage[i];
    const bool runs_back = back > std::max(noise_range * noise, of_fall * (fall.advance + back));
    if (runs_back && fall.advance > 0 && (!found || fall.fall * found->advance > found->fall * fall.advance))
      found = fall;
    if (record.stage[i] > record.stage[farthest]) farthest = i;
  }
  return found;
}

// True if the force falls while the stage runs back from one point to another, as the specimen gives way.
bool gives_way(const Record& record, std::size_t from, std::size_t to) {
  constexpr double fall = 0.05;  // [1] of the maximum force
  const double greatest = *std::max_element(record.force.begin(), record.force.end());
  return record.force[from] - record.force[to] > fall * greatest;
}

// Ends the record before the stage recoils from a point.
Done end_at_recoil(Preparing& at, std::size_t point, double recoil) {
  at.result.end = MeasurementEnd::failure;
  at.loading.last = at.loading.first + point + 1;
  at.result.record = first_points(at.result.record, point + 1);
  require_points(at, at.result.record);
  const std::size_t last = row_before(at, at.loading.last);
  return PreparationStep{
      .changed = true,
      .done = fmt::format("after row {} the stage recoils by {} while the force falls: later rows are left out", last,
                          readable_length(at.input(), recoil)),
      .value = value_in(at.input(), recoil, {}, kind::length),
      .rows = RowRange{last + 1, at.result.rows}};
}

InputError stage_runs_back(const Preparing& at, std::size_t point, double farthest) {
  constexpr std::size_t beginning = 30;  // [points]
  const std::size_t row = at.sampling().rows[at.loading.first + point];
  const auto in_words = [&](double length) { return readable_length(at.input(), length == 0 ? 0 : length); };
  return InputError(
      {.file = at.table().source,
       .line = at.table().lines[at.table().rows_before(row)],
       .field = "the stage",
       .problem = fmt::format("The stage moves back from {} to {} within the loading", in_words(farthest),
                              in_words(at.result.record.stage[point])),
       .remedy = point < beginning
                     ? fmt::format("check the sign of the displacement: {} or \"reverse\"",
                                   instruction_to_set(at.input(), switch_to("sign", "keep")))
                     : "keep only the loading: " +
                           instruction_to_set(at.input(), KeyChange{"record", "until", fmt::format("{}", row)})});
}

}  // namespace

Done hold_stage(Preparing& at) {
  // A stage that runs back by less than the larger limit has a noisy encoder. Beyond it, the record
  // is another test or out of order.
  constexpr double max_noise = 0.005;  // [travel]
  constexpr double noise_range = 5;    // [noise of the stage] between the extremes of some hundred readings
  std::vector<double>& stage = at.result.record.stage;
  const auto [least, most] = std::minmax_element(stage.begin(), stage.end());
  const bool is_reckoned = !at.readings.has(Reading::stage);
  if (is_reckoned) at.result.least_train = least_train(at.result.record);
  const double allowed = at.result.cycles || is_reckoned
                             ? infinity
                             : std::max(max_noise * (*most - *least), noise_range * stage_noise(stage));
  double farthest = stage.front(), largest = 0;
  std::size_t held = 0, at_farthest = 0;
  for (std::size_t i = 1; i < stage.size(); ++i) {
    if (farthest - stage[i] > allowed) {
      if (gives_way(at.result.record, at_farthest, i)) return end_at_recoil(at, at_farthest, farthest - stage[i]);
      throw stage_runs_back(at, i, farthest);
    }
    if (stage[i] < farthest) ++held;
    if (stage[i] > farthest) at_farthest = i;
    largest = std::max(largest, farthest - stage[i]);
    farthest = std::max(farthest, stage[i]);
    stage[i] = farthest;
  }
  if (held == 0) return {};
  return PreparationStep{
      .changed = true,
      .done = fmt::format("where the stage runs back, at {} {}, its farthest position until then is used", held,
                          held == 1 ? "point" : "points"),
      .value = value_in(at.input(), largest, {}, kind::length)};
}

}  // namespace flexslip
