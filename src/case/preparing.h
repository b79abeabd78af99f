// The steps from the readings of a file to what is evaluated: what each works on, and what it says.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "case/measurement.h"
#include "case/preparation.h"
#include "case/readings.h"
#include "data/record.h"
#include "data/relaxation.h"
#include "data/sampling.h"

namespace flexslip {

// Rows of the table, counted from 0, as a case states them.
struct StatedRows {
  std::size_t first = 0;               // those before are left out
  std::optional<std::size_t> until{};  // so many, with those before the first; what lies behind decides nothing
};

// A record on the way. Each step finds it as the step before left it.
struct Preparing {
  Measurement result;  // what is evaluated, as far as it is known
  Readings readings;
  Needs needs;
  double stiffness;                       // [N/m] of the load train
  Record all{};                           // every row of the table; of those that count, once they are picked
  StatedRows stated{};                    // by begin_where_stated
  std::optional<std::size_t> last_row{};  // of the file, from 1, as stated
  std::vector<StageRest> rests{};         // of all rows of the table
  std::size_t rows_looked_at = 0;         // between the first and the last that count
  std::size_t points = 0;                 // of `all`, up to where the record is stated to end
  Leg loading{0, 0, Direction::loading};  // of `all`, the loading that is evaluated
  std::optional<Leg> way_back{};          // behind it

  const Test& input() const { return result.test; }
  const Table& table() const { return readings.table; }
  const Sampling& sampling() const { return result.sampling; }
};

// What a step did, without its name; nothing where there is nothing to say.
using Done = std::optional<PreparationStep>;

// Zeros and signs (zeros.cpp).
// Fails: InputError for numbers that are too large; for a stage that stands still; for too few readings.
Done count_the_right_way(Preparing& at);
Done count_force_from_zero(Preparing& at);
Done say_compliance(Preparing& at);

// Rows that do not count (rows_left_out.cpp).
// Fails: InputError for a place that the record does not reach, or that lies behind its stated end.
Done begin_where_stated(Preparing& at);
Done end_before_overload(Preparing& at);
Done leave_out_repeated(Preparing& at);  // and picks the rows that count, of which the next four tell
Done say_held(Preparing& at);
Done say_interpolated(Preparing& at);
Done say_unloaded(Preparing& at);
Done say_thinning(Preparing& at);
Done leave_out_stray_positions(Preparing& at);
Done leave_out_holds(Preparing& at);
Done leave_out_way_back(Preparing& at);
Done leave_out_spikes(Preparing& at);

// The loading that is evaluated (evaluated_loading.cpp).
// Fails: InputError for a record that has no loading, for one that falls where it should rise, for too few readings, for a load train that yields
//        by more than the stage moves, for a stage that runs back by more than its noise.
Done end_where_stated(Preparing& at);
Done choose_loading(Preparing& at);
Done end_before_failure(Preparing& at);
Done hold_stage(Preparing& at);

// Where displacements are counted from (contact_of_record.cpp).
// Fails: InputError where the contact is to be found and the force does not rise from one, and for too few readings behind it.
Done count_from_contact(Preparing& at);

// What the rests up to the end of the loading show.
std::optional<Relaxation> relaxation_of(const Preparing& at);

// What several of these ask.

// Fails: InputError for fewer points than are needed.
void require_points(const Preparing& at, const Record& record);

// The rows of the first loading, up to its greatest force.
Record first_rise(const Record& record);

// [N] The force at the beginning of a record, whatever one reading says.
double force_at_start(std::span<const double> force);

// The points before a row, counted from 0.
std::size_t points_before(std::size_t row, const Sampling& sampling);

// The last row, counted from 1, before that of the point after so many.
std::size_t rows_of_points(const Sampling& sampling, std::size_t points);

}  // namespace flexslip
