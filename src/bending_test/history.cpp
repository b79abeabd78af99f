#include "bending_test/history.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "fibre/elastica.h"

namespace flexslip {
namespace {

PathPoint path_point(const RigPoint& point, Motion motion) {
  return {point.stage, point.w, point.F, point.S, point.q, motion};
}

// Work along the sliding curve from one length to another: of friction, and of the force on the stage position.
struct CurveWork {
  double friction;  // ∫ q P_n dS
  double stage;     // ∫ F dG
};

// Gauss-Legendre quadrature of order 10 in σ, on pieces over which the roughness bends little: 1e-12 of the integral.
CurveWork work_between(const LoadingCurve& curve, double S_from, double S_to) {
  constexpr std::array<double, 5> x{0.14887433898163122, 0.43339539412924719, 0.67940956829902441, 0.86506336668898451,
                                    0.97390652851717172};
  constexpr std::array<double, 5> weight{0.29552422471475287, 0.26926671930999636, 0.21908636251598204,
                                         0.14945134915058059, 0.06667134430868814};
  const double c = 1 / curve.rig.stiffness;
  CurveWork work{0, 0};
  // A drift may hold friction at zero on a part of the way: the kink where it begins is closed in by halving.
  const auto has_kink = [&](double a, double b) {
    int zeros = 0;
    for (const double fraction : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const double sigma = a + fraction * (b - a);
      zeros += curve.friction.at(1 + sigma * sigma).mu == 0;
    }
    return zeros > 0 && zeros < 5;
  };
  const auto add = [&](auto&& self, double a, double b, int halvings) -> void {
    constexpr int most_halvings = 24;  // a piece 1e-7 of the whole, in which the error is far below the quadrature's
    if (halvings < most_halvings && has_kink(a, b)) {
      self(self, a, 0.5 * (a + b), halvings + 1);
      self(self, 0.5 * (a + b), b, halvings + 1);
      return;
    }
    for (std::size_t i = 0; i < x.size(); ++i)
      for (const double sign : {-1.0, 1.0}) {
        const double sigma = 0.5 * (a + b) + sign * 0.5 * (b - a) * x[i];
        const double S = 1 + sigma * sigma;
        const auto mu = curve.friction.at(S);
        const auto [state, slopes] = fibre_state_slopes(S, mu.mu);
        const double G_S = slopes.w_S + c * slopes.F_S + (slopes.w_q + c * slopes.F_q) * mu.slope;
        const double dS = 0.5 * (b - a) * weight[i] * 2 * sigma;
        work.friction += mu.mu * state.Pn * dS;
        work.stage += state.F * G_S * dS;
      }
  };
  const auto knots = curve.friction.knots();
  for (double S = S_from; S < S_to;) {
    const double sigma = std::sqrt(S - 1);
    const auto knot = std::upper_bound(knots.begin(), knots.end(), S);
    const double next_knot = knot == knots.end() ? S_to : *knot;
    const double next =
        std::min({S_to, S + curve.friction.smooth_scale(), 1 + (sigma + 0.125) * (sigma + 0.125), next_knot});
    add(add, sigma, std::sqrt(next - 1), 0);
    S = next;
  }
  return work;
}

// A rig so soft that the fibre bends by less than a millionth of its span loses the digits of S - 1.
void require_bending(const Rig& rig, double stage_max) {
  if (!(stage_max / (1 + 48 / rig.stiffness) >= 1e-6))
    throw std::invalid_argument("the rig is too soft, or moved too little, to bend the fibre: its stiffness is " +
                                std::to_string(rig.stiffness) + " EI/L^3");
}

// Follows the stable parts of a traced curve.
class Loading {
 public:
  Loading(const Friction& friction, const Rig& rig, double stage_max)
      : curve_(trace_loading_curve(friction, rig, longest_at_stage(stage_max))), parts_(stable_parts(curve_)) {}

  // Loads to a stage position, through any snaps on the way. False if there is no equilibrium.
  bool load_to(double stage) {
    Motion motion = Motion::slip_in;
    while (parts_[part_].to.stage < stage) {
      if (at_last_part()) return false;
      snap();
      motion = Motion::snap;
    }
    const RigPoint point = point_at_stage(curve_, parts_[part_], stage);
    S_ = point.S;
    history_.path.push_back(path_point(point, motion));
    return true;
  }

  const StablePart& part() const { return parts_[part_]; }
  bool at_last_part() const { return part_ + 1 == parts_.size(); }

  // From the end of this stable part to the start of the next.
  void snap() {
    const RigPoint& before = parts_[part_].to;
    slide(parts_[part_].from.S, before.S);
    const RigPoint& after = parts_[++part_].from;
    history_.snaps.push_back({before.stage, path_point(before, Motion::slip_in), path_point(after, Motion::snap)});
    const auto work = work_between(curve_, before.S, after.S);
    history_.energy.friction += work.friction;
    history_.energy.snaps -= work.stage;
    S_ = after.S;
  }

  void move_to(const RigPoint& point) { S_ = point.S; }

  void record(const RigPoint& point, Motion motion) { history_.path.push_back(path_point(point, motion)); }

  const LoadingCurve& curve() const { return curve_; }

  History finish(HistoryStatus status) {
    slide(parts_[part_].from.S, S_);
    const auto point = point_at_length(curve_, S_);
    auto& energy = history_.energy;
    energy.bending = fibre_state(S_, point.q).U;
    energy.load_train = 0.5 * point.F * point.F / curve_.rig.stiffness;
    energy.imbalance = energy.stage_work - (energy.bending + energy.load_train + energy.friction + energy.snaps);
    history_.status = status;
    return std::move(history_);
  }

 private:
  void slide(double S_from, double S_to) {
    const auto work = work_between(curve_, S_from, S_to);
    history_.energy.friction += work.friction;
    history_.energy.stage_work += work.stage;
  }

  LoadingCurve curve_;
  std::vector<StablePart> parts_;
  std::size_t part_ = 0;
  double S_ = 1;
  History history_{};
};

}  // namespace

History load_in_steps(const Friction& friction, const Rig& rig, std::span<const double> stages) {
  double previous = 0;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    if (!(stages[i] >= previous && std::isfinite(stages[i])))
      throw std::invalid_argument("stage position " + std::to_string(i) +
                                  " must be finite and not below the one before: it is " + std::to_string(stages[i]));
    previous = stages[i];
  }
  if (!(previous > 0)) throw std::invalid_argument("the stage programme has no position above 0");
  require_bending(rig, previous);
  Loading loading(friction, rig, previous);
  for (const double stage : stages)
    if (!loading.load_to(stage)) return loading.finish(HistoryStatus::slipped_through);
  return loading.finish(HistoryStatus::ok);
}

History load_continuously(const Friction& friction, const Rig& rig, double stage_max, int n) {
  if (!(stage_max > 0))
    throw std::invalid_argument("the stage must move to a position above 0, not " + std::to_string(stage_max));
  if (n < 2) throw std::invalid_argument("a stable part needs at least 2 points, not " + std::to_string(n));
  require_bending(rig, stage_max);
  Loading loading(friction, rig, stage_max);
  while (true) {
    const StablePart& part = loading.part();
    const bool reaches = part.to.stage >= stage_max;
    const RigPoint to = reaches ? point_at_stage(loading.curve(), part, stage_max) : part.to;
    loading.record(part.from, part.from.S > 1 ? Motion::snap : Motion::slip_in);
    for (int i = 1; i < n - 1; ++i) {
      const double low = std::sqrt(part.from.S - 1);
      const double sigma = low + (std::sqrt(to.S - 1) - low) * i / (n - 1);
      loading.record(point_at_length(loading.curve(), 1 + sigma * sigma), Motion::slip_in);
    }
    loading.record(to, Motion::slip_in);
    loading.move_to(to);
    if (reaches) return loading.finish(HistoryStatus::ok);
    if (loading.at_last_part()) return loading.finish(HistoryStatus::slipped_through);
    loading.snap();
  }
}

}  // namespace flexslip
