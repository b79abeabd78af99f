#include "instruments/metadata.h"

#include <string>
#include <vector>

#include <doctest/doctest.h>

using namespace flexslip;

namespace {

std::string read_line(std::string_view line, char separator) {
  std::string all;
  for (const Metadatum& datum : metadata_on_line(Sheet(std::string(line), separator), 0))
    all += (all.empty() ? "" : " & ") + datum.name + "|" + datum.value;
  return all;
}

}  // namespace

TEST_CASE("metadata: lines of real preambles") {
  CHECK(read_line("General : Start date,\"2020-09-02\"", ',') == "General : Start date|2020-09-02");
  CHECK(read_line("Maximum Load : Maximum Load,\"6.95912\",N", ',') == "Maximum Load : Maximum Load|6.95912 N");
  CHECK(read_line("Test Run: C18-L-M-RF", '\t') == "Test Run|C18-L-M-RF");
  CHECK(read_line("Station Name: FORTH-1.cfg", ' ') == "Station Name|FORTH-1.cfg");
  CHECK(read_line("# General : Start date: 2020-09-02", ',') == "General : Start date|2020-09-02");
  CHECK(read_line("Raw Data", ',') == "Raw Data|");
  CHECK(read_line("Largeur (mm),25,Épaisseur (mm),15", ',') == "Largeur (mm)|25 & Épaisseur (mm)|15");
}

TEST_CASE("metadata: quantities of the test in SI, those that contradict each other left out") {
  const std::vector<Metadatum> data{{"Support span", "40.28 mm", 1},
                                    {"Durchmesser", "2,5 mm", 2},
                                    {"Breite", "1,0 mm", 3},
                                    {"width", "2,0 mm", 4},
                                    {"Thickness (mm)", "4", 5},
                                    {"Rate 1", "10 mm/min", 6},
                                    {"Support roller diameter", "5 mm", 7}};
  const ExportedTest test = test_in(data, {',', '\0'});
  constexpr double ulp = 3e-16;        // relative, one rounding
  CHECK_FALSE(test.span.has_value());  // "40.28" is no number where the comma is the decimal mark
  CHECK(test.diameter.value() == doctest::Approx(2.5e-3).epsilon(ulp));
  CHECK_FALSE(test.width.has_value());
  CHECK(test.thickness.value() == doctest::Approx(4e-3).epsilon(ulp));
  CHECK(test.rate.value() == doctest::Approx(0.01 / 60).epsilon(ulp));
}

TEST_CASE("metadata: a dimension of supports and nose is none of the specimen, in whatever language") {
  for (const char* name : {"Support roller diameter", "Rollendurchmesser", "Diamètre des appuis", "Diamètre du poinçon",
                           "Auflagerbreite", "Diámetro de los rodillos", "Diametro dei rulli"}) {
    INFO(name);
    const ExportedTest test = test_in(std::vector<Metadatum>{{name, "10,0 mm", 1}}, {',', '\0'});
    CHECK_FALSE(test.diameter.has_value());
    CHECK_FALSE(test.width.has_value());
  }
  const std::vector<Metadatum> data{{"Distance entre appuis", "17,0 mm", 1}, {"Diamètre de l'éprouvette", "2,0 mm", 2}};
  const ExportedTest test = test_in(data, {',', '\0'});
  CHECK(test.span.value() == doctest::Approx(0.017).epsilon(3e-16));
  CHECK(test.diameter.value() == doctest::Approx(0.002).epsilon(3e-16));
}

TEST_CASE("metadata: the dimensions of a bar in Spanish and Portuguese, and an anchor that is no width") {
  const std::vector<Metadatum> spanish{
      {"Ancho [mm]", "10.2", 1}, {"Espesor [mm]", "3.1", 2}, {"Distancia entre apoyos [mm]", "50", 3}};
  const std::vector<Metadatum> portuguese{
      {"Largura", "10.2 mm", 1}, {"Espessura", "3.1 mm", 2}, {"Distância entre apoios", "50 mm", 3}};
  for (const auto& data : {spanish, portuguese}) {
    const ExportedTest test = test_in(data, {});
    CHECK(test.width.value() == doctest::Approx(10.2e-3).epsilon(3e-16));
    CHECK(test.thickness.value() == doctest::Approx(3.1e-3).epsilon(3e-16));
    CHECK(test.span.value() == doctest::Approx(0.05).epsilon(3e-16));
  }
  CHECK_FALSE(test_in(std::vector<Metadatum>{{"Anchor distance", "80 mm", 1}}, {}).width.has_value());
}
