// Stiffness and flexural modulus as defined by the bending standards (ISO 178, ASTM D790).
#pragma once

#include <string>

#include "flexslip/estimate.h"
#include "flexslip/test.h"

namespace flexslip::v1 {

// The numbers assume small deflections, no friction and no shear.
struct Modulus {
  std::string status;    // ok; otherwise no_straight_part, uncertain or too_stiff, and no number is known
  Estimate stiffness;    // [N/m] slope of the linear region, without the load train
  Estimate modulus;      // [Pa] to report: of the chord, or else of the linear region; not known without a section
  Estimate chord;        // [Pa] of the chord between the strains 0.05 % and 0.25 %; not known if not covered
  double maximum_force;  // [N]
  double strength;       // [Pa] flexural stress at the maximum force; not known without a section
  std::string json;      // the whole answer, as `flexslip modulus --json` writes it (docs/results.md)
};

// Domain:     a setup with a load train if the record has stage positions; at least 11 readings.
// Max error:  the standard error includes scatter and load train, not the dimensions.
// Fails:      Error for an input outside the domain.
// Cost:       about 10 ms.
Modulus modulus(const Setup& setup, const Record& record);

}  // namespace flexslip::v1
