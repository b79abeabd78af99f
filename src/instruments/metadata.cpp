#include "instruments/metadata.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

#include <fmt/format.h>
#include <fmt/ranges.h>

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

// True for a dimension of the rig: rollers, supports, nose.
bool is_of_the_rig(std::string_view name) {
  return has_any(name, {"roller", "nose",    "support", "pin",     "punch",    "anvil",   "rolle", "auflage",
                        "finne",  "stempel", "appui",   "poinçon", "rouleau",  "rodillo", "apoyo", "apoio",
                        "punzón", "rull",    "appoggi", "punzone", "coltello", "mesnet",  "支点",  "圧子"});
}

// [SI] "10.00000 mm/min", or "10.00000" with the unit in the name, "Span (mm)".
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

std::string without_colon(std::string_view name) {
  return std::string(name.substr(0, name.find_last_not_of(": \t") + 1));
}

// Several data on one line, "Width (mm),25,Thickness (mm),15": a number after each name. Otherwise
// empty.
std::vector<Metadatum> pairs_in(const std::vector<std::string>& cells, std::size_t line) {
  if (cells.size() < 4 || cells.size() % 2 != 0) return {};
  std::vector<Metadatum> pairs;
  for (std::size_t i = 0; i < cells.size(); i += 2) {
    if (!number_cell(cells[i]).number.empty() || number_cell(cells[i + 1]).number.empty()) return {};
    pairs.push_back({without_colon(cells[i]), cells[i + 1], line + 1});
  }
  return pairs;
}

}  // namespace

std::vector<Metadatum> metadata_on_line(const Sheet& sheet, std::size_t line) {
  std::string text(trimmed(sheet.text(line)));
  std::vector<std::string> cells;  // not empty
  for (std::size_t column = 0; column < sheet.cells(line).size(); ++column)
    if (!sheet.at(line, column).empty()) cells.push_back(sheet.shown(line, column));
  const auto only = [line](std::string_view name, std::string_view value) {
    if (name.empty() && value.empty()) return std::vector<Metadatum>{};
    return std::vector{Metadatum{without_colon(name), std::string(value), line + 1}};
  };
  const bool comment = sheet.is_comment(line);
  if (comment) text = trimmed(text.substr(std::min(text.find_first_not_of('#'), text.size())));
  if (!comment && cells.size() > 1 && text.find_first_of(",;\t") != std::string::npos) {
    if (std::vector<Metadatum> pairs = pairs_in(cells, line); !pairs.empty()) return pairs;
    const auto values = std::span(cells).subspan(sheet.at(line, 0).empty() ? 0 : 1);
    return only(sheet.at(line, 0), fmt::format("{}", fmt::join(values, " ")));
  }
  if (!comment && cells.size() == 1) text = cells.front();
  std::size_t colon = text.find(": ");  // "General : Start date: today" is cut after the date
  while (colon != std::string::npos && colon > 0 && text[colon - 1] == ' ') colon = text.find(": ", colon + 1);
  if (colon == std::string::npos) return only(text, "");
  return only(std::string_view(text).substr(0, colon), trimmed(std::string_view(text).substr(colon + 2)));
}

ExportedTest test_in(std::span<const Metadatum> metadata, const NumberFormat& format) {
  const Dimension& length = kind::length.dimension;
  ExportedTest test;
  test.span = agreed(metadata, format, length, [](std::string_view name) {
    return has_any(name, {"span", "stützweite", "spannweite", "auflagerabstand", "auflageabstand", "portée", "entraxe",
                          "entre appuis", "entre apoyos", "entre apoios", "distance between supports",
                          "support distance", "luce", "支点間"}) &&
           !has(name, "spannung");
  });
  test.diameter = agreed(metadata, format, length, [](std::string_view name) {
    return has_any(name, {"diameter", "durchmesser", "diamètre", "diámetro", "diâmetro", "diametro", "çap", "直径"}) &&
           !is_of_the_rig(name);
  });
  test.width = agreed(metadata, format, length, [](std::string_view name) {
    return has_any(name,
                   {"width", "breite", "largeur", "anchura", "ancho", "largura", "larghezza", "genişlik", "幅"}) &&
           !has(name, "anchor") && !is_of_the_rig(name);
  });
  test.thickness = agreed(metadata, format, length, [](std::string_view name) {
    return has_any(name, {"thickness", "dicke", "épaisseur", "espesor", "espessura", "spessore", "kalınlık", "厚さ",
                          "厚み"}) &&
           !is_of_the_rig(name);
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
