// What a case says of friction, [friction]. Units: those of a physical case (case_file.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace flexslip {

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

enum class TraceDirection { outwards, inwards };  // along the specimen, seen from midspan

// μ from the slopes of a surface that the support climbs: a height trace at a friction of the flat surface.
struct SurfaceFriction {
  double mu0;                           // [1] of the flat surface, > 0
  std::string trace;                    // a file, relative to the working directory
  std::string position{}, height{};     // its columns, as read_trace takes them; empty: found
  std::optional<double> trace_step{};   // [m] between heights, of a file without positions
  std::optional<double> trace_begin{};  // [m] from midspan, where the trace begins; none: half of the span
  TraceDirection direction = TraceDirection::outwards;
  std::size_t level = 1;                // degree of the polynomial that is taken off
  std::optional<double> cutoff{};       // [m] of a filter that takes shorter waves out
  std::optional<double> edge_radius{};  // [m] of the support; none: that of its rollers, or a sharp edge
  bool operator==(const SurfaceFriction&) const = default;
};

using FrictionProfileInput = std::variant<WavyFriction, TabulatedFriction, RoughFriction, SurfaceFriction>;

enum class FrictionModel { constant, drift, sinusoid, sinusoids, table, rough, surface, roughness };

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

}  // namespace flexslip
