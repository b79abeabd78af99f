#include "inference/profile.h"

#include <algorithm>
#include <cmath>

#include "data/names.h"
#include "fibre/batch_inverse.h"
#include "fibre/elastica.h"
#include "numerics/elementary.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

// The friction at length S on the load line of a stage position, w + F/k = stage, clamped to the
// domain of the map.
double friction_on_load_line(double S, double stage, const Rig& rig, double start) {
  const double c = 1 / rig.stiffness;
  double q = start;
  for (int iteration = 0; iteration < 50; ++iteration) {
    const auto [state, slopes] = rig.fibre.state_slopes(S, q);
    if (state.status != FibreStatus::ok) return q;
    const double next = held_friction(rig.fibre, q - (state.w + c * state.F - stage) / (slopes.w_q + c * slopes.F_q));
    const bool done = std::abs(next - q) <= 1e-12 * (1 + q);  // far below the resolution of a measurement
    q = next;
    if (done) break;
  }
  return q;
}

// Derivatives of friction in force and deflection, and of the length in the force at fixed stage
// position.
struct ToldSlopes {
  double q_F, q_w;  // [L^2/EI], [1/L]
  double S_force;   // [L^3/EI]
};

ProfilePoint point_of(std::size_t index, const FibreState& told, double F, const ToldSlopes& slopes, const Rig& rig,
                      const MeasurementErrors& errors) {
  return {.index = index,
          .S = told.S,
          .length = rig.fibre.length_between_contacts(told),
          .imaged = rig.fibre.imaged_length(told),
          .mu = told.q,
          .from_force =
              errors.force * std::abs(slopes.q_F - slopes.q_w / rig.stiffness),  // an error of F is also an error of w
          .from_bending_stiffness =
              errors.bending_stiffness * std::abs(F * slopes.q_F),  // EI enters through the scaling of F
          .from_contact = errors.contact * std::abs(slopes.q_w),
          .S_force = slopes.S_force};
}

}  // namespace

double held_friction(const Fibre& fibre, double mu) { return std::clamp(mu, 0.0, fibre.max_friction()); }

double standard_error(const ProfilePoint& point) {
  return elementary::length(elementary::length(point.from_force, point.from_bending_stiffness), point.from_contact);
}

ReadStates read_states(const ReducedRecord& record, const Fibre& fibre, double least) {
  ReadStates read;
  std::vector<std::size_t> rows;
  std::vector<double> deflections, forces;
  for (std::size_t i = 0; i < record.force.size(); ++i) {
    if (!(record.deflection[i] > least)) continue;
    if (record.force[i] < 0) {
      read.unexplained.push_back(i);
      continue;
    }
    rows.push_back(i);
    deflections.push_back(record.deflection[i]);
    forces.push_back(record.force[i]);
  }
  const InverseArrays states = fibre.states_from_forces(deflections, forces);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (std::isnan(states.q[i])) {
      read.unexplained.push_back(rows[i]);
      continue;
    }
    read.rows.push_back(rows[i]);
    read.S.push_back(states.S[i]);
    read.q.push_back(states.q[i]);
  }
  std::sort(read.unexplained.begin(), read.unexplained.end());
  return read;
}

FrictionProfile measure_friction(const ReducedRecord& record, const Rig& rig, const MeasurementErrors& errors,
                                 double min_deflection) {
  const Fibre& fibre = rig.fibre;
  const ReadStates read = read_states(record, fibre, min_informative_deflection(fibre, min_deflection));
  FrictionProfile profile{.points = {}, .unexplained = read.unexplained};
  const SlopeArrays slopes = fibre.states_slopes({read.S, read.q});
  for (std::size_t i = 0; i < read.rows.size(); ++i) {
    // The inverse of the Jacobian of Ψ: its second row.
    const double jacobian = slopes.w_S[i] * slopes.F_q[i] - slopes.w_q[i] * slopes.F_S[i];
    const double q_F = slopes.w_S[i] / jacobian;
    const double q_w = -slopes.F_S[i] / jacobian;
    const double S_force = (-slopes.w_q[i] - slopes.F_q[i] / rig.stiffness) / jacobian;
    profile.points.push_back(point_of(read.rows[i], fibre.state(read.S[i], read.q[i]), record.force[read.rows[i]],
                                      {q_F, q_w, S_force}, rig, errors));
  }
  return profile;
}

double min_informative_deflection(const Fibre& fibre, double min_deflection) {
  return std::max(min_deflection, least_half_depths * fibre.supports().half_depth);
}

double max_curvature(const FrictionProfile& profile, const Fibre& fibre) {
  double greatest = not_a_number;
  for (const auto& point : profile.points)
    greatest = std::fmax(greatest, fibre.curvature_at_midspan(fibre.state(point.S, point.mu)));
  return greatest;
}

FrictionTable replay_table(const ReducedRecord& record, const Rig& rig, const FrictionProfile& profile,
                           std::span<const Drop> drops) {
  std::vector<ProfilePoint> points;
  std::vector<double> lengths;
  for (const auto& point : profile.points)
    if (record.deflection[point.index] > min_friction_deflection) {
      points.push_back(point);
      lengths.push_back(point.S);
    }
  lengths = non_falling(lengths);
  // Noise makes some lengths equal; the minimum distance is far below the resolution.
  constexpr double min_distance = 2e-6;
  for (std::size_t i = 1; i < lengths.size(); ++i) lengths[i] = std::max(lengths[i], lengths[i - 1] + min_distance);

  FrictionTable table;
  auto drop = drops.begin();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double stage = record.stage[points[i].index];
    const double mu = friction_on_load_line(lengths[i], stage, rig, held_friction(rig.fibre, points[i].mu));
    while (drop != drops.end() && drop->after < points[i].index) ++drop;
    const bool falls = i > 0 && drop != drops.end() && drop->before < points[i].index && drop->after >= points[i].index;
    if (falls) {
      const double depth = 0.25 * std::max(std::abs(mu - table.mu.back()), 0.01);
      const double from = table.S.back();
      for (const double part : {0.25, 0.5, 0.75}) {
        const double S = from + part * (lengths[i] - from);
        const double on_line = friction_on_load_line(S, stage, rig, mu);
        table.S.push_back(S);
        table.mu.push_back(std::max(on_line - depth * (part == 0.5 ? 1.0 : 0.7), 0.0));
      }
    }
    table.S.push_back(lengths[i]);
    table.mu.push_back(mu);
  }
  return table;
}

SuspectReport find_suspects(const ReducedRecord& record, const FrictionProfile& profile, double limit) {
  SuspectReport report{.limit = limit};
  for (const double deflection : record.deflection) report.points_judged += deflection > min_judged_deflection;
  for (const auto& point : profile.points)
    if (record.deflection[point.index] > min_judged_deflection && point.mu > limit)
      report.points.push_back(point.index);
  report.suspect = 20 * report.points.size() > report.points_judged;
  return report;
}

ImagedLength compare_with_images(const FrictionProfile& profile, std::span<const double> pulled_in) {
  constexpr double none = not_a_number;
  ImagedLength compared{{}, normal_estimate(none, none), none};
  std::vector<double> differences;
  for (const auto& point : profile.points) {
    if (!(point.index < pulled_in.size()) || !std::isfinite(pulled_in[point.index])) continue;
    compared.points.push_back({point.index, point.imaged - 1, pulled_in[point.index]});
    differences.push_back(point.imaged - 1 - pulled_in[point.index]);
  }
  if (differences.empty()) return compared;
  const double offset = median_of(differences);
  for (double& difference : differences) difference = std::abs(difference - offset);
  compared.scatter = deviation_by_median * median_of(differences);
  constexpr double of_a_median = 1.2533;  // standard error of a median / of a mean
  compared.offset =
      normal_estimate(offset, of_a_median * compared.scatter / std::sqrt(static_cast<double>(differences.size())));
  return compared;
}

std::string_view name_of(SlipVerdict verdict) {
  return name_in_order<SlipVerdict::too_short>(
      verdict, {"possible", "unexplained", "implausible", "negative", "moves_out", "too_short"});
}

std::vector<Slip> slips_of(const FrictionProfile& profile, std::span<const Drop> drops, const MeasurementErrors& errors,
                           double limit) {
  const auto find = [&](std::size_t index) -> const ProfilePoint* {
    const auto at = std::lower_bound(profile.points.begin(), profile.points.end(), index,
                                     [](const ProfilePoint& point, std::size_t i) { return point.index < i; });
    return at == profile.points.end() || at->index != index ? nullptr : &*at;
  };
  std::vector<Slip> slips;
  for (std::size_t i = 0; i < drops.size(); ++i) {
    const Drop& drop = drops[i];
    const ProfilePoint* const before = find(drop.before);
    const ProfilePoint* const after = find(drop.after);
    if (!before || !after) {
      const bool is_told = std::binary_search(profile.unexplained.begin(), profile.unexplained.end(), drop.before) ||
                           std::binary_search(profile.unexplained.begin(), profile.unexplained.end(), drop.after);
      slips.push_back({drop, is_told ? SlipVerdict::unexplained : SlipVerdict::too_short, not_a_number, not_a_number,
                       not_a_number, not_a_number, not_a_number});
      continue;
    }
    Slip slip{drop,
              SlipVerdict::possible,
              before->S,
              after->S,
              before->mu,
              after->mu,
              elementary::length(errors.force * before->S_force, errors.force * after->S_force)};
    const double advance = slip.S_after - slip.S_before;
    if (advance < -two_sided_95 * slip.advance_error)
      slip.verdict = SlipVerdict::moves_out;
    else if (slip.mu_before - two_sided_95 * standard_error(*before) > limit)
      slip.verdict = SlipVerdict::implausible;
    else if (slip.mu_after + two_sided_95 * standard_error(*after) < 0)
      slip.verdict = SlipVerdict::negative;
    else if (advance < slip.advance_error)
      slip.verdict = SlipVerdict::too_short;
    const ProfilePoint* const next = i + 1 < drops.size() ? find(drops[i + 1].before) : &profile.points.back();
    if (next)
      slip.can_be_crack =
          before->mu - next->mu > two_sided_95 * elementary::length(before->from_force, next->from_force);
    slips.push_back(slip);
  }
  return slips;
}

std::vector<Slip> with_friction_from(const FrictionProfile& profile, std::span<const Slip> judged,
                                     const MeasurementErrors& errors) {
  std::vector<Drop> drops;
  for (const Slip& slip : judged) drops.push_back(slip.drop);
  std::vector<Slip> told = slips_of(profile, drops, errors, infinity);
  for (std::size_t i = 0; i < told.size(); ++i) {
    told[i].verdict = judged[i].verdict;
    told[i].can_be_crack = judged[i].can_be_crack;
  }
  return told;
}

SlipSummary summarise(std::span<const Slip> all, Nose nose) {
  std::vector<Slip> slips;  // the possible slips
  for (const auto& slip : all)
    if (slip.verdict == SlipVerdict::possible && std::isfinite(slip.S_before)) slips.push_back(slip);
  std::vector<double> spacings;
  std::vector<double> falls;
  for (std::size_t i = 0; i < slips.size(); ++i) {
    falls.push_back(slips[i].mu_before - slips[i].mu_after);
    if (i > 0) spacings.push_back(share_of_sliding(nose) * (slips[i].S_before - slips[i - 1].S_before));
  }
  const auto possible =
      std::count_if(all.begin(), all.end(), [](const Slip& slip) { return slip.verdict == SlipVerdict::possible; });
  return {.count = static_cast<std::size_t>(possible),
          .median_spacing = median_of(spacings),
          .median_fall = median_of(falls)};
}

}  // namespace flexslip
