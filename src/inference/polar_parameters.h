// The parameters of a ForceModel as one speaks of them, and values at which they are held.
#pragma once

#include <vector>

#include <Eigen/Dense>

#include "inference/force_model.h"

namespace flexslip {

// Instead of cosine, sine and wavelength: amplitude relative to the mean [1], wavelength [L], and the phase [rad], continuous in
// both, at S_phase; the others as they are.
struct PolarParameters {
  double S_middle;  // [L] about which cosine and sine are meant
  double S_phase;   // [L] 0: φ of (4.25)

  Eigen::VectorXd from_cartesian(const ModelLayout& layout, const Eigen::VectorXd& p) const;
  Eigen::VectorXd to_cartesian(const ModelLayout& layout, const Eigen::VectorXd& q) const;
  // ∂p/∂q
  Eigen::MatrixXd directions(const ModelLayout& layout, const Eigen::VectorXd& p) const;
};

struct HeldParameter {
  Eigen::Index index;  // of the polar parameters
  double value;
};

// The directions in which a fit may move: all, those of the mean alone, or those in which some polar parameters stay.
class Freedom {
 public:
  explicit Freedom(const ModelLayout& layout);
  static Freedom of_the_mean(const ModelLayout& layout);
  Freedom(const ModelLayout& layout, const PolarParameters& polar, std::vector<HeldParameter> held);

  bool restricted() const { return !held_.empty(); }
  Eigen::VectorXd permitted(const Eigen::VectorXd& p) const;   // the nearest one, in polar parameters
  Eigen::MatrixXd directions(const Eigen::VectorXd& p) const;  // a column for each that is free
  Eigen::VectorXd moved(const Eigen::VectorXd& p, const Eigen::VectorXd& step) const;

 private:
  ModelLayout layout_;
  PolarParameters polar_{};
  std::vector<HeldParameter> held_;
  std::vector<Eigen::Index> free_;
};

}  // namespace flexslip
