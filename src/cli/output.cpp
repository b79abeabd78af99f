#include "cli/output.h"

#include <filesystem>
#include <iostream>

#include <fmt/format.h>

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
  command.add_flag("--quiet", output.quiet, "No remarks on standard error, only errors");
}

void add_figure_option(CLI::App& command, std::string& path) {
  add_output_file(command, "--figure", path,
                  "Draw the result: FILE.svg, FILE.pdf or FILE.png; its gnuplot script and data go beside it")
      ->each([](const std::string& file) {
        const std::filesystem::path picture(file);
        const std::string name = picture.stem().string();
        files_of_this_call().writes(picture.parent_path() / (name + ".gp"), "--figure");
        files_of_this_call().writes_like(picture.parent_path(), name + "-", ".csv", "--figure");
      });
}

void draw_for(const Output& output, const Plot& plot, const std::string& path) {
  if (draw(plot, path) == DrawStatus::no_gnuplot)
    note(output, "gnuplot is not installed: the figure is not drawn, but its script and data are there");
}

void note(const Output& output, std::string_view remark) {
  if (!output.quiet) std::cerr << fmt::format("flexslip: {}\n", remark);
}

}  // namespace flexslip
