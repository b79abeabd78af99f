#include "case/dimensions_of_file.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "case/case_file.h"
#include "case/case_keys.h"
#include "case/mechanics.h"
#include "data/section.h"
#include "io/input_error.h"
#include "io/text.h"
#include "numerics/statistics.h"

namespace flexslip {
namespace {

constexpr double tolerance = 0.01;  // [1] rounding of dimensions and of columns

struct ComparedLength {
  std::string_view name;
  std::optional<double> stated, found;  // [m]
};

std::vector<ComparedLength> dimensions_of(const Test& asked, const ExportedTest& found) {
  const SpecimenInput specimen = asked.specimen.value_or(SpecimenInput{});
  const auto value_of = [](const auto& length) {
    return length ? std::optional<double>(static_cast<double>(*length)) : std::nullopt;
  };
  return {{"span", asked.rig ? value_of(asked.rig->span) : std::nullopt, found.span},
          {"diameter", value_of(specimen.diameter), found.diameter},
          {"width", value_of(specimen.width), found.width},
          {"thickness", value_of(specimen.height), found.thickness}};
}

bool differs(const ComparedLength& each) {
  return each.stated && each.found && std::abs(*each.stated / *each.found - 1) > tolerance;
}

// The ratio of two columns [SI], if it is the same in all rows of large force; else nullopt.
std::optional<double> constant_ratio(const std::vector<double>& of, const std::vector<double>& to,
                                     const std::vector<double>& force) {
  constexpr double large = 0.3;
  constexpr std::size_t min_rows = 10;
  double greatest = 0;
  for (const double each : force)
    if (std::isfinite(each)) greatest = std::max(greatest, std::abs(each));
  std::vector<double> ratios;
  for (std::size_t i = 0; i < of.size(); ++i)
    if (std::abs(force[i]) > large * greatest && to[i] != 0 && std::isfinite(of[i] / to[i]))
      ratios.push_back(std::abs(of[i] / to[i]));
  if (ratios.size() < min_rows) return std::nullopt;
  const double middle = median_of(ratios);
  for (double& each : ratios) each = std::abs(each / middle - 1);
  return median_of(ratios) < tolerance ? std::optional(middle) : std::nullopt;
}

// A column of stress or strain, and its ratio to force or displacement by the file and by a test.
struct DerivedColumn {
  std::string name;
  double in_file;                                      // [1/m²] or [1/m]
  std::optional<double> (*by_test)(const Test& test);  // the same by span and section
};

std::optional<double> stress_per_force(const Test& test) {
  const auto section = section_of(test);
  if (!section || !test.rig || !test.rig->span) return std::nullopt;
  return *test.rig->span * depth(*section) / (8 * second_moment(*section));
}

std::optional<double> strain_per_deflection(const Test& test) {
  const auto section = section_of(test);
  if (!section || !test.rig || !test.rig->span) return std::nullopt;
  return 6 * depth(*section) / (*test.rig->span * *test.rig->span);
}

std::vector<DerivedColumn> derived_columns(const Export& file, const ExportedSpecimen& specimen,
                                           const ExportColumn& force, const ExportColumn& displacement) {
  std::vector<DerivedColumn> columns;
  const auto in_words = [](const ExportColumn& column, std::string_view word) {
    return folded(column.name).find(word) != std::string::npos;
  };
  const std::vector<double> forces = in_si(file, force, kind::force);
  for (const ExportColumn& column : specimen.columns) {
    if (column.role != ColumnRole::other || !column.words.empty()) continue;
    const auto unit = machine_unit(column.unit);
    if (unit && unit->dimension == kind::pressure.dimension &&
        (in_words(column, "stress") || in_words(column, "spannung"))) {
      if (const auto ratio = constant_ratio(in_si(file, column, kind::pressure), forces, forces))
        columns.push_back({column.name, *ratio, stress_per_force});
    } else if (in_words(column, "strain") || in_words(column, "dehnung")) {
      const double size = trimmed(column.unit) == "%" ? 0.01 : 1;
      std::vector<double> strains = column.values;
      for (double& each : strains) each *= size;
      if (const auto ratio = constant_ratio(strains, in_si(file, displacement, kind::length), forces))
        columns.push_back({column.name, *ratio, strain_per_deflection});
    }
  }
  return columns;
}

bool agrees(const DerivedColumn& column, const Test& test) {
  const auto expected = column.by_test(test);
  return expected && std::abs(column.in_file / *expected - 1) <= tolerance;
}

// The test with every dimension that the file states.
Test as_in_file(Test test, const ExportedTest& found) {
  if (!test.rig) test.rig.emplace();
  SpecimenInput specimen = test.specimen.value_or(SpecimenInput{});
  if (found.span) test.rig->span = *found.span;
  if (found.diameter) specimen.diameter = *found.diameter;
  if (found.width) specimen.width = *found.width;
  if (found.thickness) specimen.height = *found.thickness;
  test.specimen = specimen;
  return test;
}

std::string dimensions_in_words(const Test& test, const std::vector<ComparedLength>& list,
                                std::optional<double> ComparedLength::*value) {
  std::vector<std::string> words;
  for (const ComparedLength& each : list)
    words.push_back(fmt::format("{} {}", each.name, readable_length(test, *(each.*value))));
  std::string text = words.front();
  for (std::size_t i = 1; i < words.size(); ++i) text += (i + 1 == words.size() ? " and " : ", ") + words[i];
  return text;
}

}  // namespace

void complete_from_file(Test& test, const ExportedTest& found, const std::optional<double>& load_train,
                        std::vector<PreparationStep>& steps) {
  const auto note = [&](std::string words, double value, KeyChange otherwise, const Kind& kind = kind::length) {
    steps.push_back({.name = "metadata",
                     .done = std::move(words),
                     .value = PreparedValue{value, {}, kind},
                     .otherwise = std::move(otherwise)});
  };
  if (load_train && !(test.rig && test.rig->stiffness)) {
    if (!test.rig) test.rig.emplace();
    test.rig->stiffness = *load_train;
    note("the load train is as stiff as the stage's displacement, the deflection and the force in the file say",
         *load_train, KeyChange{"rig", "stiffness", "\"…\""}, kind::stiffness);
  }
  if (found.span && !(test.rig && test.rig->span)) {
    if (!test.rig) test.rig.emplace();
    test.rig->span = *found.span;
    note("the span is the one in the file", *found.span, KeyChange{"rig", "span", "\"…\""});
  }
  SpecimenInput specimen = test.specimen.value_or(SpecimenInput{});
  const bool is_half = specimen.width.has_value() != specimen.height.has_value();
  if (section_of(test)) return;
  if (found.diameter && (found.width || found.thickness) && !is_half) {
    steps.push_back({.name = "metadata",
                     .done = fmt::format("no section is taken from the file, which states both a diameter and a {}",
                                         found.width && found.thickness ? "width and a thickness"
                                         : found.width                  ? "width"
                                                                        : "thickness"),
                     .otherwise = KeyChange{"specimen", "diameter", "\"…\""}});
    return;
  }
  if (found.diameter && !is_half) {
    specimen.diameter = *found.diameter;
    note("the diameter is the one in the file", *found.diameter, KeyChange{"specimen", "diameter", "\"…\""});
  } else if ((specimen.width || found.width) && (specimen.height || found.thickness)) {
    if (!specimen.width) {
      specimen.width = *found.width;
      note("the width is the one in the file", *found.width, KeyChange{"specimen", "width", "\"…\""});
    }
    if (!specimen.height) {
      specimen.height = *found.thickness;
      note("the height is the thickness in the file", *found.thickness, KeyChange{"specimen", "height", "\"…\""});
    }
  } else if (is_half) {
    throw missing(test, specimen.width ? "specimen.height" : "specimen.width");
  } else {
    return;
  }
  test.specimen = specimen;
}

std::vector<std::string> contradictions(const Test& asked, const Test& completed, const Export& file,
                                        const ExportedSpecimen& specimen, const ExportColumn& force,
                                        const ExportColumn& displacement) {
  std::vector<ComparedLength> unlike = dimensions_of(asked, file.test);
  std::erase_if(unlike, [](const ComparedLength& each) { return !differs(each); });
  std::vector<std::string> sentences;
  if (holds_stress(force)) return sentences;
  const std::vector<DerivedColumn> columns = derived_columns(file, specimen, force, displacement);
  const auto column_that = [&](const auto& is_so) {
    const auto found = std::find_if(columns.begin(), columns.end(), is_so);
    return found == columns.end() ? nullptr : &*found;
  };
  const auto as_stated = [&](const DerivedColumn& column) { return agrees(column, completed); };
  if (unlike.empty()) {
    // A strain may be measured by another instrument than the displacement, so it raises no doubt.
    const DerivedColumn* column = column_that([&](const DerivedColumn& each) {
      return each.by_test == stress_per_force && each.by_test(completed) && !agrees(each, completed);
    });
    if (column != nullptr && column_that(as_stated) == nullptr)
      sentences.push_back(fmt::format("The file's column {} is {:.3g} times what span and section give.",
                                      in_quotes(column->name), column->in_file / *column->by_test(completed)));
    return sentences;
  }
  std::string sentence =
      fmt::format("The file states {}, not {}.", dimensions_in_words(asked, unlike, &ComparedLength::found),
                  dimensions_in_words(asked, unlike, &ComparedLength::stated));
  const Test in_file = as_in_file(completed, file.test);
  if (const auto* column = column_that([&](const DerivedColumn& each) { return agrees(each, in_file); }))
    sentence += fmt::format(" Its column {} agrees with the file.", in_quotes(column->name));
  else if (const auto* other = column_that(as_stated))
    sentence += fmt::format(" Its column {} agrees with the stated values.", in_quotes(other->name));
  sentences.push_back(std::move(sentence));
  return sentences;
}

bool holds_stress(const ExportColumn& force) {
  const auto unit = machine_unit(force.unit);
  return unit && unit->dimension == kind::pressure.dimension;
}

std::vector<double> forces_of_stresses(const Test& completed, const Export& file, const ExportColumn& column,
                                       std::vector<double> stresses) {
  const auto ratio = stress_per_force(completed);
  if (!ratio) {
    std::vector<KeyChange> needed;
    if (!completed.rig || !completed.rig->span) needed.push_back({"rig", "span", "\"… mm\""});
    if (!section_of(completed)) {
      needed.push_back({"specimen", "width", "\"… mm\""});
      needed.push_back({"specimen", "height", "\"… mm\""});
    }
    throw InputError(
        {.file = file.origin.source,
         .field = "column " + in_quotes(column.name),
         .problem = fmt::format("The column holds a stress, in {}; its force follows from span and section",
                                in_quotes(column.unit)),
         .remedy = instruction_to_set(completed, needed)});
  }
  for (double& each : stresses) each /= *ratio;
  return stresses;
}

}  // namespace flexslip
