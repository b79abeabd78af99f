#include "instruments/export_words.h"

#include <fmt/format.h>

#include "io/input_error.h"

namespace flexslip {

char mark_named(const std::string& text, std::string_view flag) {
  if (text.size() == 1) return text.front();
  if (text == "tab" || text == "\\t") return '\t';
  if (text == "space") return ' ';
  if (text == "comma") return ',';
  if (text == "semicolon") return ';';
  if (text == "point") return '.';
  if (text == "apostrophe") return '\'';
  if (text == "none") return '\0';
  throw InputError({.field = std::string(flag),
                    .expected = "one character, or comma, semicolon, point, tab, space, apostrophe or none",
                    .found = in_quotes(text)});
}

char mark_of(const std::string& text, std::string_view flag, std::string_view allowed) {
  const char mark = mark_named(text, flag);
  if (allowed.find(mark) == std::string_view::npos)
    throw InputError({.field = std::string(flag),
                      .expected = fmt::format("one of {}", allowed == ".," ? ". and ," : allowed),
                      .found = in_quotes(text)});
  return mark;
}

ExportOptions options_of(const ExportWords& words) {
  using namespace std::string_view_literals;
  ExportOptions options;
  if (!words.sheet.empty()) options.sheet = words.sheet;
  if (words.sheet_number > 0) options.sheet = words.sheet_number;
  if (!words.encoding.empty()) options.encoding = encoding_named(words.encoding);
  if (!words.separator.empty()) options.separator = mark_named(words.separator, "--separator");
  if (!words.decimal.empty()) options.decimal = mark_of(words.decimal, "--decimal", ".,");
  if (!words.thousands.empty()) options.thousands = mark_of(words.thousands, "--thousands", "., '\0"sv);
  const auto column = [&](ColumnRole role, const std::string& name) {
    if (!name.empty()) options.columns[role] = name;
  };
  column(ColumnRole::time, words.time);
  column(ColumnRole::crosshead, words.crosshead);
  column(ColumnRole::deflection, words.deflection);
  column(ColumnRole::force, words.force);
  const auto unit = [&](ColumnRole role, const std::string& text) {
    if (!text.empty()) options.units[role] = text;
  };
  unit(ColumnRole::time, words.time_unit);
  unit(ColumnRole::displacement, words.displacement_unit);
  unit(ColumnRole::force, words.force_unit);
  if (!words.calibration.empty() && !words.calibration.ends_with("/V"))
    throw InputError(
        {.field = "--calibration", .expected = "such as \"222 N/V\"", .found = in_quotes(words.calibration)});
  unit(ColumnRole::force, words.calibration);
  if (!words.displacement.empty())
    options.displacement = words.displacement == "crosshead" ? ColumnRole::crosshead : ColumnRole::deflection;
  return options;
}

}  // namespace flexslip
