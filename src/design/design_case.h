// A test that is being planned: the numbers of a case that a designer may change, and the design they make.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "bending_test/design.h"
#include "case/case_file.h"
#include "data/scales.h"
#include "data/section.h"
#include "design/design_parameter.h"
#include "io/input_error.h"
#include "io/quantity.h"

namespace flexslip {

// Why numbers make no design.
enum class DesignFault {
  impossible,      // there is no such test: a specimen too thick for its span, a rig too soft to bend it
  not_computable,  // beyond what FlexSlip can compute: friction above largest_q, roughness too fine
};

struct DesignRefusal {
  DesignFault fault;
  InputError error;
};

// What makes numbers of the case of those of a design.
struct DesignUnits {
  Scales scales;
  std::optional<SurfaceStrain> surface;  // none without a section
};

struct PlannedDesign {
  Design design;
  DesignUnits units;
};

// A case whose numbers can be varied. Values in SI, or in the model's scaled variables if the case is reduced.
class DesignCase {
 public:
  // Domain:     a case to simulate, with specimen, rig, friction and [stage], whose farthest position is the travel and
  //             whose step is the step.
  // Fails:      InputError, naming the key, for what is not there or cannot be loaded once: a measured programme, one that turns
  //             back before its farthest position, static friction above the kinetic one, snaps that overshoot.
  explicit DesignCase(const Case& input);

  bool reduced() const { return input_->reduced; }
  const Case& given() const { return *input_; }
  Kind shown_as(const Kind& kind) const { return kind_in(*input_, kind); }  // as in case_file.h

  // Does the case have this parameter? A table of friction has no wavelength, a rectangular section height and width and no
  // diameter, a reduced case neither span nor modulus. Of friction, mu0 is one with any waves, reference only if the case states it (else it is the span, whatever that is), and amplitude,
  // wavelength and phase are those of a single one; tables and rough profiles are used as they are. Those of a section count only if the
  // bending stiffness follows from them.
  bool has(DesignParameter parameter) const;
  double value(DesignParameter parameter) const;
  // Fails:      InputError if the case does not have it, or the value is out of its range.
  // Cost:       a few ns. Whether the numbers go together is told by plan().
  void set(DesignParameter parameter, double value);

  // What the numbers as they are now make: it can be computed (outcome_of) if it is not refused.
  // Cost:       below 1 µs, but for tables and rough profiles.
  std::variant<PlannedDesign, DesignRefusal> plan() const;
  // [1/L] from which the specimen wraps the nose (problem.h).
  double nose_curvature(const Scales& scales) const;
  // [1] Friction at which rollers turn on their pins, as these are now; none of others.
  std::optional<double> pin_limit() const;
  // [m/N] of the supports (problem.h).
  double support_compliance() const { return support_compliance_; }
  // Fails:      InputError if it is refused.
  PlannedDesign planned() const;

 private:
  static constexpr std::size_t count = static_cast<std::size_t>(DesignParameter::pin_friction) + 1;
  struct Value {
    bool exists = false;
    double number = 0;
  };
  // A table of friction whose lengths [L] are those of the case as it was read.
  using Profile = std::variant<WavyFriction, FrictionTable, RoughFriction>;

  Value& at(DesignParameter parameter) { return values_[static_cast<std::size_t>(parameter)]; }
  const Value& at(DesignParameter parameter) const { return values_[static_cast<std::size_t>(parameter)]; }
  void add(DesignParameter parameter, double number) { at(parameter) = {true, number}; }
  RigInput rig() const;
  std::optional<Section> section() const;
  std::optional<SurfaceStrain> surface(const Scales& scales) const;
  double bending_stiffness() const;
  std::optional<Scales> scales() const;
  std::optional<DesignRefusal> fault_of_specimen() const;
  std::optional<DesignRefusal> fault_of_pins() const;
  std::optional<DesignRefusal> fault_of_loading(const Scales& scales) const;
  static Profile profile_of(const FrictionProfileInput& input, const Friction& friction);
  Profile varied_profile() const;
  std::optional<DesignRefusal> fault_of_roughness(const Profile& profile, const Scales& scales, double S_max) const;
  Friction friction(const Profile& profile, const Scales& scales, double S_max) const;
  DesignRefusal refusal(DesignFault fault, DesignParameter parameter, std::string expected) const;

  std::shared_ptr<const Case> input_;  // what does not vary
  std::array<Value, count> values_{};
  double span_;                    // [m] as it was read
  double bending_stiffness_ = 0;   // [N m^2] likewise
  double support_compliance_ = 0;  // [m/N]
  Profile profile_;                // the numbers that vary are in values_
  std::optional<Profile> other_;   // of the other support, which does not vary
};

}  // namespace flexslip
