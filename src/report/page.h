// An answer as one HTML file that needs no other, on screens light and dark and in print.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "report/document.h"
#include "report/draw.h"

namespace flexslip {

// A page with the answer first, in HTML, and the chapters below it. The figures are drawn on the way, into <folder>/figures, as SVG, PDF and PNG with
// their scripts and data. Where gnuplot draws no picture, the page says why; what is returned is the first picture that is missing.
// Fails:      as draw(); InputError if a file cannot be written.
Drawing write_page(const std::string& folder, const std::string& title, const std::string& answer,
                   const std::vector<Chapter>& chapters);

// next_pictures gives the HTML of the pictures of a block, one block after the other.
std::string in_html(const std::vector<Chapter>& chapters, const std::function<std::string()>& next_pictures);

// The answer in a paragraph, its first word, if there is one, in the colour of the verdict.
std::string answer_in_html(const std::string& words, const Verdict* verdict = nullptr);

// Makes a folder and those it lies in.
// Fails:      InputError.
void make_folder(const std::string& folder);

}  // namespace flexslip
