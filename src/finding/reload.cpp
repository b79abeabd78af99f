#include "finding/reload.h"

#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "finding/printed.h"

namespace flexslip {

namespace {

constexpr std::string_view before_it_softens =
    "Unload the next specimen earlier, before it loses stiffness, and load it once more.";

}  // namespace

using T = const FittedTest&;

ReloadChange reload_of(T test) {
  if (test.judgement) return test.judgement->reload;
  return test.cycles ? reload_change(test.cycles->stiffness, test.measurement.loading.number - 1) : ReloadChange{};
}

std::optional<Finding> softer_reload(T test) {
  const ReloadChange reload = reload_of(test);
  if (!lost_stiffness(reload)) return std::nullopt;
  return Finding{.severity = Severity::suspicion,
                 .sentence = fmt::format("The specimen lost stiffness: loaded again, it is {:.1f} ± {:.1f} % softer.",
                                         100 * reload.loss, 100 * reload.loss_error),
                 .short_form = fmt::format("{:.0f} % softer when reloaded", 100 * reload.loss),
                 .remedy = std::string(before_it_softens),
                 .numbers = {{"loss", reload.loss}, {"loss_error", reload.loss_error}}};
}

std::optional<Finding> changed_reload(T test) {
  const ReloadChange reload = reload_of(test);
  if (reload.change != StiffnessChange::slightly_softer && reload.change != StiffnessChange::stiffer)
    return std::nullopt;
  const bool is_softer = reload.change == StiffnessChange::slightly_softer;
  const std::string_view how = is_softer ? "softer" : "stiffer";
  return Finding{
      .severity = Severity::doubt,
      .sentence = fmt::format("Loaded again, the specimen is {:.1f} ± {:.1f} % {} than at first.",
                              100 * std::abs(reload.loss), 100 * reload.loss_error, how),
      .short_form = fmt::format("{:.0f} % {} when reloaded", 100 * std::abs(reload.loss), how),
      .remedy = std::string(is_softer ? before_it_softens : "See whether the contact or the rig has changed."),
      .numbers = {{"loss", reload.loss}, {"loss_error", reload.loss_error}}};
}

std::string reload_in_words(T test) {
  if (!test.cycles) return "";
  const CyclicFriction& friction = test.cycles->friction;
  std::vector<std::string> parts;
  if (test.judgement && friction.status == CyclesStatus::ok && !lost_stiffness(*test.judgement)) {
    const auto [in, out, rms] = direction_means(friction);
    parts.push_back(
        fmt::format("friction {:.2f} sliding in and {:.2f} sliding out{}", in, out,
                    is_beyond_friction(friction) ? "; EI and contact had to move too far to make them alike" : ""));
  }
  constexpr double says_nothing = 0.25;
  if (const ReloadChange reload = reload_of(test); reload.loss_error > says_nothing)
    parts.emplace_back("their slopes are too uncertain to be compared");
  else if (std::isfinite(reload.loss))
    parts.push_back(fmt::format(
        "{} is {:.1f} ± {:.1f} % {} than {}", reload.comes_after ? "the last that can be compared" : "that evaluated",
        100 * std::abs(reload.loss), 100 * reload.loss_error, reload.loss > 0 ? "softer" : "stiffer",
        reload.comes_after ? "that evaluated" : "the first"));
  return fmt::format("{}{}{}", format_count(test.cycles->stiffness.size(), "loading", "loadings"),
                     parts.empty() ? "" : ": ", fmt::join(parts, "; "));
}

}  // namespace flexslip
