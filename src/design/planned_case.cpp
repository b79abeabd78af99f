#include "design/planned_case.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "case/case_changes.h"
#include "case/case_file.h"
#include "case/toml.h"
#include "data/literature_friction.h"
#include "design/design_result.h"
#include "io/input_error.h"

namespace flexslip {
namespace {

// What the case states about the specimen before it is complete.
struct Outline {
  std::optional<double> thickness, span;  // [units of the case]
  std::optional<Materials> materials;
  bool reduced;

  double thickness_or_usual() const { return thickness ? *thickness : span ? *span / usual_slenderness : usual; }
  double span_or_usual() const { return reduced ? 1 : span ? *span : usual_slenderness * thickness_or_usual(); }
  // A number as the value of a key.
  std::string value(double number) const {
    return reduced ? fmt::format("{:.3g}", number) : fmt::format("\"{}\"", readable_in_case(number));
  }
  // A length with three digits, as people write it in a case.
  std::string readable_in_case(double length) const {
    const std::string_view unit = best_unit(length, kind::length);
    return fmt::format("{:.3g} {}", from_si(length, parse_unit(unit)), unit);
  }

  static constexpr double usual_slenderness = 20;  // [thickness] ISO 178 has a span of 16
  static constexpr double usual = 1e-3;            // [m] thickness, if nothing is stated
};

std::optional<double> stated_length(const toml::table& table, std::string_view section, std::string_view name) try {
  const toml::node_view<const toml::node> node = table[section][name];
  const auto text = node.value<std::string>();
  if (!text) return node.value<double>();
  const auto parts = value_and_uncertainty(*text);
  return parse_quantity(parts ? parts->first : std::string_view(*text), kind::length);
} catch (const InputError&) {
  return std::nullopt;  // read_case says what is wrong
}

Outline outline_of(const toml::table& table) {
  Outline outline{.thickness = stated_length(table, "specimen", "height"),
                  .span = stated_length(table, "rig", "span"),
                  .materials = {},
                  .reduced = table["reduced"].value_or(false)};
  if (!outline.thickness) outline.thickness = stated_length(table, "specimen", "diameter");
  const auto specimen = table["specimen"]["material"].value<std::string>(),
             support = table["rig"]["support_material"].value<std::string>();
  if (specimen && support) outline.materials = Materials{*specimen, *support};
  return outline;
}

// ---- Friction that may stay open

struct ProposedRange {
  double from, to;
  Spacing spacing;
  std::string reason;
};

ProposedRange proposed_mu0(const Outline& outline) {
  constexpr double usual_low = 0.1, usual_high = 0.5, about = 0.2;
  const auto known = outline.materials ? friction_in_literature(*outline.materials) : std::nullopt;
  if (!known)
    return {usual_low, usual_high, Spacing::linear,
            "usual; state [specimen] material and [rig] support_material to take it from the literature"};
  const bool is_range = known->low < known->high;
  return {is_range ? known->low : (1 - about) * known->low, is_range ? known->high : (1 + about) * known->high,
          Spacing::linear, fmt::format("literature for {} on {}: {}", known->specimen, known->support, known->source)};
}

ProposedRange proposed_wavelength(const Outline& outline) {
  constexpr double finest = 0.01, coarsest = 0.1;  // [thickness] grain of a surface
  const double thickness =
      outline.reduced && !outline.thickness ? 1 / Outline::usual_slenderness : outline.thickness_or_usual();
  return {finest * thickness, coarsest * thickness, Spacing::logarithmic,
          outline.thickness ? "1 to 10 % of the thickness; better: the grain of the surface"
                            : "0.05 to 0.5 % of the span; better: the grain of the surface"};
}

// The range of a number of friction that may stay open; empty for another key.
std::optional<ProposedRange> range_of(std::string_view key, const Outline& outline) {
  if (key == "friction.mu0") return proposed_mu0(outline);
  if (key == "friction.amplitude") return ProposedRange{0.05, 0.3, Spacing::linear, "usual"};
  if (key == "friction.wavelength") return proposed_wavelength(outline);
  return std::nullopt;
}

std::string_view name_in(std::string_view key) { return key.substr(key.rfind('.') + 1); }

// ---- Values that are needed

// A value that lets the reader go on, and what the user is asked for.
struct Proposal {
  std::string change, remedy;
};

// Empty for a key without a proposal.
std::optional<Proposal> proposal_for(std::string_view key, const Outline& outline) {
  const double thickness = outline.thickness_or_usual(), span = outline.span_or_usual();
  if (const auto range = range_of(key, outline)) {
    const bool is_length = key == "friction.wavelength";
    const auto shown = [&](double number) { return is_length ? outline.value(number) : fmt::format("{:.3g}", number); };
    const double middle = value_at({range->from, range->to, range->spacing, 0}, 0.5);
    return Proposal{fmt::format("{}={}", key, shown(middle)),
                    fmt::format("add {} = …, or leave it out for a range from {} to {} ({})", name_in(key),
                                shown(range->from), shown(range->to), range->reason)};
  }
  if (key == "friction.model")
    return Proposal{"friction.model=sinusoid", "add model = \"sinusoid\", or state no friction, for a range"};
  if (key == "specimen.diameter" && !outline.reduced)
    return Proposal{fmt::format("specimen.diameter={}", outline.value(span / Outline::usual_slenderness)),
                    "add the diameter of the specimen, diameter = \"… mm\", or width and height"};
  if (key == "specimen.height" || key == "specimen.width")
    return Proposal{fmt::format("{}={}", key, outline.value(thickness)),
                    fmt::format("add the {} of the specimen, {} = \"… mm\"", name_in(key), name_in(key))};
  if (key == "specimen.modulus")
    return Proposal{"specimen.modulus=10 GPa", "add the flexural modulus of the material, modulus = \"… GPa\""};
  if (key == "rig.span")
    return Proposal{fmt::format("rig.span={}", outline.value(span)),
                    outline.thickness ? fmt::format("add span = {}, 16 times the thickness (ISO 178), to {}, 40 times",
                                                    outline.value(16 * thickness), outline.value(40 * thickness))
                                      : "add the span of your supports, span = \"… mm\""};
  if (key == "rig.stiffness")
    return Proposal{"rig.stiffness=inf",
                    fmt::format("add the stiffness of your load train, stiffness = {}, or \"inf\" for displacement "
                                "control",
                                outline.reduced ? "… (in EI/L^3)" : "\"… N/m\"")};
  if (key == "stage.program") {
    const std::string zero = outline.reduced ? "0" : "\"0 mm\"", half = outline.value(span / 2);
    return Proposal{fmt::format("stage.program=[{}, {}]", zero, half),
                    fmt::format("add program = [{}, {}], up to half the span", zero, half)};
  }
  return std::nullopt;
}

// The first key of a missing section, by which the others follow.
std::string_view key_of_section(std::string_view key) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 4> first_keys{{{"specimen", "specimen.diameter"},
                                                                                     {"rig", "rig.span"},
                                                                                     {"friction", "friction.model"},
                                                                                     {"stage", "stage.program"}}};
  const auto found =
      std::find_if(first_keys.begin(), first_keys.end(), [&](const auto& each) { return each.first == key; });
  return found == first_keys.end() ? key : found->second;
}

// The missing values of a case, in the order in which its reader asks for them.
struct Gaps {
  Faults faults{};
  std::vector<std::string> changes{};  // that fill them
  std::vector<std::string> open{};     // keys of friction that may stay open
  bool is_only_friction = true;

  bool has(std::string_view change) const { return std::find(changes.begin(), changes.end(), change) != changes.end(); }

  // Fills the gap that an error names. False if it is none, or has no proposal.
  bool fill(const InputError& error, const Outline& outline) {
    const std::string key(key_of_section(error.fault.key));
    const auto proposal = error.fault.kind == FaultKind::missing && !(outline.reduced && key == "rig.span")
                              ? proposal_for(key, outline)
                              : std::nullopt;
    if (!proposal || has(proposal->change)) {
      faults.add(error);
      return false;
    }
    InputFault fault = error.fault;
    fault.key = key;
    fault.problem = "This value is missing";
    fault.field = fmt::format("[{}] {}", key.substr(0, key.rfind('.')), name_in(key));
    fault.remedy = proposal->remedy;
    faults.add(InputError(fault));
    changes.push_back(proposal->change);
    if (range_of(key, outline)) open.push_back(key);
    is_only_friction = is_only_friction && (range_of(key, outline) || key == "friction.model");
    return true;
  }
};

}  // namespace

PlannedCase planned_case(std::string_view text, const std::string& source, const std::vector<std::string>& changes) {
  const Outline outline = outline_of(with_changes(parse_toml(text, source), changes));
  Gaps gaps;
  std::optional<Test> loading;
  while (!loading) {
    std::vector<std::string> all = changes;
    all.insert(all.end(), gaps.changes.begin(), gaps.changes.end());
    try {
      loading = one_loading_of(read_case(text, source, all));
    } catch (const InputError& error) {
      if (gaps.changes.empty() && error.fault.kind != FaultKind::missing) throw;
      if (!gaps.fill(error, outline)) gaps.faults.raise();
    }
  }
  if (!gaps.is_only_friction) gaps.faults.raise();
  PlannedCase planned{.loading = *loading};
  for (const std::string& key : gaps.open) {
    if (!value_of(*loading, name_in(key))) gaps.faults.raise();  // a model in which it cannot be varied
    const auto [from, to, spacing, reason] = *range_of(key, outline);
    planned.open.push_back({{design_parameter(name_in(key)), AxisRange{from, to, spacing, 0}}, reason});
    set(planned.loading, name_in(key), value_at({from, to, spacing, 0}, 0.5));
  }
  return planned;
}

std::vector<std::string> values_taken_for(const PlannedCase& planned, const std::vector<DesignAxis>& varied) {
  std::vector<std::string> sentences;
  for (const OpenNumber& each : planned.open) {
    const DesignParameter& parameter = each.axis.parameter;
    if (std::none_of(varied.begin(), varied.end(),
                     [&](const DesignAxis& axis) { return axis.parameter.name == parameter.name; }))
      sentences.push_back(fmt::format(
          "{} is not stated: the map is for {}", parameter.name,
          readable(value_of(planned.loading, parameter.name).value(), kind_in(planned.loading, parameter.kind()))));
  }
  return sentences;
}

PlannedCase read_planned_case(const std::string& path, const std::vector<std::string>& changes) {
  return planned_case(case_text(path), path == "-" ? "standard input" : path, changes);
}

}  // namespace flexslip
