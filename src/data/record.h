// One measured bending test in SI units, and what can be read off it without mechanics.
//
// stage is the imposed displacement w_s (crosshead), deflection that of the specimen's midpoint w0, and force = k_c (stage
// - deflection) with the stiffness k_c of whatever carries the load cell. Points are counted from 0, in the order of time.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "data/scales.h"

namespace flexslip {

struct Record {
  std::vector<double> stage;       // [m]
  std::vector<double> deflection;  // [m]
  std::vector<double> force;       // [N]
};

struct ReducedRecord {
  std::vector<double> stage;       // [L]
  std::vector<double> deflection;  // [L]
  std::vector<double> force;       // [EI/L^2]
};

// What a record has to be for whatever is asked of it: columns of one length, every reading finite; std::invalid_argument otherwise.
void require_readings(std::span<const double> stage, std::span<const double> deflection, std::span<const double> force);
inline void require_readings(const Record& record) { require_readings(record.stage, record.deflection, record.force); }
inline void require_readings(const ReducedRecord& record) {
  require_readings(record.stage, record.deflection, record.force);
}

ReducedRecord to_reduced(const Record& record, const Scales& scales);
Record to_physical(const ReducedRecord& record, const Scales& scales);

// A record from two of its columns ([m], [N]) and the load-train stiffness [N/m], which gives the third.
// Domain: columns of one length, stiffness > 0; it may be infinite (displacement control: stage and deflection are one)
//         where the force is a column. std::invalid_argument otherwise.
Record record_from_stage_and_force(std::span<const double> stage, std::span<const double> force, double stiffness);
Record record_from_deflection_and_force(std::span<const double> deflection, std::span<const double> force,
                                        double stiffness);
Record record_from_stage_and_deflection(std::span<const double> stage, std::span<const double> deflection,
                                        double stiffness);

// The first points of a record: with find_failure (failure.h), the part before the specimen broke.
Record first_points(const Record& record, std::size_t points);

// Points [first, last) of a record.
Record points_between(const Record& record, std::size_t first, std::size_t last);

// A record without its first points, its stage and deflection counted from a contact [m].
Record counted_from(double contact, Record record, std::size_t skipped = 0);

// Some of its points. (Means would smear the drops.)
// Domain: points of the record.
Record picked(const Record& record, std::span<const std::size_t> points);

enum class RecordFault {
  none,
  lengths_differ,   // the columns are not of one length; index = the length of the shortest
  not_finite,       // index = the first point with a value that is not finite
  stage_runs_back,  // index = the first point whose stage lies behind that of the point before
};

struct RecordCheck {
  RecordFault fault;
  std::size_t index;  // as the fault says; 0 if none
};

// Is this a loading test that can be evaluated? Everything below takes for granted that lengths agree and values are finite.
RecordCheck check_record(const Record& record);

// The force step [N] from each point to the next that a smooth curve would make: size - 1 values. The slope at a step is the
// median over the 21 steps around it, weighted by their travel and straightened by the bend of that median over 10 steps either
// side: immune to up to 10 drops in a window. At the ends the outermost window is continued linearly.
std::vector<double> smooth_steps(const Record& record);

// The resolution of a digital instrument, in the unit of its readings: the smallest difference between them; 0 if no two are alike and they do not lie
// in steps of it (at least 20 of them).
// Domain: at least one reading.
double resolution_of(std::vector<double> readings);

// The noise of a record about its smooth curve, both of which have to outlive it.
// Domain: smooth = smooth_steps(record); std::invalid_argument otherwise.
class StepNoise {
 public:
  StepNoise(const Record& record, std::span<const double> smooth);

  // Standard deviation [N] of force[i + steps] - force[i] about the smooth curve where the record is quiet.
  // Domain: 1 <= steps, and at least steps + 10 points; std::invalid_argument otherwise.
  // Method: median absolute deviation in windows of 30 points, of which the quietest tenth counts, corrected for having been
  //         chosen (to 4 % in the mean over one step, for Gaussian noise and 30 points or more; a single record of 260 points
  //         tells it to 12 %). So it is the noise of the instrument: drops, and the unrest of a specimen that slips all the time,
  //         leave it alone as long as a tenth of the record is quiet. At least what the resolution of the force makes it; 0 only
  //         for a force without noise.
  double over(std::size_t steps) const;

  double resolution() const { return resolution_; }  // [N] of the force

 private:
  const Record& record_;
  std::span<const double> smooth_;
  double resolution_;
};

// Noise of a single position of the stage, in its unit: at least what two readings rounded to its resolution differ by.
// Domain: at least one reading.
double stage_noise(std::span<const double> stage);

// Noise of a single force reading [N]: that of one step over √2, its standard deviation if readings err independently.
// Domain: at least so many points; std::invalid_argument otherwise.
inline constexpr std::size_t least_noise_points = 11;
double force_noise(const Record& record);

// The loading and unloading legs of a record: a stage programme with turning points, cut at them.

enum class Direction { loading, unloading };  // the stage advances, or goes back

struct Leg {
  std::size_t first, last;  // points [first, last); the turning point is the last of the leg that it ends
  Direction direction;
};

struct LegOptions {
  double min_travel = 0.02;  // [range of the stage] a turn counts once the stage has gone back by more; shorter
                             // excursions are noise, backlash or a hold, and belong to the leg they interrupt
};

// Legs in the order of time, loading and unloading in turn; together they are all points. None for a stage that stands still.
// Domain: stage finite, in any unit; 0 < min_travel < 1. std::invalid_argument otherwise.
// Method: a turning point is the farthest position before a return of more than min_travel; of equal ones the first. So noise
//         of the stage shifts it by no more than its own size, and cannot make one if its range is below min_travel. At the beginning,
//         where a specimen may be settled by small cycles, a quarter of that is enough if it is more than half of the way so far and
//         beyond the noise of the stage.
// Cost:   one pass, and another where small cycles may begin the record.
std::vector<Leg> find_legs(std::span<const double> stage, const LegOptions& options = {});

// The median of the five values about each: one or two that are none do not move it. At the ends of the first or the last five; of fewer than thirty
// values, which have none to spare, the values themselves.
std::vector<double> medians_of_five(std::span<const double> values);

// Which way a testing machine counts: compression is negative in many an export, of the force, the displacement or both.

struct Signs {
  int displacement, force;  // 1: as a bending test counts, both positive in loading; -1: the other way
};

// The signs of a record, read off it as a whole.
// Domain: columns of one length, finite, in any units; std::invalid_argument for different lengths.
// Fails:  never: columns that do not change are taken as they are.
// Method: a specimen between its supports only pushes back, so that the force of greatest magnitude is one of compression: of medians of five
//         rows, as one or two readings may be none (of thirty rows and more). The displacement advances from the least force before that one to it; after it, if
//         the record begins with the greatest. Wrong for a record whose force is tared by more than it rises.
Signs find_signs(std::span<const double> displacement, std::span<const double> force);

}  // namespace flexslip
