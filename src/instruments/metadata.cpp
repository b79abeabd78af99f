#include "instruments/metadata.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

#include "instruments/column_unit.h"
#include "instruments/column_words.h"
#include "io/quantity.h"
#include "io/text.h"

namespace flexslip {
namespace {

constexpr Dimension of_speed{.metre = 1, .second = -1};

bool has(std::string_view text, std::string_view word) { return text.find(word) != std::string_view::npos; }

bool has_any(std::string_view text, std::initializer_list<std::string_view> words) {
  return std::any_of(words.begin(), words.end(), [&](std::string_view word) { return has(text, word); });
}

// "10.00000 mm/min", or "10.00000" with the unit in the name, "Span (mm)". [SI]
std::optional<double> quantity_in(const Metadatum& datum, const NumberFormat& format, const Dimension& dimension) {
  const std::string_view value = trimmed(datum.value);
  const std::size_t end = std::min(value.find_first_not_of("+-0123456789.,eE"), value.size());
  const double number = number_in(trimmed(value.substr(0, end)), format);
  const std::string stated = title_parts(datum.name).unit;
  const std::string_view text = end < value.size() ? without_brackets(trimmed(value.substr(end))) : stated;
  const std::optional<Unit> unit = machine_unit(text);
  if (std::isnan(number) || !unit || unit->dimension != dimension) return std::nullopt;
  return to_si(number, *unit);
}

// The value of the data whose folded names `means` accepts, if they agree.
template <class Means>
std::optional<double> agreed(std::span<const Metadatum> metadata, const NumberFormat& format,
                             const Dimension& dimension, const Means& means) {
  std::optional<double> value;
  for (const Metadatum& datum : metadata) {
    if (!means(folded(datum.name))) continue;
    const std::optional<double> found = quantity_in(datum, format, dimension);
    if (!found || *found <= 0) continue;
    if (value && *value != *found) return std::nullopt;
    value = found;
  }
  return value;
}

}  // namespace

Metadatum metadatum_on(std::string_view text, std::span<const std::string_view> cells, std::size_t line) {
  text = trimmed(text);
  const bool comment = text.starts_with('#');
  if (comment) text = trimmed(text.substr(std::min(text.find_first_not_of('#'), text.size())));
  const auto without_colon = [](std::string_view name) { return name.substr(0, name.find_last_not_of(": \t") + 1); };
  const auto filled = std::count_if(cells.begin(), cells.end(), [](std::string_view cell) { return !cell.empty(); });
  if (!comment && filled > 1 && text.find_first_of(",;\t") != std::string_view::npos) {
    std::string value;
    for (const std::string_view cell : cells.subspan(1))
      if (!cell.empty()) value.append(value.empty() ? "" : " ").append(cell);
    return {std::string(without_colon(cells.front())), value, line};
  }
  if (!comment && filled == 1)
    text = *std::find_if(cells.begin(), cells.end(), [](std::string_view cell) { return !cell.empty(); });
  std::size_t colon = text.find(": ");  // "General : Start date: today" is cut behind the date
  while (colon != std::string_view::npos && colon > 0 && text[colon - 1] == ' ') colon = text.find(": ", colon + 1);
  if (colon == std::string_view::npos) return {std::string(without_colon(text)), "", line};
  return {std::string(without_colon(text.substr(0, colon))), std::string(trimmed(text.substr(colon + 2))), line};
}

ExportedTest test_in(std::span<const Metadatum> metadata, const NumberFormat& format) {
  const Dimension& length = kind::length.dimension;
  ExportedTest test;
  test.span = agreed(metadata, format, length, [](std::string_view name) {
    return has_any(name, {"span", "stützweite", "spannweite", "auflagerabstand", "auflageabstand", "portée", "entraxe",
                          "distance between supports", "support distance", "luce", "支点間"}) &&
           !has(name, "spannung");
  });
  test.diameter = agreed(metadata, format, length, [](std::string_view name) {
    return has_any(name, {"diameter", "durchmesser", "diamètre", "diámetro", "diametro", "çap", "直径"}) &&
           !has_any(name, {"roller", "nose", "support", "pin"});
  });
  test.width = agreed(metadata, format, length, [](std::string_view name) {
    return has_any(name, {"width", "breite", "largeur", "anchura", "larghezza", "genişlik", "幅"});
  });
  test.thickness = agreed(metadata, format, length, [](std::string_view name) {
    return has_any(name, {"thickness", "dicke", "épaisseur", "espesor", "spessore", "kalınlık", "厚さ", "厚み"});
  });
  test.rate = agreed(metadata, format, of_speed, [](std::string_view name) {
    return name == "v1" || name == "v2" ||
           has_any(name, {"rate", "speed", "geschwindigkeit", "vitesse", "velocidad", "velocità", "hız", "速度"});
  });
  return test;
}

bool states_maximum_force(const Metadatum& datum) {
  const std::string name = folded(datum.name);
  return has_any(name, {"maximum load", "maximum force", "max load", "max force", "peak load", "peak force",
                        "maximalkraft", "force maxi", "charge maxi"}) &&
         !has_any(name, {" at ", "stress", "strain"});
}

std::optional<StatedForce> stated_maximum(std::span<const Metadatum> metadata, const NumberFormat& format) {
  for (const Metadatum& datum : metadata)
    if (states_maximum_force(datum))
      if (const auto value = quantity_in(datum, format, kind::force.dimension)) return StatedForce{*value, &datum};
  return std::nullopt;
}

std::string specimen_name(std::span<const Metadatum> metadata) {
  static constexpr std::array<std::string_view, 12> names{
      "specimen",  "specimen name", "specimen label", "specimen id", "sample",   "sample name",
      "sample id", "test run",      "probenname",     "probe",       "試験片名", "試料名"};
  for (const Metadatum& datum : metadata)
    if (std::find(names.begin(), names.end(), folded(datum.name)) != names.end()) return datum.value;
  return "";
}

}  // namespace flexslip
