// A bending test as the user describes it. Each key has a member here and a row in case_keys.cpp.
//
// Numbers are in SI and radians; in a reduced test, lengths are in spans L, forces in EI/L^2.
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
// Determined from the record.
struct ToFit {
  bool operator==(const ToFit&) const = default;
};
// A number and its uncertainty.
struct Known {
  double value;
  std::optional<double> uncertainty;  // one standard deviation, same unit; empty if not stated

  Known(double number = 0, std::optional<double> deviation = {}) : value(number), uncertainty(deviation) {}
  operator double() const { return value; }
  std::optional<double> relative_uncertainty() const {
    return uncertainty ? std::optional(value == 0 ? 0 : *uncertainty / value) : std::nullopt;
  }
  bool operator==(const Known&) const = default;
  bool operator==(double number) const { return value == number; }
};
inline constexpr double max_uncertainty = 0.3;  // [1] relative; more would be another test
using StatedStiffness = std::variant<ToFit, Known>;

struct CrackInput {   // a sudden, permanent loss of bending stiffness
  double deflection;  // [m] the loss occurs when this is first reached
  double loss;        // [1] of the remaining stiffness, in (0, 1)
  bool operator==(const CrackInput&) const = default;
};

struct SpecimenInput {
  std::optional<Known> diameter{}, inner_diameter{}, wall{}, width{}, height{};  // [m]
  std::optional<StatedStiffness> modulus{};            // [Pa] fitted if this and bending_stiffness are empty
  std::optional<StatedStiffness> bending_stiffness{};  // [N m^2] reduced: 1
  std::optional<std::string> material{};
  std::optional<double> strain_at_break{};  // [1] in bending, at the surface
  std::optional<double> strength{};         // [Pa] instead of strain_at_break
  std::vector<CrackInput> cracks{};
  bool operator==(const SpecimenInput&) const = default;
};

// Where friction acts: at the surface of the specimen, or at its axis as in the paper's model.
enum class FrictionAt { surface, axis };

enum class SupportKind { edges, rollers };
enum class Rollers { fixed, pinned };  // pinned rollers turn when the specimen slides

struct RigInput {
  std::optional<Known> span{};                // [m] reduced: 1; empty: in the export of the record
  std::optional<Known> stiffness{};           // [N/m] infinite for displacement control
  std::optional<double> support_stiffness{};  // [N/m] of each support, vertical; empty: rigid
  std::optional<SupportKind> supports{};      // empty: rollers with a radius, otherwise knife edges
  std::optional<Known> roller_radius{};       // [m] empty: knife edges
  Rollers rollers = Rollers::fixed;
  std::optional<double> pin_radius{}, pin_friction{};  // [m], [1] of rollers on pins
  FrictionAt friction_at = FrictionAt::surface;        // no effect without a section
  std::optional<double> nose_radius{};                 // [m] empty: sharp
  Nose nose = Nose::holds;
  std::optional<SnapRest> snaps{};
  std::optional<std::string> support_material{};
  bool in_inches = false;  // the span is in inches, and so are answers
  bool operator==(const RigInput&) const = default;
  bool states_supports() const { return supports || roller_radius; }
  // True if pins this tight never turn, for any friction of the specimen.
  bool pins_turn() const { return rollers != Rollers::pinned || *pin_friction * *pin_radius < *roller_radius; }
};

enum class FrictionModel { constant, drift, sinusoid, sinusoids, table, rough, surface, roughness };
enum class TraceDirection { outwards, inwards };  // along the specimen, from midspan

// One term of μ: amplitude cos(π S/wavelength + phase), (4.25).
struct WaveInput {
  double amplitude;               // [1] relative to mu0, in [0, 1]
  double wavelength;              // [m]
  std::optional<double> phase{};  // [rad] empty: 0
  bool operator==(const WaveInput&) const = default;
};

// The friction of a support: a model with parameters for a simulation, the model alone for a fit.
// case_file.cpp lists the parameters of each model.
struct FrictionInput {
  std::optional<FrictionModel> model{};
  std::optional<double> mu0{};                      // [1]
  std::optional<double> drift{}, reference{};       // [1/m], [m]: drift (S - reference); empty reference: the span
  std::optional<double> amplitude{}, wavelength{};  // of a single wave, as WaveInput
  std::optional<double> phase{};
  std::vector<WaveInput> waves{};
  std::optional<std::string> file{}, length{}, mu{};  // a table over S, as from an AFM, and the titles of its columns
  std::optional<double> rms{}, correlation_length{};  // [1] of ln μ, [m]
  std::optional<std::uint64_t> seed{};                // of the random numbers
  std::optional<std::string> trace{}, position{}, height{};  // a file with heights and its columns (read_trace)
  std::optional<double> trace_step{};                        // [m] spacing of the heights, for a file without positions
  std::optional<double> trace_begin{};                       // [m] from midspan; empty: half the span
  TraceDirection direction = TraceDirection::outwards;
  std::uint64_t level = 1;                        // degree of the subtracted polynomial
  std::optional<double> cutoff{}, edge_radius{};  // [m] of a filter; of the support, by default its rollers
  std::optional<double> static_excess{};          // [1] of static over kinetic friction
  std::optional<double> wear{};  // [1] share of friction that remains after a turn of the stage; empty: 1
  std::shared_ptr<const FrictionTable> points{};  // content of the file, once read: S [m] and μ
  bool operator==(const FrictionInput&) const = default;

  bool has_parameters() const { return mu0 || file; }
};

// Positions between which the stage moves; a repeated position is a rest. Or a path from a file.
struct StageInput {
  std::vector<double> program{};                       // [m] at least two
  std::uint64_t cycles = 1;                            // repetitions of all positions after the first
  std::optional<double> step{};                        // [m] empty: continuous, with exact snaps
  std::optional<std::string> file{}, stage{}, time{};  // and the titles of its columns
  char decimal = '.';
  std::optional<SnapRest> snaps{};  // in a simulation; empty: as in the rig
  bool operator==(const StageInput&) const = default;
};

// Where an export measures displacement: at the stage (with the load train) or at midspan.
enum class DisplacementOf { crosshead, deflection };
enum class SignRule { find, keep, reverse };
enum class FailureRule { find, none };
enum class ZeroWord { find, keep, slope };
enum class ContactWord { find, first_row };
using ForceZeroRule = std::variant<ZeroWord, double>;  // [N] to subtract
using ContactRule = std::variant<ContactWord, Known>;  // [m] displacement at first contact

// The start or end of a record: a row from 1, or where its stage or deflection reaches a value.
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

// A table with two named columns of stage, deflection and force, or the export of a machine.
struct RecordInput {
  std::string file{};
  std::optional<SheetChoice> sheet{};  // of a workbook; empty: the first sheet with a table of numbers
  // titles, in an export also numbers; length: sliding length over both supports, as imaged
  std::optional<std::string> stage{}, deflection{}, force{}, length{};
  std::optional<DisplacementOf> displacement{};  // empty: from the titles in the file
  std::optional<std::string> displacement_column{};
  std::optional<std::uint64_t> specimen{};   // from 1; empty: the only one
  std::optional<std::string> calibration{};  // of a force in volts, "222 N/V"
  std::optional<double> speed{};             // [m/s] of the crosshead, where the file has a time and no displacement
  SignRule sign = SignRule::find;
  ForceZeroRule zero = ZeroWord::find;
  std::optional<ContactRule> contact{};  // empty: found if the record begins before the contact
  std::optional<double> gain_error{}, preload_error{}, slow_force_error{};  // standard deviations: [1], [m], [1]
  FailureRule failure = FailureRule::find;
  std::optional<char> decimal{};
  std::optional<PlaceInRecord> first{}, until{};  // empty: the first row; before the failure
  // The columns of a call in memory, in SI and in the order above; `file` is a name for messages.
  std::shared_ptr<const Table> given{};
  bool operator==(const RecordInput&) const = default;

  bool is_export() const {
    return displacement || displacement_column || calibration || speed || !(stage || deflection);
  }
};

struct Test {
  std::string source{};                     // the name that the user gave
  bool reduced = false, by_flags = false;   // by_flags: stated by flags, for a data file
  std::optional<SpecimenInput> specimen{};  // this and the rig always exist in reduced tests
  std::optional<RigInput> rig{};
  std::optional<FrictionInput> friction{};
  std::optional<FrictionInput> other{};  // of the other support, [friction.other]; empty: the same friction
  std::optional<StageInput> stage{};
  std::optional<RecordInput> record{};
  // The line of each key, "specimen.diameter", "stage.program[1]"; absent keys have defaults.
  std::map<std::string, std::size_t, std::less<>> lines{};
  std::vector<std::string> changed{};  // keys from the command line, "rig.stiffness"
};

}  // namespace flexslip
