// A test that is planned, as an example for tests.
#pragma once

#include <string>

#include "design/design_result.h"

namespace flexslip {

inline const std::string spicule = R"([specimen]
diameter = "34.8 um"
modulus = "29.6 GPa"
[rig]
span = "1278 um"
stiffness = "90.65 N/m"
[friction]
model = "sinusoid"
mu0 = 0.5
amplitude = 0.15
wavelength = "40 um"
phase = 1.0
[stage]
program = ["0 um", "700 um"]
step = "2 um"
)";

// The example with something else.
inline std::string with(const std::string& from, const std::string& to) {
  std::string text = spicule;
  text.replace(text.find(from), from.size(), to);
  return text;
}

inline Test loading_of(const std::string& text) { return one_loading_of(read_case(text, "case.toml")); }

}  // namespace flexslip
