// An answer as one self-contained HTML file for light and dark screens and for print.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "report/document.h"
#include "report/draw.h"

namespace flexslip {

// Writes a page with the answer (HTML) and the chapters below it. The figures go to
// <folder>/figures as SVG, PDF and PNG with scripts and data, at most figure_width [mm] wide. If
// gnuplot cannot draw a picture, the page gives the reason. Returns the first drawing that is not done.
// Fails:      as draw(); throws InputError if a file cannot be written.
Drawing write_page(const std::string& folder, const std::string& title, const std::string& answer,
                   const std::vector<Chapter>& chapters, double figure_width = two_columns);

// The chapters as HTML. next_pictures returns the HTML of the next block of pictures.
std::string in_html(const std::vector<Chapter>& chapters, const std::function<std::string()>& next_pictures);

// The answer as a paragraph. The first word has the colour of the verdict, if given.
std::string answer_in_html(const std::string& words, const Verdict* verdict = nullptr);

// Creates a folder and its parents.
// Fails:      throws InputError.
void make_folder(const std::string& folder);

// Fails:      InputError for a folder with another program's report.html.
void require_own_report(const std::string& folder);

}  // namespace flexslip
