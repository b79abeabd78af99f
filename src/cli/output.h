// Where a command's results go, and in which form.
#pragma once

#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

#include "report/draw.h"
#include "report/fit_document.h"
#include "result/json.h"
#include "result/table.h"

namespace flexslip {

struct Output {
  std::string path = "-";  // of the results; "-" is standard output
  bool json = false;
  bool quiet = false;
};

// Gives a command an option that names a file to write, and announces the file (CallFiles) before the command reads any.
CLI::Option* add_output_file(CLI::App& command, const std::string& names, std::string& path, const std::string& help);

// Gives a command the options --json, --output and --quiet.
void add_output_options(CLI::App& command, Output& output);

// Gives a command the option --figure.
void add_figure_option(CLI::App& command, std::string& path);

// Draws a figure; without gnuplot a remark says that only its script and data are there.
void draw_for(const Output& output, const Plot& plot, const std::string& path);

// As wide as the terminal, and in colour on one, unless NO_COLOR is set; of results that go into a file, as a file has them.
ScreenStyle screen_style(const Output& output);

// A remark on standard error: what was assumed, left out or cut short.
void note(const Output& output, std::string_view remark);

}  // namespace flexslip
