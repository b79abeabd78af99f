// A bending test as a user describes it. Every key of a case file has its member here and its row in case_keys.cpp.
//
// Numbers are in SI and radians; in a reduced test they are in the model's scaled variables: lengths in spans L, forces in EI/L^2, stiffnesses
// in EI/L^3. A member's unit below is that of a physical test.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bending_test/motion.h"
#include "contact/nose.h"
#include "data/section.h"
#include "io/table.h"

namespace flexslip {

struct FrictionTable;  // contact/friction.h

// To be found from the record.
struct ToFit {
  bool operator==(const ToFit&) const = default;
};
// A number, and how certain it is.
struct Known {
  double value;
  std::optional<double> uncertainty;  // one standard deviation, same unit; none if none is stated

  Known(double number = 0, std::optional<double> deviation = {}) : value(number), uncertainty(deviation) {}
  operator double() const { return value; }
  std::optional<double> relative_uncertainty() const {
    return uncertainty ? std::optional(value == 0 ? 0 : *uncertainty / value) : std::nullopt;
  }
  bool operator==(const Known&) const = default;
  bool operator==(double number) const { return value == number; }
};
inline constexpr double max_uncertainty = 0.3;  // [1] of a value: beyond it the test would be another one
using StatedStiffness = std::variant<ToFit, Known>;

struct CrackInput {   // a loss of bending stiffness, at once and for good
  double deflection;  // [m] at which it happens when that is first reached
  double loss;        // [1] of what is left, in (0, 1)
  bool operator==(const CrackInput&) const = default;
};

struct SpecimenInput {
  std::optional<Known> diameter{}, inner_diameter{}, wall{}, width{}, height{};  // [m]
  std::optional<StatedStiffness> modulus{};            // [Pa] neither this nor the next: to be fitted
  std::optional<StatedStiffness> bending_stiffness{};  // [N m^2] reduced: 1 where it is known
  std::optional<std::string> material{};
  std::optional<double> strain_at_break{};  // [1] in bending, at the surface
  std::optional<double> strength{};         // [Pa] instead
  std::vector<CrackInput> cracks{};
  bool operator==(const SpecimenInput&) const = default;
};

// Where friction acts on the specimen: at its surface, or, as the paper has it, at its axis, as if it had no thickness.
enum class FrictionAt { surface, axis };

enum class SupportKind { edges, rollers };
enum class Rollers { fixed, pinned };  // when the specimen slides over them, pinned ones turn

struct RigInput {
  std::optional<Known> span{};                // [m] reduced: 1; none: the export of the record says it
  std::optional<Known> stiffness{};           // [N/m] infinite for displacement control
  std::optional<double> support_stiffness{};  // [N/m] of each support, vertically; none: rigid
  std::optional<SupportKind> supports{};      // none: rollers if they have a radius, else edges are assumed
  std::optional<Known> roller_radius{};       // [m] none: edges
  Rollers rollers = Rollers::fixed;
  std::optional<double> pin_radius{}, pin_friction{};  // [m], [1] of rollers on pins
  FrictionAt friction_at = FrictionAt::surface;  // one with the axis where no section says how thick the specimen is
  std::optional<double> nose_radius{};           // [m] none: sharp
  Nose nose = Nose::holds;
  std::optional<SnapRest> snaps{};
  std::optional<std::string> support_material{};
  bool in_inches = false;  // the span is stated so: people are answered in inches and pounds
  bool operator==(const RigInput&) const = default;
  bool states_supports() const { return supports || roller_radius; }
  // Whatever the specimen's friction, pins that hold their rollers so fast never turn.
  bool pins_turn() const { return rollers != Rollers::pinned || *pin_friction * *pin_radius < *roller_radius; }
};

enum class FrictionModel { constant, drift, sinusoid, sinusoids, table, rough, surface, roughness };
enum class TraceDirection { outwards, inwards };  // along the specimen, seen from midspan

// One term of μ: amplitude cos(π S/wavelength + phase), (4.25).
struct WaveInput {
  double amplitude;               // [1] relative to mu0, in [0, 1]
  double wavelength;              // [m]
  std::optional<double> phase{};  // [rad] none: 0
  bool operator==(const WaveInput&) const = default;
};

// The friction of a support. To simulate, a model with its parameters; the model alone, to fit. Which parameters a model has stands in case_file.cpp.
struct FrictionInput {
  std::optional<FrictionModel> model{};
  std::optional<double> mu0{};                      // [1]
  std::optional<double> drift{}, reference{};       // [1/m], [m]: drift (S - reference); no reference: the span
  std::optional<double> amplitude{}, wavelength{};  // of a single wave, as WaveInput
  std::optional<double> phase{};
  std::vector<WaveInput> waves{};
  std::optional<std::string> file{}, length{}, mu{};  // a table over S, as from an AFM, and the titles of its columns
  std::optional<double> rms{}, correlation_length{};  // [1] of ln μ, [m]
  std::optional<std::uint64_t> seed{};                // of the random numbers
  std::optional<std::string> trace{}, position{},
      height{};                         // a file with heights, and its columns, as read_trace takes them
  std::optional<double> trace_step{};   // [m] between heights, of a file without positions
  std::optional<double> trace_begin{};  // [m] from midspan; none: half of the span
  TraceDirection direction = TraceDirection::outwards;
  std::uint64_t level = 1;                        // degree of the polynomial that is taken off
  std::optional<double> cutoff{}, edge_radius{};  // [m] of a filter; of the support, none: that of its rollers
  std::optional<double> static_excess{};          // [1] of the static friction over the kinetic one
  std::optional<double> wear{};                   // [1] share of friction that a turn of the stage leaves; none: 1
  std::shared_ptr<const FrictionTable> points{};  // what the file holds, once it is read: S [m] and μ
  bool operator==(const FrictionInput&) const = default;

  bool has_parameters() const { return mu0 || file; }
};

// Positions between which the stage moves straight on, one that is repeated being a halt; or row by row from a file.
struct StageInput {
  std::vector<double> program{};                       // [m] at least two
  std::uint64_t cycles = 1;                            // how often all after the first is gone through
  std::optional<double> step{};                        // [m] none: continuous, with exact snaps
  std::optional<std::string> file{}, stage{}, time{};  // and the titles of its columns
  char decimal = '.';
  std::optional<SnapRest> snaps{};  // of a simulation; none: as those of the rig
  bool operator==(const StageInput&) const = default;
};

// What the displacement of an export is one of: of the stage, to which the load train gives way as well, or of the specimen's midpoint.
enum class DisplacementOf { crosshead, deflection };
enum class SignRule { find, keep, reverse };
enum class FailureRule { find, none };
enum class ZeroWord { find, keep, slope };
enum class ContactWord { find, first_row };
using ForceZeroRule = std::variant<ZeroWord, double>;  // [N] to be taken off
using ContactRule = std::variant<ContactWord, Known>;  // [m] displacement at first contact

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

// A table whose columns are named, two of stage, deflection and force; or the export of a testing machine, whose columns are found by what they
// are called.
struct RecordInput {
  std::string file{};
  std::optional<SheetChoice> sheet{};                         // of a workbook; none: the first with a table of numbers
  std::optional<std::string> stage{}, deflection{}, force{};  // titles; of an export, the name or number of the force
  std::optional<std::string> length{};                        // pulled in over both supports, as imaged
  std::optional<DisplacementOf> displacement{};               // none: as the words of the file say
  std::optional<std::string> displacement_column{};
  std::optional<std::uint64_t> specimen{};   // counted from 1; none: there is only one
  std::optional<std::string> calibration{};  // of a force in volts, "222 N/V"
  std::optional<double> speed{};             // [m/s] of the crosshead, where the file has a time and no displacement
  SignRule sign = SignRule::find;
  ForceZeroRule zero = ZeroWord::find;
  std::optional<ContactRule> contact{};  // none: found where the record begins before it
  std::optional<double> gain_error{}, preload_error{}, slow_force_error{};  // standard deviations: [1], [m], [1]
  FailureRule failure = FailureRule::find;
  std::optional<char> decimal{};
  std::optional<PlaceInRecord> first{}, until{};  // none: with its first row, before failure
  // What a call holds in memory instead of a file: the columns named, in SI and in their order above; `file` is a name for messages.
  std::shared_ptr<const Table> given{};
  bool operator==(const RecordInput&) const = default;

  bool is_export() const {
    return displacement || displacement_column || calibration || speed || !(stage || deflection);
  }
};

struct Test {
  std::string source{};                     // the file as the user named it
  bool reduced = false, by_flags = false;   // the latter where flags of a command state it, beside a data file
  std::optional<SpecimenInput> specimen{};  // this and the rig are always there in reduced tests
  std::optional<RigInput> rig{};
  std::optional<FrictionInput> friction{};
  std::optional<FrictionInput> other{};  // of the other support, [friction.other]; none: both are alike
  std::optional<StageInput> stage{};
  std::optional<RecordInput> record{};
  // Where each key is said, "specimen", "specimen.diameter", "stage.program[1]": its line; what is not here is a default.
  std::map<std::string, std::size_t, std::less<>> lines{};
  std::vector<std::string> changed{};  // keys that the command line says, "rig.stiffness"
};

}  // namespace flexslip
