// Draws figures with gnuplot. Each figure consists of a script, its data as CSV, and the pictures,
// so that users can restyle it.
#pragma once

#include <string>
#include <vector>

#include "report/plot.h"

namespace flexslip {

struct Drawing {
  // why the pictures are missing, in words; script and data are written anyway
  std::string why_not{};

  bool is_done() const { return why_not.empty(); }
};

// Writes <folder>/<name>.gp, its data, and the pictures in the given formats: "svg", "pdf", "png".
// Fails:      not done if gnuplot is missing, fails, takes longer than 20 s, or has no temporary
//             folder. Throws InputError if a file cannot be written.
// Method:     the same figure gives the same bytes. The date in the PDF is SOURCE_DATE_EPOCH or
//             1970, and gnuplot ignores the user's settings.
Drawing draw(const Plot& plot, const std::string& folder, const std::vector<std::string>& formats);

// Draws one picture FILE.svg, FILE.pdf or FILE.png. Script and data get the same name in the same
// folder.
// Fails:      as above; throws InputError for another ending.
Drawing draw(Plot plot, const std::string& picture);

}  // namespace flexslip
