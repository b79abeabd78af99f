#include "case/rows_that_count.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "data/no_readings.h"

namespace flexslip {
namespace {

void note_sampling(const Sampling& sampling, std::size_t rows, Preparation& steps) {
  const auto add = [&](const char* name, std::size_t count, std::string_view what) {
    if (count > 0) steps.add(name, true, fmt::format("{} of the {} rows {}", count, rows, what), {});
  };
  add("repeated", sampling.repeated, "repeat the previous row and count once");
  add("held", sampling.held, "repeat the force of the previous row while the displacement moves on, and are left out");
  add("interpolated", sampling.interpolated, "are interpolated between readings and are left out");
  add("unloaded", sampling.unloaded, "lie far before or after the load and are left out");
  if (sampling.stride > 1)
    steps.add("thinning", true,
              fmt::format("one row in {} is used, out of {}", sampling.stride,
                          rows - sampling.repeated - sampling.held - sampling.interpolated - sampling.at_rest -
                              sampling.unloaded),
              {});
}

// Of the rows [first, until), counted from 0, and of those behind, which tell no more than what came after.
Sampling sampling_between(std::size_t first, std::size_t until, std::span<const double> displacement,
                          const Record& every, Preparation& steps) {
  const auto sampled = [&](std::size_t begin, std::size_t end) {
    const std::size_t most =
        find_legs(points_between(every, begin, end).stage).size() > 1 ? max_cyclic_points : max_record_points;
    Sampling sampling =
        sampling_of(displacement.subspan(begin, end - begin), std::span(every.force).subspan(begin, end - begin), most);
    for (auto* each : {&sampling.rows, &sampling.halts})
      for (std::size_t& row : *each) row += begin;
    sampling.end += begin;
    sampling.last_at_rest += begin;
    return sampling;
  };
  Sampling sampling = sampled(first, until);
  note_sampling(sampling, until - first, steps);
  if (const std::size_t end = every.force.size(); until < end) {
    const Sampling behind = sampled(until, end);
    sampling.rows.insert(sampling.rows.end(), behind.rows.begin(), behind.rows.end());
    sampling.end = end;
  }
  return sampling;
}

// The record up to where the load cell is at its end.
Record before_overload(Record every, const Table& table, std::size_t first, Preparation& steps) {
  const std::size_t rows = first + points_before_overload(points_between(every, first, every.force.size()));
  if (rows == every.force.size()) return every;
  const std::size_t row = table.file_row(rows - 1) + 1, last = table.rows_of_file();
  steps.add("overload", true, fmt::format("the load cell is at its end from row {} on: later rows are left out", row),
            KeyChange{"record", "until", fmt::format("{}", last)}, {}, RowRange{row + 1, last});
  return first_points(every, rows);
}

// Rows of a table as those of its file.
void count_as_file(const Table& table, Sampling& sampling) {
  if (table.missing_rows.empty()) return;
  for (auto* each : {&sampling.rows, &sampling.halts})
    for (std::size_t& row : *each) row = table.file_row(row);
  sampling.last_at_rest = table.file_row(sampling.last_at_rest);
  sampling.end = sampling.end < table.rows() ? table.file_row(sampling.end) : table.rows_of_file();
}

// Takes points out of a record and of its sampling.
void leave_out(const std::vector<std::size_t>& points, Record& record, Sampling& sampling) {
  std::vector<std::size_t> kept;
  for (std::size_t point = 0; point < record.force.size(); ++point)
    if (!std::binary_search(points.begin(), points.end(), point)) kept.push_back(point);
  record = picked(record, kept);
  for (std::size_t& point : kept) point = sampling.rows[point];
  sampling.rows = std::move(kept);
}

// What the force does while the stage halts: the first reading there belongs to the loading.
void leave_out_holds(Record& record, Sampling& sampling, Preparation& steps) {
  const std::vector<std::size_t> halts = find_halts(record.stage);
  Sampling left = sampling;
  left.leave_out_at_rest(halts);
  if (left.at_rest == 0) return;
  const std::size_t places = left.halts.size();
  steps.add("holds", true,
            fmt::format("{} rows read while the stage halts, at {} {}, are left out", left.at_rest, places,
                        places == 1 ? "place" : "places"),
            {}, {}, RowRange{left.halts.front() + 2, left.last_at_rest + 1});
  leave_out(halts, record, sampling);
  sampling = std::move(left);
}

// The way back of the stage before the first loading, which bends nothing that is evaluated.
void leave_out_way_back(Record& record, Sampling& sampling, Preparation& steps) {
  const std::vector<Leg> legs = find_legs(record.stage);
  if (legs.size() < 2 || legs.front().direction == Direction::loading) return;
  std::vector<std::size_t> before(legs.front().last);
  std::iota(before.begin(), before.end(), std::size_t{0});
  const RowRange range{sampling.rows.front() + 1, sampling.rows[before.back()] + 1};
  steps.add("way_back", true,
            fmt::format("the stage goes back before it loads: rows {} to {} are left out", range.first, range.last),
            KeyChange{"record", "first", fmt::format("{}", range.last + 1)}, {}, range);
  leave_out(before, record, sampling);
}

// Readings that are none, counted and named.
void leave_out_spikes(const std::vector<std::size_t>& spikes, std::string_view what, std::string_view name,
                      Record& record, Sampling& sampling, Preparation& steps) {
  if (spikes.empty()) return;
  const RowRange range{sampling.rows[spikes.front()] + 1, sampling.rows[spikes.back()] + 1};
  constexpr std::size_t shown = 3;
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < std::min(shown, spikes.size()); ++i) rows.push_back(sampling.rows[spikes[i]] + 1);
  const bool one = spikes.size() == 1;
  steps.add(
      name, true,
      fmt::format("{} {} {} left out: row{} {}{}", one ? "a reading" : fmt::format("{} readings", spikes.size()), what,
                  one ? "is" : "are", one ? "" : "s", fmt::join(rows, ", "), spikes.size() > shown ? ", …" : ""),
      {}, {}, range);
  sampling.spikes += spikes.size();
  leave_out(spikes, record, sampling);
}

// Single forces that no specimen can have made, in any loading.
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

std::size_t points_before(std::size_t row, const Sampling& sampling) {
  return static_cast<std::size_t>(std::lower_bound(sampling.rows.begin(), sampling.rows.end(), row) -
                                  sampling.rows.begin());
}

std::size_t rows_of_points(const Sampling& sampling, std::size_t points) {
  return points < sampling.rows.size() ? sampling.rows[points] : sampling.end;
}

CountedRows rows_that_count(Record every, const Table& table, std::span<const double> displacement,
                            const StatedRows& stated, double stiffness, Preparation& steps) {
  const std::size_t rows = every.force.size();
  if (!stated.until) every = before_overload(std::move(every), table, stated.first, steps);
  CountedRows counted{.record = {}, .sampling = {}, .ends_in_overload = every.force.size() < rows};
  auto& [record, sampling, ends_in_overload] = counted;
  sampling = sampling_between(stated.first, stated.until.value_or(every.force.size()), displacement, every, steps);
  record = picked(every, sampling.rows);
  std::vector<double> places;
  for (const std::size_t row : sampling.rows) places.push_back(displacement[row]);
  count_as_file(table, sampling);
  leave_out_spikes(find_stray_positions(places, record.force),
                   "that the displacement jumps to and comes back from at once", "stray", record, sampling, steps);
  leave_out_holds(record, sampling, steps);
  leave_out_way_back(record, sampling, steps);
  leave_out_spikes(spikes_of_force(record, stiffness),
                   "that the force goes to and comes back from faster than the load train allows", "spikes", record,
                   sampling, steps);
  return counted;
}

}  // namespace flexslip
