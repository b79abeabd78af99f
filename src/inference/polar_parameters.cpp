#include "inference/polar_parameters.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace flexslip {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A wave is a cos x + b sin x = h cos(x + φ), x = π (S - S_middle)/λ, with a = h cos φ, b = -h sin φ and h = A μ0.

VectorXd PolarParameters::from_cartesian(const ModelLayout& layout, const VectorXd& p) const {
  VectorXd q = p;
  for (Index wave = 0; wave < layout.waves; ++wave) {
    const Index at = layout.wave(wave);
    const double turned = std::numbers::pi * (S_middle - S_phase) / p[at + 2];
    q.segment(at, 3) << std::hypot(p[at], p[at + 1]) / p[0], p[at + 2], std::atan2(-p[at + 1], p[at]) - turned;
  }
  return q;
}

VectorXd PolarParameters::to_cartesian(const ModelLayout& layout, const VectorXd& q) const {
  VectorXd p = q;
  for (Index wave = 0; wave < layout.waves; ++wave) {
    const Index at = layout.wave(wave);
    const double phase = q[at + 2] + std::numbers::pi * (S_middle - S_phase) / q[at + 1];
    p.segment(at, 3) << q[at] * q[0] * std::cos(phase), -q[at] * q[0] * std::sin(phase), q[at + 1];
  }
  return p;
}

MatrixXd PolarParameters::directions(const ModelLayout& layout, const VectorXd& p) const {
  MatrixXd T = MatrixXd::Identity(p.size(), p.size());
  for (Index wave = 0; wave < layout.waves; ++wave) {
    const Index at = layout.wave(wave);
    const double a = p[at];
    const double b = p[at + 1];
    const double wavelength = p[at + 2];
    const double amplitude = std::max(std::hypot(a, b) / p[0], 1e-12);
    const double turn = -std::numbers::pi * (S_middle - S_phase) / (wavelength * wavelength);
    T.block(at, 0, 2, 1) << a / p[0], b / p[0];
    T.block(at, at, 3, 3) << a / amplitude, b * turn, b, b / amplitude, -a * turn, -a, 0, 1, 0;
  }
  return T;
}

Freedom::Freedom(const ModelLayout& layout) : Freedom(layout, {}, {}) {}

Freedom::Freedom(const ModelLayout& layout, const PolarParameters& polar, std::vector<HeldParameter> held)
    : layout_(layout), polar_(polar), held_(std::move(held)) {
  for (Index i = 0; i < layout.size(); ++i)
    if (std::none_of(held_.begin(), held_.end(), [&](const auto& h) { return h.index == i; })) free_.push_back(i);
}

Freedom Freedom::of_the_mean(const ModelLayout& layout) {
  Freedom freedom(layout);
  freedom.free_.resize(static_cast<std::size_t>(layout.wave(0)));
  return freedom;
}

VectorXd Freedom::permitted(const VectorXd& p) const {
  if (!restricted()) return p;
  VectorXd q = polar_.from_cartesian(layout_, p);
  for (const auto& held : held_) q[held.index] = held.value;
  return polar_.to_cartesian(layout_, q);
}

MatrixXd Freedom::directions(const VectorXd& p) const {
  const MatrixXd all = restricted() ? polar_.directions(layout_, p) : MatrixXd::Identity(p.size(), p.size());
  MatrixXd free(p.size(), static_cast<Index>(free_.size()));
  for (std::size_t i = 0; i < free_.size(); ++i) free.col(static_cast<Index>(i)) = all.col(free_[i]);
  return free;
}

VectorXd Freedom::moved(const VectorXd& p, const VectorXd& step) const {
  VectorXd q = restricted() ? polar_.from_cartesian(layout_, p) : p;
  for (std::size_t i = 0; i < free_.size(); ++i) q[free_[i]] += step[static_cast<Index>(i)];
  for (const auto& held : held_) q[held.index] = held.value;
  return restricted() ? polar_.to_cartesian(layout_, q) : q;
}

}  // namespace flexslip
