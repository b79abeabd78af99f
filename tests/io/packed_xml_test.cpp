#include "io/packed_xml.h"

#include <string>
#include <string_view>

#include <doctest/doctest.h>

#include "io/input_error.h"

using namespace flexslip;

namespace {

constexpr std::string_view document =
    R"(<?xml version="1.0"?><x:a xmlns:x="urn:1" xmlns="urn:2"><b r="A1" x:id="7">1 &lt; 2<c/></b>µm&#10;</x:a>)";

// What is told of a document that comes in pieces of a size.
std::string told(std::string_view text, std::size_t size) {
  std::string events;
  XmlStream xml({[&](std::string_view name, const XmlAttributes& attributes) {
                   events += "<" + std::string(name) + " " + std::string(attributes.find("r").value_or("-")) + " " +
                             std::string(attributes.find("id").value_or("-")) + ">";
                 },
                 [&](std::string_view name) { events += "</" + std::string(name) + ">"; },
                 [&](std::string_view piece) { events += piece; }});
  for (std::size_t at = 0; at < text.size(); at += size) xml.feed(text.substr(at, size));
  xml.finish();
  return events;
}

}  // namespace

TEST_CASE("identity: a document says the same in pieces of any size, names without their namespaces") {
  const std::string whole = told(document, document.size());
  CHECK(whole == "<a - -><b A1 7>1 < 2<c - -></c></b>µm\n</a>");
  for (std::size_t size = 1; size < document.size(); ++size) CHECK(told(document, size) == whole);
}

TEST_CASE("packed_xml: what is cut off, broken or could define entities is refused") {
  for (std::size_t size = 0; size < document.size(); ++size) {
    CAPTURE(size);
    CHECK_THROWS_AS(told(document.substr(0, size), 7), InputError);
  }
  CHECK_THROWS_WITH_AS(told("<!DOCTYPE a [<!ENTITY b \"b\">]><a>&b;</a>", 5), doctest::Contains("a document type"),
                       InputError);
  CHECK_THROWS_WITH_AS(told("<a><b></a></b>", 5), doctest::Contains("broken XML"), InputError);
}

TEST_CASE("packed_xml: what a handler throws comes out of feed") {
  XmlStream xml({[](std::string_view, const XmlAttributes&) { throw InputError({.expected = "no element"}); },
                 [](std::string_view) {}, [](std::string_view) {}});
  CHECK_THROWS_WITH_AS(xml.feed(document), doctest::Contains("no element"), InputError);
}
