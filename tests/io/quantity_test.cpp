#include "io/quantity.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <rapidcheck.h>

#include "io/input_error.h"
#include "tests/has.h"

using namespace flexslip;

namespace {

std::string complaint(std::string_view text, const Kind& kind, Range range = Range::any) {
  try {
    parse_quantity(text, kind, range);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string complaint_about_unit(std::string_view text) {
  try {
    parse_unit(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("table: quantities as people write them, to the bit of the SI literal") {
  CHECK(parse_quantity("1278 um", kind::length) == 1278e-6);
  CHECK(parse_quantity("34.8 um", kind::length) == 34.8e-6);
  CHECK(parse_quantity("34.8 \u00b5m", kind::length) == 34.8e-6);  // micro sign
  CHECK(parse_quantity("34.8 \u03bcm", kind::length) == 34.8e-6);  // Greek mu
  CHECK(parse_quantity("34.8micron", kind::length) == 34.8e-6);
  CHECK(parse_quantity("  +0.348e2\tum ", kind::length) == 34.8e-6);
  CHECK(parse_quantity("-3 mm", kind::length) == -3e-3);
  CHECK(parse_quantity("29.6 GPa", kind::pressure) == 29.6e9);
  CHECK(parse_quantity("29.6 kN/mm^2", kind::pressure) == 29.6e9);
  CHECK(parse_quantity("90.65 N/m", kind::stiffness) == 90.65);
  CHECK(parse_quantity("88 mN/um", kind::stiffness) == 88e3);
  CHECK(parse_quantity("88 N m^-1", kind::stiffness) == 88);
  CHECK(parse_quantity("88 N m-1", kind::stiffness) == 88);
  CHECK(parse_quantity("88 N·m⁻¹", kind::stiffness) == 88);
  for (const char* unit : {"N m^2", "N m²", "N·m²", "N*m**2", "N m2", "N  m^2", "Pa m^4", "J m", "kg m^3/s^2"})
    CHECK_MESSAGE(parse_quantity("2.1e-12 " + std::string(unit), kind::bending_stiffness) == 2.1e-12, unit);
  CHECK(parse_quantity("2.1 uN mm^2", kind::bending_stiffness) == 2.1e-12);
  CHECK(parse_quantity("7.2e4 um^4", kind::area_moment) == 7.2e-20);
  CHECK(parse_quantity("3.4 uJ", kind::energy) == 3.4e-6);
  CHECK(parse_quantity("3.4 mN mm", kind::energy) == 3.4e-6);
  CHECK(parse_quantity("0.2 1/mm", kind::inverse_length) == 200);
  CHECK(parse_quantity("1.5 rad", kind::angle) == 1.5);
  CHECK(parse_quantity("1.5", kind::angle) == 1.5);
  CHECK(parse_quantity("5 %", kind::number) == 0.05);
  CHECK(parse_quantity("0.5", kind::number) == 0.5);
}

TEST_CASE("table: units that are no power of ten, against their legal definitions") {
  // One product of correctly rounded numbers each: 1 ulp, which is at most 2^-52 of the value.
  const double ulp = std::numeric_limits<double>::epsilon();
  CHECK(std::abs(parse_quantity("90 deg", kind::angle) - std::numbers::pi / 2) <= ulp * 2);
  CHECK(std::abs(parse_quantity("180°", kind::angle) - std::numbers::pi) <= ulp * 4);
  CHECK(std::abs(parse_quantity("2 in", kind::length) - 0.0508) <= ulp * 0.0508);
  CHECK(std::abs(parse_quantity("1 lbf", kind::force) - 4.4482216152605) <= ulp * 4.5);
  CHECK(std::abs(parse_quantity("1 psi", kind::pressure) - 6894.757293168361) <= ulp * 6895);
  CHECK(parse_quantity("2 min", kind::time) == 120);
}

TEST_CASE("table: units by the names that people and machines give them, alike wherever a unit is read") {
  CHECK(parse_quantity("1 gf", kind::force) == 9.80665e-3);
  CHECK(parse_quantity("1 kp", kind::force) == 9.80665);
  CHECK(parse_quantity("1 lbs", kind::force) == parse_quantity("1 lbf", kind::force));
  CHECK(parse_quantity("16 ozf", kind::force) == parse_quantity("1 lbf", kind::force));
  CHECK(parse_quantity("1 kip", kind::force) == parse_quantity("1000 lbf", kind::force));
  CHECK(parse_quantity("1 ft", kind::length) == parse_quantity("12 in", kind::length));
  CHECK(parse_quantity("2 inches", kind::length) == parse_quantity("2 in", kind::length));
  CHECK(parse_quantity("1 ksi", kind::pressure) == parse_quantity("1000 psi", kind::pressure));
  for (const char* unit : {"gf", "lbf", "Newton", "seconds", "inch", "ksi", "kip", "kN"})
    CHECK(machine_unit(unit) == unit_named(unit));
}

TEST_CASE("table: a unit that is none, and which may be meant") {
  using Units = std::vector<std::string_view>;
  CHECK(meant_units("KN", kind::force) == Units{"kN"});
  CHECK(meant_units("g", kind::force) == Units{"gf"});
  CHECK(meant_units("Kg", kind::force) == Units{"kgf"});
  CHECK(meant_units("lbF", kind::force) == Units{"lbf"});
  CHECK(meant_units("mn", kind::force) == Units{"mN", "MN"});
  CHECK(meant_units("IN", kind::length) == Units{"in"});
  CHECK(meant_units("MM", kind::length) == Units{"mm"});
  CHECK(meant_units("S", kind::time) == Units{"s"});
  for (const char* text : {"", "Q", "mm", "V"}) CHECK(meant_units(text, kind::force).empty());
}

TEST_CASE("table: infinity where it means something, and nowhere else") {
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(parse_quantity("inf", kind::stiffness, Range::positive_or_infinite) == infinity);
  CHECK(parse_quantity("inf N/m", kind::stiffness, Range::positive_or_infinite) == infinity);
  CHECK(has(complaint("inf", kind::length), "'inf' is not a finite length"));
  CHECK(has(complaint("-inf", kind::stiffness, Range::positive_or_infinite), "finite stiffness"));
  CHECK(has(complaint("1e999 m", kind::length, Range::positive_or_infinite), "a computer can hold"));
  CHECK(has(complaint("1e300 Gm^9", {"a length", {.metre = 9}, {}, ""}, Range::any), "finite length"));
  CHECK(has(complaint("nan um", kind::length), "'nan um' is not a known length"));
}

TEST_CASE("table: values out of range are refused with the value") {
  CHECK(complaint("0 um", kind::length, Range::positive) == "'0 um' is not a positive length.");
  CHECK(complaint("-1 GPa", kind::pressure, Range::positive) == "'-1 GPa' is not a positive modulus.");
  CHECK(complaint("-0.1 um", kind::length, Range::non_negative) == "'-0.1 um' is not a non-negative length.");
  CHECK(has(complaint("-3 N/m", kind::stiffness, Range::positive_or_infinite), "'-3 N/m' is not a positive stiffness"));
  CHECK(parse_quantity("0 um", kind::length, Range::non_negative) == 0);
  CHECK(parse_quantity("-1 um", kind::length) == -1e-6);
  CHECK(complaint("1e200 m", kind::length, Range::positive) ==
        "'1e200 m' is not a possible length. No test has one of that size; look at its exponent.");
  CHECK(has(complaint("1e-100 N", kind::force, Range::any), "a possible force"));
}

TEST_CASE("table: what is not a quantity is refused with the way to mend it") {
  CHECK(complaint("1278", kind::length) ==
        "The number '1278' has no unit, but a length needs one. Write \"1278 nm\", \"1278 um\", \"1278 mm\" or \"1278 "
        "m\".");
  CHECK(complaint("29.6 GPa", kind::length) == "'29.6 GPa' is a modulus, not a length. Write it as in \"1278 um\".");
  CHECK(has(complaint("3 kg", kind::length), "'3 kg' is another quantity, not a length"));
  CHECK(has(complaint("0.5 rad", kind::number), "'0.5 rad' is an angle, not a plain number"));
  CHECK(has(complaint("1,278 um", kind::length), "Write a decimal point and no thousands separators"));
  CHECK(has(complaint("", kind::length),
            "An empty text is not a length with its unit. Write a number and a unit, \"1278 um\""));
  CHECK(has(complaint("um", kind::length), "'um' is not a length with its unit"));
  CHECK(has(complaint("12 MM", kind::length), "Did you mean 'mm'?"));
  CHECK(has(complaint("12 GPA", kind::pressure), "Did you mean 'GPa'?"));
  CHECK(has(complaint("2.1e-12 Nm^2", kind::bending_stiffness), "A product of units needs a space, \"N m\""));
  CHECK(has(complaint("5 V", kind::force), "'V' is not a unit. Known are m, g, s, N"));
}

TEST_CASE("table: units that can be read in two ways, or not at all, are refused") {
  CHECK(has(complaint_about_unit("N/m s"), "ambiguous"));
  for (const char* text : {"", "/", "N/", "N//m", "*N", "N^", "N^0", "N^99", "N^1.5", "m-", "12/m", "1", "N/(m s)",
                           "m m m m m m m m m", "m^99999999999999999999", "\xc2", "µ", "N⁻"})
    CHECK_MESSAGE(complaint_about_unit(text) != "", text);
}

TEST_CASE("oracle: any product of prefixed units, against its exponents counted by hand") {
  struct Factor {
    const char* symbol;
    int exponent;
    Dimension dimension;
  };
  static const Factor factors[] = {{"m", 0, {.metre = 1}},      {"um", -6, {.metre = 1}}, {"mN", -3, {1, 1, -2, 0}},
                                   {"GPa", 9, {-1, 1, -2, 0}},  {"kJ", 3, {2, 1, -2, 0}}, {"g", -3, {.kilogram = 1}},
                                   {"mrad", -3, {.radian = 1}}, {"ms", -3, {.second = 1}}};
  CHECK(rc::check("product of powers", [] {
    Unit expected;
    std::string text;
    const auto count = *rc::gen::inRange(1, 8);
    for (int i = 0; i < count; ++i) {
      const Factor& factor = factors[*rc::gen::inRange(0, 8)];
      const int size = *rc::gen::inRange(1, 5);
      const int power = i > 0 ? size * (*rc::gen::element(1, -1)) : size;
      text += (i > 0 ? " " : "") + std::string(factor.symbol) + "^" + std::to_string(power);
      expected.exponent += power * factor.exponent;
      expected.dimension.metre += power * factor.dimension.metre;
      expected.dimension.kilogram += power * factor.dimension.kilogram;
      expected.dimension.second += power * factor.dimension.second;
      expected.dimension.radian += power * factor.dimension.radian;
    }
    RC_ASSERT(parse_unit(text) == expected);
  }));
}

TEST_CASE("table: a unit alone must suit its kind") {
  CHECK(parse_unit("mN", kind::force).exponent == -3);
  CHECK(parse_unit("1", kind::number) == Unit{});
  CHECK(parse_unit("", kind::number) == Unit{});
  CHECK_THROWS_WITH_AS(
      parse_unit("m", kind::force),
      "The unit 'm' measures a length, but a unit of force is needed. Write \"nN\", \"uN\", \"mN\", \"N\" or \"kN\".",
      InputError);
  CHECK_THROWS_WITH_AS(
      parse_unit("", kind::force),
      "No unit is stated, but a unit of force is needed. Write \"nN\", \"uN\", \"mN\", \"N\" or \"kN\".", InputError);
  CHECK_THROWS_WITH_AS(parse_unit("m", kind::number), "The unit 'm' measures a length, but no unit is needed.",
                       InputError);
}

TEST_CASE("identity: to SI and back is the same but for two roundings") {
  CHECK(rc::check("from_si(to_si(x)) = x", [](double value) {
    for (const char* text : {"um", "GPa", "mN/um", "deg", "in", "uN mm^2"}) {
      const Unit unit = parse_unit(text);
      const double back = from_si(to_si(value, unit), unit);
      // each direction rounds twice at most, half an ulp each
      RC_ASSERT(std::abs(back - value) <= 2 * std::numeric_limits<double>::epsilon() * std::abs(value));
    }
  }));
}

TEST_CASE("limit: inches and pounds are exact by definition, and shown where a kind is shown in them") {
  CHECK(parse_quantity("1 mil", kind::length) == 2.54e-5);
  CHECK(parse_quantity("1 kgf", kind::force) == 9.80665);
  CHECK(parse_quantity("2 Msi", kind::pressure) == doctest::Approx(2e6 * 6894.757293168361).epsilon(1e-15));
  CHECK(readable(0.0635, in_inches(kind::length)) == "2.5 in");
  CHECK(readable(3e9, in_inches(kind::pressure)) == "435.1 ksi");
  CHECK(readable(0.5, in_inches(kind::number)) == "0.5");
  for (const double inches : {2.5, 0.05, 1.0 / 3, 0.0503})
    CHECK(exact_text(parse_quantity(fmt::format("{} in", inches), kind::length), in_inches(kind::length)) ==
          fmt::format("{} in", inches));
}

TEST_CASE("identity: exact text is read back to the same bits") {
  CHECK(exact_text(34.8e-6, kind::length) == "34.8 um");
  CHECK(exact_text(1.278e-3, kind::length) == "1.278 mm");
  CHECK(exact_text(29.6e9, kind::pressure) == "29.6 GPa");
  CHECK(exact_text(90.65, kind::stiffness) == "90.65 N/m");
  CHECK(exact_text(2.1e-12, kind::bending_stiffness) == "2.1 uN mm^2");
  CHECK(exact_text(0, kind::length) == "0 m");
  CHECK(exact_text(-2e-6, kind::length) == "-2 um");
  CHECK(exact_text(5e-13, kind::length) == "0.0005 nm");
  CHECK(exact_text(1e12, kind::length) == "1e12 m");
  CHECK(exact_text(0.1, kind::number) == "0.1");
  CHECK(parse_quantity(exact_text(std::numeric_limits<double>::infinity(), kind::stiffness), kind::stiffness,
                       Range::positive_or_infinite) > 1e308);
  const Kind kinds[] = {kind::length,      kind::force, kind::pressure, kind::bending_stiffness,
                        kind::area_moment, kind::angle, kind::number};
  CHECK(rc::check("parse(exact_text(x)) = x", [&kinds] {
    const double mantissa = *rc::gen::arbitrary<double>();
    const double value = std::ldexp(mantissa, *rc::gen::inRange(-150, 150));
    RC_PRE(value == 0 || (std::abs(value) > 1e-59 && std::abs(value) < 1e59));
    for (const Kind& kind : kinds) RC_ASSERT(parse_quantity(exact_text(value, kind), kind) == value);
  }));
}

TEST_CASE("table: quantities for people") {
  CHECK(readable(10.9e-6, kind::length) == "10.9 µm");
  CHECK(readable(1278e-6, kind::length) == "1.278 mm");
  CHECK(readable(1234.567e-6, kind::length) == "1.235 mm");
  CHECK(readable(29.6e9, kind::pressure) == "29.6 GPa");
  CHECK(readable(2.1e-12, kind::bending_stiffness) == "2.1 µN mm²");
  CHECK(readable(7.2e-20, kind::area_moment) == "72000 µm⁴");
  CHECK(readable(0, kind::force) == "0 N");
  CHECK(readable(0.1449, kind::number) == "0.1449");
  CHECK(readable(1.5e-12, kind::number) == "1.5e-12");
  CHECK(readable(1.5e-4, kind::number) == "0.00015");
  CHECK(readable(-3e-3, kind::force) == "-3 mN");
}

TEST_CASE("table: a value shows as many digits as its uncertainty knows") {
  CHECK(readable(10.9e-6, 0.2e-6, kind::length) == "10.90 ± 0.20 µm");
  CHECK(readable(1278e-6, 3e-6, kind::length) == "1.2780 ± 0.0030 mm");
  CHECK(readable(29.61234e9, 1.5e9, kind::pressure) == "29.6 ± 1.5 GPa");
  CHECK(readable(0.58123, 0.0123, kind::number) == "0.581 ± 0.012");
  CHECK(readable(0.1e-6, 20e-6, kind::length) == "0 ± 20 µm");
  CHECK(readable(123.4, 45.6, kind::number) == "123 ± 46");
  CHECK(readable(0.201583, 8.8e-4, kind::number) == "0.20158 ± 0.00088");
  CHECK(readable(4.6e-4, 3e-4, kind::number) == "0.00046 ± 0.00030");
  CHECK(readable(4.6e-6, 3e-6, kind::number) == "0.0000046 ± 0.0000030");
  CHECK(readable(4.6e-9, 3e-9, kind::number) == "4.6e-09 ± 3.0e-09");
  CHECK(readable(1e-9, 3e-4, kind::number) == "0.00000 ± 0.00030");
  CHECK(readable(-0.001, 0.12, kind::number) == "0.00 ± 0.12");
  CHECK(readable(1.5e-12, 3e-13, kind::number) == "1.50e-12 ± 3.0e-13");
  CHECK(signed_percent(-0.0001) == "+0.0 %");
  CHECK(signed_percent(-0.0213) == "-2.1 %");
  CHECK(readable(10.9e-6, std::nan(""), kind::length) == "10.9 µm (uncertainty not known)");
  CHECK(readable(25e3, 2e-11, kind::stiffness) == "25 N/mm (to a millionth)");
}

TEST_CASE("table: units for figures and tables") {
  CHECK(best_unit(900e-6, kind::length) == "um");
  CHECK(best_unit(1e-3, kind::length) == "mm");
  CHECK(best_unit(1e-15, kind::length) == "nm");
  CHECK(best_unit(5, kind::number).empty());
  CHECK(typeset("um") == "µm");
  CHECK(typeset("uN mm^2") == "µN mm²");
  CHECK(typeset("1/um") == "1/µm");
  CHECK(typeset("um^4") == "µm⁴");
}
