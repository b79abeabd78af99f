#include "answers/cycles_fields.h"

#include <cmath>
#include <optional>
#include <vector>

#include "data/names.h"

namespace flexslip {
namespace {

using T = const FittedTest&;

// One of the loops of a test.
struct LoopOf {
  const FittedTest& test;
  std::size_t i;
  const FrictionLoop& loop() const { return test.cycles->friction.loops[i]; }
  const LoopEnergy& energy() const { return test.cycles->energy[i]; }
};
using L = const LoopOf&;

// A place of a table of friction.
struct LoopPlace {
  double S, mu;
  std::optional<double> error;
};

std::vector<LoopPlace> places_of(const FrictionTable& table, const std::vector<double>& errors = {}) {
  std::vector<LoopPlace> places;
  for (std::size_t i = 0; i < table.S.size(); ++i)
    places.push_back({table.S[i], table.mu[i], errors.empty() ? std::nullopt : std::optional(errors[i])});
  return places;
}

Fields<LoopPlace> place_fields() {
  return Fields<LoopPlace>()
      .number("length", kind::length, "length between the supports: the span and what was pulled in", &LoopPlace::S)
      .number("drawn_in", kind::length, "length pulled in (both supports)", [](const LoopPlace& p) { return p.S - 1; })
      .number("position", kind::length,
              "position of the support along the specimen, from midspan: half of length, on edges",
              [](const LoopPlace& p) { return p.S / 2; })
      .number("mu", "friction at this place", &LoopPlace::mu);
}

Fields<BumpCorrelation> correlation_fields() {
  return Fields<BumpCorrelation>()
      .number("value", "Pearson's r of friction in the two directions, without slow trends", &BumpCorrelation::value)
      .number("low", "lower end of the 95 % interval of value", &BumpCorrelation::low)
      .number("high", "upper end of the 95 % interval of value", &BumpCorrelation::high)
      .number("effective_points", "effective number of independent places", &BumpCorrelation::effective_points);
}

Fields<Leg> leg_fields() {
  return Fields<Leg>()
      .row("first_row", "first row of the leg in the file", &Leg::first)
      .row("last_row", "last row of the leg in the file", [](const Leg& leg) { return leg.last - 1; });
}

Fields<LoopCorner> corner_fields() {
  return Fields<LoopCorner>()
      .row("row", "row of the file", &LoopCorner::index)
      .number("length", kind::length, "length between the supports: the span and what was pulled in", &LoopCorner::S)
      .number("q", "mobilised friction", &LoopCorner::q);
}

Fields<FrictionLoop> corners_fields() {
  const Fields<LoopCorner> corner = corner_fields();
  return Fields<FrictionLoop>()
      .group("start", "first sliding point of the loading", corner, &FrictionLoop::start)
      .group("turn", "point at which the stage turned back", corner, &FrictionLoop::turn)
      .group("slides_back", "point at which the specimen began to slide out", corner, &FrictionLoop::slides_back)
      .group("end", "last point of the unloading", corner, &FrictionLoop::end);
}

Fields<LoopEnergy> loop_energy_fields() {
  return Fields<LoopEnergy>()
      .number("loading", kind::energy, "work put in during loading, the apparent work of fracture",
              &LoopEnergy::loading)
      .number("unloading", kind::energy, "work given back during unloading; null if the loop was not unloaded",
              &LoopEnergy::unloading)
      .number("stored", kind::energy, "bending energy gained between the beginning and the end of the loop",
              &LoopEnergy::stored)
      .number("lost", kind::energy,
              "area of the loop minus the stored energy; null if the loop is not closed or was not loaded",
              &LoopEnergy::lost)
      .number("lost_share", "lost divided by loading",
              [](const LoopEnergy& energy) { return energy.lost / energy.loading; })
      .number("friction", kind::energy, "heat of friction during sliding", &LoopEnergy::friction);
}

Fields<LoopOf> loop_fields() {
  const auto leg_of = [](std::optional<std::size_t> FrictionLoop::*leg) {
    return [leg](L loop) -> const Leg* {
      const auto& which = loop.loop().*leg;
      return which ? &loop.test.cycles->friction.legs[*which] : nullptr;
    };
  };
  const auto part = [](auto member) { return [member](L loop) { return loop.loop().*member; }; };
  const auto row_of = [](const LoopOf& of, bool last) {
    const auto& [loading, unloading] = std::pair(of.loop().loading, of.loop().unloading);
    const auto& legs = of.test.cycles->friction.legs;
    return last ? legs[unloading ? *unloading : *loading].last - 1 : legs[loading ? *loading : *unloading].first;
  };
  return Fields<LoopOf>()
      .row("first_row", "first row of the loop in the file", [row_of](L loop) { return row_of(loop, false); })
      .row("last_row", "last row of the loop in the file", [row_of](L loop) { return row_of(loop, true); })
      .group("loading", "rows of the loading; null without one", leg_fields(), leg_of(&FrictionLoop::loading))
      .group("unloading", "rows of the unloading; null without one", leg_fields(), leg_of(&FrictionLoop::unloading))
      .estimate("contact", kind::length, "stage position of the contact", part(&FrictionLoop::contact))
      .group(
          "corners", "corners of the loop of friction over length; null if it has none", corners_fields(),
          [](L loop) -> const auto& { return loop.loop(); })
      .number("stick_advance", kind::length,
              "length pulled in after the turn, while the specimen should stick: 0 in the model",
              part(&FrictionLoop::stick_advance))
      .count("places", "number of places at which the directions are compared", part(&FrictionLoop::places))
      .only_where([](L loop) { return loop.loop().places > 0; })
      .estimate("mu_in", kind::number, "mean friction while sliding in, over the places", part(&FrictionLoop::mu_in))
      .estimate("mu_out", kind::number, "mean friction while sliding out, over the places", part(&FrictionLoop::mu_out))
      .estimate("mean_difference", kind::number,
                "mean difference between the two directions, after EI and contact were chosen so that they agree",
                part(&FrictionLoop::mean_difference))
      .estimate("rms_difference", kind::number,
                "root mean square difference between the two directions from place to place",
                part(&FrictionLoop::rms_difference))
      .group("correlation", "correlation of the bumps of friction in the two directions", correlation_fields(),
             part(&FrictionLoop::correlation))
      .anywhere()
      .group(
          "energy", "work on the specimen, beyond the deflection at which friction shows", loop_energy_fields(),
          [](L loop) -> const auto& { return loop.energy(); })
      .number("replay_rms", "rms residual of one profile for all loops, run forward, as a share of the greatest force",
              [](L loop) {
                const auto& rms = loop.test.cycles->replay.residual_rms;
                return loop.i < rms.size() ? std::optional(rms[loop.i]) : std::nullopt;
              })
      .list("profile", "friction along the specimen, supported by both directions",
            place_fields().number("mu_error", "standard error of mu", &LoopPlace::error),
            [](L loop) { return places_of(loop.loop().table, loop.loop().error); });
}

Fields<LoadingStiffness> loading_fields() {
  using S = const LoadingStiffness&;
  const auto is_reference = [](S loading) {
    return loading.status == LoadingStatus::ok && loading.ratio.standard_error == 0;
  };
  return Fields<LoadingStiffness>()
      .words("status",
             "whether the loading is compared: ok, reference (the first), or why not: loaded_too_little, "
             "window_not_covered, "
             "too_few_points, not_rising, still_drawn_in, no_reference",
             [is_reference](S loading) {
               if (is_reference(loading)) return std::string_view("reference");
               return name_of(loading.status);
             })
      .only_where([](S loading) { return loading.status == LoadingStatus::ok; })
      .own_numbers("rows", kind::number, "first and last row of the window in the file",
                   [](S loading, const Frame& frame) {
                     return std::vector{frame.row(loading.first), frame.row(loading.last - 1)};
                   })
      .own_estimate("slope", kind::stiffness, "slope of force over deflection in the window; its error from scatter",
                    &LoadingStiffness::slope)
      .only_where([is_reference](S loading) { return loading.status == LoadingStatus::ok && !is_reference(loading); })
      .own_estimate("ratio", kind::number, "slope divided by that of the first loading; its error from scatter",
                    &LoadingStiffness::ratio)
      .number("ratio_systematic",
              "half the difference between the ratios in the lower and the upper half of the window",
              &LoadingStiffness::ratio_systematic)
      .words("verdict", "whether the specimen lost stiffness: damaged, not_damaged or undecided",
             [](S loading) { return name_of(loading.verdict); });
}

Fields<CyclicPoint> point_fields() {
  return Fields<CyclicPoint>()
      .row("row", "row of the file", &CyclicPoint::index)
      .number("length", kind::length, "length between the supports: the span and what was pulled in", &CyclicPoint::S)
      .number("q", "mobilised friction: μ while sliding in, −μ while sliding out, in between while stuck",
              &CyclicPoint::q)
      .number("q_error", "standard error of q from noise, EI and contact", &CyclicPoint::standard_error)
      .words("motion", "how the specimen moves: slip_in, slip_out or stick", [](const CyclicPoint& point) {
        return name_in_order<LegMotion::stuck>(point.motion, {"slip_in", "slip_out", "stick"});
      });
}

Fields<BuildUpLength> build_up_fields() {
  return Fields<BuildUpLength>()
      .number("value", kind::length, "build-up length of friction, in length of sliding over both supports",
              [](const BuildUpLength& build_up) { return build_up.length.value; })
      .number("standard_error", kind::length,
              "standard error from the scatter between reversals; null for a single one",
              [](const BuildUpLength& build_up) { return build_up.length.standard_error; })
      .number("least", kind::length, "smallest build-up length that could be detected", &BuildUpLength::least)
      .count("reversals", "number of reversals used", &BuildUpLength::reversals)
      .yes_no("told", "the build-up length differs significantly from zero", &BuildUpLength::is_told);
}

const CyclicFriction& friction_of(T test) { return test.cycles->friction; }
bool is_mirrored(T test) { return friction_of(test).status == CyclesStatus::ok; }
bool is_measurable(T test) { return is_mirrored(test) || friction_of(test).status == CyclesStatus::no_mirror; }

Estimate stiffness_of(T test) { return exponential(friction_of(test).log_stiffness); }

std::vector<LoopOf> loops_of(T test) {
  std::vector<LoopOf> loops;
  if (is_measurable(test))
    for (std::size_t i = 0; i < friction_of(test).loops.size(); ++i) loops.push_back({test, i});
  return loops;
}

}  // namespace

std::size_t cyclic_row(const FittedTest& test, std::size_t point) { return cyclic_file_row(test.measurement, point); }

std::string_view name_of(CyclesStatus status) {
  return name_in_order<CyclesStatus::not_converged>(status, {"ok", "no_mirror", "too_few_points", "not_converged"});
}

std::string_view name_of(LoadingStatus status) {
  return name_in_order<LoadingStatus::no_reference>(
      status, {"ok", "loaded_too_little", "window_not_covered", "too_few_points", "not_rising", "still_drawn_in",
               "no_reference"});
}

std::string_view name_of(DamageVerdict verdict) {
  return name_in_order<DamageVerdict::undecided>(verdict, {"damaged", "not_damaged", "undecided"});
}

Fields<FittedTest> cycles_fields() {
  const auto if_measurable = [](T test, auto points) { return is_measurable(test) ? points : decltype(points){}; };
  return Fields<FittedTest>()
      .in_frame([](T test) {
        return Frame{.scales = test.analysis.scales,
                     .reduced = test.reduced,
                     .in_inches = is_in_inches(test.measurement.test),
                     .row = [&test](std::size_t point) { return cyclic_row(test, point); }};
      })
      .words("status",
             "whether the loops were evaluated: ok, no_mirror (no part of the specimen slid both ways), too_few_points "
             "or not_converged",
             [](T test) { return name_of(friction_of(test).status); })
      .only_where(is_measurable)
      .estimate("bending_stiffness", kind::bending_stiffness,
                "EI at which friction is the same in loading and unloading", stiffness_of,
                Fields<FittedTest>().number("relative_to_nominal",
                                            "value divided by the stated EI, or by that of the initial slope",
                                            [](T test) { return stiffness_of(test).value; }))
      .only_where(is_mirrored)
      .estimate("asymmetry", kind::number,
                "friction while sliding in minus friction while sliding out, fitted beside EI and contacts",
                [](T test) { return friction_of(test).asymmetry; })
      .group("correlation", "correlation of the bumps of friction in the two directions, over all loops",
             correlation_fields(), [](T test) { return friction_of(test).correlation; })
      .number("mu_in", "mean friction while sliding in, over the places of all loops",
              [](T test) { return direction_means(friction_of(test)).in; })
      .number("mu_out", "mean friction while sliding out, over the places of all loops",
              [](T test) { return direction_means(friction_of(test)).out; })
      .number("rms_difference", "root mean square difference between the two directions from place to place",
              [](T test) { return direction_means(friction_of(test)).rms_difference; })
      .yes_no("beyond_friction",
              "asymmetry is significant and larger than friction itself, which is an error of the model",
              [](T test) { return is_beyond_friction(friction_of(test)); })
      .anywhere()
      .group("build_up_length", "length over which friction builds up after a reversal (Dahl); null without a reversal",
             build_up_fields(), [](T test) { return test.cycles->build_up; })
      .only_where(is_measurable)
      .number("force_noise", kind::force, "standard deviation of one force reading",
              [](T test) { return friction_of(test).force_noise; })
      .anywhere()
      .list("loops", "loops: each loading with the unloading that follows", loop_fields(), loops_of)
      .list(
          "loading_stiffness", "stiffness of each loading compared with the first", loading_fields(),
          [](T test) -> const auto& { return test.cycles->stiffness; })
      .list("profile", "friction along the specimen, from all loops", place_fields(),
            [if_measurable](T test) { return if_measurable(test, places_of(friction_of(test).table)); })
      .list("points", "mobilised friction, point by point", point_fields(),
            [if_measurable](T test) { return if_measurable(test, friction_of(test).points); });
}

}  // namespace flexslip
