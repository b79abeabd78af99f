#include "case/measurement.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "case/preparation_steps.h"
#include "case/reading_columns.h"
#include "case/readings.h"
#include "case/stiffness_used.h"
#include "data/contact.h"
#include "data/record.h"
#include "io/quantity.h"
#include "io/table.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

// Rows whose force is within four times the noise of zero say that there is no contact yet, if they are this many more than a
// specimen in contact from the first row on would show.
constexpr double least_free_rows = 5;
// A stage that runs back by less is one whose encoder is noisy; farther, the record is another test, or out of order.
constexpr double most_stage_noise = 0.005;  // [travel]
constexpr std::size_t least_noise_points = 11;

void require_finite(const Record& record, const Table& table) {
  const RecordCheck check = check_record(record);
  if (check.fault != RecordFault::not_finite) return;
  throw InputError({.file = table.source,
                    .line = table.line_of(check.index),
                    .expected = "readings of a bending test",
                    .found = "numbers that are too large",
                    .remedy = "check the units"});
}

double stiffness_for(const Case& input, const ReadingColumns& columns) {
  if (input.rig && input.rig->stiffness) return rig_stiffness_of(input);
  // A deflection with its force needs no stiffness: what the stage did is not asked then.
  if (!columns.has(Reading::stage)) return infinity;
  if (!columns.has(Reading::deflection))
    throw wrong_value(input, "rig.stiffness",
                      "the stiffness of the load train, as the displacement is that of the stage", "none",
                      "write the stiffness of your load train into [rig] as stiffness = \"… N/m\", or pass "
                      "--stiffness; write \"inf\" if the displacement is that of the specimen's midpoint or already "
                      "corrected; --stage, --deflection and --force name columns");
  throw missing(input, input.rig ? "rig.stiffness" : "rig");
}

void find_sign(SignRule rule, ReadingColumns& columns, PreparationSteps& steps) {
  Signs signs{1, 1};
  if (rule == SignRule::reverse) signs = {-1, -1};
  if (rule == SignRule::find) {
    signs = find_signs(columns.displacement(), columns.force_or_difference());
    // Without a force column its sign is that of the displacements it is the difference of.
    if (!columns.has(Reading::force) && signs.force != signs.displacement) signs = {1, 1};
  }
  columns.apply(signs);
  const bool is_found = rule == SignRule::find;
  const bool changed = signs.displacement < 0 || signs.force < 0;
  std::string words = signs.displacement < 0 && signs.force < 0 ? "displacement and force are reversed"
                      : signs.displacement < 0                  ? "the displacement is reversed"
                      : signs.force < 0                         ? "the force is reversed"
                                                                : "displacement and force keep their signs";
  words += !is_found ? ", as stated" : changed ? ", as compression is negative in the file" : ", positive in loading";
  steps.add("sign", changed, std::move(words),
            KeyChange{"record", "sign",
                      !is_found ? "\"find\""
                      : changed ? "\"keep\""
                                : "\"reverse\""});
}

// The rows of the first rise, up to the greatest force.
Record first_rise(const Record& record) {
  const auto greatest = std::max_element(record.force.begin(), record.force.end());
  return first_points(record, static_cast<std::size_t>(greatest - record.force.begin()) + 1);
}

// The last row, counted from 1, before that of the point after so many.
std::size_t rows_of_points(const Sampling& sampling, std::size_t rows, std::size_t points) {
  return points < sampling.rows.size() ? sampling.rows[points] : rows;
}

void note_sampling(const Sampling& sampling, std::size_t rows, PreparationSteps& steps) {
  if (sampling.repeated > 0)
    steps.add("repeated", true,
              fmt::format("{} of the {} rows repeat the previous row and count once", sampling.repeated, rows), {});
  if (sampling.held > 0)
    steps.add(
        "held", true,
        fmt::format(
            "{} of the {} rows repeat the force of the previous row while the displacement moves on, and are left out",
            sampling.held, rows),
        {});
  if (sampling.interpolated > 0)
    steps.add("interpolated", true,
              fmt::format("{} of the {} rows are interpolated between readings and are left out", sampling.interpolated,
                          rows),
              {});
  if (sampling.stride > 1)
    steps.add("thinning", true,
              fmt::format("one row in {} is used, out of {}", sampling.stride,
                          rows - sampling.repeated - sampling.held - sampling.interpolated),
              {});
}

ForceZero zero_of(const Record& record) {
  const Record rise = first_rise(record);
  if (rise.force.size() < least_noise_points) return {ForceZeroStatus::no_free_rows, 0, 0, 0};
  return find_force_zero(rise.stage, rise.force, force_noise(rise));
}

Record with_force_zero(const Record& record, double offset, bool stage_is_read, double stiffness) {
  std::vector<double> force = record.force;
  for (double& value : force) value -= offset;
  return stage_is_read ? record_from_stage_and_force(record.stage, force, stiffness)
                       : record_from_deflection_and_force(record.deflection, force, stiffness);
}

Record zeroed(const Case& input, const Record& record, bool stage_is_read, double stiffness, const Sampling& sampling,
              std::size_t rows, PreparationSteps& steps) {
  const ForceZeroRule& rule = input.record->zero;
  if (std::holds_alternative<ToKeep>(rule)) {
    steps.add("zero", false, "the force is counted from the file's own zero, as stated",
              KeyChange{"record", "zero", "\"find\""});
    return record;
  }
  if (const auto* stated = std::get_if<double>(&rule)) {
    steps.add("zero", *stated != 0, "the force is counted from the zero stated",
              KeyChange{"record", "zero", "\"keep\""}, steps.value(*stated, {}, kind::force));
    return with_force_zero(record, *stated, stage_is_read, stiffness);
  }
  const ForceZero zero = zero_of(record);
  if (zero.status != ForceZeroStatus::found) {
    steps.add("zero", false,
              "the record has no rows before contact that show the zero of the force: the file's own zero is kept",
              KeyChange{"record", "zero", "\"…\""});
    return record;
  }
  const bool changed = is_significant(zero);
  steps.add("zero", changed,
            changed ? "the mean force before contact is subtracted"
                    : "the mean force before contact is zero within four standard errors and is not subtracted",
            KeyChange{"record", "zero", "\"keep\""}, steps.value(zero.offset, zero.error, kind::force),
            RowRange{1, rows_of_points(sampling, rows, zero.points)});
  return changed ? with_force_zero(record, zero.offset, stage_is_read, stiffness) : record;
}

void note_compliance(const Case& input, const ReadingColumns& columns, double stiffness, PreparationSteps& steps) {
  const bool is_stiff = std::isinf(stiffness);
  const bool is_stated = input.rig && input.rig->stiffness;
  const std::string_view of =
      support_compliance_of(input) > 0 ? "the stiffness of load train and supports" : "load-train stiffness";
  std::string words;
  if (!columns.has(Reading::force))
    words = fmt::format("the force is {} times the difference between stage displacement and deflection", of);
  else if (columns.has(Reading::stage))
    words = is_stiff ? "the deflection equals the stage displacement, as the load train is stated to be rigid"
                     : fmt::format("the deflection is the stage displacement minus force over {}", of);
  else
    words = !is_stated ? "the stage displacement is taken to equal the deflection, as no load-train stiffness is stated"
            : is_stiff ? "the stage displacement equals the deflection, as the load train is stated to be rigid"
                       : fmt::format("the stage displacement is the deflection plus force over {}", of);
  std::optional<PreparedValue> value;
  if (!is_stiff) value = steps.value(stiffness, {}, kind::stiffness);
  steps.add("compliance", !is_stiff, std::move(words), KeyChange{"rig", "stiffness", is_stiff ? "\"…\"" : "\"inf\""},
            value);
}

// A load train under a force gives way by no more than the stage moves: the rest is the deflection.
void require_stiff_enough(const Case& input, const Record& record, double stiffness) {
  const Record rise = first_rise(record);
  const double force = rise.force.back() - rise.force.front();
  const double way = rise.stage.back() - rise.stage.front();
  if (!(way > 0) || force / stiffness <= way) return;
  const Kind force_kind = kind_in(input, kind::force);
  throw wrong_value(input, "rig.stiffness", "a load train that yields by less than the stage moves",
                    fmt::format("{0}, which yields by {2} under {1}, but the stage moved {3}",
                                readable(stiffness, kind_in(input, kind::stiffness)), readable(force, force_kind),
                                readable_length(input, force / stiffness), readable_length(input, way)),
                    "check it and the units of stage and force; write \"inf\" if the displacement is that of the "
                    "specimen's midpoint or already corrected");
}

// Holds the stage where it runs back by no more than its noise.
// Fails: InputError where it runs back farther.
void hold_stage(const Case& input, const Table& table, Record& record, const Sampling& sampling, bool turns,
                PreparationSteps& steps) {
  std::vector<double>& stage = record.stage;
  double farthest = stage.front();
  const auto [least, most] = std::minmax_element(stage.begin(), stage.end());
  const double allowed = turns ? infinity : most_stage_noise * (*most - *least);
  std::size_t held = 0;
  double largest = 0;
  for (std::size_t i = 1; i < stage.size(); ++i) {
    if (farthest - stage[i] > allowed)
      throw InputError(
          {.file = table.source,
           .line = table.line_of(sampling.rows[i]),
           .field = "the stage",
           .expected = fmt::format("a position no smaller than in the previous row, {}",
                                   readable_length(input, stage[i - 1] == 0 ? 0 : stage[i - 1])),
           .found = readable_length(input, stage[i]),
           .remedy = i < 30 ? "check the sign of the displacement: write sign = \"keep\" or \"reverse\" into [record]"
                            : fmt::format("keep only the loading: write until = {} into [record]", sampling.rows[i])});
    if (stage[i] < farthest) {
      ++held;
      largest = std::max(largest, farthest - stage[i]);
    }
    farthest = std::max(farthest, stage[i]);
    stage[i] = farthest;
  }
  if (held > 0)
    steps.add("stage", true,
              fmt::format("where the stage runs back, at {} {}, its farthest position so far is used", held,
                          held == 1 ? "point" : "points"),
              {}, steps.value(largest, {}, kind::length));
}

bool begins_before_contact(const Record& record, const Contact& contact, double noise) {
  if (contact.status != ContactStatus::found) return false;
  const auto free =
      std::find_if(record.force.begin(), record.force.end(), [&](double force) { return std::abs(force) > 4 * noise; });
  const double rise = record.force[contact.last - 1] - record.force[contact.first];
  const double rise_per_row = rise / static_cast<double>(contact.last - 1 - contact.first);
  return static_cast<double>(free - record.force.begin()) >= least_free_rows + 4 * noise / rise_per_row;
}

Record without_first(const Record& record, std::size_t points) {
  const auto rest = [=](const std::vector<double>& values) {
    return std::vector<double>(values.begin() + static_cast<std::ptrdiff_t>(points), values.end());
  };
  return {rest(record.stage), rest(record.deflection), rest(record.force)};
}

void require_points(const Table& table, const Record& record, std::size_t least_points) {
  if (record.force.size() >= least_points) return;
  throw InputError({.file = table.source,
                    .expected = fmt::format("at least {} rows of readings before failure", least_points),
                    .found = std::to_string(record.force.size())});
}

void require_loading_first(const Table& table, const Record& record, const Leg& first) {
  if (first.direction == Direction::loading && record.stage[first.last - 1] > record.stage[first.first]) return;
  throw InputError({.file = table.source,
                    .line = table.line_of(0),
                    .field = "the stage",
                    .expected = "a record that begins by loading",
                    .found = "one that begins by unloading",
                    .remedy = "if the stage is counted the other way, reverse it with sign in [record] or --sign; "
                              "otherwise leave out the rows before the first loading"});
}

// How many rows lie before a place: those before the row, or before the stage or the deflection first gets there.
// Fails:      InputError where the record does not get there.
std::size_t rows_before(const PlaceInRecord& place, std::string_view key, const Case& input, const Record& every,
                        const std::string& file) {
  if (const auto* at = std::get_if<AtRow>(&place)) {
    if (at->row > every.force.size())
      throw wrong_value(input, key, fmt::format("one of the {1} rows of {0}", file, every.force.size()),
                        std::to_string(at->row));
    return at->row - 1;
  }
  const auto* stage = std::get_if<AtStage>(&place);
  const auto& positions = stage ? every.stage : every.deflection;
  const double position = stage ? stage->position : std::get<AtDeflection>(place).position;
  const auto there = std::find_if(positions.begin(), positions.end(), [&](double at) { return at >= position; });
  if (there == positions.end())
    throw wrong_value(input, key,
                      fmt::format("a {} within the record, which reaches {}", stage ? "stage position" : "deflection",
                                  readable_length(input, *std::max_element(positions.begin(), positions.end()))),
                      readable_length(input, position));
  return static_cast<std::size_t>(there - positions.begin());
}

// And those up to it, the row or the position itself among them.
std::size_t rows_up_to(const PlaceInRecord& place, std::string_view key, const Case& input, const Record& every,
                       const std::string& file) {
  const std::size_t before = rows_before(place, key, input, every, file);
  if (std::holds_alternative<AtRow>(place)) return before + 1;
  const auto& positions = std::holds_alternative<AtStage>(place) ? every.stage : every.deflection;
  const bool is_there =
      positions[before] == (std::holds_alternative<AtStage>(place) ? std::get<AtStage>(place).position
                                                                   : std::get<AtDeflection>(place).position);
  return before + (is_there ? 1 : 0);
}

// Ends the record before the failure, or where it is stated to end. What is left, in points.
std::size_t end_of(const Case& input, const Record& all, const std::vector<Leg>& legs,
                   const std::optional<std::size_t>& until, Measurement& result, PreparationSteps& steps) {
  const std::size_t rows = result.rows;
  std::size_t points = all.force.size();
  if (until) {
    const auto& counted = result.sampling.rows;
    points = std::min(
        points, static_cast<std::size_t>(std::lower_bound(counted.begin(), counted.end(), *until) - counted.begin()));
    result.end = MeasurementEnd::until;
    const bool changed = *until < rows;
    steps.add("end", changed, fmt::format("the record ends with row {}, as stated", *until),
              KeyChange{"record", "until", fmt::format("{}", rows)}, {},
              changed ? std::optional(RowRange{*until + 1, rows}) : std::nullopt);
    return points;
  }
  if (!input.record->find_failure) {
    steps.add("end", false, "failure was not looked for, as stated: all rows are used",
              KeyChange{"record", "failure", "\"find\""});
    return points;
  }
  const Failure failure = find_failure(all);
  if (failure.status == FailureStatus::found && (legs.size() < 2 || failure.points <= legs.front().last)) {
    result.end = MeasurementEnd::failure;
    const std::size_t last = rows_of_points(result.sampling, rows, failure.points);
    steps.add("end", true, fmt::format("the specimen failed after row {}: later rows are left out", last),
              KeyChange{"record", "failure", "\"none\""}, {}, RowRange{last + 1, rows});
    return failure.points;
  }
  steps.add("end", false, "no failure was found: all rows are kept", KeyChange{"record", "until", "…"});
  return points;
}

// What the contact is taken off at, and how certainly.
void find_zero_displacement(const Case& input, const Record& whole, Measurement& result, PreparationSteps& steps) {
  const ContactRule& rule = input.record->contact;
  const Contact contact = find_contact(whole);
  // The contact lies somewhere within a step.
  result.contact_error =
      (whole.stage.back() - whole.stage.front()) / static_cast<double>(whole.stage.size() - 1) / std::sqrt(12.0);
  const bool begins_free = begins_before_contact(whole, contact, result.force_noise);
  const bool is_asked = std::holds_alternative<ToFind>(rule);
  // The stage's own zero is far from where the force begins to rise, and that is where the record begins.
  constexpr double far = 10, near = 0.25;
  const bool begins_elsewhere =
      contact.status == ContactStatus::found && std::abs(contact.offset.value) > far * contact.offset.standard_error &&
      std::abs(contact.offset.value - whole.stage.front()) < near * std::abs(contact.offset.value);
  if (is_asked && contact.status != ContactStatus::found)
    throw wrong_value(input, "record.contact",
                      "a force that rises from contact over at least 5 rows, to find the contact", "none",
                      "state the contact, or leave the key out");
  if (is_asked || (std::holds_alternative<WhereFree>(rule) && (begins_free || begins_elsewhere))) {
    result.contact = ContactSource::found;
    result.contact_offset = contact.offset.value;
    result.contact_error = contact.offset.standard_error;
    steps.add("contact", true,
              "displacements are counted from where the straight first part of the curve meets zero force",
              KeyChange{"record", "contact", "\"first row\""},
              steps.value(contact.offset.value, contact.offset.standard_error, kind::length),
              contact.points_before > 0
                  ? std::optional(RowRange{1, rows_of_points(result.sampling, result.rows, contact.points_before)})
                  : std::nullopt);
    return;
  }
  if (std::holds_alternative<WhereFree>(rule)) {
    std::optional<PreparedValue> toe;
    if (contact.status == ContactStatus::found)
      toe = steps.value(contact.offset.value, contact.offset.standard_error, kind::length);
    steps.add("contact", false,
              toe ? "displacements are counted from the file's own zero; the value is where the straight first part of "
                    "the curve would meet zero force"
                  : "displacements are counted from the file's own zero",
              KeyChange{"record", "contact", "\"find\""}, toe);
    return;
  }
  const auto* stated = std::get_if<double>(&rule);
  result.contact = ContactSource::stated;
  result.contact_offset = stated ? *stated : whole.stage.front();
  steps.add("contact", result.contact_offset != 0,
            stated ? "displacements are counted from the contact stated"
                   : "displacements are counted from the first row, as stated",
            KeyChange{"record", "contact", "\"find\""}, steps.value(result.contact_offset, {}, kind::length));
}

}  // namespace

Measurement read_measurement(const Case& asked, std::size_t least_points) {
  if (least_points < least_noise_points)
    throw std::invalid_argument(fmt::format("the noise of {} points cannot be estimated", least_points));
  if (!asked.record) throw missing(asked, "record");
  Readings readings = read_readings(asked);
  Table& table = readings.table;
  Measurement result{.test = std::move(readings.test),
                     .preparation = std::move(readings.preparation),
                     .file = table.source,
                     .rows = table.rows(),
                     .sampling = {},
                     .first = 0,
                     .record = {},
                     .pulled_in = {},
                     .cycles = {},
                     .end = MeasurementEnd::last_row,
                     .contact = ContactSource::first_point,
                     .contact_offset = 0,
                     .contact_error = 0,
                     .force_noise = 0};
  const Case& input = result.test;
  PreparationSteps steps(result.preparation, input);

  ReadingColumns columns(readings);
  const double stiffness = stiffness_for(input, columns);
  find_sign(input.record->sign, columns, steps);
  Record every = columns.record(stiffness);
  if (columns.has(Reading::length)) result.pulled_in = columns.of(Reading::length);
  require_finite(every, table);
  const std::size_t most_points = find_legs(every.stage).size() > 1 ? most_cyclic_points : most_record_points;
  std::optional<std::size_t> until;  // the last row
  if (const auto& place = input.record->until) until = rows_up_to(*place, "record.until", input, every, result.file);
  std::size_t first = 0;
  if (const auto& place = input.record->first) first = rows_before(*place, "record.first", input, every, result.file);
  if (first > 0)
    steps.add("first", true, fmt::format("the record begins with row {}, as stated", first + 1),
              KeyChange{"record", "first", "1"}, {}, RowRange{1, first});
  result.sampling =
      sampling_of(std::span(columns.displacement()).subspan(first), std::span(every.force).subspan(first), most_points);
  for (std::size_t& row : result.sampling.rows) row += first;
  note_sampling(result.sampling, result.rows - first, steps);
  every = picked(every, result.sampling.rows);
  const Record all = zeroed(input, every, columns.has(Reading::stage), stiffness, result.sampling, result.rows, steps);
  note_compliance(input, columns, stiffness, steps);

  const std::vector<Leg> legs = find_legs(all.stage);
  std::size_t points = end_of(input, all, legs, until, result, steps);
  if (legs.size() > 1 && legs.front().last < points) {
    require_loading_first(table, all, legs.front());
    result.cycles = first_points(all, points);
    points = legs.front().last;
    result.end = MeasurementEnd::turn;
    steps.add("turn", true,
              fmt::format("the stage turns back after row {}, where the first loading ends; later rows belong "
                          "to {} further loadings and unloadings",
                          rows_of_points(result.sampling, result.rows, points), legs.size() - 1),
              KeyChange{"record", "until", fmt::format("{}", rows_of_points(result.sampling, result.rows, points))});
  }
  Record whole = first_points(all, points);
  require_points(table, whole, least_points);
  if (columns.has(Reading::stage) && columns.has(Reading::force)) require_stiff_enough(input, whole, stiffness);
  hold_stage(input, table, whole, result.sampling, result.cycles.has_value(), steps);
  result.force_noise = force_noise(whole);
  find_zero_displacement(input, whole, result, steps);

  const auto begin = std::lower_bound(whole.stage.begin(), whole.stage.end(), result.contact_offset);
  const std::size_t skipped =
      result.contact == ContactSource::first_point ? 0 : static_cast<std::size_t>(begin - whole.stage.begin());
  result.first = skipped;
  if (points - skipped < least_points)
    throw wrong_value(input, "record.contact", fmt::format("at least {} rows of readings after contact", least_points),
                      std::to_string(points - skipped));
  result.record = without_first(whole, skipped);
  const auto take_contact_off = [&](Record& record) {
    for (double& stage : record.stage) stage -= result.contact_offset;
    for (double& deflection : record.deflection) deflection -= result.contact_offset;
  };
  take_contact_off(result.record);
  if (result.cycles) take_contact_off(*result.cycles);
  return result;
}

std::size_t file_row(const Measurement& measurement, std::size_t point) {
  return cyclic_file_row(measurement, measurement.first + point);
}

std::size_t cyclic_file_row(const Measurement& measurement, std::size_t point) {
  return measurement.sampling.rows[point] + 1;
}

std::size_t last_file_row(const Measurement& measurement, std::size_t point) {
  return rows_of_points(measurement.sampling, measurement.rows, measurement.first + point + 1);
}

}  // namespace flexslip
