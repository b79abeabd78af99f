// Compiled once for each instruction set (Highway's foreach_target.h).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "contact/friction.cpp"
#include "contact/friction.h"

#include <hwy/foreach_target.h>  // must come before highway.h

#include "contact/waves-inl.h"

HWY_BEFORE_NAMESPACE();
namespace flexslip::HWY_NAMESPACE {

void sum_waves(const FrictionWaves& waves, const WaveTerm* terms, const double* S, std::size_t count, double* mu,
               double* slope) {
  for_each_lanes(S, S, count, [&](std::size_t i, std::size_t n, Lanes lengths, Lanes) HWY_ATTR {
    const auto sum = held(wave_sum<Lanes>(waves, terms, lengths));
    store(sum.mu, mu + i, n);
    store(sum.slope, slope + i, n);
  });
}

}  // namespace flexslip::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>

#include "contact/two_supports.h"
#include "numerics/elementary.h"
#include "numerics/polynomial.h"

namespace flexslip {
namespace {

using HWY_NAMESPACE::held;
using HWY_NAMESPACE::wave_sum;

HWY_EXPORT(sum_waves);

[[noreturn]] void refuse(const std::string& what, double value) {
  throw std::invalid_argument(what + ", not " + std::to_string(value));
}

// Slopes at the knots for a monotone cubic interpolant: Fritsch & Butland (1984) in the weighted
// harmonic form of Fritsch & Carlson's PCHIP; limited three-point slopes at the ends.
std::vector<double> monotone_slopes(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t n = x.size();
  std::vector<double> slope(n, 0.0);
  if (n < 2) return slope;
  const auto chord = [&](std::size_t i) { return (y[i + 1] - y[i]) / (x[i + 1] - x[i]); };
  if (n == 2) return {chord(0), chord(0)};
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double left = chord(i - 1);
    const double right = chord(i);
    if (left * right <= 0) continue;
    const double h_left = x[i] - x[i - 1];
    const double h_right = x[i + 1] - x[i];
    const double w_left = 2 * h_right + h_left;
    const double w_right = h_right + 2 * h_left;
    slope[i] = (w_left + w_right) / (w_left / left + w_right / right);
  }
  const auto end_slope = [](double h0, double h1, double d0, double d1) {
    const double three_point = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
    if (three_point * d0 <= 0) return 0.0;
    return d0 * d1 <= 0 && std::abs(three_point) > 3 * std::abs(d0) ? 3 * d0 : three_point;
  };
  slope[0] = end_slope(x[1] - x[0], x[2] - x[1], chord(0), chord(1));
  slope[n - 1] = end_slope(x[n - 1] - x[n - 2], x[n - 2] - x[n - 3], chord(n - 2), chord(n - 3));
  return slope;
}

}  // namespace

Friction::Friction(FrictionWaves waves) {
  if (!(waves.mu0 >= 0 && waves.mu0 < infinity))
    refuse("the mean coefficient of friction mu0 must be finite and >= 0", waves.mu0);
  if (!std::isfinite(waves.S_reference)) refuse("the length of reference must be finite", waves.S_reference);
  if (!std::isfinite(waves.drift)) refuse("the drift of friction must be finite", waves.drift);
  double total = 0;
  for (const auto& term : waves.terms) {
    if (!(term.amplitude >= 0)) refuse("an amplitude of friction must be >= 0", term.amplitude);
    if (!(term.wavelength > 0 && term.wavelength < infinity))
      refuse("a wavelength of friction must be > 0", term.wavelength);
    constexpr double min_wavelength = 1e-12;  // shorter waves are lost in the rounding of S
    if (term.wavelength < min_wavelength)
      throw std::invalid_argument("a wavelength of friction of " + std::to_string(1e12 * term.wavelength) +
                                  "e-12 spans is shorter than 1e-12 spans, the rounding of lengths");
    if (!std::isfinite(term.phase)) refuse("a phase of friction must be finite", term.phase);
    total += term.amplitude;
    const double height = waves.mu0 * term.amplitude;
    terms_.push_back({.height = height,
                      .frequency = 0.5 / term.wavelength,
                      .phase = term.phase / (2 * std::numbers::pi),
                      .steepness = height * std::numbers::pi / term.wavelength});
  }
  if (!(total <= 1)) refuse("friction would become negative: its relative amplitudes must add up to at most 1", total);
  form_ = std::move(waves);
}

Friction::Friction(FrictionTable table) {
  if (table.S.empty() || table.S.size() != table.mu.size())
    throw std::invalid_argument("a friction table needs as many lengths as values, and at least one: it has " +
                                std::to_string(table.S.size()) + " and " + std::to_string(table.mu.size()));
  for (std::size_t i = 0; i < table.S.size(); ++i) {
    if (!std::isfinite(table.S[i])) refuse("a length of the friction table must be finite", table.S[i]);
    if (!(table.mu[i] >= 0 && table.mu[i] < infinity))
      refuse("friction in a table must be finite and >= 0", table.mu[i]);
    if (i > 0 && !(table.S[i] > table.S[i - 1]))
      refuse("the lengths of a friction table must rise strictly", table.S[i]);
  }
  knot_slopes_ = monotone_slopes(table.S, table.mu);
  form_ = std::move(table);
}

Friction Friction::constant(double mu) { return Friction(FrictionWaves{.mu0 = mu, .drift = 0, .terms = {}}); }

Friction Friction::sinusoid(double mu0, double amplitude, double wavelength, double phase) {
  return Friction(FrictionWaves{.mu0 = mu0, .drift = 0, .terms = {{amplitude, wavelength, phase}}});
}

Friction Friction::waves(FrictionWaves waves) { return Friction(std::move(waves)); }

Friction Friction::table(FrictionTable table) { return Friction(std::move(table)); }

Friction Friction::rough(double mu0, double rms, double correlation_length, std::uint64_t seed, double S_max) {
  if (!(rms >= 0 && rms < infinity)) refuse("the roughness of friction must be finite and >= 0", rms);
  if (!(correlation_length > 0 && correlation_length < infinity))
    refuse("the correlation length of friction must be finite and > 0", correlation_length);
  if (!(S_max > 1 && S_max < infinity)) refuse("the end of a rough profile must be > 1", S_max);
  constexpr std::size_t per_length = 8;
  // the kernel below is exp(-16) at four correlation lengths
  constexpr std::size_t reach = 4 * per_length;
  // S advances by twice the length along the specimen.
  const double step = 2 * correlation_length / static_cast<double>(per_length);
  constexpr double max_knots = 1e6;
  if (!((S_max - 1) / step < max_knots))
    refuse("a rough profile has at most 1e6 knots: the correlation length is too short", correlation_length);
  const auto n = static_cast<std::size_t>(std::ceil((S_max - 1) / step)) + 1;

  // White noise filtered by a Gaussian kernel of width correlation_length/√2 has the stated
  // correlation. Normal numbers are computed here (Box & Muller) because std::normal_distribution
  // differs between libraries.
  std::mt19937_64 generator(seed);
  const auto uniform = [&] { return (static_cast<double>(generator() >> 11) + 0.5) * 0x1p-53; };
  std::vector<double> noise(n + 2 * reach);
  for (auto& value : noise) {
    // the first of two random numbers
    const double radius = std::sqrt(-2 * elementary::log(uniform()));
    value = radius * elementary::sine_and_cosine(2 * std::numbers::pi * uniform()).cosine;
  }
  std::vector<double> kernel(2 * reach + 1);
  double power = 0;
  for (std::size_t j = 0; j < kernel.size(); ++j) {
    const double x = (static_cast<double>(j) - static_cast<double>(reach)) / static_cast<double>(per_length);
    kernel[j] = elementary::exp(-x * x);
    power += elementary::exp(-2 * x * x);
  }

  FrictionTable table;
  for (std::size_t i = 0; i < n; ++i) {
    double g = 0;
    for (std::size_t j = 0; j < kernel.size(); ++j) g += kernel[j] * noise[i + j];
    table.S.push_back(1 + step * static_cast<double>(i));
    table.mu.push_back(mu0 * elementary::exp(rms * g / std::sqrt(power) - 0.5 * rms * rms));
  }
  return Friction(std::move(table));
}

Friction Friction::mean_of(Friction left, Friction right, double S_max) {
  return Friction(std::make_shared<const MeanOfSides>(std::move(left), std::move(right), S_max));
}

Friction Friction::on_two_supports(Friction left, Friction right, double S_max) {
  return Friction(
      std::make_shared<const TwoSupportPath>(std::move(left), std::move(right), ContactPoints{0, 0}, S_max));
}

Friction Friction::as_met(FrictionTable table) {
  Friction friction(std::move(table));
  friction.met_ = true;
  return friction;
}

Friction Friction::from(double S, double q, double direction) const {
  auto onward = way() ? way()->from(S, q, direction) : nullptr;
  return onward ? Friction(std::move(onward)) : *this;
}

std::shared_ptr<const PathDependentFriction> PathDependentFriction::scaled(double /*factor*/) const {
  throw std::invalid_argument("only friction of the points of a specimen can be scaled");
}

Friction Friction::scaled(double factor) const {
  if (way()) return Friction(way()->scaled(factor));
  if (const auto* own = std::get_if<FrictionTable>(&form_)) {
    FrictionTable table = *own;
    for (double& mu : table.mu) mu *= factor;
    Friction scaled(std::move(table));
    scaled.met_ = met_;
    return scaled;
  }
  FrictionWaves waves = std::get<FrictionWaves>(form_);
  waves.mu0 *= factor;
  waves.drift *= factor;
  return Friction(std::move(waves));
}

const PathDependentFriction* Friction::way() const {
  const auto* way = std::get_if<std::shared_ptr<const PathDependentFriction>>(&form_);
  return way ? way->get() : nullptr;
}

const TwoSupportPath* Friction::two_supports() const { return dynamic_cast<const TwoSupportPath*>(way()); }

FrictionPoint Friction::at(double S) const {
  if (way()) return way()->at(S);
  if (std::holds_alternative<FrictionTable>(form_)) return in_table(S, piece_of(S, 0));
  const auto [mu, slope] = held(wave_sum<double>(std::get<FrictionWaves>(form_), terms_.data(), S));
  return {mu, slope};
}

FrictionArrays Friction::at(std::span<const double> S) const {
  FrictionArrays result{std::vector<double>(S.size()), std::vector<double>(S.size())};
  if (const auto* waves = std::get_if<FrictionWaves>(&form_)) {
    HWY_DYNAMIC_DISPATCH(sum_waves)
    (*waves, terms_.data(), S.data(), S.size(), result.mu.data(), result.slope.data());
    return result;
  }
  if (way()) return way()->at(S);
  std::size_t piece = 0;
  for (std::size_t i = 0; i < S.size(); ++i) {
    piece = piece_of(S[i], piece);
    const auto [mu, slope] = in_table(S[i], piece);
    result.mu[i] = mu;
    result.slope[i] = slope;
  }
  return result;
}

FrictionArrays PathDependentFriction::at(std::span<const double> S) const {
  FrictionArrays result;
  for (const double each : S) {
    const auto [mu, slope] = at(each);
    result.mu.push_back(mu);
    result.slope.push_back(slope);
  }
  return result;
}

// The piece of a table that contains S, searched first at `near` and the next; 0 outside the table.
std::size_t Friction::piece_of(double S, std::size_t near) const {
  const std::vector<double>& x = std::get<FrictionTable>(form_).S;
  if (!(S > x.front() && S < x.back())) return 0;
  for (std::size_t i = near; i < near + 2 && i + 1 < x.size(); ++i)
    if (x[i] <= S && S < x[i + 1]) return i;
  return static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), S) - x.begin()) - 1;
}

FrictionPoint Friction::in_table(double S, std::size_t piece) const {
  const auto& [x, y] = std::get<FrictionTable>(form_);
  if (S <= x.front()) return {y.front(), 0};
  if (S >= x.back()) return {y.back(), 0};
  const std::size_t next = piece + 1;
  const double h = x[next] - x[piece];
  const Cubic cubic(y[piece], y[next], knot_slopes_[piece] * h, knot_slopes_[next] * h);
  const auto [mu, slope] = cubic.at((S - x[piece]) / h);
  return {std::max(mu, 0.0), slope / h};
}

double Friction::without_limit(double S) const {
  if (!may_reach_zero()) return at(S).mu;
  return wave_sum<double>(std::get<FrictionWaves>(form_), terms_.data(), S).mu;
}

double Friction::drift() const {
  const auto* waves = std::get_if<FrictionWaves>(&form_);
  return waves ? waves->drift : 0;
}

bool Friction::may_reach_zero() const { return drift() != 0; }

double Friction::max_up_to(double S_max) const {
  if (way()) return way()->max_up_to(S_max);
  if (const auto* table = std::get_if<FrictionTable>(&form_)) {
    double max_mu = std::max(at(1).mu, at(S_max).mu);  // monotone between the knots
    for (std::size_t i = 0; i < table->S.size(); ++i)
      if (table->S[i] > 1 && table->S[i] < S_max) max_mu = std::max(max_mu, table->mu[i]);
    return max_mu;
  }
  const auto& waves = std::get<FrictionWaves>(form_);
  double max_mu = waves.mu0 + waves.drift * ((waves.drift > 0 ? S_max : 1) - waves.S_reference);
  for (const WaveTerm& term : terms_) max_mu += term.height;
  return std::max(max_mu, 0.0);
}

double Friction::steepest() const {
  if (way()) throw std::invalid_argument("the friction of a way has no bound on its slope");
  if (const auto* table = std::get_if<FrictionTable>(&form_)) {
    double max_mu = 0;
    for (std::size_t i = 0; i + 1 < table->S.size(); ++i) {
      const double rise = (table->mu[i + 1] - table->mu[i]) / (table->S[i + 1] - table->S[i]);
      // A monotone cubic is steepest at an end, or at its middle with 3/2 of its mean slope.
      max_mu = std::max({max_mu, std::abs(knot_slopes_[i]), std::abs(knot_slopes_[i + 1]), 1.5 * std::abs(rise)});
    }
    return max_mu;
  }
  double max_mu = std::abs(drift());
  for (const WaveTerm& term : terms_) max_mu += term.steepness;
  return max_mu;
}

double Friction::smooth_scale() const {
  if (way()) return way()->smooth_scale();
  double highest = 0;
  for (const WaveTerm& term : terms_) highest = std::max(highest, term.frequency);
  return highest > 0 ? 0.25 / highest : infinity;
}

double Friction::end_of(double S, double scales, bool inwards) const {
  if (way()) return way()->end_of(S, scales, inwards);
  const double step = scales * smooth_scale();
  return inwards ? S + step : S - step;
}

std::span<const double> Friction::knots() const {
  if (way()) return way()->knots();
  const auto* table = std::get_if<FrictionTable>(&form_);
  return table ? std::span<const double>(table->S) : std::span<const double>();
}

bool Friction::has_corner_at(double knot) const {
  const auto all = knots();
  return has_corners() ? std::binary_search(all.begin(), all.end(), knot)
                       : !all.empty() && (knot == all.front() || knot == all.back());
}

}  // namespace flexslip

#endif  // HWY_ONCE
