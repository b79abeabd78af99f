#include "finding/sensitivities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "data/names.h"
#include "finding/printed.h"
#include "inference/rig_error_effects.h"
#include "numerics/elementary.h"

namespace flexslip {
namespace {

using T = const FittedTest&;

constexpr std::array in_order{
    StatedQuantity::bending_stiffness, StatedQuantity::load_train, StatedQuantity::span,
    StatedQuantity::force_gain,        StatedQuantity::contact,    StatedQuantity::support_radius,
    StatedQuantity::thickness,         StatedQuantity::preload};
static_assert(in_order.size() == stated_quantities.size());

std::string_view name_of(StatedQuantity quantity) {
  return name_in_order<StatedQuantity::support_radius>(
      quantity,
      {"bending_stiffness", "contact", "preload", "load_train", "span", "force_gain", "thickness", "support_radius"});
}

std::string_view title_of(StatedQuantity quantity) {
  return name_in_order<StatedQuantity::support_radius>(
      quantity,
      {"EI", "contact", "preload or bow", "load train", "span", "force calibration", "thickness", "support radius"});
}

// A quantity as the case states it, and its uncertainty.
struct Statement {
  std::string stated{};
  bool is_there = true;      // false: the fit assumes none
  bool may_be_there = true;  // false: there is none
  bool states_error = true;  // or no error can be stated
  double error = 0;          // [1] relative, or [m] for an offset
};

bool is_offset(StatedQuantity quantity) {
  return quantity == StatedQuantity::contact || quantity == StatedQuantity::preload;
}

Statement statement_of(T test, StatedQuantity quantity) {
  const Test& input = test.measurement.test;
  const TestAnalysis& analysis = test.analysis;
  const Scales& scales = analysis.scales;
  const Supports& supports = analysis.rig.fibre.supports();
  const RigErrors& errors = analysis.rig_errors;
  const Print print(test);
  const auto has_error = [](const std::optional<Known>& known) { return known && known->uncertainty; };
  switch (quantity) {
    case StatedQuantity::bending_stiffness:
      return {.stated = print.own(scales.bending_stiffness(), kind::bending_stiffness),
              .states_error = test.stiffness == StiffnessSource::stated,
              .error = analysis.bending_stiffness_error};
    case StatedQuantity::load_train: {
      const bool is_compliant = std::isfinite(analysis.rig.stiffness);
      return {
          .stated = is_compliant ? print.own(scales.physical_stiffness(analysis.rig.stiffness), kind::stiffness) : "∞",
          .is_there = is_compliant,
          .may_be_there = is_compliant,
          .states_error = has_error(input.rig->stiffness),
          .error = errors.load_train};
    }
    case StatedQuantity::span:
      return {.stated = print.length(1), .states_error = has_error(input.rig->span), .error = errors.span};
    case StatedQuantity::force_gain:
      return {
          .stated = "as recorded", .states_error = input.record->gain_error.has_value(), .error = errors.force_gain};
    case StatedQuantity::contact: {
      const auto* contact = input.record->contact ? std::get_if<Known>(&*input.record->contact) : nullptr;
      const double offset = test.measurement.contact_offset;
      return {.stated = offset == 0 ? "zero of the file" : print.own(offset, kind::length),
              .states_error = test.measurement.contact == ContactSource::found || (contact && contact->uncertainty),
              .error = test.measurement.contact_error};
    }
    case StatedQuantity::preload:
      return {.stated = test.measurement.begins_free ? "straight; no preload: rows before the contact" : "none",
              .states_error = input.record->preload_error.has_value(),
              .error = scales.physical_length(errors.preload)};
    case StatedQuantity::thickness: {
      const bool is_there = supports.half_depth > 0, at_axis = input.rig->friction_at == FrictionAt::axis;
      return {
          .stated = is_there  ? print.length(2 * supports.half_depth)
                    : at_axis ? "friction acts at the axis"
                              : "not stated",
          .is_there = is_there,
          .may_be_there = !at_axis,
          .states_error = input.specimen && (has_error(input.specimen->height) || has_error(input.specimen->diameter)),
          .error = errors.thickness};
    }
    case StatedQuantity::support_radius: {
      const bool is_there = supports.radius > 0;
      return {.stated = is_there ? print.length(supports.radius) : "edges",
              .is_there = is_there,
              .may_be_there = input.rig->states_supports(),  // otherwise the fit on standard rollers shows more
              .states_error = has_error(input.rig->roller_radius),
              .error = errors.support_radius};
    }
  }
  return {};
}

std::string error_in_words(T test, StatedQuantity quantity, double error) {
  return is_offset(quantity) ? format_roughly(error, Print(test).as(kind::length)) : format_relative(error);
}

std::string signed_points(double share) {
  return fmt::format("{}{:.1f} points", share < 0 ? "\u2212" : "+", 100 * std::abs(share));
}

}  // namespace

std::string signed_number(double value) { return fmt::format("{}{:.2f}", value < 0 ? "\u2212" : "+", std::abs(value)); }

std::vector<Sensitivity> sensitivities_of(T test) {
  const TestAnalysis& analysis = test.analysis;
  if (!is_fitted(test) || !analysis.fit.friction_by) return {};
  const PerQuantity<double> deviations =
      prior_deviations(analysis.errors, analysis.rig_errors, analysis.rig.fibre.supports());
  const Kind length = Print(test).as(kind::length);
  std::vector<Sensitivity> all;
  for (const StatedQuantity quantity : in_order) {
    const Statement statement = statement_of(test, quantity);
    const double deviation = statement.is_there ? deviations[quantity] : unstated_length;
    if (!statement.may_be_there || !(deviation > 0)) continue;
    const double unit = changes_in_spans(quantity) ? analysis.scales.span() : 1;
    const double friction = (*analysis.fit.friction_by)[quantity];
    const double work =
        analysis.work_share_sensitivities ? (*analysis.work_share_sensitivities)[quantity] : not_a_number;
    const std::string step =
        statement.is_there ? error_in_words(test, quantity, statement.error) : format_roughly(deviation * unit, length);
    all.push_back({.quantity = name_of(quantity),
                   .title = title_of(quantity),
                   .stated = statement.stated,
                   .step = step,
                   .may_be_off = !statement.is_there      ? "say " + step
                                 : statement.states_error ? step
                                                          : step + ", assumed",
                   .is_supposed = !statement.is_there,
                   .friction = friction / unit,
                   .friction_moves = friction * deviation,
                   .work_moves = work * deviation});
  }
  const auto weight = [](const Sensitivity& each) {
    return std::pair(!each.is_supposed, std::abs(each.friction_moves));
  };
  std::stable_sort(all.begin(), all.end(),
                   [&](const Sensitivity& a, const Sensitivity& b) { return weight(a) > weight(b); });
  return all;
}

std::string sensitivities_in_words(T test, bool has_work) {
  const auto all = sensitivities_of(test);
  std::vector<std::string> clauses;
  constexpr double noticeable = 0.005;
  const Sensitivity* of_work = nullptr;  // the largest effect on the work
  for (const Sensitivity& each : all) {
    if (std::abs(each.friction_moves) >= noticeable)
      clauses.push_back(fmt::format("{} +{}: {}{}", each.title, each.step, clauses.empty() ? "friction " : "",
                                    signed_number(each.friction_moves)));
    if (!each.is_supposed && (!of_work || std::abs(each.work_moves) > std::abs(of_work->work_moves))) of_work = &each;
  }
  if (clauses.empty()) clauses.emplace_back("no input changes friction by 0.01 or more");
  if (has_work && of_work && std::abs(of_work->work_moves) >= noticeable)
    clauses.push_back(
        fmt::format("{} +{}: share of the work {}", of_work->title, of_work->step, signed_points(of_work->work_moves)));
  return fmt::format("{}", fmt::join(clauses, "; "));
}

std::vector<FindingNumber> assumed_errors(T test) {
  std::vector<FindingNumber> assumed;
  for (const StatedQuantity quantity : in_order)
    if (const Statement statement = statement_of(test, quantity); statement.is_there && !statement.states_error)
      assumed.push_back({title_of(quantity), statement.error, is_offset(quantity) ? kind::length : kind::number});
  return assumed;
}

}  // namespace flexslip
