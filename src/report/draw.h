// Figures drawn by gnuplot. Each is a script and its data as CSV, kept beside the pictures for restyling.
#pragma once

#include <ctime>
#include <string>
#include <string_view>
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

// [s] SOURCE_DATE_EPOCH, where it is set, so that what is made can be made again to the byte; and a date of Greenwich.
std::time_t date_of_source(std::time_t otherwise);
std::tm calendar_date(std::time_t seconds);

// Text with all that stands in it replaced.
std::string replaced(std::string text, std::string_view what, std::string_view by);

}  // namespace flexslip
