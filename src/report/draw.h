// Figures drawn by gnuplot. Each is a script and its data as CSV, kept beside the pictures for restyling.
#pragma once

#include <string>
#include <vector>

#include "report/plot.h"

namespace flexslip {

struct Drawing {
  std::string why_not{};  // in words, if the pictures are missing: script and data are written all the same

  bool is_done() const { return why_not.empty(); }
};

// Writes <folder>/<name>.gp and its data, and the pictures in the formats given: "svg", "pdf", "png".
// Fails:      not done without gnuplot, or if gnuplot fails, takes longer than 20 s, or has no temporary folder; InputError if a file
//             cannot be written.
// Method:     the same figure gives the same bytes: the date in the PDF is set to SOURCE_DATE_EPOCH, or 1970. gnuplot reads no settings of
//             the user.
Drawing draw(const Plot& plot, const std::string& folder, const std::vector<std::string>& formats);

// The same to one picture FILE.svg, FILE.pdf or FILE.png, script and data beside it under the same name.
// Fails:      also InputError for another ending.
Drawing draw(Plot plot, const std::string& picture);

}  // namespace flexslip
