// The coefficient of friction along the fibre, as the support sees it: μ as a function of the length S between the supports.
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

#include "contact/friction_forms.h"
#include "contact/friction_on_a_way.h"

namespace flexslip {

class Walk;

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

  // Of two supports that are not alike, from where the fibre is straight, up to a length S_most (two_supports.h).
  static Friction on_two_supports(Friction left, Friction right, double S_most);

  // A table over what has been drawn in, as a fibre on rollers meets it on the way in: on edges a table.
  static Friction as_met(FrictionTable table);
  bool is_met() const { return met_ || (way() && way()->is_met()); }

  static Friction on_a_way(std::shared_ptr<const FrictionOnAWay> way) { return Friction(std::move(way)); }

  // The friction on a way that leads on from a length and a mobilised friction, in (1) or out (-1): of one profile, the same.
  Friction from(double S, double q, double direction) const;
  bool leads(double S, double direction) const { return !way() || way()->leads(S, direction); }
  bool depends_on_way() const { return way() && way()->depends_on_way(); }  // changes where the fibre turns back
  // Does the fibre stick where it turns back, until friction is exhausted? Else it creeps.
  bool lets_stick() const { return !way() || way()->lets_stick(); }
  // Of the beginning of a test of a thick specimen: what builds up stays as it is at the length 1.
  Friction at_the_beginning() const { return lets_stick() ? *this : constant(std::abs(at(1).mu)); }
  const Walk* walk() const;  // none of one profile

  // Domain: S > 0; a table is constant before its first knot.
  // Max error: 4 ulp of mu0, besides that of the argument π S/λ of the cosines. Tables reproduce their values exactly.
  FrictionPoint at(double S) const;

  // The same at many lengths, bit by bit, on the widest vectors that the processor has.
  FrictionArrays at(std::span<const double> S) const;

  // What μ would be, were it not held at zero: its zeros are the kinks of at(). Only a drift brings them about.
  double unheld(double S) const;
  bool may_be_held() const;
  double drift() const;  // [1/L] 0 of all but waves

  // The greatest μ at lengths from 1 to S_max: of a table to rounding; of waves a bound, their crests on the greatest mean.
  // Domain: S_max >= 1.
  double most_up_to(double S_max) const;

  // [1/L] A bound on how steep the profile is, |dμ/dS|.
  // Domain: waves or a table; std::invalid_argument otherwise.
  double steepest() const;

  // Lengths in S within which the profile is smooth and bends little: a quarter of the shortest period for waves
  // (infinite for constant friction, and infinite for tables, too, which are smooth between their knots).
  double smooth_scale() const;
  std::span<const double> knots() const;
  bool has_corners() const { return way() != nullptr; }  // at its knots, at which a table is smooth

  // The end of a stretch of so many smooth scales, on the way in or out: infinite as these are.
  double end_of(double S, double scales, bool inwards) const;

  using Form = std::variant<FrictionWaves, FrictionTable, std::shared_ptr<const FrictionOnAWay>>;
  const Form& form() const { return form_; }

 private:
  explicit Friction(FrictionWaves waves);
  explicit Friction(FrictionTable table);
  explicit Friction(std::shared_ptr<const FrictionOnAWay> way) : form_(std::move(way)) {}

  const FrictionOnAWay* way() const;
  FrictionPoint in_table(double S) const;

  Form form_;
  bool met_ = false;  // a table as_met
  std::vector<WaveTerm> terms_;
  std::vector<double> knot_slopes_;  // dμ/dS at each knot of a table
};

}  // namespace flexslip
