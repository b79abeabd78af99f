// The friction coefficient along the specimen, μ(S) with S the length between the supports, and
// Coulomb's law with a static excess.
//
// A point at arc length s from midspan touches the support when S = 2 s. A wave of length λ along
// the specimen therefore has the period 2 λ in S: hence π S/λ in (4.25). All lengths are in spans.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace flexslip {

// One periodic term of friction: amplitude cos(π S/wavelength + phase), relative to the mean.
struct Sinusoid {
  double amplitude;   // [1] relative to mu0, A of (4.25); >= 0
  double wavelength;  // [L] along the fibre, λ of (4.25); > 0
  double phase;       // [rad] φ of (4.25)
};

// mu0 (1 + Σ amplitude cos(π S/wavelength + phase)) + drift (S - S_reference), at least zero.
// Without terms and drift, constant friction.
struct FrictionWaves {
  double mu0;    // [1] mean coefficient of friction at S_reference
  double drift;  // [1/L] slope of the mean in S
  std::vector<Sinusoid> terms;
  double S_reference = 1;  // [L]
};

// Values at given lengths with monotone interpolation (no overshoot), constant beyond the ends.
struct FrictionTable {
  std::vector<double> S;   // [L] rising strictly
  std::vector<double> mu;  // [1] >= 0
};

// μ and dμ/dS at one length.
struct FrictionPoint {
  double mu;     // [1]
  double slope;  // [1/L]
};

struct FrictionArrays {
  std::vector<double> mu;     // [1]
  std::vector<double> slope;  // [1/L]
};

// A term in the form in which it is summed: height cos(2π (frequency S + phase)).
struct WaveTerm {
  double height;     // [1]
  double frequency;  // [1/L]
  double phase;      // [1] in turns
  double steepness;  // [1/L] maximum slope
};

// Friction that depends on the path by which the specimen reaches a length (two_supports.h,
// over_rollers.h); on one path, in or out.
class PathDependentFriction {
 public:
  virtual ~PathDependentFriction() = default;
  virtual FrictionPoint at(double S) const = 0;
  virtual FrictionArrays at(std::span<const double> S) const;
  virtual double smooth_scale() const = 0;
  virtual double end_of(double S, double scales, bool inwards) const {
    const double step = scales * smooth_scale();
    return inwards ? S + step : S - step;
  }
  virtual double max_up_to(double S_max) const = 0;
  virtual std::span<const double> knots() const = 0;
  // True if S is the sliding length rather than the contact point on the specimen.
  virtual bool is_met() const { return false; }

  // True if the specimen can continue from S in a direction, in (1) or out (-1). If not, it takes
  // the path that from() returns for S and q.
  virtual bool continues(double /*S*/, double /*direction*/) const { return true; }
  virtual std::shared_ptr<const PathDependentFriction> from(double /*S*/, double /*q*/, double /*direction*/) const {
    return nullptr;
  }
  virtual bool is_path_dependent() const { return false; }

  // The same friction multiplied by a factor.
  // Domain:     friction at points of the specimen; std::invalid_argument otherwise.
  virtual std::shared_ptr<const PathDependentFriction> scaled(double factor) const;
};

class TwoSupportPath;

class Friction {
 public:
  // Fails:      std::invalid_argument with the value if a number is not finite, a wavelength is
  //             below 1e-12, or μ could become negative (Σ amplitude > 1, or mu < 0 in a table).
  static Friction constant(double mu);
  static Friction sinusoid(double mu0, double amplitude, double wavelength, double phase);
  static Friction waves(FrictionWaves waves);
  static Friction table(FrictionTable table);

  // Random friction: μ = mu0 exp(g(S) - rms^2/2), with mean mu0. g is Gaussian with standard
  // deviation rms [1] and correlation exp(-(s/correlation_length)^2/2) along the specimen. The
  // table has eight points per correlation length [L] up to S_max [L]. A seed gives the same
  // profile on every machine.
  static Friction rough(double mu0, double rms, double correlation_length, std::uint64_t seed, double S_max);

  // Friction on two different supports, up to S_max (two_supports.h): the mean of both under a
  // fixed nose, and path-dependent friction under a free nose.
  static Friction mean_of(Friction left, Friction right, double S_max);
  static Friction on_two_supports(Friction left, Friction right, double S_max);

  // A table over the sliding length, for sliding in; on knife edges an ordinary table.
  static Friction as_met(FrictionTable table);
  bool is_met() const { return met_ || (way() && way()->is_met()); }

  static Friction path_dependent(std::shared_ptr<const PathDependentFriction> way) { return Friction(std::move(way)); }

  // The friction on the path from S and q, in (1) or out (-1). A single profile is unchanged.
  Friction from(double S, double q, double direction) const;
  bool continues(double S, double direction) const { return !way() || way()->continues(S, direction); }
  bool is_path_dependent() const { return way() && way()->is_path_dependent(); }
  const TwoSupportPath* two_supports() const;  // null except under a free nose

  // The friction times a factor along the specimen; the friction of roller pins does not change.
  // Domain:     factor finite, >= 0; as PathDependentFriction::scaled.
  Friction scaled(double factor) const;

  // Domain:     S > 0; a table is constant before its first knot.
  // Max error:  4 ulp of mu0, plus the error of the argument π S/λ. Tables are exact at knots.
  FrictionPoint at(double S) const;

  // The same at many lengths, vectorised: bit-identical, but 1e-12 over rollers.
  FrictionArrays at(std::span<const double> S) const;

  // μ without the lower limit zero, which only a drift can reach. Its zeros are the kinks of at().
  double without_limit(double S) const;
  bool may_reach_zero() const;
  double drift() const;  // [1/L] 0 except for waves

  // The maximum of μ for S in [1, S_max]; for waves an upper bound.
  // Domain:     S_max >= 1.
  double max_up_to(double S_max) const;

  // [1/L] An upper bound of |dμ/dS|.
  // Domain:     waves or a table; std::invalid_argument otherwise.
  double steepest() const;

  // The length in S within which the profile is smooth: a quarter of the shortest period for waves.
  // Infinite for constant friction and for tables, which are smooth between knots.
  double smooth_scale() const;
  std::span<const double> knots() const;
  bool has_corners() const { return way() != nullptr; }  // at its knots; a table is smooth there
  // True if the slope may jump at a knot, as it does at the ends of a table.
  bool has_corner_at(double knot) const;

  // The end of an interval of this many smooth scales, on the path in or out.
  double end_of(double S, double scales, bool inwards) const;

  using Form = std::variant<FrictionWaves, FrictionTable, std::shared_ptr<const PathDependentFriction>>;
  const Form& form() const { return form_; }

 private:
  explicit Friction(FrictionWaves waves);
  explicit Friction(FrictionTable table);
  explicit Friction(std::shared_ptr<const PathDependentFriction> way) : form_(std::move(way)) {}

  const PathDependentFriction* way() const;
  std::size_t piece_of(double S, std::size_t near) const;
  FrictionPoint in_table(double S, std::size_t piece) const;

  Form form_;
  bool met_ = false;  // a table over the sliding length
  std::vector<WaveTerm> terms_;
  std::vector<double> knot_slopes_;  // dμ/dS at each knot of a table
};

// The friction law at a support, for a resting and a sliding specimen.
//
// The paper uses Coulomb's law with one coefficient, |q| <= μ(S). A sawtooth then needs friction
// that varies along the specimen. With a static friction μ_s above the kinetic one, μ_k, the
// specimen sticks and slips on perfectly smooth supports, an alternative that the paper leaves
// open. A specimen at rest stays at rest while |q| <= μ_s(S). Sliding has q = ±μ_k(S) until it
// stops: when the stage reverses or stops, or a snap ends.

struct FrictionLaw {
  Friction kinetic;        // μ_k
  Friction static_excess;  // μ_s - μ_k; zero for Coulomb's law

  FrictionLaw(Friction coulomb)  // NOLINT(google-explicit-constructor): a friction is also a law
      : FrictionLaw(std::move(coulomb), Friction::constant(0)) {}
  FrictionLaw(Friction sliding, Friction excess) : kinetic(std::move(sliding)), static_excess(std::move(excess)) {}

  FrictionLaw scaled(double factor) const { return {kinetic.scaled(factor), static_excess.scaled(factor)}; }
};

// μ_s. Domain: S >= 1.
inline double static_friction(const FrictionLaw& law, double S) {
  return law.kinetic.at(S).mu + law.static_excess.at(S).mu;
}

}  // namespace flexslip
