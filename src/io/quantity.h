// Physical quantities as people write them, "1278 um" or "2.1e-9 N m^2", to and from SI.
//
// A unit is a product, quotient and power of m g s N Pa J rad deg (with the prefixes f p n u µ m c
// d k M G T), micron, sec, min, h, in, ft, mil, lbf, ozf, kip, psi, ksi, Msi, gf, kgf and %:
// "mN/um", "N m^2", "N·m²", "m4", "1/mm". Spaces, * and · multiply. Names of units are accepted in
// any case: "seconds", "Newton", "lbs", "kp", "inches".
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace flexslip {

// Exponents of the base units. The angle has one, so that a phase is not taken for a friction coefficient.
struct Dimension {
  int metre{};
  int kilogram{};
  int second{};
  int radian{};
  bool operator==(const Dimension&) const = default;
};

// A unit of measurement: 1 unit = factor 10^exponent in SI. The power of ten is separate, so that "34.8 um"
// is read as the double nearest to 34.8e-6.
struct Unit {
  Dimension dimension{};
  int exponent{};
  double factor{1};  // [1]
  bool operator==(const Unit&) const = default;
};

// A kind of quantity: its dimension and its usual notation.
struct Kind {
  std::string_view name;  // with its article, "a length"
  Dimension dimension;
  std::span<const std::string_view> units;  // decimal units for display, ascending; empty if dimensionless
  std::string_view example;                 // "1278 um"
};

// The name without the article, "length".
constexpr std::string_view noun(const Kind& kind) { return kind.name.substr(kind.name.find(' ') + 1); }

namespace kind {
namespace shown_in {
inline constexpr std::array<std::string_view, 4> length{"nm", "um", "mm", "m"};
inline constexpr std::array<std::string_view, 3> inverse_length{"1/m", "1/mm", "1/um"};
inline constexpr std::array<std::string_view, 5> force{"nN", "uN", "mN", "N", "kN"};
inline constexpr std::array<std::string_view, 5> stiffness{"uN/m", "mN/m", "N/m", "N/mm", "kN/mm"};
inline constexpr std::array<std::string_view, 4> pressure{"Pa", "kPa", "MPa", "GPa"};
inline constexpr std::array<std::string_view, 6> bending_stiffness{"nN mm^2", "uN mm^2", "mN mm^2",
                                                                   "N mm^2",  "kN mm^2", "N m^2"};
inline constexpr std::array<std::string_view, 3> area_moment{"um^4", "mm^4", "m^4"};
inline constexpr std::array<std::string_view, 5> energy{"pJ", "nJ", "uJ", "mJ", "J"};
inline constexpr std::array<std::string_view, 1> angle{"rad"};
inline constexpr std::array<std::string_view, 1> time{"s"};
inline constexpr std::array<std::string_view, 4> speed{"nm/s", "um/s", "mm/s", "m/s"};
}  // namespace shown_in

inline constexpr Kind length{"a length", {.metre = 1}, shown_in::length, "1278 um"};
inline constexpr Kind inverse_length{"an inverse length", {.metre = -1}, shown_in::inverse_length, "0.2 1/mm"};
inline constexpr Kind force{"a force", {1, 1, -2, 0}, shown_in::force, "12 mN"};
inline constexpr Kind stiffness{"a stiffness", {0, 1, -2, 0}, shown_in::stiffness, "90.65 N/m"};
inline constexpr Kind pressure{"a modulus", {-1, 1, -2, 0}, shown_in::pressure, "29.6 GPa"};
inline constexpr Kind bending_stiffness{
    "a bending stiffness", {3, 1, -2, 0}, shown_in::bending_stiffness, "2.1e-9 N m^2"};
inline constexpr Kind area_moment{"an area moment", {.metre = 4}, shown_in::area_moment, "7.2e4 um^4"};
inline constexpr Kind energy{"an energy", {2, 1, -2, 0}, shown_in::energy, "3.4 uJ"};
inline constexpr Kind angle{"an angle", {.radian = 1}, shown_in::angle, "90 deg"};
inline constexpr Kind time{"a time", {.second = 1}, shown_in::time, "0.5 s"};
inline constexpr Kind speed{"a speed", {.metre = 1, .second = -1}, shown_in::speed, "0.5 mm/s"};
inline constexpr Kind number{"a plain number", {}, {}, "0.5"};
}  // namespace kind

// The kind in inches and pounds. A plain number, an angle and a time remain unchanged.
const Kind& in_inches(const Kind& kind);

// The range of valid values. Infinity must be written "inf"; NaN is never valid.
enum class Range { any, non_negative, positive, positive_or_infinite };

// A quantity of the given kind from text.
// Units:      the result is in SI, radians.
// Max error:  correctly rounded where the unit is decimal; 1 ulp otherwise (deg, in, lbf, psi, min, h).
// Fails:      InputError, without a place, for text without a number; for a missing, unknown or
//             wrong unit; for a value out of range; and for a finite value other than 0 outside
//             [1e-60, 1e60].
double parse_quantity(std::string_view text, const Kind& kind, Range range = Range::any);

// The range check of parse_quantity. Returns the value.
// Fails:      InputError that quotes `text`, if the value is out of range.
double within(Range range, double value, std::string_view text, const Kind& kind);

// A unit from text.
// Fails:      InputError, without a place, if the text is no unit.
Unit parse_unit(std::string_view text);

// A unit from text; nullopt if the text is no unit.
std::optional<Unit> unit_named(std::string_view text);

// A unit from text that must be one of the given kind; kind::number also takes "", "1" and "-".
// Fails:      InputError, without a place.
Unit parse_unit(std::string_view text, const Kind& kind);

// A unit as testing machines write it: the units of parse_unit, and "p" for pond. nullopt for other
// text; no unit is guessed.
std::optional<Unit> machine_unit(std::string_view text);

// The units that an invalid text may mean: kN for "KN", gf for "g", mN or MN for "mn". Empty if no unit is similar.
std::vector<std::string_view> meant_units(std::string_view text, const Kind& kind);

// [V] The size of a voltage unit, "V", "mV" or "Volts", as of a transducer without calibration. nullopt for other text.
std::optional<double> volts_in(std::string_view text);

// True for a unit, a voltage, "-" or "1", with or without brackets.
bool names_a_unit(std::string_view text);

// A value in a unit, in SI.
// Max error:  1 ulp (one rounding for the power of ten, where |exponent| <= 22; one for a factor other than 1).
double to_si(double value, const Unit& unit);

// A value in SI, converted to a unit. Max error as to_si.
double from_si(double value, const Unit& unit);

// The best unit for a value [SI] of this size: the largest unit that does not exceed it.
std::string_view best_unit(double magnitude, const Kind& kind);

// A unit in typeset form: "um" as "µm", "N mm^2" as "N mm²".
std::string typeset(std::string_view unit);

// A value [SI] for people: up to four significant digits in its best unit, "10.9 µm".
std::string readable(double value, const Kind& kind);

// A value with its standard uncertainty [SI], which has two digits: "10.90 ± 0.20 µm". The text
// also reports an uncertainty that is unknown (NaN) or below a millionth of the value.
std::string readable(double value, double uncertainty, const Kind& kind);

// A difference [1] as "+2.1 %".
std::string signed_percent(double share);

// A value [SI] as text in its best unit: "34.8 um". parse_quantity reads it back exactly, in inches
// and pounds to 1 ulp.
std::string exact_text(double value, const Kind& kind);

}  // namespace flexslip
