// An answer for people, as chapters of words, tables and pictures: said once, and laid out for a terminal and for a page.
#pragma once

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "finding/printed.h"
#include "report/fit_print.h"
#include "report/page.h"
#include "report/preparation_words.h"

namespace flexslip {

struct Bullets {
  std::vector<std::string> items;
};

// On a page alone; made when it is drawn.
struct Picture {
  std::function<Plot()> plot;
};

// What a machine reads, line by line; on a page alone.
struct Verbatim {
  std::string text;
};

struct Files {
  std::vector<InputFile> files;
};

using Block = std::variant<std::string, Bullets, PrintedTable, std::vector<ParameterRow>, std::vector<PreparationRow>,
                           Files, Picture, Verbatim>;

struct Chapter {
  std::string title;  // empty: what comes right after the answer
  std::vector<Block> blocks{};

  Chapter& say(const std::string& words);  // a paragraph; nothing if there are no words
  Chapter& say(const std::vector<std::string>& paragraphs);
  Chapter& show(PrintedTable table);  // nothing if it has no rows
  Chapter& show(Block block);         // as it is
};

// Without pictures and what a machine reads.
std::string in_text(const std::vector<Chapter>& chapters);

// Domain:     figure gives the HTML of a picture.
std::string in_html(const std::vector<Chapter>& chapters, const std::function<std::string(const Plot&)>& figure);

}  // namespace flexslip
