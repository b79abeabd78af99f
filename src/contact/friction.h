// The coefficient of friction along the fibre, as the support sees it: μ as a function of the length S between the supports;
// and Coulomb's law with a static excess.
//
// A point of the fibre at arc length s from midspan meets the support when S = 2 s, so a wave of length λ along the fibre
// has the period 2 λ in S: hence π S/λ in (4.25). All lengths are in spans.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace flexslip {

// The forms that a profile of friction may have, and what it is at a length.

// One term of the roughness: amplitude cos(π S/wavelength + phase), relative to the mean.
struct Sinusoid {
  double amplitude;   // [1] relative to mu0, A of (4.25); >= 0
  double wavelength;  // [L] along the fibre, λ of (4.25); > 0
  double phase;       // [rad] φ of (4.25)
};

// mu0 (1 + Σ amplitude cos(π S/wavelength + phase)) + drift (S - S_reference), and zero where a drift would carry it below.
// Without terms and drift: constant friction.
struct FrictionWaves {
  double mu0;    // [1] mean coefficient of friction at S_reference
  double drift;  // [1/L] slope of the mean in S
  std::vector<Sinusoid> terms;
  double S_reference = 1;  // [L]
};

// Values at given lengths, interpolated monotonically (no over- or undershoot), constant beyond the ends.
struct FrictionTable {
  std::vector<double> S;   // [L] rising strictly
  std::vector<double> mu;  // [1] >= 0
};

// μ and dμ/dS at one length.
struct FrictionPoint {
  double mu;     // [1]
  double slope;  // [1/L]
};

// The same at many lengths.
struct FrictionArrays {
  std::vector<double> mu;     // [1]
  std::vector<double> slope;  // [1/L]
};

// A term as it is summed: height cos(2π (frequency S + phase)).
struct WaveTerm {
  double height;     // [1]
  double frequency;  // [1/L]
  double phase;      // [1] in turns
  double steepness;  // [1/L] the greatest slope
};

// Friction that is more than a profile: it depends on the way on which the fibre gets to a length.

// Friction as it is met on a way, in or out, from the lengths of which it makes more than a profile (two_supports.h, over_rollers.h).
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
  // As the fibre meets it, at what has been drawn in: else of the points of the specimen.
  virtual bool is_met() const { return false; }

  // May a fibre that is at a length slide on in a direction, in (1) or out (-1)? If not it takes the way from there, and from its q.
  virtual bool continues(double /*S*/, double /*direction*/) const { return true; }
  virtual std::shared_ptr<const PathDependentFriction> from(double /*S*/, double /*q*/, double /*direction*/) const {
    return nullptr;
  }
  virtual bool depends_on_way() const { return false; }

  // Of a specimen on which it is so many times as large.
  // Domain: friction that is its points' own; std::invalid_argument otherwise.
  virtual std::shared_ptr<const PathDependentFriction> scaled(double factor) const;
};

class TwoSupportPath;

class Friction {
 public:
  // Fails: std::invalid_argument, naming the value, if a number is not finite, a wavelength below 1e-12, or μ could
  // become negative: mu0 Σ amplitude > mu0, or mu < 0 in a table.
  static Friction constant(double mu);
  static Friction sinusoid(double mu0, double amplitude, double wavelength, double phase);
  static Friction waves(FrictionWaves waves);
  static Friction table(FrictionTable table);

  // Random roughness: μ = mu0 exp(g(S) - rms^2/2) with g Gaussian, of standard deviation rms [1] and correlation
  // exp(-(s/correlation_length)^2/2) along the fibre; the mean is mu0. Tabulated eight times a correlation length [L] up to
  // S_max [L]. The same seed gives the same profile on every machine.
  static Friction rough(double mu0, double rms, double correlation_length, std::uint64_t seed, double S_max);

  // Of two unlike supports, up to a length S_most (two_supports.h): the mean of both, under a nose that holds; the friction of a way, under a free one.
  static Friction mean_of(Friction left, Friction right, double S_most);
  static Friction on_two_supports(Friction left, Friction right, double S_most);

  // A table over what has been drawn in, as a fibre on rollers meets it on the way in: on edges a table.
  static Friction as_met(FrictionTable table);
  bool is_met() const { return met_ || (way() && way()->is_met()); }

  static Friction path_dependent(std::shared_ptr<const PathDependentFriction> way) { return Friction(std::move(way)); }

  // The friction on a way that leads on from a length and a mobilised friction, in (1) or out (-1): of one profile, the same.
  Friction from(double S, double q, double direction) const;
  bool continues(double S, double direction) const { return !way() || way()->continues(S, direction); }
  bool depends_on_way() const { return way() && way()->depends_on_way(); }  // changes where the fibre turns back
  const TwoSupportPath* two_supports() const;                               // none but under a free nose

  // So many times as large everywhere along the specimen: of rollers on pins, the friction of the pins stays.
  // Domain: factor finite and >= 0, friction of the points of a specimen; std::invalid_argument otherwise.
  Friction scaled(double factor) const;

  // Domain: S > 0; a table is constant before its first knot.
  // Max error: 4 ulp of mu0, besides that of the argument π S/λ of the cosines. Tables reproduce their values exactly.
  FrictionPoint at(double S) const;

  // The same at many lengths, on the widest vectors that the processor has: bit by bit, but over rollers to 1e-12.
  FrictionArrays at(std::span<const double> S) const;

  // What μ would be, were it not held at zero: its zeros are the kinks of at(). Only a drift brings them about.
  double unheld(double S) const;
  bool may_be_held() const;
  double drift() const;  // [1/L] 0 of all but waves

  // The greatest μ at lengths from 1 to S_max: of a table to rounding; of waves a bound, their crests on the greatest mean.
  // Domain: S_max >= 1.
  double max_up_to(double S_max) const;

  // [1/L] A bound on how steep the profile is, |dμ/dS|.
  // Domain: waves or a table; std::invalid_argument otherwise.
  double steepest() const;

  // Lengths in S within which the profile is smooth and bends little: a quarter of the shortest period for waves
  // (infinite for constant friction, and infinite for tables, too, which are smooth between their knots).
  double smooth_scale() const;
  std::span<const double> knots() const;
  bool has_corners() const { return way() != nullptr; }  // at its knots, at which a table is smooth
  // May the slope jump at a knot? That of a table does at its ends, beyond which it is constant.
  bool has_corner_at(double knot) const;

  // The end of a stretch of so many smooth scales, on the way in or out: infinite as these are.
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
  bool met_ = false;  // a table as_met
  std::vector<WaveTerm> terms_;
  std::vector<double> knot_slopes_;  // dμ/dS at each knot of a table
};

// What a support does to the fibre: it holds it while at rest, and rubs while it slides.
//
// Coulomb's law with one coefficient, |q| <= μ(S), is the paper's; there a sawtooth needs a friction that varies along the
// fibre. With a static friction above the kinetic one the fibre sticks and slips on supports as smooth as one likes: the
// alternative that the paper leaves open. A fibre at rest stays so while |q| <= μ_s(S). Once it slides, q = ±μ_k(S) until
// the sliding stops: when the stage turns back or halts, or a snap comes to rest.

struct FrictionLaw {
  Friction kinetic;        // μ_k
  Friction static_excess;  // μ_s - μ_k; zero: Coulomb's law

  FrictionLaw(Friction coulomb)  // NOLINT(google-explicit-constructor): a friction is a law by itself
      : FrictionLaw(std::move(coulomb), Friction::constant(0)) {}
  FrictionLaw(Friction sliding, Friction excess) : kinetic(std::move(sliding)), static_excess(std::move(excess)) {}

  FrictionLaw scaled(double factor) const { return {kinetic.scaled(factor), static_excess.scaled(factor)}; }
};

// μ_s. Domain: S >= 1.
inline double static_friction(const FrictionLaw& law, double S) {
  return law.kinetic.at(S).mu + law.static_excess.at(S).mu;
}

}  // namespace flexslip
