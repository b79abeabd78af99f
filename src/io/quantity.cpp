#include "io/quantity.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>
#include <vector>

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include "io/input_error.h"
#include "io/text.h"

namespace flexslip {
namespace {

constexpr int highest_power = 12;  // of one factor; mechanics needs no higher power, and exponents cannot overflow
constexpr std::size_t most_factors = 8;  // in one unit

struct NamedUnit {
  std::string_view symbol;
  Unit unit;
};

constexpr Dimension of_force{1, 1, -2, 0};
constexpr Dimension of_pressure{-1, 1, -2, 0};
constexpr Dimension of_energy{2, 1, -2, 0};

constexpr std::array with_prefix{
    NamedUnit{"m", {{.metre = 1}}},    NamedUnit{"g", {{.kilogram = 1}, -3}}, NamedUnit{"s", {{.second = 1}}},
    NamedUnit{"N", {of_force}},        NamedUnit{"Pa", {of_pressure}},        NamedUnit{"J", {of_energy}},
    NamedUnit{"rad", {{.radian = 1}}},
};

constexpr double degree = std::numbers::pi / 180;
constexpr double pound_force = 4.4482216152605;  // [N] exact by definition
constexpr double standard_gravity = 9.80665;     // [N] exact by definition
constexpr double inch = 0.0254;                  // [m] exact by definition

constexpr std::array without_prefix{
    NamedUnit{"micron", {{.metre = 1}, -6}},
    NamedUnit{"microns", {{.metre = 1}, -6}},
    NamedUnit{"in", {{.metre = 1}, 0, inch}},
    NamedUnit{"mil", {{.metre = 1}, -3, inch}},
    NamedUnit{"sec", {{.second = 1}}},
    NamedUnit{"min", {{.second = 1}, 0, 60}},
    NamedUnit{"h", {{.second = 1}, 0, 3600}},
    NamedUnit{"lbf", {of_force, 0, pound_force}},
    NamedUnit{"psi", {of_pressure, 0, pound_force / (inch * inch)}},
    NamedUnit{"ksi", {of_pressure, 3, pound_force / (inch * inch)}},
    NamedUnit{"Msi", {of_pressure, 6, pound_force / (inch * inch)}},
    NamedUnit{"kgf", {of_force, 0, standard_gravity}},
    NamedUnit{"gf", {of_force, -3, standard_gravity}},
    NamedUnit{"ozf", {of_force, 0, pound_force / 16}},
    NamedUnit{"kip", {of_force, 3, pound_force}},
    NamedUnit{"ft", {{.metre = 1}, 0, 12 * inch}},
    NamedUnit{"deg", {{.radian = 1}, 0, degree}},
    NamedUnit{"°", {{.radian = 1}, 0, degree}},
    NamedUnit{"%", {{}, -2}},
};

// Other names of units, in lower case.
constexpr std::array<std::pair<std::string_view, std::string_view>, 26> spellings{
    {{"secs", "s"},        {"second", "s"},      {"seconds", "s"},     {"sekunden", "s"},    {"sek", "s"},
     {"sec.", "s"},        {"sec", "s"},         {"秒", "s"},          {"mins", "min"},      {"minutes", "min"},
     {"millimeter", "mm"}, {"millimetre", "mm"}, {"meter", "m"},       {"metre", "m"},       {"inch", "in"},
     {"inches", "in"},     {"in.", "in"},        {"micrometer", "um"}, {"micrometre", "um"}, {"newton", "N"},
     {"newtons", "N"},     {"lb", "lbf"},        {"lbs", "lbf"},       {"kgf", "kgf"},       {"kp", "kgf"},
     {"gf", "gf"}}};
constexpr std::size_t longest_spelling = 24;  // [bytes] longer words are prose

constexpr std::array<std::pair<std::string_view, int>, 13> prefixes{{{"f", -15},
                                                                     {"p", -12},
                                                                     {"n", -9},
                                                                     {"u", -6},
                                                                     {"\u00b5", -6},
                                                                     {"\u03bc", -6},
                                                                     {"m", -3},
                                                                     {"c", -2},
                                                                     {"d", -1},
                                                                     {"k", 3},
                                                                     {"M", 6},
                                                                     {"G", 9},
                                                                     {"T", 12}}};

constexpr std::array all_kinds{&kind::length,      &kind::inverse_length, &kind::force,
                               &kind::stiffness,   &kind::pressure,       &kind::bending_stiffness,
                               &kind::area_moment, &kind::energy,         &kind::angle,
                               &kind::time,        &kind::number};

bool take(std::string_view& text, std::string_view head) {
  if (!text.starts_with(head)) return false;
  text.remove_prefix(head.size());
  return true;
}

std::optional<Unit> known_unit(std::string_view symbol) {
  for (const NamedUnit& named : without_prefix)
    if (symbol == named.symbol) return named.unit;
  for (const NamedUnit& named : with_prefix) {
    if (!symbol.ends_with(named.symbol)) continue;
    const std::string_view prefix = symbol.substr(0, symbol.size() - named.symbol.size());
    if (prefix.empty()) return named.unit;
    for (const auto& [name, exponent] : prefixes)
      if (prefix == name) return Unit{named.unit.dimension, named.unit.exponent + exponent, named.unit.factor};
  }
  if (symbol.size() > longest_spelling) return std::nullopt;
  const std::string small = folded(symbol);
  for (const auto& [spelling, unit] : spellings)
    if (spelling == small && unit != symbol) return known_unit(unit);
  return std::nullopt;
}

std::string remedy_for_symbol(std::string_view symbol) {
  for (std::size_t i = 1; i < symbol.size(); ++i)
    if (known_unit(symbol.substr(0, i)) && known_unit(symbol.substr(i)))
      return fmt::format("a product of units needs a space, \"{} {}\"", symbol.substr(0, i), symbol.substr(i));
  static const std::vector<std::string> usual{"nm",  "um",  "mm",  "mN", "N",   "kN",  "Pa",
                                              "kPa", "MPa", "GPa", "mJ", "rad", "deg", "micron"};
  return did_you_mean(
      symbol, usual,
      "known are m, g, s, N, Pa, J, rad with prefixes, deg, in, ft, mil, lbf, ozf, kip, psi, ksi, Msi, gf, kgf, min, "
      "h and %, as in \"mN/um\" or \"N m^2\"");
}

// A unit in ASCII: "N·m⁻²" becomes "N*m-2".
std::string in_ascii(std::string_view text) {
  static constexpr std::array<std::pair<std::string_view, char>, 13> signs{{{"⁰", '0'},
                                                                            {"¹", '1'},
                                                                            {"²", '2'},
                                                                            {"³", '3'},
                                                                            {"⁴", '4'},
                                                                            {"⁵", '5'},
                                                                            {"⁶", '6'},
                                                                            {"⁷", '7'},
                                                                            {"⁸", '8'},
                                                                            {"⁹", '9'},
                                                                            {"⁻", '-'},
                                                                            {"·", '*'},
                                                                            {"⋅", '*'}}};
  std::string plain;
  while (!text.empty()) {
    const auto* const sign =
        std::find_if(signs.begin(), signs.end(), [&](const auto& each) { return text.starts_with(each.first); });
    plain += sign == signs.end() ? text.front() : sign->second;
    text.remove_prefix(sign == signs.end() ? 1 : sign->first.size());
  }
  return plain;
}

// The parser of units, left to right: factor { (space | * | · | /) factor }.
class UnitReader {
 public:
  explicit UnitReader(std::string_view text) : whole_(text), ascii_(in_ascii(text)) {}

  Unit read() {
    if (take(rest_, "1")) {
      skip_spaces();
      if (!rest_.starts_with('/')) refuse("a unit", "");
    } else {
      multiply_by_factor(1);
    }
    bool divided = false;
    for (std::size_t factors = 1; skip_spaces(), !rest_.empty(); ++factors) {
      if (factors == most_factors) refuse(fmt::format("a unit of at most {} factors", most_factors), "");
      if (take(rest_, "/")) {
        divided = true;
        multiply_by_factor(-1);
        continue;
      }
      if (divided) refuse("a unit with one meaning", "what follows a / is ambiguous; write \"N s/m\" or \"N/m/s\"");
      take(rest_, "*");  // the sign is optional; a space has been skipped already
      multiply_by_factor(1);
    }
    return unit_;
  }

 private:
  [[noreturn]] void refuse(std::string expected, std::string remedy) const {
    throw InputError(
        {.problem = fmt::format("{} is not {}", in_quotes(whole_), expected), .remedy = std::move(remedy)});
  }

  void skip_spaces() {
    while (take(rest_, " ") || take(rest_, "\t")) {
    }
  }

  void multiply_by_factor(int sign) {
    skip_spaces();
    const std::string_view symbol = take_symbol();
    const std::optional<Unit> unit = known_unit(symbol);
    if (!unit) refuse_symbol(symbol);
    const int power = sign * take_power();
    unit_.dimension.metre += power * unit->dimension.metre;
    unit_.dimension.kilogram += power * unit->dimension.kilogram;
    unit_.dimension.second += power * unit->dimension.second;
    unit_.dimension.radian += power * unit->dimension.radian;
    unit_.exponent += power * unit->exponent;
    for (int i = 0; i < std::abs(power); ++i)
      unit_.factor = power > 0 ? unit_.factor * unit->factor : unit_.factor / unit->factor;
  }

  [[noreturn]] void refuse_symbol(std::string_view symbol) const {
    if (symbol.empty()) refuse("a unit", "");
    throw InputError(
        {.problem = fmt::format("{} is not a unit", in_quotes(symbol)), .remedy = remedy_for_symbol(symbol)});
  }

  std::string_view take_symbol() {
    const std::string_view symbol = rest_.substr(0, rest_.find_first_of(" \t*/^0123456789-+"));
    rest_.remove_prefix(symbol.size());
    return symbol;
  }

  int take_power() {
    const bool announced = take(rest_, "^") || take(rest_, "**");
    const std::size_t sign = rest_.starts_with('-') ? 1 : 0;  // "N m-1"
    const std::string_view digits = rest_.substr(0, rest_.find_first_not_of("0123456789", sign));
    rest_.remove_prefix(digits.size());
    if (digits.empty() && !announced) return 1;
    int power = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), power);
    const bool whole = error == std::errc{} && end == digits.data() + digits.size();
    if (!whole || power == 0 || std::abs(power) > highest_power) refuse("a unit to a small whole power", "");
    return power;
  }

  std::string_view whole_;
  std::string ascii_;
  std::string_view rest_{ascii_};
  Unit unit_{};
};

std::string name_of(Dimension dimension) {
  for (const Kind* each : all_kinds)
    if (each->dimension == dimension) return std::string(each->name);
  return "another quantity";
}

// A number at the start of `text`, and where it ends.
struct LeadingNumber {
  double value;           // [1] before the unit
  std::string_view text;  // without a leading +
  std::string_view rest;
};

std::optional<LeadingNumber> leading_number(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = fast_float::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) return std::nullopt;
  const auto length = static_cast<std::size_t>(end - text.data());
  return LeadingNumber{value, text.substr(0, length), text.substr(length)};
}

// The number times 10^shift, rounded once.
double with_decimal_shift(const LeadingNumber& number, int shift) {
  if (shift == 0 || number.value == 0 || !std::isfinite(number.value)) return number.value;
  const std::size_t mark = number.text.find_first_of("eE");
  int exponent = 0;
  if (mark != std::string_view::npos) {
    const char* first = number.text.data() + mark + 1;
    if (*first == '+') ++first;
    std::from_chars(first, number.text.data() + number.text.size(), exponent);  // valid: finite and not 0
  }
  const std::string shifted = fmt::format("{}e{}", number.text.substr(0, mark), exponent + shift);
  double value = 0;
  fast_float::from_chars(shifted.data(), shifted.data() + shifted.size(), value);
  return value;
}

// A number in the units of its kind, for a remedy: "1278 nm", "1278 um", "1278 mm" or "1278 m".
std::string in_units(std::string_view number, const Kind& kind) {
  std::string text;
  for (std::size_t i = 0; i < kind.units.size(); ++i) {
    if (i > 0) text += i + 1 == kind.units.size() ? " or " : ", ";
    text += fmt::format("\"{}{}{}\"", number, number.empty() ? "" : " ", kind.units[i]);
  }
  return text;
}

bool spells_infinity(std::string_view number) { return number.find_first_of("iI") != std::string_view::npos; }

double power_of_ten(int exponent) {  // exact up to 10^22, the last power that a double holds
  double power = 1;
  for (int i = 0; i < exponent; ++i) power *= 10;
  return power;
}

int decade(double value) { return static_cast<int>(std::floor(std::log10(std::abs(value)))); }

constexpr int most_decimals = 9;  // more decimals are unreadable

// Fixed notation for exponents that are easy to read, scientific notation otherwise.
std::string with_decimals(double value, int decimals) {
  if (value != 0 && (decimals > most_decimals || std::abs(value) >= 1e7))
    return fmt::format("{:.{}e}", value, std::clamp(decade(value) + decimals, 0, 16));
  return fmt::format("{:.{}f}", value, std::clamp(decimals, 0, 16));
}

// "-0.00" as "0.00".
std::string without_minus_of_zero(std::string text) {
  const bool is_zero = text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos;
  return is_zero ? text.substr(1) : text;
}

std::string without_trailing_zeros(std::string text) {
  const std::size_t mark = std::min(text.find('e'), text.size());
  std::string digits = text.substr(0, mark);
  if (digits.find('.') == std::string::npos) return text;
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.') digits.pop_back();
  return digits + text.substr(mark);
}

// value 10^shift, with the fewest digits that identify the bits of the value. Only the decimal
// point moves; nothing is rounded.
std::string exact_decimal(double value, int shift) {
  if (value == 0) return "0";
  const std::string text = fmt::format("{}", std::abs(value));  // "0.00125", "125000", "1.25e-07"
  const std::size_t mark = std::min(text.find('e'), text.size());
  const std::size_t dot = std::min(text.find('.'), mark);
  std::string digits = text.substr(0, mark);
  std::erase(digits, '.');
  const std::size_t zeros = digits.find_first_not_of('0');
  digits = digits.substr(zeros, digits.find_last_not_of('0') + 1 - zeros);
  const int exponent = mark == text.size() ? 0 : std::atoi(text.c_str() + mark + 1);
  const int point = static_cast<int>(dot) - static_cast<int>(zeros) + exponent + shift;  // digits before the point
  const std::string sign = value < 0 ? "-" : "";
  if (point < -3 || point > 7)
    return fmt::format("{}{}{}{}e{}", sign, digits[0], digits.size() > 1 ? "." : "", digits.substr(1), point - 1);
  if (point <= 0) return sign + "0." + std::string(static_cast<std::size_t>(-point), '0') + digits;
  const auto whole = static_cast<std::size_t>(point);
  if (digits.size() <= whole) return sign + digits + std::string(whole - digits.size(), '0');
  return sign + digits.substr(0, whole) + "." + digits.substr(whole);
}

std::string with_typeset_unit(const std::string& number, std::string_view unit) {
  return unit.empty() ? number : number + " " + typeset(unit);
}

}  // namespace

double within(Range range, double value, std::string_view text, const Kind& kind) {
  const auto refuse = [&](std::string_view adjective, std::string_view remedy) {
    throw InputError({.problem = fmt::format("{} is not a {} {}", in_quotes(text), adjective, noun(kind)),
                      .remedy = std::string(remedy)});
  };
  if (std::isnan(value)) refuse("known", "");
  if (std::isinf(value) && !(range == Range::positive_or_infinite && value > 0)) refuse("finite", "");
  if (range == Range::non_negative && value < 0) refuse("non-negative", "");
  if (range == Range::positive && value <= 0) refuse("positive", "");
  if (range == Range::positive_or_infinite && value <= 0)
    refuse("positive", "write \"inf\" if it is too large to matter");
  constexpr double farthest = 1e60;  // in either direction; products of several values, such as EI/L^3, remain finite
  const double size = std::abs(value);
  if (value != 0 && std::isfinite(value) && !(1 / farthest <= size && size <= farthest))
    refuse("possible", "no test has one of that size; look at its exponent");
  return value;
}

double parse_quantity(std::string_view text, const Kind& kind, Range range) {
  const std::string_view body = trimmed(text);
  const std::optional<LeadingNumber> number = leading_number(body);
  if (!number)
    throw InputError({.problem = fmt::format("{} is not {} with its unit",
                                             body.empty() ? "An empty text" : in_quotes(body), kind.name),
                      .remedy = fmt::format("write a number and a unit, \"{}\"", kind.example)});
  const std::string_view symbol = trimmed(number->rest);
  if (std::isinf(number->value) && !spells_infinity(number->text))
    throw InputError({.problem = fmt::format("{} is not {} that a computer can hold", in_quotes(body), kind.name)});
  if (symbol.starts_with(','))
    throw InputError(
        {.problem = fmt::format("{} is not {}", in_quotes(body), kind.name),
         .remedy = fmt::format("write a decimal point and no thousands separators, \"{}\"", kind.example)});
  const bool needs_no_unit = !std::isfinite(number->value) || kind.dimension == Dimension{} ||
                             kind.dimension == kind::angle.dimension;  // radians
  if (symbol.empty() && !needs_no_unit)
    throw InputError(
        {.problem = fmt::format("The number {} has no unit, but {} needs one", in_quotes(number->text), kind.name),
         .remedy = "write " + in_units(number->text, kind)});
  const Unit unit = symbol.empty() ? Unit{} : parse_unit(symbol);
  if (!symbol.empty() && unit.dimension != kind.dimension)
    throw InputError({.problem = fmt::format("{} is {}, not {}", in_quotes(body), name_of(unit.dimension), kind.name),
                      .remedy = fmt::format("write it as in \"{}\"", kind.example)});
  return within(range, with_decimal_shift(*number, unit.exponent) * unit.factor, body, kind);
}

Unit parse_unit(std::string_view text) { return UnitReader(trimmed(text)).read(); }

std::optional<Unit> unit_named(std::string_view text) {
  try {
    return parse_unit(text);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

Unit parse_unit(std::string_view text, const Kind& kind) {
  const bool is_number = kind.dimension == Dimension{};
  const std::string_view body = trimmed(text);
  if (is_number && (body.empty() || body == "1" || body == "-")) return {};
  const auto wanted = [&] { return is_number ? std::string("no unit") : fmt::format("a unit of {}", noun(kind)); };
  const auto remedy = [&] { return is_number ? std::string() : "write " + in_units("", kind); };
  if (body.empty())
    throw InputError({.problem = fmt::format("No unit is stated, but {} is needed", wanted()), .remedy = remedy()});
  const Unit unit = parse_unit(body);
  if (unit.dimension != kind.dimension)
    throw InputError({.problem = fmt::format("The unit {} measures {}, but {} is needed", in_quotes(body),
                                             name_of(unit.dimension), wanted()),
                      .remedy = remedy()});
  return unit;
}

std::optional<Unit> machine_unit(std::string_view text) {
  const std::string_view body = trimmed(text);
  if (body.empty() || body.size() > longest_spelling) return std::nullopt;
  if (body == "p" || body == "P") return unit_named("gf");
  return unit_named(body);
}

std::vector<std::string_view> meant_units(std::string_view text, const Kind& kind) {
  static constexpr std::array<std::string_view, 24> units{"N",   "kN",  "mN",     "cN",  "uN", "nN", "MN", "gf",
                                                          "kgf", "lbf", "ozf",    "kip", "mm", "um", "m",  "cm",
                                                          "nm",  "mil", "micron", "in",  "ft", "s",  "ms", "min"};
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 13> masses{{{"g", "gf"},
                                                                                         {"gr", "gf"},
                                                                                         {"gram", "gf"},
                                                                                         {"grams", "gf"},
                                                                                         {"gms", "gf"},
                                                                                         {"kg", "kgf"},
                                                                                         {"kgs", "kgf"},
                                                                                         {"kilo", "kgf"},
                                                                                         {"kilogram", "kgf"},
                                                                                         {"kilograms", "kgf"},
                                                                                         {"oz", "ozf"},
                                                                                         {"lbm", "lbf"},
                                                                                         {"kips", "kip"}}};
  // A file read in the wrong encoding shows a µ as two characters or as a ?: "Âµm", "?m".
  const std::string_view body = trimmed(text);
  const std::size_t strange = body.find_last_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ");
  const bool is_strange =
      strange != std::string_view::npos && (body[strange] == '?' || static_cast<unsigned char>(body[strange]) >= 0x80);
  if (is_strange) {
    const std::string_view rest = body.substr(strange + 1);
    if (rest == "m" && kind.dimension == kind::length.dimension) return {"um"};
    if (rest == "N" && kind.dimension == kind::force.dimension) return {"uN"};
  }
  const std::string small = folded(body);
  std::vector<std::string_view> meant;
  const auto add = [&](std::string_view unit) {
    if (parse_unit(unit).dimension == kind.dimension) meant.push_back(unit);
  };
  for (const std::string_view unit : units)
    if (folded(unit) == small && unit != body) add(unit);
  for (const auto& [mass, unit] : masses)
    if (mass == small) add(unit);
  return meant;
}

std::optional<double> volts_in(std::string_view text) {
  const std::string_view body = trimmed(text);
  const std::string small = folded(body);
  if (body == "V" || small == "volt" || small == "volts") return 1;
  if (body == "mV") return 1e-3;
  return body == "uV" || body == "\u00b5V" ? std::optional(1e-6) : std::nullopt;
}

bool names_a_unit(std::string_view text) {
  const std::string_view body = without_brackets(trimmed(text));
  return body == "-" || body == "1" || volts_in(body) || machine_unit(body);
}

double to_si(double value, const Unit& unit) {
  const double power = power_of_ten(std::abs(unit.exponent));
  return (unit.exponent < 0 ? value / power : value * power) * unit.factor;
}

double from_si(double value, const Unit& unit) {
  const double power = power_of_ten(std::abs(unit.exponent));
  return (unit.exponent < 0 ? value * power : value / power) / unit.factor;
}

std::string_view best_unit(double magnitude, const Kind& kind) {
  if (kind.units.empty()) return "";
  if (!std::isfinite(magnitude)) return kind.units.back();
  const double shown = magnitude == 0 ? 1 : std::abs(magnitude);  // zero is shown in the SI unit
  std::string_view best = kind.units.front();
  for (const std::string_view unit : kind.units)
    if (to_si(1, parse_unit(unit)) <= shown) best = unit;
  return best;
}

const Kind& in_inches(const Kind& kind) {
  static constexpr std::array<std::string_view, 3> pressure{"psi", "ksi", "Msi"};
  static constexpr std::array<std::string_view, 1> length{"in"}, inverse_length{"1/in"}, force{"lbf"},
      stiffness{"lbf/in"}, bending_stiffness{"lbf in^2"}, area_moment{"in^4"}, energy{"lbf in"};
  static constexpr std::array<Kind, 8> kinds{
      Kind{kind::length.name, kind::length.dimension, length, "0.05 in"},
      Kind{kind::inverse_length.name, kind::inverse_length.dimension, inverse_length, "5 1/in"},
      Kind{kind::force.name, kind::force.dimension, force, "0.003 lbf"},
      Kind{kind::stiffness.name, kind::stiffness.dimension, stiffness, "0.5 lbf/in"},
      Kind{kind::pressure.name, kind::pressure.dimension, pressure, "4.3 Msi"},
      Kind{kind::bending_stiffness.name, kind::bending_stiffness.dimension, bending_stiffness, "7e-10 lbf in^2"},
      Kind{kind::area_moment.name, kind::area_moment.dimension, area_moment, "2e-13 in^4"},
      Kind{kind::energy.name, kind::energy.dimension, energy, "3e-5 lbf in"}};
  const auto same = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& each) {
    return each.dimension == kind.dimension && !kind.units.empty() && each.name == kind.name;
  });
  return same == kinds.end() ? kind : *same;
}

std::string typeset(std::string_view unit) {
  std::string text;
  char before = ' ';
  for (const char c : unit) {
    const bool starts_symbol = before == ' ' || before == '/';
    if (c == 'u' && starts_symbol)
      text += "µ";
    else if (before == '^' && c >= '2' && c <= '4')
      text += c == '2' ? "²" : c == '3' ? "³" : "⁴";
    else if (c != '^')
      text += c;
    before = c;
  }
  return text;
}

std::string readable(double value, const Kind& kind) {
  const std::string_view unit = best_unit(value, kind);
  const double shown = unit.empty() ? value : from_si(value, parse_unit(unit));
  if (shown == 0 || !std::isfinite(shown)) return with_typeset_unit(fmt::format("{}", shown), unit);
  return with_typeset_unit(without_trailing_zeros(with_decimals(shown, 3 - decade(shown))), unit);
}

std::string readable(double value, double uncertainty, const Kind& kind) {
  if (!std::isfinite(uncertainty) || !std::isfinite(value)) return readable(value, kind) + " (uncertainty not known)";
  if (uncertainty == 0) return readable(value, kind) + " (exact)";
  constexpr double millionth = 1e-6;
  if (uncertainty < millionth * std::abs(value)) return readable(value, kind) + " (to a millionth)";
  const std::string_view unit = best_unit(std::max(std::abs(value), std::abs(uncertainty)), kind);
  const Unit scale = unit.empty() ? Unit{} : parse_unit(unit);
  const double shown = from_si(value, scale);
  const double spread = from_si(uncertainty, scale);
  const int decimals = 1 - decade(spread);
  const bool is_fixed = std::max(std::abs(shown), spread) < 1e7 && decimals <= most_decimals;
  const auto text = [&](double number) {
    return is_fixed ? without_minus_of_zero(fmt::format("{:.{}f}", number, std::max(decimals, 0)))
                    : with_decimals(number, decimals);
  };
  return with_typeset_unit(text(shown) + " ± " + text(spread), unit);
}

std::string signed_percent(double share) {
  const std::string text = fmt::format("{:+.1f} %", 100 * share);
  return text == "-0.0 %" ? "+0.0 %" : text;
}

std::string exact_text(double value, const Kind& kind) {
  if (kind.units.empty() || !std::isfinite(value)) return fmt::format("{}", value);
  const std::string_view name = best_unit(value, kind);
  const Unit unit = parse_unit(name);
  if (unit.factor == 1) return fmt::format("{} {}", exact_decimal(value, -unit.exponent), name);
  constexpr int all_digits = 17;
  for (int digits = 1; digits < all_digits; ++digits)
    if (std::string text = fmt::format("{:.{}g} {}", from_si(value, unit), digits, name);
        parse_quantity(text, kind) == value)
      return text;
  return fmt::format("{:.{}g} {}", from_si(value, unit), all_digits, name);
}

}  // namespace flexslip
