// The prepared record of a test: correct signs, correct zeros, ends with the loading. Its steps
// list everything that was done (preparation.h).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case/case_file.h"
#include "case/preparation.h"
#include "case/readings.h"
#include "data/contact.h"
#include "data/record.h"
#include "data/relaxation.h"
#include "data/sampling.h"
#include "data/small_deflection.h"
#include "inference/beginning.h"
#include "io/quantity.h"

namespace flexslip {

// The reason why the evaluated loading ends.
enum class MeasurementEnd { last_row, until, failure, turn, overload };
enum class ContactSource {
  stated,       // by the case
  found,        // the contact point of the record (find_contact), or the linear region after a toe
  first_point,  // the record begins at the contact: nothing is subtracted
};

// The number of the first loading, from 1, that reaches almost the largest deflection, or whose
// force no later loading reaches.
struct EvaluatedLoading {
  std::size_t number = 1, of = 1;
};

// The evaluated part of a record: one loading, from the contact to the failure or the reversal, and
// the whole record for a test with unloading.
// A force drop during which the deflection grew by less than the stated load train releases. The
// load train is therefore stiffer than fall/advance.
struct LeastTrain {
  std::size_t before;  // point of the record
  double fall;         // [N] decrease of the force
  double advance;      // [m] increase of the deflection, > 0
};

// The curve along which the specimen is bent farther than ever before: the first loading, then of each
// later one up to the evaluated one the points beyond. The evaluated loading alone if an earlier one
// goes as far. A reload meets this curve where the stage turned back, unless stiffness was lost.
struct FirstCurve {
  Record record{};                    // stage and deflection from the contact
  std::vector<std::size_t> points{};  // the index of each point in Sampling::rows
};

struct Measurement {
  Test test;                                   // completed from the file (Readings)
  std::vector<PreparationStep> preparation{};  // the steps from the file to the record
  std::string file;
  std::size_t rows;                           // of the file
  std::size_t missing = 0;                    // omitted rows without a number
  std::vector<std::string> contradictions{};  // sentences: see dimensions_of_file.h
  Sampling sampling{};                        // the rows that are points, from the first row of the file
  EvaluatedLoading loading{};
  std::size_t first = 0;            // the first point of the record among them
  Record record{};                  // stage and deflection from the contact
  std::vector<double> pulled_in{};  // [m] sliding length of each row of the file, as imaged; otherwise empty
  std::optional<Record> cycles{};   // all loadings from the first row of the file, if several; from the contact too
  MeasurementEnd end = MeasurementEnd::last_row;  // reason for the end of the loading
  std::size_t drops_behind = 0;                   // after the failure or the stated end of the loading
  ContactSource contact = ContactSource::first_point;
  bool is_derived = false;   // true if the deflection was computed from the stage and the load train
  bool begins_free = false;  // true if rows before the contact prove that there is no preload
  // For a stage that was computed from deflection and force and runs back during a force drop.
  std::optional<LeastTrain> least_train{};
  double begins_under = 0;    // [N] force of the first points, if the specimen cannot cause it
  double contact_offset = 0;  // [m] subtracted from stage and deflection
  double contact_error = 0;   // [m] standard deviation, at least the distance to the record's own contact
  Contact own_contact{ContactStatus::too_few_points};  // of the record, from the subtracted contact
  FirstCurve first_curve{};
  std::optional<LinearRegion> straight{};  // linear region of the first curve
  // True if the bending stiffness of every command is the slope of the linear region: the
  // deflection is below min_informative_deflection. At larger deflections the start of the record
  // is better, because friction steepens the rest.
  bool straight_is_initial = false;
  double force_noise = 0;                  // [N] standard deviation of one point
  std::optional<Relaxation> relaxation{};  // from rests of the stage up to the end of the record
  Baseline baseline{};                     // of the force before the contact, if it is not level
  bool baseline_is_off = false;            // true if it was subtracted, as the case requests
};

// The rows of the file, from 1, of points [first, last) of the first curve.
RowRange rows_of_first_curve(const Measurement& measurement, std::size_t first, std::size_t last);

// The row of the file, from 1, at which a point of the record or of the cycles begins.
std::size_t file_row(const Measurement& measurement, std::size_t point);
std::size_t cyclic_file_row(const Measurement& measurement, std::size_t point);

// The row of the file, from 1, before the next point, or the last row.
std::size_t last_file_row(const Measurement& measurement, std::size_t point);

// Reads the record of a case and prepares it by the steps of preparing.h.
// Domain:     at least 11 points; std::invalid_argument otherwise.
// Fails:      InputError as read_readings; for too few points, a record without a loading, an
//             `until` beyond the file, a missing rig stiffness for a stage displacement, or a
//             contact that cannot be found because the force does not rise straight.
Measurement read_measurement(const Test& asked, const Needs& needs);

}  // namespace flexslip
