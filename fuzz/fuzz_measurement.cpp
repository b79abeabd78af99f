// The preparation of a record: whatever was read, it returns a loading that can be analysed or throws an InputError.
//
// The first byte chooses what the test asks for; each two that follow are a row, by how far displacement and force move on from the row before.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

#include "case/case_file.h"
#include "case/measurement.h"

using flexslip::InputError;
using flexslip::Measurement;
using flexslip::read_case;
using flexslip::read_measurement;
using flexslip::Table;
using flexslip::Test;

namespace {

constexpr std::string_view fibre = R"([specimen]
diameter = "35 um"
modulus = "30 GPa"
[rig]
span = "1278 um"
stiffness = "90 N/m"
supports = "edges"
)";
constexpr std::string_view bar = R"([specimen]
width = "10 mm"
height = "4 mm"
modulus = "fit"
[rig]
span = "64 mm"
stiffness = "inf"
)";
constexpr std::array<std::string_view, 8> rules{"",
                                                "contact = \"find\"\n",
                                                "zero = \"find\"\n",
                                                "zero = \"slope\"\n",
                                                "failure = \"none\"\n",
                                                "sign = \"keep\"\n",
                                                "contact = \"first row\"\nzero = \"keep\"\n",
                                                "first = 5\nuntil = 40\n"};

// Usual steps, and now and then one that no stage and no specimen makes.
double step(std::uint8_t byte) {
  if (byte >= 250) return 40.0 * (byte - 252.0);
  return (byte - 110) / 16.0;
}

}  // namespace

// The name is libFuzzer's. NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t most_rows = 1500;
  if (size < 3) return 0;
  const bool is_bar = (data[0] & 8) != 0, is_deflection = (data[0] & 16) != 0;
  const double length = is_bar ? 20e-6 : 2e-6, force = is_bar ? 2.0 : 5e-5;  // a usual step of either
  auto table = std::make_shared<Table>();
  table->source = "fuzz";
  table->columns = {{is_deflection ? "w" : "ws", {}}, {"F", {}}};
  double at = 0, under = 0;
  for (std::size_t i = 1; i + 1 < size && table->lines.size() < most_rows; i += 2) {
    table->columns[0].values.push_back(at += length * step(data[i]));
    table->columns[1].values.push_back(under += force * step(data[i + 1]));
    table->lines.push_back(table->lines.size() + 2);
  }
  try {
    const std::string record = std::string("[record]\nfile = \"fuzz\"\nforce = \"F\"\n") +
                               (is_deflection ? "deflection = \"w\"\n" : "stage = \"ws\"\n");
    Test test =
        read_case(std::string(is_bar ? bar : fibre) + record + std::string(rules[data[0] % rules.size()]), "fuzz.toml");
    test.record->given = table;
    const Measurement measured = read_measurement(test, {.points = 30, .span = true});
    const auto& [stage, deflection, forces] = measured.record;
    if (stage.size() < 30 || stage.size() != deflection.size() || stage.size() != forces.size()) std::abort();
    for (std::size_t i = 0; i < stage.size(); ++i) {
      if (!std::isfinite(stage[i]) || !std::isfinite(deflection[i]) || !std::isfinite(forces[i])) std::abort();
      if (i > 0 && stage[i] < stage[i - 1]) std::abort();
      const std::size_t row = file_row(measured, i);
      if (row < 1 || row > table->lines.size()) std::abort();
      if (i > 0 && row <= file_row(measured, i - 1)) std::abort();
    }
  } catch (const InputError& error) {
    if (error.fault.problem.empty() || std::string(error.what()).find('\n') != std::string::npos) std::abort();
  }
  return 0;
}
