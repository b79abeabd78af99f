// Figures drawn by gnuplot. Each is a script and its data as CSV, kept beside the pictures for restyling.
#pragma once

#include <string>
#include <vector>

#include "report/plot.h"

namespace flexslip {

enum class DrawStatus {
  drawn,
  no_gnuplot,  // script and data are written, pictures are not
};

// Writes <folder>/<name>.gp and its data, and the pictures in the formats given: "svg", "pdf", "png".
// Fails:      no_gnuplot; InputError if a file cannot be written; std::runtime_error, with its words, if gnuplot refuses.
// Method:     the same figure gives the same bytes: the date in the PDF is set to SOURCE_DATE_EPOCH, or 1970.
DrawStatus draw(const Plot& plot, const std::string& folder, const std::vector<std::string>& formats);

// The same to one picture FILE.svg, FILE.pdf or FILE.png, script and data beside it under the same name.
// Fails:      also InputError for another ending.
DrawStatus draw(Plot plot, const std::string& picture);

}  // namespace flexslip
