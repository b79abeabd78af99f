// One measured bending test in SI units, and the quantities that need no mechanical model.
//
// stage is the imposed displacement w_s of the crosshead, deflection the displacement w0 of the
// specimen's midpoint. force = k_c (stage - deflection), with k_c the stiffness of the load train.
// Points are counted from 0, in the order of time.
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

// Checks that the columns have equal length and finite values; throws std::invalid_argument
// otherwise.
void require_readings(std::span<const double> stage, std::span<const double> deflection, std::span<const double> force);
inline void require_readings(const Record& record) { require_readings(record.stage, record.deflection, record.force); }
inline void require_readings(const ReducedRecord& record) {
  require_readings(record.stage, record.deflection, record.force);
}

ReducedRecord to_reduced(const Record& record, const Scales& scales);
Record to_physical(const ReducedRecord& record, const Scales& scales);

// A record computed from two of its columns ([m], [N]) and the load-train stiffness [N/m].
// Domain:     columns of equal length, stiffness > 0, std::invalid_argument otherwise. If force is
//             given, the stiffness may be infinite: displacement control, in which stage and
//             deflection are equal.
Record record_from_stage_and_force(std::span<const double> stage, std::span<const double> force, double stiffness);
Record record_from_deflection_and_force(std::span<const double> deflection, std::span<const double> force,
                                        double stiffness);
Record record_from_stage_and_deflection(std::span<const double> stage, std::span<const double> deflection,
                                        double stiffness);

// The first points of a record; with find_failure (failure.h), the part before failure.
Record first_points(const Record& record, std::size_t points);

// Points [first, last) of a record.
Record points_between(const Record& record, std::size_t first, std::size_t last);

// A record without its first `skipped` points, with stage and deflection relative to a contact
// point [m].
Record counted_from(double contact, Record record, std::size_t skipped = 0);

// The selected points of a record. (Averages would smear the drops.)
// Domain:     indices of points of the record.
Record picked(const Record& record, std::span<const std::size_t> points);

enum class RecordFault {
  none,
  lengths_differ,   // the columns differ in length; index = the smallest length
  not_finite,       // index = the first point with a value that is not finite
  stage_runs_back,  // index = the first point at which the stage moves back
};

struct RecordCheck {
  RecordFault fault;
  std::size_t index;  // see RecordFault; 0 without a fault
};

// The first fault that prevents an evaluation of a record. The functions below require columns of
// equal length with finite values.
RecordCheck check_record(const Record& record);

// The force step [N] of the smooth trend between successive points: size - 1 values. The slope is
// the median over the surrounding 21 steps, weighted by their travel. A second median over 10 steps
// on either side corrects its curvature. The result is insensitive to up to 10 drops in a window.
// At the ends the outermost window is extrapolated linearly.
std::vector<double> smooth_steps(const Record& record);

// The resolution of a digital instrument, in the unit of its readings: the smallest difference
// between readings. It is 0 if all readings differ and at least 20 of them are not multiples of a
// step.
double resolution_of(std::vector<double> readings);

// The noise of a record about its smooth trend. It keeps references to both arguments.
class StepNoise {
 public:
  StepNoise(const Record& record, std::span<const double> smooth);

  // Standard deviation [N] of force[i + steps] - force[i] about the smooth trend where the record
  // is quiet.
  // Domain:     1 <= steps, and at least steps + 10 points; std::invalid_argument otherwise.
  // Max error:  4 % in the mean over one step, for Gaussian noise and 30 points or more; 12 % for a
  //             single record of 260 points. At least the rounding error of the resolution. 0 only
  //             for a force without noise.
  // Method:     median absolute deviation in windows of 30 points. The quietest tenth of the
  //             windows counts, with a correction for this choice. Drops and continual slipping
  //             therefore have no effect while a tenth of the record is quiet.
  double over(std::size_t steps) const;

  double resolution() const { return resolution_; }  // [N] of the force

 private:
  const Record& record_;
  std::span<const double> smooth_;
  double resolution_;
};

// Noise of a single stage position, in its unit; at least the rounding error of a difference of two
// readings.
double stage_noise(std::span<const double> stage);

// Noise of a single force reading [N]: the noise of one step over √2, for independent readings.
// Domain:     at least least_noise_points points; std::invalid_argument otherwise.
inline constexpr std::size_t least_noise_points = 11;
double force_noise(const Record& record);

// Loading and unloading legs: the parts of a record between the turning points of the stage.

enum class Direction { loading, unloading };  // the stage advances or moves back

struct Leg {
  // points [first, last); a turning point is the last point of the leg before it
  std::size_t first, last;
  Direction direction;
};

struct LegOptions {
  // [range of the stage] The smallest return that counts as a turning point. A shorter one is
  // noise, backlash or a hold, and belongs to the leg that it interrupts.
  double min_travel = 0.02;
};

// The legs in the order of time, alternately loading and unloading; together they contain all
// points. Empty if the stage does not move.
// Domain:     stage finite, in any unit; 0 < min_travel < 1; std::invalid_argument otherwise.
// Method:     a turning point is the farthest position before a return of more than min_travel; of
//             equal positions, the first. The return must also exceed eight standard deviations of
//             the stage's noise and 1.5 times its resolution, or a quarter of the range. Noise shifts
//             a turning point at most by its own size. At the start, where small cycles may settle a
//             specimen, a quarter of min_travel suffices if it exceeds half of the previous travel.
// Cost:       one pass, or two if small cycles may begin the record.
std::vector<Leg> find_legs(std::span<const double> stage, const LegOptions& options = {});

// The running median of five values, which removes one or two outliers. At each end, the median of
// the outermost five values. Fewer than thirty values are returned unchanged.
std::vector<double> medians_of_five(std::span<const double> values);

// The sign convention of a testing machine. In many exports compression is negative: in the force,
// the displacement or both.

struct Signs {
  int displacement, force;  // 1: positive in loading; -1: negative in loading
};

// The signs of a record, determined from the whole record.
// Domain:     columns of equal length, finite, in any units; std::invalid_argument for different
//             lengths. Wrong for a force tared by more than its rise.
// Fails:      never; the sign of a constant column is 1.
// Method:     supports only push, so the force of largest magnitude is compression. Running medians
//             of five rows remove outliers if there are at least thirty rows. The displacement
//             advances from the preceding minimum of the force to this point, or after it if the
//             record begins with the maximum.
Signs find_signs(std::span<const double> displacement, std::span<const double> force);

}  // namespace flexslip
