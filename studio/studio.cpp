#include "studio/studio.h"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "bending_test/equilibrium.h"
#include "bending_test/history.h"
#include "bending_test/sliding_table.h"
#include "contact/over_rollers.h"
#include "data/names.h"
#include "data/scales.h"
#include "io/quantity.h"
#include "numerics/elementary.h"

namespace flexslip::studio {
namespace {

struct Box {
  const Kind* kind;
  Range range;
};
constexpr std::array boxes{Box{&kind::length, Range::positive},
                           Box{&kind::speed, Range::positive},
                           Box{&kind::stiffness, Range::positive_or_infinite},
                           Box{&kind::pressure, Range::positive},
                           Box{&kind::bending_stiffness, Range::positive},
                           Box{&kind::force, Range::any},
                           Box{&kind::time, Range::positive},
                           Box{&kind::angle, Range::any},
                           Box{&kind::number, Range::any}};

const Box& box_of(std::string_view name) {
  const auto* const box =
      std::find_if(boxes.begin(), boxes.end(), [&](const Box& each) { return each.kind->name == name; });
  if (box == boxes.end()) throw std::invalid_argument("no input has the kind " + std::string(name));
  return *box;
}

Scales scales_of(const RigInput& rig) { return {rig.span, rig.bending_stiffness}; }

Supports supports_of(const RigInput& rig, const Scales& scales) {
  const Supports supports{scales.reduced_length(rig.roller_radius), 0.5 * scales.reduced_length(rig.depth)};
  if (!(supports.radius + supports.half_depth < widest_supports))
    throw std::invalid_argument("the rollers, with half of the specimen's thickness, leave no span between them");
  return supports;
}

// The specimen on its supports. Tables of recent ones are kept (fibre/fibre.cpp).
Fibre fibre_on(const RigInput& rig, const Scales& scales) { return Fibre(supports_of(rig, scales)); }

// Fails:      throws std::invalid_argument if friction exceeds the limit of the fibre, as for a
//             case.
Friction friction_of(const RigInput& rig, const Scales& scales, const Fibre& fibre, double S_max) {
  FrictionTable table = rig.friction;
  for (double& S : table.S) S = scales.reduced_length(S);
  Friction friction = Friction::table(std::move(table));
  if (friction.max_up_to(S_max) > fibre.max_friction())
    throw std::invalid_argument("friction reaches " + std::to_string(friction.max_up_to(S_max)) + "; the limit is " +
                                std::to_string(fibre.max_friction()));
  return friction;
}

double drawn_in(const Scales& scales, double S) { return scales.physical_length(S - 1); }

void add(Loading& loading, const Scales& scales, double w, double F, double S, double q) {
  loading.deflection.push_back(scales.physical_length(w));
  loading.force.push_back(scales.physical_force(F));
  loading.drawn.push_back(drawn_in(scales, S));
  loading.friction.push_back(q);
}

State physical_state(const PathPoint& point, const Scales& scales) {
  return {scales.physical_length(point.w), scales.physical_force(point.F), drawn_in(scales, point.S), point.q};
}

// The axis from the contact to midspan. Its curvature follows from the moment of the support
// forces; the integration is Runge-Kutta.
std::vector<Point> half_axis(const SupportedState& state, double half_depth, Point from, int points) {
  constexpr int steps_a_point = 4;
  const auto [sine, cosine] = elementary::sine_and_cosine(state.theta0);
  const double upward = 0.5 * state.F;                         // on the left support
  const double inward = state.Pn * (sine - state.q * cosine);  // on the left support
  const double couple = state.q * state.Pn * half_depth;       // of friction at the surface
  struct Here {
    double x, y, slope;  // downward
  };
  const auto rate = [&](const Here& at) {
    const auto direction = elementary::sine_and_cosine(at.slope);
    const double moment = upward * (at.x - from.x) + inward * (from.y - at.y) + couple;
    return Here{direction.cosine, -direction.sine, -moment};
  };
  const auto moved = [](const Here& at, const Here& by, double h) {
    return Here{at.x + h * by.x, at.y + h * by.y, at.slope + h * by.slope};
  };
  Here at{from.x, from.y, state.theta0};
  std::vector<Point> axis{from};
  const double h = 0.5 * state.length / (points * steps_a_point);
  for (int i = 0; i < points; ++i) {
    for (int j = 0; j < steps_a_point; ++j) {
      const Here a = rate(at), b = rate(moved(at, a, 0.5 * h)), c = rate(moved(at, b, 0.5 * h)),
                 d = rate(moved(at, c, h));
      at = moved(moved(moved(at, a, h / 6), b, h / 3), c, h / 3);
      at = moved(at, d, h / 6);
    }
    axis.push_back({at.x, at.y});
  }
  return axis;
}

}  // namespace

Loading simulate(const RigInput& input, std::span<const double> programme, std::optional<double> step, int points) {
  constexpr int fewest = 2;
  if (programme.empty()) throw std::invalid_argument("the programme of the stage has no positions");
  const Scales scales = scales_of(input);
  const double farthest = scales.reduced_length(*std::max_element(programme.begin(), programme.end()));
  const double S_max = longest_at_stage(farthest);
  const Rig rig{scales.reduced_stiffness(input.stiffness), fibre_on(input, scales)};
  const BendingTest test{friction_of(input, scales, rig.fibre, S_max), rig};

  const std::vector<double> positions =
      step ? stage_steps(programme, *step) : std::vector<double>(programme.begin(), programme.end());
  std::vector<double> stages;
  stages.reserve(positions.size());
  for (const double position : positions) stages.push_back(scales.reduced_length(position));
  const History history =
      step ? follow_in_steps(test, stages) : follow_continuously(test, stages, std::max(points, fewest));

  Loading loading;
  loading.status =
      name_in_order<HistoryStatus::contact_lost>(history.status, {"ok", "slipped_through", "contact_lost"});
  for (std::size_t i = 0; i < history.path.size(); ++i) {
    const PathPoint& point = history.path[i];
    loading.stage.push_back(step ? positions[i] : scales.physical_length(point.stage));
    add(loading, scales, point.w, point.F, point.S, point.q);
    loading.motion.push_back(static_cast<std::uint8_t>(point.motion));
  }
  for (const Snap& snap : history.snaps)
    loading.snaps.push_back(
        {scales.physical_length(snap.stage), physical_state(snap.before, scales), physical_state(snap.after, scales)});
  return loading;
}

Loading sketch(const RigInput& input, double farthest, int steps) {
  constexpr double lengths = 1500;  // about 40 per period of friction
  if (!(farthest > 0) || steps < 2) throw std::invalid_argument("the sketch has no stage positions");
  const Scales scales = scales_of(input);
  const double end = scales.reduced_length(farthest);
  const double S_max = std::min(longest_at_stage(end), longest_ladder);
  const Fibre fibre = fibre_on(input, scales);
  const Friction of_specimen = friction_of(input, scales, fibre, S_max);
  const Friction friction = met_without_knots(of_specimen, fibre, 1).value_or(of_specimen);
  const SlidingLadder ladder(S_max, 2 * (S_max - 1) / lengths, fibre);
  const auto S = ladder.lengths();
  const std::vector<double> mu = friction.at(S).mu;
  const StateArrays curve = ladder.curve(mu);
  const double compliance = 1 / scales.reduced_stiffness(input.stiffness);
  if (!(curve.w.back() + compliance * curve.F.back() >= end))
    throw std::invalid_argument("the specimen does not reach this stage position");

  std::vector<double> stages;
  for (int i = 0; i <= steps; ++i) stages.push_back(end * i / steps);
  const std::vector<double> forces = measured_curve(curve.w, curve.F, compliance, stages);
  Loading loading;
  loading.status = "ok";
  std::size_t place = 0;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const double w = stages[i] - compliance * forces[i];
    while (place + 1 < S.size() && curve.w[place] < w) ++place;
    loading.stage.push_back(scales.physical_length(stages[i]));
    add(loading, scales, w, forces[i], S[place], mu[place]);
  }
  return loading;
}

Loading equilibrium(const RigInput& rig, double longest, int points) {
  const Scales scales = scales_of(rig);
  const double S_max = scales.reduced_length(longest);
  const Fibre fibre = fibre_on(rig, scales);
  const Friction friction = friction_of(rig, scales, fibre, S_max);
  const EquilibriumCurve curve = equilibrium_curve(friction, Sliding::in, S_max, points, fibre);
  Loading loading;
  loading.status = name_in_order<EquilibriumStatus::branch_ended>(curve.status, {"ok", "branch_ended"});
  for (const EquilibriumPoint& point : curve.points) {
    add(loading, scales, point.w, point.F, point.S, point.q);
    loading.stage.push_back(loading.deflection.back() + loading.force.back() / rig.stiffness);
    loading.motion.push_back(static_cast<std::uint8_t>(Motion::slip_in));
  }
  return loading;
}

Shape shape(const RigInput& rig, double deflection, double friction, int points, double beyond) {
  if (points < 2) throw std::invalid_argument("the shape has fewer than two points");
  const Scales scales = scales_of(rig);
  const Supports supports = fibre_on(rig, scales).supports();
  const SupportedState state = state_on_supports(scales.reduced_length(deflection), friction, supports);
  if (state.status != FibreStatus::ok)
    throw std::invalid_argument("the specimen has no equilibrium at this deflection and friction");
  const auto [sine, cosine] = elementary::sine_and_cosine(state.theta0);
  // the axis turns about the support at this distance
  const double radius = supports.radius + supports.half_depth;
  const Point left{-0.5 + radius * sine, -radius * (1 - cosine)};
  const std::vector<Point> half = half_axis(state, supports.half_depth, left, (points + 1) / 2);

  const auto at = [&](double x, double y) { return Point{scales.physical_length(x), scales.physical_length(y)}; };
  const double rest = std::max(scales.reduced_length(beyond) - 0.5 * state.slid, 0.0);
  const Point end{left.x - rest * cosine, left.y + rest * sine};
  Shape result;
  result.axis.push_back(at(end.x, end.y));
  for (const Point& point : half) result.axis.push_back(at(point.x, point.y));
  for (auto point = half.rbegin() + 1; point != half.rend(); ++point) result.axis.push_back(at(-point->x, point->y));
  result.axis.push_back(at(-end.x, end.y));
  result.left = at(left.x, left.y);
  result.right = at(-left.x, left.y);
  result.slope = state.theta0;
  result.normal = scales.physical_force(state.Pn);
  result.tangential = scales.physical_force(state.q * state.Pn);
  result.force = scales.physical_force(state.F);
  result.slid = scales.physical_length(state.slid);
  return result;
}

double quantity(std::string_view words, std::string_view kind) {
  const Box& box = box_of(kind);
  return parse_quantity(words, *box.kind, box.range);
}

double unit(std::string_view words, std::string_view kind) { return to_si(1, parse_unit(words, *box_of(kind).kind)); }

double euler_bernoulli(const RigInput& rig, double deflection) {
  const Scales scales = scales_of(rig);
  return scales.physical_force(48 * scales.reduced_length(deflection));
}

}  // namespace flexslip::studio
