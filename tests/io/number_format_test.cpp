#include "io/number_format.h"

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "io/input_error.h"

using namespace flexslip;

namespace {

NumberEvidence evidence_of(const std::vector<std::string>& cells) {
  NumberEvidence evidence;
  for (const std::string& cell : cells) evidence.add(cell);
  return evidence;
}

}  // namespace

TEST_CASE("number_format: values against the same numbers in C++") {
  CHECK(number_in("1,234.5", {'.', ','}) == 1234.5);
  CHECK(number_in("1.234.567,25", {',', '.'}) == 1234567.25);
  CHECK(number_in("1 234,5", {',', ' '}) == 1234.5);
  CHECK(number_in("1\u00a0234,5", {',', ' '}) == 1234.5);
  CHECK(number_in("1'234.5", {'.', '\''}) == 1234.5);
  CHECK(number_in("5e-005", {}) == 5e-5);
  CHECK(number_in("-4,40547E-8", {',', '\0'}) == -4.40547e-8);
  CHECK(std::signbit(number_in("-0", {})));
}

TEST_CASE("number_format: signs that few files use, against the same numbers in C++") {
  for (const char* text :
       {"\u22121.5", "\u20131.5", "(1.5)", "( 1.5 )", "1.5-", "-1.5D+00", "\u22120.15d01", "-15.D-01"})
    CHECK_MESSAGE(number_in(number_cell(text).number, {}) == -1.5, text);
  CHECK(number_in("\u22124,5E\u22121", {',', '\0'}) == -0.45);
  CHECK(number_cell("\u22121.5 N").unit == "N");
  CHECK(evidence_of({"\u22120,5", "(1,25)"}).decimal() == ',');
  for (const char* text : {"(1)", "()", "(a)", "1D5", "1.5D", "-", "--", "\u2212", "1-2", "a-", "(1.5", "1.5)"})
    CHECK_MESSAGE(number_cell(text).number.empty(), text);
}

TEST_CASE("number_format: what says that there is no number, and what says that a sensor was at its end (table)") {
  for (const char* text : {"", "NaN", "---", "n.a.", "\u2014"})
    CHECK_MESSAGE((says_missing(text) && !says_overload(text)), text);
  for (const char* text : {"OVER", "Over range", "OL", "+OVLD", "overflow", ">>>", "> 500", "Inf", "1.#INF"})
    CHECK_MESSAGE((says_overload(text) && !says_missing(text)), text);
  for (const char* text : {"1.5", "load", "cover", "N", "olive"}) CHECK_MESSAGE(!says_overload(text), text);
}

TEST_CASE("number_format: what is not written in the format is no number") {
  for (const char* text : {"", "nan", "inf", "1,5", "1.2.3", "1,234", "--1", "1e999", "0x1"})
    CHECK_MESSAGE(std::isnan(number_in(text, {})), text);
  for (const char* text : {"12,34", "1,2345", ",123", "0,123", "1234,567", "1,234,56"})
    CHECK_MESSAGE(std::isnan(number_in(text, {'.', ','})), text);
}

TEST_CASE("number_format: what cells prove, and what they leave open") {
  CHECK(evidence_of({"0,5", "1,25"}).decimal() == ',');
  CHECK(evidence_of({"0.5", "1,234"}).decimal() == '.');
  CHECK(evidence_of({"1,234.5"}).decimal() == '.');
  CHECK(evidence_of({"1,234.5"}).thousands('.') == ',');
  CHECK(evidence_of({"1.234,5", "2.345,6"}).thousands(',') == '.');
  CHECK_FALSE(evidence_of({"1,234", "2,345"}).decimal().has_value());
  CHECK(evidence_of({"1,234", "2,345"}).undecidable());
  CHECK_FALSE(evidence_of({"1", "2"}).undecidable());
  CHECK_THROWS_AS(evidence_of({"0,5", "0.5"}).decimal(), InputError);
}

TEST_CASE("number_format: a damaged cell in many changes nothing") {
  NumberEvidence evidence;
  for (int i = 0; i < 1000; ++i) evidence.add("12.345");
  for (int i = 0; i < 1000; ++i) evidence.add("0.5");
  evidence.add("12,345");
  evidence.add("0,5");
  CHECK(evidence.decimal() == '.');
  CHECK(evidence.thousands('.') == '\0');
}

TEST_CASE("number_format: numbers in any notation, with a unit or without, and what is none") {
  for (const char* text : {"1", "-0", "+1.5", "1,5", "1.234,5", "1'234.5", "1 234", "4.4E-8", "5e-005", ".5"})
    CHECK_MESSAGE(number_cell(text).number == text, text);
  CHECK(number_cell("12.5 N").number == "12.5");
  CHECK(number_cell("12.5 N").unit == "N");
  for (const char* text : {"", "-", "e5", "1e", "1-Preload", "12:30", "10/26/2022", "1 apple", "inf", "nan", "1e5x"})
    CHECK_MESSAGE(number_cell(text).number.empty(), text);
}
