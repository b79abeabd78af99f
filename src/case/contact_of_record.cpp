#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "case/mechanics.h"
#include "case/preparing.h"
#include "data/contact.h"
#include "inference/first_passages.h"
#include "io/input_error.h"
#include "numerics/elementary.h"

// The zero of displacements: the stated contact, or the contact of the record.
namespace flexslip {
namespace {

bool begins_before_contact(const Record& record, const Contact& contact, double noise) {
  // Rows with a force within four times the noise of zero lie before the contact, if there are this
  // many more than for a specimen in contact from the first row.
  constexpr double min_free_rows = 5;
  if (contact.status != ContactStatus::found) return false;
  const auto free =
      std::find_if(record.force.begin(), record.force.end(), [&](double force) { return std::abs(force) > 4 * noise; });
  const double step = (record.stage.back() - record.stage.front()) / static_cast<double>(record.stage.size() - 1);
  return static_cast<double>(free - record.force.begin()) >= min_free_rows + 4 * noise / (contact.slope * step);
}

// Facts about a test before its record is examined. Without a span, as for some moduli, the curve
// is treated as straight.
BeginningOf beginning_of(const Test& input, const Record& record, double stiffness) {
  constexpr double straight = 20;  // [maximum deflection]
  BeginningOf beginning{.span = straight * *std::max_element(record.deflection.begin(), record.deflection.end()),
                        .load_train_stiffness = stiffness};
  if (!(beginning.span > 0)) beginning.span = 1;
  if (!input.rig || !input.rig->span) return beginning;
  beginning.span = *input.rig->span;
  if (input.rig->roller_radius) beginning.support_radius = *input.rig->roller_radius;
  if (states_stiffness(input)) {
    const BendingStiffnessUsed stated = bending_stiffness_of(input);
    beginning.bending_stiffness = stated.value;
    beginning.bending_stiffness_error = stated.relative_error;
  }
  return beginning;
}

// [N] The force at the start of a record whose file counts from the contact, if the specimen cannot
// cause it, or if it is negative. Otherwise 0.
double force_at_beginning(const Record& record, const Contact& contact, double slope, double contact_error,
                          double noise) {
  constexpr double surely = 3, of_noise = 4, of_greatest = 0.01;
  const auto& force = record.force;
  const double first = force_at_start(force);
  if (first < -std::max(of_noise * noise, of_greatest * *std::max_element(force.begin(), force.end()))) return first;
  if (contact.status != ContactStatus::found ||
      contact.offset.value > record.stage.front() - surely * contact_error)  // or its first reading is an outlier
    return 0;
  const double way = std::max(record.deflection.front() + surely * contact_error, 0.0);
  return record.force.front() > slope * way + of_noise * noise ? record.force.front() : 0;
}

// True if too few readings for a fit reach the minimum deflection for friction.
bool tells_no_friction(const Test& input, const Record& record) {
  const Scales scales(*input.rig->span, 1);
  return readings_judged(to_reduced(record, scales), fibre_of(input, scales)).size() < min_readings;
}

// True if enough points lie after a contact.
bool leaves(std::size_t points, const Record& record, double contact) {
  return record.stage.size() >= points && record.stage[record.stage.size() - points] >= contact;
}

// True if the linear region meets zero force farther after the contact than friction and supports
// explain. Everything before it is then a toe.
bool begins_with_toe(const Record& record, const LinearRegion& straight, const BeamGeometry& geometry, double contact,
                     double contact_error) {
  constexpr double surely = 3;
  const double middle = straight.middle(record);
  const double error = elementary::length(contact_error, straight.origin_error(record));
  const double steeper = max_steepening(geometry, middle - contact);
  return straight.origin - contact > surely * error + (middle - contact) * steeper / (1 + steeper);
}

// True if the record shows a contact from which displacements should be counted.
bool shows_contact(const Preparing& at, const Contact& contact) {
  const std::optional<ContactRule>& rule = at.input().record->contact;
  if (rule) return rule == ContactRule{ContactWord::find};
  if (contact.status != ContactStatus::found) return false;
  // The zero of the stage is far from the start of the force, where the record begins.
  constexpr double far = 10, near = 0.25;
  const double offset = contact.offset.value;
  const bool begins_elsewhere = std::abs(offset) > far * contact.offset.standard_error &&
                                std::abs(offset - at.result.record.stage.front()) < near * std::abs(offset);
  // Without a stated EI, EI follows from the slope of a line through the contact, unless it follows
  // from the linear region.
  const bool determines_slope = !states_stiffness(at.input()) && !at.result.straight_is_initial &&
                                leaves(at.needs.points, at.result.record, offset);
  return at.result.begins_free || begins_elsewhere || at.result.begins_under > 0 || determines_slope;
}

// The points of the record before a contact.
std::optional<RowRange> rows_before_contact(const Preparing& at, const Contact& contact) {
  if (contact.points_before == 0) return {};
  return RowRange{at.sampling().rows[at.result.first] + 1,
                  rows_of_points(at.sampling(), at.result.first + contact.points_before)};
}

PreparationStep count_from_straight_part(Preparing& at, const Contact& contact, double usual_error) {
  Measurement& result = at.result;
  const LinearRegion& straight = *result.straight;
  result.contact = ContactSource::found;
  result.contact_offset = straight.origin;
  const double between = contact.status == ContactStatus::found ? straight.origin - contact.offset.value : 0;
  result.contact_error = elementary::length(usual_error, between);
  result.own_contact = counted_from(straight.origin, contact);
  const RowRange rows = rows_of_first_curve(result, straight.first, straight.last);
  return {.changed = true,
          .done = fmt::format("the record begins with a toe: displacements are counted from where the straight part, "
                              "rows {} to {}, would meet zero force",
                              rows.first, rows.last),
          .value = value_in(at.input(), straight.origin, result.contact_error, kind::length),
          .otherwise = switch_to("contact", "first row")};
}

PreparationStep count_from_own_contact(Preparing& at, const Contact& contact) {
  Measurement& result = at.result;
  result.contact = ContactSource::found;
  result.contact_offset = contact.offset.value;
  // The extrapolated baseline has an error at the contact.
  result.contact_error = elementary::length(contact.offset.standard_error, result.baseline.error / contact.slope);
  result.own_contact = counted_from(contact.offset.value, contact);
  return {.changed = true,
          .done = "displacements are counted from where the record itself begins",
          .value = value_in(at.input(), contact.offset.value, contact.offset.standard_error, kind::length),
          .rows = rows_before_contact(at, contact),
          .otherwise = switch_to("contact", "first row")};
}

// From the zero of the file, from the first row, or from the stated contact.
PreparationStep count_from_stated_contact(Preparing& at, const Contact& contact, double usual_error) {
  Measurement& result = at.result;
  const std::optional<ContactRule>& rule = at.input().record->contact;
  const auto* stated = rule ? std::get_if<Known>(&*rule) : nullptr;
  if (rule) {
    result.contact = ContactSource::stated;
    result.contact_offset = stated ? stated->value : result.record.stage.front();
    result.own_contact = counted_from(result.contact_offset, contact);
  }
  result.contact_error = stated ? stated->uncertainty.value_or(usual_error) : usual_error;
  if (contact.status == ContactStatus::found) {  // includes the contact of the record
    const Estimate& own = result.own_contact.offset;
    result.contact_error =
        elementary::length(result.contact_error, std::max(std::abs(own.value) - own.standard_error, 0.0));
  }
  PreparationStep step{.done = "displacements are counted from the file's own zero",
                       .otherwise = switch_to("contact", "find")};
  if (!rule) return step;
  step.changed = result.contact_offset != 0;
  step.done = stated ? "displacements are counted from the contact stated"
                     : "displacements are counted from the first row, as stated";
  step.value = value_in(at.input(), result.contact_offset, stated ? stated->uncertainty : std::nullopt, kind::length);
  return step;
}

// The subtracted contact and its uncertainty.
PreparationStep find_contact_of_record(Preparing& at) {
  Measurement& result = at.result;
  const Record& record = result.record;
  const std::optional<ContactRule>& rule = at.input().record->contact;
  const bool is_asked = rule == ContactRule{ContactWord::find};
  const BeginningOf beginning = beginning_of(at.input(), record, at.stiffness);
  const double usual_error = default_contact_error * beginning.span;
  const Contact contact = find_contact(record, beginning);
  result.own_contact = contact;
  if (is_asked && contact.status != ContactStatus::found)
    throw wrong_value(at.input(), "record.contact",
                      "The force does not rise from contact over at least 5 rows, so the contact cannot be determined",
                      "state the contact, or leave the key out");
  result.begins_free = result.baseline.points > 0 || begins_before_contact(record, contact, result.force_noise);
  const double slope = result.straight_is_initial ? result.straight->slope.value : contact.slope;
  if (result.baseline.points == 0)
    result.begins_under = force_at_beginning(record, contact, slope, usual_error, result.force_noise);
  const bool is_found = shows_contact(at, contact);
  if ((is_asked || !rule) && result.straight_is_initial && leaves(at.needs.points, record, result.straight->origin) &&
      begins_with_toe(record, *result.straight, geometry_of(at.input()), is_found ? contact.offset.value : 0,
                      is_found ? contact.offset.standard_error : usual_error))
    return count_from_straight_part(at, contact, usual_error);
  return is_found ? count_from_own_contact(at, contact) : count_from_stated_contact(at, contact, usual_error);
}

// Before displacements are counted from the contact.
FirstCurve first_curve_of(const Preparing& at) {
  const Measurement& result = at.result;
  std::vector<std::size_t> points;
  double farthest = -infinity;
  const auto go_on = [&](std::size_t first, std::size_t last) {
    while (first < last && !(at.all.stage[first] > farthest)) ++first;
    for (; first < last; ++first) {
      points.push_back(first);
      farthest = std::max(farthest, at.all.stage[first]);
    }
  };
  if (result.loading.number > 1)
    for (const Leg& leg : find_legs(result.cycles->stage))
      if (leg.direction == Direction::loading && leg.last <= result.first) go_on(leg.first, leg.last);
  if (!(result.record.stage.back() > farthest)) {
    points.clear();
    farthest = -infinity;
  }
  go_on(result.first, result.first + result.record.stage.size());
  FirstCurve curve{picked(at.all, points), std::move(points)};
  for (std::size_t i = 1; i < curve.record.stage.size(); ++i)
    curve.record.stage[i] = std::max(curve.record.stage[i], curve.record.stage[i - 1]);
  return curve;
}

// The linear region of the first curve.
std::optional<LinearRegion> straight_part(const Preparing& at) {
  const FirstCurve& curve = at.result.first_curve;
  SmallDeflectionOptions options;
  if (at.result.is_derived) options.load_train_error = rig_errors_of(at.result).load_train;
  options.halts = at.sampling().halts_among(curve.points);
  return find_linear_region(curve.record, geometry_of(at.input()), options);
}

std::size_t points_before_contact(const Measurement& result, const std::vector<double>& stage) {
  if (result.contact == ContactSource::first_point) return 0;
  return static_cast<std::size_t>(std::lower_bound(stage.begin(), stage.end(), result.contact_offset) - stage.begin());
}

// Counts from the contact and removes the points before it.
void take_off_contact(Preparing& at) {
  Measurement& result = at.result;
  const std::vector<double>& stage = result.record.stage;
  const std::size_t skipped = points_before_contact(result, stage);
  result.first += skipped;
  if (stage.size() - skipped < at.needs.points)
    throw wrong_value(at.input(), "record.contact",
                      fmt::format("Only {} rows of readings lie after contact; at least {} are needed",
                                  stage.size() - skipped, at.needs.points));
  result.record = counted_from(result.contact_offset, std::move(result.record), skipped);
  FirstCurve& curve = result.first_curve;
  const std::size_t before = points_before_contact(result, curve.record.stage);
  curve = {counted_from(result.contact_offset, std::move(curve.record), before),
           {curve.points.begin() + static_cast<std::ptrdiff_t>(before), curve.points.end()}};
  if (result.straight && result.straight->first >= before) {
    result.straight->first -= before;
    result.straight->last -= before;
    result.straight->origin -= result.contact_offset;
  } else {
    result.straight = straight_part(at);
  }
  if (result.cycles) result.cycles = counted_from(result.contact_offset, std::move(*result.cycles));
}

}  // namespace

Done count_from_contact(Preparing& at) {
  Measurement& result = at.result;
  result.force_noise = force_noise(result.record);
  result.first_curve = first_curve_of(at);
  result.straight = straight_part(at);
  result.straight_is_initial =
      result.straight && at.input().rig && at.input().rig->span && tells_no_friction(at.input(), result.record);
  PreparationStep step = find_contact_of_record(at);
  take_off_contact(at);
  return step;
}

}  // namespace flexslip
