// What every report is laid out with: one HTML file that needs no other, on screens light and dark and in print.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "finding/printed.h"
#include "report/draw.h"
#include "report/plot.h"

namespace flexslip {

inline constexpr std::size_t no_row = static_cast<std::size_t>(-1);

// A hyphen before a number is a minus sign.
std::string typeset_minus(const std::string& text);

std::string section(const std::string& title);
std::string paragraph(const std::string& words);

// Words to the left, numbers to the right; the marked row stands out.
std::string html_table(const PrintedTable& table, std::size_t marked = no_row);

// Words, the last column the longest. The first cell of a row leads to its link, where there is one that is not empty.
std::string html_word_table(const PrintedTable& table, const std::vector<std::string>& links = {});

// The picture itself, its caption and links to its files, which lie in <folder>/figures.
std::string html_figure(const std::string& folder, const Plot& plot, DrawStatus drawn, int number);

// A page with the answer first. Head and body are HTML.
std::string page(const std::string& title, const std::string& head, const std::string& body);

// An answer in a paragraph, for its head.
std::string answer_in_html(const std::string& words);

// Makes a folder and those it lies in.
// Fails:      InputError.
void make_folder(const std::string& folder);

}  // namespace flexslip
