#include "cli/output.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "io/call_files.h"

namespace flexslip {

CLI::Option* add_output_file(CLI::App& command, const std::string& names, std::string& path, const std::string& help) {
  CLI::Option* option = command.add_option(names, path, help)->type_name("FILE");
  return option->each([option](const std::string& file) {
    if (file != "-") files_of_this_call().writes(file, option->get_name());
  });
}

void add_output_options(CLI::App& command, Output& output) {
  command.add_flag("--json", output.json, "Write JSON instead of CSV");
  add_output_file(command, "-o,--output", output.path, "Write to this file; - is standard output")
      ->capture_default_str();
  command.add_flag("--quiet", output.quiet, "Write no remarks on standard error, only errors");
}

void add_figure_option(CLI::App& command, std::string& path) {
  add_output_file(command, "--figure", path,
                  "Draw the result as FILE.svg, FILE.pdf or FILE.png, with its gnuplot script and data beside it")
      ->each([](const std::string& file) {
        const std::filesystem::path picture(file);
        const std::string name = picture.stem().string();
        files_of_this_call().writes(picture.parent_path() / (name + ".gp"), "--figure");
        files_of_this_call().writes_like(picture.parent_path(), name + "-", ".csv", "--figure");
      });
}

void draw_for(const Output& output, const Plot& plot, const std::string& path) {
  if (draw(plot, path) == DrawStatus::no_gnuplot)
    note(output, "gnuplot is not installed: the script and data of the figure are written, but no picture");
}

ScreenStyle screen_style(const Output& output) {
  if (output.path != "-" || isatty(STDOUT_FILENO) != 1) return {};
  constexpr std::size_t narrowest = 40, widest = 160;
  ScreenStyle style{.width = line_length, .colour = std::getenv("NO_COLOR") == nullptr};
  if (winsize size{}; ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
    style.width = std::clamp<std::size_t>(size.ws_col, narrowest, widest);
  return style;
}

void note(const Output& output, std::string_view remark) {
  if (!output.quiet) std::cerr << fmt::format("flexslip: {}\n", remark);
}

}  // namespace flexslip
