#include "surface/placement.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>

#include "numerics/elementary.h"
#include "numerics/fourier.h"
#include "surface/texture.h"

namespace flexslip {
namespace {

// The correlation of a short column with every stretch of a long one.
class Search {
 public:
  Search(const std::vector<double>& shorter, std::size_t longer)
      : n_(shorter.size()), padded_(power_of_two_from(longer + n_)) {
    double mean = 0;
    for (const double each : shorter) mean += each / static_cast<double>(n_);
    Complexes x(padded_, 0);
    for (std::size_t i = 0; i < n_; ++i) {
      x[i] = shorter[i] - mean;
      square_ += (shorter[i] - mean) * (shorter[i] - mean);
    }
    transformed_ = fourier(std::move(x));
    for (auto& each : transformed_) each = std::conj(each);
  }

  struct Found {
    std::size_t at;
    double correlation;
  };

  // The greatest, and where the stretch begins; of column and, as a second, the one of opposite sign in reverse.
  Found greatest(const std::vector<double>& longer) const {
    Complexes x(padded_, 0);
    for (std::size_t i = 0; i < longer.size(); ++i) x[i] = longer[i];
    x = fourier(std::move(x));
    for (std::size_t i = 0; i < padded_; ++i) x[i] *= transformed_[i];
    x = inverse_fourier(std::move(x));
    Found best{0, -2};
    double sum = 0, squares = 0;
    const auto n = static_cast<double>(n_);
    for (std::size_t i = 0; i < n_; ++i) {
      sum += longer[i];
      squares += longer[i] * longer[i];
    }
    double all = 0;
    for (const double each : longer) all += each * each;
    for (std::size_t at = 0; at + n_ <= longer.size(); ++at) {
      const double variance = std::max(squares - sum * sum / n, 1e-12 * all);
      const double correlation = x[at].real() / std::sqrt(variance * square_);
      if (correlation > best.correlation) best = {at, correlation};
      if (at + n_ == longer.size()) break;
      sum += longer[at + n_] - longer[at];
      squares += longer[at + n_] * longer[at + n_] - longer[at] * longer[at];
    }
    return best;
  }

 private:
  std::size_t n_, padded_;
  double square_ = 0;
  Complexes transformed_;
};

std::vector<double> turned_round(std::vector<double> slopes) {
  std::reverse(slopes.begin(), slopes.end());
  for (double& each : slopes) each = -each;
  return slopes;
}

// Columns with the spectrum of one and random phases. Coherent waves are kept whole, each with a phase of its own: to let them decay would make any
// two waves of one length seem to belong together.
class Surrogates {
 public:
  Surrogates(const std::vector<double>& of, std::uint64_t seed) : generator_(seed), rest_{0, 1, of} {
    constexpr std::size_t max_waves = 8, tapers = 7;
    while (of.size() >= fewest_heights && waves_.size() < max_waves) {
      const auto wave = coherent_wave_in(rest_, spectrum_of(rest_.height, 1, tapers));
      if (!wave) break;
      rest_ = without_wave(std::move(rest_), *wave);
      waves_.push_back(*wave);
    }
    Complexes x(power_of_two_from(2 * of.size()), 0);
    double mean = 0;
    for (const double each : rest_.height) mean += each / static_cast<double>(of.size());
    for (std::size_t i = 0; i < of.size(); ++i) x[i] = rest_.height[i] - mean;
    x = fourier(std::move(x));
    // As great as the rest, though the padded column is longer, and each part of a complex number has half of its square.
    const double kept = 2 * static_cast<double>(x.size()) / static_cast<double>(of.size());
    for (const auto& each : x) size_.push_back(std::sqrt(std::norm(each) * kept) / static_cast<double>(x.size()));
  }

  // Two of them: the real and the imaginary part of one transform.
  std::pair<std::vector<double>, std::vector<double>> next() {
    Complexes x(size_.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      const auto [sine, cosine] = elementary::sine_and_cosine(phase());
      x[i] = {size_[i] * cosine, size_[i] * sine};
    }
    x = fourier(std::move(x));
    HeightTrace one{0, 1, {}}, other{0, 1, {}};
    for (std::size_t i = 0; i < rest_.height.size(); ++i) {
      one.height.push_back(x[i].real());
      other.height.push_back(x[i].imag());
    }
    for (DominantWave wave : waves_) {  // with its other half turn, taken off is put on
      wave.phase = phase();
      one = without_wave(std::move(one), wave);
      wave.phase = phase();
      other = without_wave(std::move(other), wave);
    }
    return {std::move(one.height), std::move(other.height)};
  }

 private:
  double phase() { return 2 * std::numbers::pi * static_cast<double>(generator_() >> 11) * 0x1p-53; }

  std::mt19937_64 generator_;
  HeightTrace rest_;
  std::vector<DominantWave> waves_;
  std::vector<double> size_;
};

bool all_alike(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [&](double each) { return each == values.front(); });
}

}  // namespace

Placement placed(const Slopes& profile, const Slopes& trace, const PlacementOptions& options) {
  constexpr std::size_t fewest = 8, most = std::size_t{1} << 20;
  const std::size_t m = profile.value.size(), n = trace.value.size();
  if (std::min(m, n) < fewest || std::max(m, n) > most || !(std::abs(profile.step / trace.step - 1) < 1e-9))
    throw std::invalid_argument("slopes of " + std::to_string(m) + " places sought among " + std::to_string(n));
  if (all_alike(profile.value) || all_alike(trace.value))
    throw std::invalid_argument("slopes that are all alike lie nowhere");
  const bool profile_is_shorter = m <= n;
  // Turned: the trace, or in its stead the profile, whose slopes then are sought with the other sign from the other end.
  const std::vector<double>& shorter = profile_is_shorter ? profile.value : trace.value;
  const std::vector<double>& longer = profile_is_shorter ? trace.value : profile.value;
  const Search straight(shorter, longer.size()), turned(turned_round(shorter), longer.size());
  const auto first = straight.greatest(longer), second = turned.greatest(longer);
  Placement out{};
  out.turned = second.correlation > first.correlation;
  const auto best = out.turned ? second : first;
  out.correlation = best.correlation;
  const double shift = static_cast<double>(best.at) * trace.step;
  const double last = static_cast<double>(shorter.size() - 1) * trace.step;
  // Where the profile lies whose first slope is at profile.begin.
  if (profile_is_shorter)
    out.offset = out.turned ? trace.begin + shift + last + profile.begin : trace.begin + shift - profile.begin;
  else
    out.offset = out.turned ? trace.begin + last + profile.begin + shift : trace.begin - (profile.begin + shift);
  std::size_t reached = 0, drawn = 0;
  Surrogates surrogates(trace.value, options.seed);
  const auto reaches = [&](const std::vector<double>& surrogate) {
    if (profile_is_shorter)
      return std::max(straight.greatest(surrogate).correlation, turned.greatest(surrogate).correlation) >=
             out.correlation;
    return std::max(Search(surrogate, longer.size()).greatest(longer).correlation,
                    Search(turned_round(surrogate), longer.size()).greatest(longer).correlation) >= out.correlation;
  };
  while (drawn < options.surrogates) {
    const auto [one, other] = surrogates.next();
    reached += reaches(one) ? 1 : 0;
    if (++drawn == options.surrogates) break;
    reached += reaches(other) ? 1 : 0;
    ++drawn;
  }
  out.p_value = static_cast<double>(1 + reached) / static_cast<double>(1 + options.surrogates);
  return out;
}

Slopes averaged(const Slopes& slopes, double step) {
  if (!(step >= slopes.step * (1 - 1e-9)))
    throw std::invalid_argument("slopes at a distance of " + std::to_string(slopes.step) + " averaged over " +
                                std::to_string(step));
  // The heights, linear between the places; their differences over the new step.
  std::vector<double> height{0};
  for (const double each : slopes.value) height.push_back(height.back() + each * slopes.step);
  const auto height_at = [&](double x) {
    const double at = std::clamp(x / slopes.step, 0.0, static_cast<double>(slopes.value.size()));
    const auto i = std::min(static_cast<std::size_t>(at), slopes.value.size() - 1);
    return height[i] + (at - static_cast<double>(i)) * (height[i + 1] - height[i]);
  };
  const double all = slopes.step * static_cast<double>(slopes.value.size());
  const auto count = static_cast<std::size_t>(std::floor(all / step + 1e-9));
  Slopes out{slopes.begin + 0.5 * (step - slopes.step), step, {}};
  for (std::size_t i = 0; i < count; ++i)
    out.value.push_back((height_at(step * static_cast<double>(i + 1)) - height_at(step * static_cast<double>(i))) /
                        step);
  return out;
}

}  // namespace flexslip
