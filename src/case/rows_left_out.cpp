#include <algorithm>
#include <numeric>
#include <span>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "case/preparing.h"
#include "data/no_readings.h"
#include "data/sampling.h"
#include "io/input_error.h"

// The selection of points from the rows of a record: valid readings, without repetitions, up to the
// end of the load cell's range, and not too many.
namespace flexslip {
namespace {

// Longer records are thinned evenly: a test has a few hundred features, for any number of readings.
constexpr std::size_t max_record_points = 2000;
constexpr std::size_t max_cyclic_points = 10000;  // for a test with unloading

// The number of rows before a place, which is a row or the first row at a stage or deflection; and
// up to and including it.
struct RowsTo {
  std::size_t before, up_to;
};

// Fails:      InputError if the record does not reach the place.
RowsTo rows_to(const PlaceInRecord& place, std::string_view key, const Preparing& at) {
  const Test& input = at.input();
  const Table& table = at.table();
  if (const auto* stated = std::get_if<AtRow>(&place)) {
    if (stated->row > table.rows_of_file())
      throw wrong_value(
          input, key,
          fmt::format("Row {} is asked for, but {} has {} rows", stated->row, table.source, table.rows_of_file()));
    return {table.rows_before(stated->row - 1), table.rows_before(stated->row)};
  }
  const auto* stage = std::get_if<AtStage>(&place);
  const auto& positions = stage ? at.all.stage : at.all.deflection;
  const double position = stage ? stage->position : std::get<AtDeflection>(place).position;
  const auto there = std::find_if(positions.begin(), positions.end(), [=](double each) { return each >= position; });
  if (there == positions.end())
    throw wrong_value(input, key,
                      fmt::format("The {} of {} lies beyond the record, which reaches {}",
                                  stage ? "stage position" : "deflection", readable_length(input, position),
                                  readable_length(input, *std::max_element(positions.begin(), positions.end()))));
  const auto before = static_cast<std::size_t>(there - positions.begin());
  return {before, before + (*there == position ? 1 : 0)};
}

}  // namespace

Done begin_where_stated(Preparing& at) {
  const RecordInput& asked = *at.input().record;
  if (asked.until) at.stated.until = rows_to(*asked.until, "record.until", at).up_to;
  if (asked.first) at.stated.first = rows_to(*asked.first, "record.first", at).before;
  const auto up_to = [&](std::size_t rows) { return rows > 0 ? at.table().file_row(rows - 1) + 1 : 0; };
  const std::size_t before = up_to(at.stated.first);  // in the file
  if (at.stated.until) at.last_row = up_to(*at.stated.until);
  if (at.last_row && before >= *at.last_row)
    throw wrong_value(
        at.input(), "record.first",
        fmt::format("The record would start at row {}, after its end at row {}", before + 1, *at.last_row));
  if (before == 0) return {};
  return PreparationStep{.changed = true,
                         .done = fmt::format("the record begins with row {}, as stated", before + 1),
                         .rows = RowRange{1, before},
                         .otherwise = KeyChange{"record", "first", "1"}};
}

Done end_before_overload(Preparing& at) {
  if (at.stated.until) return {};
  const std::size_t first = at.stated.first;
  const std::size_t rows = first + points_before_overload(points_between(at.all, first, at.all.force.size()));
  if (rows == at.all.force.size()) return {};
  at.all = first_points(at.all, rows);
  at.result.end = MeasurementEnd::overload;
  const std::size_t row = at.table().file_row(rows - 1) + 1, last = at.table().rows_of_file();
  return PreparationStep{
      .changed = true,
      .done = fmt::format("the load cell is at its end from row {} on: later rows are left out", row),
      .rows = RowRange{row + 1, last},
      .otherwise = KeyChange{"record", "until", fmt::format("{}", last)}};
}

namespace {

// The selected rows in [first, last), as rows of the table.
Sampling sampled(const Preparing& at, std::size_t first, std::size_t last) {
  const std::size_t count = last - first;
  const std::size_t most =
      find_legs(points_between(at.all, first, last).stage).size() > 1 ? max_cyclic_points : max_record_points;
  Sampling sampling = sampling_of(std::span(at.readings.displacement()).subspan(first, count),
                                  std::span(at.all.force).subspan(first, count), most);
  for (auto* each : {&sampling.rows, &sampling.halts})
    for (std::size_t& row : *each) row += first;
  sampling.end += first;
  sampling.last_at_rest += first;
  return sampling;
}

// Converts rows of a table to rows of its file.
void count_as_file(const Table& table, Sampling& sampling) {
  if (table.missing_rows.empty()) return;
  for (auto* each : {&sampling.rows, &sampling.halts})
    for (std::size_t& row : *each) row = table.file_row(row);
  sampling.last_at_rest = table.file_row(sampling.last_at_rest);
  sampling.end = sampling.end < table.rows() ? table.file_row(sampling.end) : table.rows_of_file();
}

Done say_left_out(const Preparing& at, std::size_t count, std::string_view what) {
  if (count == 0) return {};
  return PreparationStep{.changed = true, .done = fmt::format("{} of the {} rows {}", count, at.rows_looked_at, what)};
}

// Removes points from the record and its sampling.
void take_out(const std::vector<std::size_t>& points, Preparing& at) {
  std::vector<std::size_t> kept;
  for (std::size_t point = 0; point < at.all.force.size(); ++point)
    if (!std::binary_search(points.begin(), points.end(), point)) kept.push_back(point);
  at.all = picked(at.all, kept);
  for (std::size_t& point : kept) point = at.sampling().rows[point];
  at.result.sampling.rows = std::move(kept);
}

// Invalid readings, with count and name.
Done leave_out_spikes_at(const std::vector<std::size_t>& spikes, std::string_view what, Preparing& at) {
  if (spikes.empty()) return {};
  const auto row = [&](std::size_t point) { return at.sampling().rows[point] + 1; };
  const RowRange range{row(spikes.front()), row(spikes.back())};
  constexpr std::size_t shown = 3;
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < std::min(shown, spikes.size()); ++i) rows.push_back(row(spikes[i]));
  const bool one = spikes.size() == 1;
  at.result.sampling.spikes += spikes.size();
  take_out(spikes, at);
  return PreparationStep{
      .changed = true,
      .done = fmt::format("{} {} {} left out: row{} {}{}",
                          one ? "a reading" : fmt::format("{} readings", spikes.size()), what, one ? "is" : "are",
                          one ? "" : "s", fmt::join(rows, ", "), spikes.size() > shown ? ", …" : ""),
      .rows = range};
}

// Single forces that the specimen cannot cause, in any loading.
std::vector<std::size_t> spikes_of_force(const Record& record, double stiffness) {
  std::vector<std::size_t> spikes;
  for (const Leg& leg : find_legs(record.stage)) {
    if (leg.direction != Direction::loading || leg.last - leg.first < least_noise_points) continue;
    for (const std::size_t point : find_spikes(points_between(record, leg.first, leg.last), stiffness))
      spikes.push_back(leg.first + point);
  }
  return spikes;
}

}  // namespace

Done leave_out_repeated(Preparing& at) {
  const std::size_t first = at.stated.first, end = at.all.force.size(), until = at.stated.until.value_or(end);
  at.rows_looked_at = until - first;
  Sampling sampling = sampled(at, first, until);
  if (until < end) {
    const Sampling behind = sampled(at, until, end);
    sampling.rows.insert(sampling.rows.end(), behind.rows.begin(), behind.rows.end());
    sampling.end = end;
  }
  at.rests = find_rests(at.readings.displacement(), at.all.force);
  at.all = picked(at.all, sampling.rows);
  count_as_file(at.table(), sampling);
  at.result.sampling = std::move(sampling);
  return say_left_out(at, at.sampling().repeated, "repeat the previous row and count once");
}

Done say_held(Preparing& at) {
  return say_left_out(at, at.sampling().held,
                      "repeat the force of the previous row while the displacement moves on, and are left out");
}

Done say_interpolated(Preparing& at) {
  return say_left_out(at, at.sampling().interpolated, "are interpolated between readings and are left out");
}

Done say_unloaded(Preparing& at) {
  return say_left_out(at, at.sampling().unloaded, "lie far before or after the load and are left out");
}

Done say_thinning(Preparing& at) {
  const Sampling& sampling = at.sampling();
  if (sampling.stride == 1) return {};
  const std::size_t left = at.rows_looked_at - sampling.repeated - sampling.held - sampling.interpolated -
                           sampling.at_rest - sampling.unloaded;
  return PreparationStep{.changed = true,
                         .done = fmt::format("one row in {} is used, out of {}", sampling.stride, left)};
}

Done leave_out_stray_positions(Preparing& at) {
  std::vector<double> places;
  for (const std::size_t row : at.sampling().rows)
    places.push_back(at.readings.displacement()[at.table().rows_before(row)]);
  return leave_out_spikes_at(find_stray_positions(places, at.all.force),
                             "that the displacement jumps to and comes back from at once", at);
}

// Removes the rows during rests of the stage; the first reading of a rest belongs to the loading.
Done leave_out_holds(Preparing& at) {
  const std::vector<std::size_t> halts = find_halts(at.all.stage);
  Sampling left = at.sampling();
  left.leave_out_at_rest(halts);
  if (left.at_rest == 0) return {};
  const std::size_t places = left.halts.size();
  take_out(halts, at);
  at.result.sampling = left;
  return PreparationStep{.changed = true,
                         .done = fmt::format("{} rows read while the stage halts, at {} {}, are left out", left.at_rest,
                                             places, places == 1 ? "place" : "places"),
                         .rows = RowRange{left.halts.front() + 2, left.last_at_rest + 1}};
}

std::optional<Relaxation> relaxation_of(const Preparing& at) {
  const Measurement& result = at.result;
  const std::size_t first = file_row(result, 0), last = file_row(result, result.record.force.size() - 1);
  std::vector<StageRest> rests;
  for (StageRest rest : at.rests) {
    const std::size_t row = at.table().file_row(rest.first);
    const std::size_t point = points_before(row, at.sampling());
    const bool is_failure = row + 1 == last && result.end == MeasurementEnd::failure;
    if (row >= last || is_failure || point >= at.all.force.size()) continue;
    rest.force = at.all.force[point];
    rests.push_back(rest);
  }
  return relaxation_at(rests, last + 1 - first, result.force_noise);
}

// Removes the movement back before the first loading, which is not evaluated.
Done leave_out_way_back(Preparing& at) {
  const std::vector<Leg> legs = find_legs(at.all.stage);
  if (legs.size() < 2 || legs.front().direction == Direction::loading) return {};
  std::vector<std::size_t> before(legs.front().last);
  std::iota(before.begin(), before.end(), std::size_t{0});
  const RowRange range{at.sampling().rows.front() + 1, at.sampling().rows[before.back()] + 1};
  take_out(before, at);
  return PreparationStep{
      .changed = true,
      .done = fmt::format("the stage goes back before it loads: rows {} to {} are left out", range.first, range.last),
      .rows = range,
      .otherwise = KeyChange{"record", "first", fmt::format("{}", range.last + 1)}};
}

Done leave_out_spikes(Preparing& at) {
  return leave_out_spikes_at(spikes_of_force(at.all, at.stiffness),
                             "that the force goes to and comes back from faster than the load train allows", at);
}

std::size_t points_before(std::size_t row, const Sampling& sampling) {
  return static_cast<std::size_t>(std::lower_bound(sampling.rows.begin(), sampling.rows.end(), row) -
                                  sampling.rows.begin());
}

std::size_t rows_of_points(const Sampling& sampling, std::size_t points) {
  return points < sampling.rows.size() ? sampling.rows[points] : sampling.end;
}

}  // namespace flexslip
