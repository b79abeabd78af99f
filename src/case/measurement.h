// The record of a test made ready to evaluate: read, counted the right way and from the right zero, cut where the loading ends. Nothing is done
// to it that is not listed in its steps (preparation.h).
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

// What ends the loading that is evaluated.
enum class MeasurementEnd { last_row, until, failure, turn, overload };
enum class ContactSource {
  stated,       // by the case
  found,        // where the record itself begins, see find_contact, or the straight part behind a toe
  first_point,  // the record begins at the contact: nothing is taken off
};

// Of the loadings of a test, counted from 1, the first that goes about as far as any, or whose force no later one reaches again.
struct EvaluatedLoading {
  std::size_t number = 1, of = 1;
};

// The part of a record that is evaluated: one loading, from the contact to the failure or to where the stage turns back; of a
// test that is unloaded, all of it besides.
// A fall of the force during which the specimen bent farther by less than the load train stated would have given back, so that
// this is stiffer than fall/advance.
struct LeastTrain {
  std::size_t before;  // point of the record
  double fall;         // [N] of the force
  double advance;      // [m] of the deflection, > 0
};

struct Measurement {
  Test test;                                   // completed with what the file says, see Readings
  std::vector<PreparationStep> preparation{};  // how the file became the record
  std::string file;
  std::size_t rows;                           // of the file
  std::size_t missing = 0;                    // of them those left out, as they hold no number
  std::vector<std::string> contradictions{};  // sentences: what the file states of span and section, against the user
  Sampling sampling{};                        // which of them are points, from the first row of the file on
  EvaluatedLoading loading{};
  std::size_t first = 0;            // of these the first that is a point of the record
  Record record{};                  // stage and deflection counted from the contact
  std::vector<double> pulled_in{};  // [m] of each row of the file, as imaged; empty where it was not
  std::optional<Record>
      cycles{};  // all loadings, from the first row of the file, if there are several; contact taken off as well
  MeasurementEnd end = MeasurementEnd::last_row;  // what ends the loading
  std::size_t drops_behind = 0;                   // of its force, behind the failure or where it is stated to end
  ContactSource contact = ContactSource::first_point;
  bool is_derived = false;   // the deflection is what the load train leaves of the stage
  bool begins_free = false;  // with rows before the contact, so that no preload hides in its zero
  // Where the stage is reckoned from deflection and force, and would have run back while the force fell.
  std::optional<LeastTrain> least_train{};
  double begins_under =
      0;  // [N] the force of its first points, where nothing of the specimen could be there; below 0: an error of the zero
  double contact_offset = 0;  // [m] taken off stage and deflection
  double contact_error = 0;   // [m] standard deviation, wide enough to hold the record's own contact
  Contact own_contact{ContactStatus::too_few_points};  // of the record, counted from that taken off
  std::optional<LinearRegion> straight{};              // of the record
  // It is the initial slope, for every command: of a record bent so little that it tells no friction (min_informative_deflection). Where one is bent farther its
  // beginning tells more, for friction steepens the rest.
  bool straight_is_initial = false;
  double force_noise = 0;                  // [N] standard deviation of one point
  std::optional<Relaxation> relaxation{};  // as rests of the stage up to the end of the record show it
  Baseline baseline{};                     // of the force before the contact, where it is not level
  bool baseline_is_off = false;            // taken off, as the case asks
};

// The record, or of several loadings the first, which starts from a specimen that friction does not hold drawn in.
Record first_loading(const Measurement& measurement);

// Row of the file, counted from 1, at which a point of the record begins; and one of the cycles.
std::size_t file_row(const Measurement& measurement, std::size_t point);
std::size_t cyclic_file_row(const Measurement& measurement, std::size_t point);

// Row of the file, counted from 1, before that at which the next point begins, or its last row.
std::size_t last_file_row(const Measurement& measurement, std::size_t point);

// Reads the record of a case and prepares it, by the steps of preparing.h.
// Domain:     11 points or more; std::invalid_argument otherwise.
// Fails:      InputError, besides what read_readings throws, for too few points, a record without a loading, an `until`
//             beyond the file, no stiffness of the rig where the displacement is that of the stage, a contact to be found
//             where the force does not rise straight.
Measurement read_measurement(const Test& asked, const Needs& needs);

}  // namespace flexslip
