// The steps from the readings of a file to the record: their common input and output.
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

// Rows of the table, from 0, that a case states.
struct StatedRows {
  std::size_t first = 0;               // earlier rows are omitted
  std::optional<std::size_t> until{};  // number of rows, including rows before the first; later rows have no effect
};

// A record in preparation. Each step uses the result of the previous step.
struct Preparing {
  Measurement result;  // the result up to this step
  Readings readings;
  Needs needs;
  double stiffness;                       // [N/m] of the load train
  Record all{};                           // all rows of the table; after the selection, the selected rows
  StatedRows stated{};                    // from begin_where_stated
  std::optional<std::size_t> last_row{};  // stated row of the file, from 1
  std::vector<StageRest> rests{};         // of all rows of the table
  std::size_t rows_looked_at = 0;         // between the first and the last selected row
  std::size_t points = 0;                 // of `all`, up to the stated end
  Leg loading{0, 0, Direction::loading};  // the evaluated loading, in `all`
  std::optional<Leg> way_back{};          // after the loading

  const Test& input() const { return result.test; }
  const Table& table() const { return readings.table; }
  const Sampling& sampling() const { return result.sampling; }
};

// What a step did, without its name; empty if there is nothing to report.
using Done = std::optional<PreparationStep>;

// Zeros and signs (zeros.cpp).
// Fails:      InputError for readings that are too large, for a stage that does not move, for too
//             few readings.
Done count_the_right_way(Preparing& at);
Done count_force_from_zero(Preparing& at);
Done say_compliance(Preparing& at);

// Omitted rows (rows_left_out.cpp).
// Fails:      InputError for a place that the record does not reach, or that lies after its stated
//             end.
Done begin_where_stated(Preparing& at);
Done end_before_overload(Preparing& at);
Done leave_out_repeated(Preparing& at);  // also selects rows for the next four steps
Done say_held(Preparing& at);
Done say_interpolated(Preparing& at);
Done say_unloaded(Preparing& at);
Done say_thinning(Preparing& at);
Done leave_out_stray_positions(Preparing& at);
Done leave_out_holds(Preparing& at);
Done leave_out_way_back(Preparing& at);
Done leave_out_spikes(Preparing& at);

// The evaluated loading (evaluated_loading.cpp).
// Fails:      InputError for a record without a loading, for a force that falls instead of rising,
//             for too few readings, for a load train softer than the stage allows, for a stage that
//             runs back beyond its noise.
Done end_where_stated(Preparing& at);
Done choose_loading(Preparing& at);
Done end_before_failure(Preparing& at);
Done hold_stage(Preparing& at);

// The zero of displacements (contact_of_record.cpp).
// Fails:      InputError if a contact cannot be found, and for too few readings after it.
Done count_from_contact(Preparing& at);

// The relaxation during rests before the end of the loading.
std::optional<Relaxation> relaxation_of(const Preparing& at);

// Common queries of the steps.

// Fails:      InputError for too few points.
void require_points(const Preparing& at, const Record& record);

// The rows of the first loading, up to its maximum force.
Record first_rise(const Record& record);

// [N] The force at the start of a record, robust against one outlier.
double force_at_start(std::span<const double> force);

// The number of points before a row, from 0.
std::size_t points_before(std::size_t row, const Sampling& sampling);

// The last row, from 1, before the point with this index.
std::size_t rows_of_points(const Sampling& sampling, std::size_t points);

}  // namespace flexslip
