#include "instruments/number_format.h"

#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>

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
