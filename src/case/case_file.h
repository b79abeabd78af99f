// Case files: one TOML file describes a test, for simulating and for fitting (docs/case-files.md).
//
// Numbers are in SI and radians; where the file says `reduced = true`, they are in the model's scaled variables: lengths
// in spans L, forces in EI/L^2, stiffnesses in EI/L^3. A field's unit below is that of the physical case.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "bending_test/motion.h"
#include "data/section.h"
#include "io/input_error.h"
#include "io/quantity.h"

namespace flexslip {

// To be found from the record.
struct ToFit {
  bool operator==(const ToFit&) const = default;
};

struct Known {
  double value;
  double uncertainty;  // one standard deviation, same unit; 0 if the file states none
  bool operator==(const Known&) const = default;
};

using StatedStiffness = std::variant<ToFit, Known>;

// How stiff the specimen is: the modulus of its section, or the product EI.
struct Modulus {
  StatedStiffness estimate;  // [Pa]
  bool operator==(const Modulus&) const = default;
};

struct BendingStiffness {
  StatedStiffness estimate;  // [N m^2]
  bool operator==(const BendingStiffness&) const = default;
};

// A loss of bending stiffness, at once and for good.
struct CrackInput {
  double deflection;  // [m] at which it happens when that is first reached
  double loss;        // [1] of what is left, in (0, 1)
  bool operator==(const CrackInput&) const = default;
};

struct SpecimenInput {
  std::optional<Section> section;                    // none beside a modulus: the export of the record says it
  std::variant<Modulus, BendingStiffness> rigidity;  // reduced: a bending stiffness, 1 where it is known
  std::optional<std::string> material{};             // "glass", for the literature's friction alone
  std::vector<CrackInput> cracks{};                  // for simulating
  std::optional<double> strain_at_break{};           // [1] in bending, at the surface; for designs
  std::optional<double> strength{};                  // [Pa] instead
  bool operator==(const SpecimenInput&) const = default;
};

// Where friction acts on the specimen: at its surface, or, as the paper has it, at its axis, as if it had no thickness.
enum class FrictionAt { surface, axis };

// What rollers do when the specimen slides over them: nothing, turn on their pins, or roll on a flat base.
enum class Rollers { fixed, pinned, loose };

struct RigInput {
  std::optional<double> span;                     // [m] reduced: 1; none: the export of the record says it
  std::optional<double> stiffness;                // [N/m] infinite for displacement control
  std::optional<std::string> support_material{};  // "steel", likewise
  std::optional<double> nose_radius{};            // [m] none: sharp
  std::optional<double> support_stiffness{};      // [N/m] of each support, vertically; none: rigid
  std::optional<double> roller_radius{};          // [m] none: edges
  Rollers rollers = Rollers::fixed;
  double pin_radius = 0, pin_friction = 0;       // [m], [1] of rollers on pins
  FrictionAt friction_at = FrictionAt::surface;  // one with the axis where no section says how thick the specimen is
  bool operator==(const RigInput&) const = default;
};

// One term of μ: amplitude cos(π S/wavelength + phase), (4.25).
struct WaveInput {
  double amplitude;   // [1] relative to mu0, in [0, 1]
  double wavelength;  // [m]
  double phase;       // [rad]
  bool operator==(const WaveInput&) const = default;
};

// mu0 (1 + Σ waves) + drift (S - reference): the models "constant" and "drift" (no wave), "sinusoid" (one) and "sinusoids".
struct WavyFriction {
  double mu0;    // [1] at the reference
  double drift;  // [1/m] 0 if the file has none
  std::vector<WaveInput> waves;
  std::optional<double> reference{};  // [m] a length between the supports, there only beside a drift; none: the span
  bool operator==(const WavyFriction&) const = default;
};

// μ from a table over S, such as an AFM trace; the point of the specimen at s from midspan is at S = 2 s.
struct TabulatedFriction {
  std::string file;    // relative to the working directory
  std::string length;  // the titles of its columns, as read_table takes them: "S [um]" and "mu"
  std::string mu;
  bool operator==(const TabulatedFriction&) const = default;
};

struct RoughFriction {
  double mu0;                 // [1] the mean
  double rms;                 // [1] standard deviation, of ln μ
  double correlation_length;  // [m] along the specimen
  std::uint64_t seed;         // of the random numbers
  bool operator==(const RoughFriction&) const = default;
};

using FrictionProfileInput = std::variant<WavyFriction, TabulatedFriction, RoughFriction>;

enum class FrictionModel { constant, drift, sinusoid, sinusoids, table, rough, roughness };

// The friction of the other support, where it is not that of the first.
struct OtherSupport {
  FrictionModel model;  // with parameters
  FrictionProfileInput profile;
  bool operator==(const OtherSupport&) const = default;
};

// For simulating, a model with its parameters; for fitting, the model to fit.
struct FrictionInput {
  std::optional<FrictionModel> model;           // none: that which is fitted where nothing is said
  std::optional<FrictionProfileInput> profile;  // there if the file gives parameters
  double static_excess = 0;                     // [1] of the static friction over the kinetic one, the profile
  std::optional<OtherSupport> other{};          // none: both supports are alike, and both slide at once
  double build_up_length = 0;  // [m] of sliding, over which friction nears the profile; 0: it is there at once
  bool operator==(const FrictionInput&) const = default;
};

// Positions between which the stage moves straight on; one that is repeated is a halt.
struct TurningPoints {
  std::vector<double> positions;  // [m] at least two
  std::uint64_t cycles;           // how often all after the first is gone through
  std::optional<double> step;     // [m] none: continuous, with exact snaps
  bool operator==(const TurningPoints&) const = default;
};

// Positions row by row from a table. Titles of columns as read_table takes them.
struct MeasuredProgramme {
  std::string file;  // relative to the working directory
  std::string stage;
  std::optional<std::string> time;  // must not run back
  char decimal;                     // '.' or ','
  bool operator==(const MeasuredProgramme&) const = default;
};

struct StageInput {
  std::variant<TurningPoints, MeasuredProgramme> programme;
  SnapRest snaps = SnapRest::nearest_stable;
  bool operator==(const StageInput&) const = default;
};

// Columns of a table, named: two of the three are there; each is a title as read_table takes it, "F_N [N]".
struct TableColumns {
  std::optional<std::string> stage, deflection, force;
  char decimal;                         // '.' or ','
  std::optional<std::string> length{};  // pulled in over both supports, as imaged: beside the others
  bool operator==(const TableColumns&) const = default;
};

// What the displacement of an export is one of.
enum class DisplacementOf {
  crosshead,   // the stage: the load train gives way as well
  deflection,  // the specimen's midpoint
};

// An export of a testing machine, whose columns are found by what they are called.
struct ExportColumns {
  std::optional<DisplacementOf> displacement{};               // none: as the words of the file say
  std::optional<std::string> displacement_column{}, force{};  // name or number of a column that is not found
  std::optional<std::size_t> specimen{};                      // counted from 1; none: there is only one
  std::optional<std::string> calibration{};                   // of a force in volts, "222 N/V"
  std::optional<char> decimal{};
  bool operator==(const ExportColumns&) const = default;
};

// What is done to a record before it is evaluated, or left undone.
struct ToFind {
  bool operator==(const ToFind&) const = default;
};
struct ToKeep {
  bool operator==(const ToKeep&) const = default;
};
struct AtFirstRow {
  bool operator==(const AtFirstRow&) const = default;
};
struct WhereFree {
  bool operator==(const WhereFree&) const = default;
};

enum class SignRule { find, keep, reverse };
using ForceZeroRule = std::variant<ToFind, ToKeep, double>;  // [N] to be taken off
using ContactRule =
    std::variant<WhereFree, ToFind, AtFirstRow, double>;  // to be found if rows lie before it, or in any
                                                          // case; or [m] displacement at first contact
// Where a record begins or ends: a row of the file, counted from 1, or where the stage or the deflection, as the file counts them, is there.
struct AtRow {
  std::size_t row;
  bool operator==(const AtRow&) const = default;
};
struct AtStage {
  double position;  // [m]
  bool operator==(const AtStage&) const = default;
};
struct AtDeflection {
  double position;  // [m]
  bool operator==(const AtDeflection&) const = default;
};
using PlaceInRecord = std::variant<AtRow, AtStage, AtDeflection>;

struct RecordInput {
  std::string file;  // relative to the working directory
  std::variant<TableColumns, ExportColumns> columns;
  SignRule sign = SignRule::find;
  ForceZeroRule zero = ToFind{};
  ContactRule contact = WhereFree{};
  bool find_failure = true;
  std::optional<PlaceInRecord> first{};  // where the record begins; none: with its first row
  std::optional<PlaceInRecord> until{};  // where it ends, before failure
  bool operator==(const RecordInput&) const = default;
};

struct Case {
  std::string source;  // the file as the user named it
  bool reduced;
  std::optional<SpecimenInput> specimen;  // this and the rig are always there in reduced cases
  std::optional<RigInput> rig;
  std::optional<FrictionInput> friction;
  std::optional<StageInput> stage;
  std::optional<RecordInput> record;
  std::map<std::string, std::size_t, std::less<>>
      lines;                           // of every key: "specimen", "specimen.diameter", "stage.program[1]"
  std::vector<std::string> changed{};  // keys that the command line says, "rig.stiffness"
};

// Reads a case. Every value is in its range, every key is known, and what belongs together is complete; which
// sections a command needs is its own affair (see missing()), and [sweep] that of its own reader (sweep_plan.h).
// Fails:      InputError with file, line and key.
Case read_case(std::string_view text, const std::string& source, const std::vector<std::string>& changes = {});

// The same from a file, "-" is standard input, with changes from the command line (case_changes.h).
Case read_case(const std::string& path, const std::vector<std::string>& changes = {});

// The text of a case file; "-" is standard input.
// Fails:      InputError if it cannot be read, or is too long for a case.
std::string case_text(const std::string& path);

// The case as TOML text: read_case gives the same case back, to the last bit, in the same working directory.
std::string to_toml(const Case& input);

// The error to throw when a value of a case turns out wrong later. `key` as in Case::lines.
InputError wrong_value(const Case& input, std::string_view key, std::string expected, std::string found,
                       std::string remedy = "");

// The key that says how thick a specimen is in the direction of bending.
std::string depth_key(const Section& section);

// In a reduced case every quantity is a plain number.
Kind kind_in(const Case& input, const Kind& kind);

// The error to throw when a command needs what a case does not have: a section, "friction", or a key, "rig.stiffness".
// The message shows an example of it.
InputError missing(const Case& input, std::string_view key);

}  // namespace flexslip
