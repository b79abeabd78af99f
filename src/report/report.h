// The report of a fitted test: one HTML file to read, print and hand on, with its figures beside it for journals.
#pragma once

#include <string>

#include "case/fitted.h"
#include "report/figure.h"

namespace flexslip {

// Writes <folder>/report.html, which needs no other file, and <folder>/figures/: every figure as SVG, PDF and PNG with its gnuplot
// script and data. The folder is made if it is not there; files of the same names are replaced.
// It links to a studio page beside it, where one is named.
// Fails:      as draw(); without gnuplot the report has no pictures and says so.
DrawStatus write_report(const std::string& folder, const FittedTest& test, const std::string& studio = "");

}  // namespace flexslip
