// The report of a fitted test: one HTML file to read, print and hand on, with its figures beside it for journals.
#pragma once

#include <string>

#include "case/fitted.h"
#include "io/call_files.h"
#include "report/draw.h"

namespace flexslip {

// What a report with its studio writes, named by an option. The figures' folder is FlexSlip's own.
// Fails:      as CallFiles::writes.
void announce_report(CallFiles& files, const std::string& folder, const std::string& option);

// Writes <folder>/report.html, which needs no other file, and <folder>/figures/: every figure as SVG, PDF and PNG with its gnuplot
// script and data. The folder is made if it is not there; files of the same names are replaced.
// It links to a studio page beside it, where one is named, and says of what day it is (that of SOURCE_DATE_EPOCH, where it is set).
// Fails:      as draw(); without gnuplot the report has no pictures and says so.
DrawStatus write_report(const std::string& folder, const FittedTest& test, const std::string& studio = "");

// The same with the studio beside it, the test inside: where there is a built page (report/studio_page.h) and the record is a file.
// Fails:      likewise, and as write_studio_page().
DrawStatus write_report_with_studio(const std::string& folder, const FittedTest& test);

}  // namespace flexslip
