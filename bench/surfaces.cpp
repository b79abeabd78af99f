// How often the intervals of a surface hold the truth: bench/surfaces TESTS simulates so many traces of each kind, lets an edge be drawn over them, turns
// them into friction and back, and prints a line of CSV for each kind of surface and radius of the edge, in percent.
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "numerics/elementary.h"
#include "numerics/fourier.h"
#include "surface/height_trace.h"
#include "surface/slope_friction.h"
#include "surface/texture.h"

namespace flexslip {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::size_t heights = 2048;
constexpr double step = 0.1, friction = 0.5;  // [µm], [1]

class Normal {
 public:
  explicit Normal(std::uint64_t seed) : generator_(seed) {}
  double operator()() {
    const double u = (static_cast<double>(generator_() >> 11) + 0.5) * 0x1p-53;
    return elementary::gaussian_quantile(std::clamp(u, 1e-11, 1 - 1e-11));
  }
  double uniform() { return (static_cast<double>(generator_() >> 11) + 0.5) * 0x1p-53; }

 private:
  std::mt19937_64 generator_;
};

struct Kind {
  const char* name;
  double rms, length;  // [µm] of the roughness; of its correlation: Gaussian exp(-(s/length)²), or exponential
  bool exponential;
  double amplitude, wavelength;  // [µm] of a wave
  double noise;                  // [µm] standard deviation of a reading
};

// [µm^3] One-sided, of the roughness.
double density_of(const Kind& kind, double f) {
  if (!kind.exponential)
    return 2 * kind.rms * kind.rms * std::sqrt(pi) * kind.length * std::exp(-std::pow(pi * f * kind.length, 2));
  const double rho = std::exp(-step / kind.length);
  return 2 * step * kind.rms * kind.rms * (1 - rho * rho) / (1 + rho * rho - 2 * rho * std::cos(2 * pi * f * step));
}

std::vector<double> surface_of(const Kind& kind, Normal& normal, std::size_t n) {
  std::vector<double> z(n, 0);
  if (kind.exponential) {
    const double rho = std::exp(-step / kind.length);
    double at = kind.rms * normal();
    for (double& each : z) {
      each = at;
      at = rho * at + kind.rms * std::sqrt(1 - rho * rho) * normal();
    }
  } else if (kind.rms > 0) {
    const std::size_t all = power_of_two_from(2 * n);
    const double df = 1 / (step * static_cast<double>(all));
    Complexes x(all, 0);
    for (std::size_t j = 1; j < all / 2; ++j) {
      const double deviation = std::sqrt(density_of(kind, df * static_cast<double>(j)) * df);
      const double re = normal(), im = normal();
      x[j] = {deviation * re, deviation * im};
    }
    x = fourier(std::move(x));
    for (std::size_t i = 0; i < n; ++i) z[i] = x[i].real();
  }
  const double phase = 2 * pi * normal.uniform();
  for (std::size_t i = 0; i < n; ++i)
    z[i] += kind.amplitude * std::cos(2 * pi * step * static_cast<double>(i) / kind.wavelength + phase);
  return z;
}

// There and back: the friction that an edge shows, its base as if it were not known, and the heights that explain it.
std::vector<double> there_and_back(const std::vector<double>& path) {
  std::vector<double> slope;
  const auto shown = friction_of_heights(path, step, friction).mu;
  const double base = base_friction(shown);
  for (const double mu : shown) slope.push_back(slope_of_friction(mu, base));
  return heights_of_slopes(slope, step);
}

struct Truth {
  std::vector<double> frequency, density;  // of the roughness as the edge climbs it
  double amplitude;                        // of the wave likewise
};

// What an edge makes of such surfaces: many of them, or their own where it is sharp.
Truth truth_of(const Kind& kind, double radius, int traces) {
  Truth truth{{}, {}, kind.amplitude};
  if (radius == 0 || kind.rms == 0) {
    const Spectrum grid = spectrum_of(std::vector<double>(heights, 0.0), step, 2);
    truth.frequency = grid.frequency;
    for (const double f : grid.frequency) truth.density.push_back(kind.rms == 0 ? 0 : density_of(kind, f));
    if (radius == 0) return truth;
  }
  Normal normal(777);
  truth.amplitude = 0;
  for (int trace = 0; trace < traces; ++trace) {
    std::vector<double> path = path_of_edge(surface_of(kind, normal, heights), step, radius);
    if (kind.amplitude > 0) {
      // Whole waves, so that the rest is orthogonal to them.
      const auto whole = static_cast<std::size_t>(
          std::floor(static_cast<double>(heights) * step / kind.wavelength) * kind.wavelength / step + 0.5);
      std::complex<double> sum = 0;
      for (std::size_t i = 0; i < whole; ++i)
        sum += path[i] * std::polar(1.0, -2 * pi * step * static_cast<double>(i) / kind.wavelength);
      sum *= 2.0 / static_cast<double>(whole);
      truth.amplitude += std::abs(sum) / traces;
      for (std::size_t i = 0; i < path.size(); ++i)
        path[i] -= (sum * std::polar(1.0, 2 * pi * step * static_cast<double>(i) / kind.wavelength)).real();
    }
    const Spectrum spectrum = spectrum_of(levelled({0, step, path}, 1).height, step, 7);
    truth.frequency = spectrum.frequency;
    truth.density.resize(spectrum.density.size());
    for (std::size_t j = 0; j < spectrum.density.size(); ++j) truth.density[j] += spectrum.density[j] / traces;
  }
  return truth;
}

double rms_of(const Truth& truth, const Kind& kind, double longest, double shortest, bool slope) {
  double square = 0;
  const double df = truth.frequency[1];
  for (std::size_t j = 1; j < truth.frequency.size(); ++j) {
    const double f = truth.frequency[j];
    const double inside =
        std::clamp((std::min(f + 0.5 * df, 1 / shortest) - std::max(f - 0.5 * df, 1 / longest)) / df, 0.0, 1.0);
    square += (slope ? 4 * pi * pi * f * f : 1) * truth.density[j] * df * inside;
  }
  if (kind.amplitude > 0) square += 0.5 * std::pow(truth.amplitude * (slope ? 2 * pi / kind.wavelength : 1), 2);
  return std::sqrt(square);
}

bool holds(const Estimate& e, double truth) { return e.low <= truth && truth <= e.high; }

int run(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: surfaces TESTS\n");
    return 2;
  }
  const int tests = std::atoi(arguments[1]);
  const std::vector<Kind> kinds{{"gaussian", 0.06, 1.0, false, 0, 1, 0},
                                {"exponential", 0.03, 2.0, true, 0, 1, 0},
                                {"sinusoidal", 0.01, 1.0, false, 0.11, 10.9, 0},
                                {"gaussian with noise", 0.06, 1.0, false, 0, 1, 0.006},
                                {"exponential with noise", 0.03, 2.0, true, 0, 1, 0.01},
                                {"sinusoid with noise", 0, 1.0, false, 0.11, 10.9, 0.05}};
  std::printf(
      "surface,radius_um,tests,slope,height,density,length,noise_found,waves_false,wave_found,amplitude,wavelength,"
      "mean_slope_over_truth\n");
  for (const Kind& kind : kinds)
    for (const double radius : {0.0, 1.0, 5.0}) {
      if (radius > 0 && kind.noise > 0) continue;  // noise is that of an instrument: no edge is drawn over it
      const Truth truth = truth_of(kind, radius, 2000);
      Normal normal(20260000 + static_cast<std::uint64_t>(10 * radius));
      double slope = 0, height = 0, density = 0, densities = 0, length = 0, lengths = 0, noisy = 0, falsely = 0,
             found = 0, amplitude = 0, wavelength = 0, ratio = 0;
      for (int test = 0; test < tests; ++test) {
        std::vector<double> path = path_of_edge(surface_of(kind, normal, heights), step, radius);
        if (kind.noise == 0) path = there_and_back(path);
        for (double& each : path) each += kind.noise * (kind.noise > 0 ? normal() : 0);
        const Texture texture = texture_of(levelled({0, step, path}, 1));
        const double true_slope = rms_of(truth, kind, texture.longest, texture.shortest, true);
        slope += holds(texture.rms_slope, true_slope);
        ratio += texture.rms_slope.value / true_slope;
        height += holds(texture.rms_height, rms_of(truth, kind, texture.longest, texture.shortest, false));
        const auto interval = density_interval(texture.spectrum.tapers);
        for (std::size_t j = 1; j < texture.spectrum.density.size(); j += 16) {
          const double f = texture.spectrum.frequency[j];
          if (f < 1 / texture.longest || f > 1 / texture.shortest) continue;
          if (kind.amplitude > 0 && std::abs(f - 1 / kind.wavelength) < 2 * texture.spectrum.half_bandwidth) continue;
          const double there = truth.density[static_cast<std::size_t>(std::lround(f / truth.frequency[1]))] +
                               2 * kind.noise * kind.noise * step;
          if (there < 1e-5 * *std::max_element(truth.density.begin() + 1, truth.density.end()))
            continue;  // tapers leak
          densities += 1;
          density += interval.low * texture.spectrum.density[j] <= there &&
                     there <= interval.high * texture.spectrum.density[j];
        }
        if (texture.correlation_length && kind.amplitude == 0 && radius == 0) {
          lengths += 1;
          length += holds(*texture.correlation_length, kind.length);
        }
        noisy += texture.continuum.noise_found;
        bool seen = false;
        for (const DominantWave& wave : texture.waves) {
          if (kind.amplitude > 0 && std::abs(wave.wavelength.value / kind.wavelength - 1) < 0.1 && !seen) {
            seen = true;
            found += 1;
            amplitude += holds(wave.amplitude, truth.amplitude);
            wavelength += holds(wave.wavelength, kind.wavelength);
          } else if (!(kind.amplitude > 0 && radius > 0 &&
                       wave.wavelength.value < 0.55 * kind.wavelength)) {  // overtones of a wave with rounded crests
            falsely += 1;
          }
        }
      }
      const double percent = 100.0 / tests;
      const auto share = [](double of, double all) { return all > 0 ? 100 * of / all : std::nan(""); };
      std::printf("%s,%g,%d,%.1f,%.1f,%.1f,%.1f,%.1f,%.1f,%.1f,%.1f,%.1f,%.4f\n", kind.name, radius, tests,
                  percent * slope, percent * height, share(density, densities), share(length, lengths), percent * noisy,
                  percent * falsely, kind.amplitude > 0 ? percent * found : std::nan(""), share(amplitude, found),
                  share(wavelength, found), ratio / tests);
      std::fflush(stdout);
    }
  return 0;
}

}  // namespace
}  // namespace flexslip

int main(int count, char** arguments) { return flexslip::run(count, arguments); }
