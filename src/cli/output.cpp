#include "cli/output.h"

#include <filesystem>
#include <iostream>
#include <span>
#include <variant>

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
                  "Draw the result: FILE.svg, FILE.pdf or FILE.png; gnuplot script and data beside it")
      ->each([](const std::string& file) {
        const std::filesystem::path picture(file);
        const std::string name = picture.stem().string();
        files_of_this_call().writes(picture.parent_path() / (name + ".gp"), "--figure");
        files_of_this_call().writes_like(picture.parent_path(), name + "-", ".csv", "--figure");
      });
}

void draw_for(const Output& output, const Figure& figure, const std::string& path) {
  if (draw(figure, path) == DrawStatus::no_gnuplot)
    note(output, "gnuplot is not installed: the figure is not drawn, but its script and data are there");
}

void note(const Output& output, std::string_view remark) {
  if (!output.quiet) std::cerr << fmt::format("flexslip: {}\n", remark);
}

std::string column_title(std::string_view name, std::string_view unit, bool reduced) {
  return reduced ? std::string(name) : fmt::format("{} [{}]", name, unit);
}

Json rows_json(const std::vector<OutputColumn>& columns) {
  Json rows = Json::array();
  const auto size = [](const auto& cells) { return cells.size(); };
  const std::size_t count = columns.empty() ? 0 : std::visit(size, columns.front().cells);
  for (std::size_t row = 0; row < count; ++row) {
    Json object = Json::object();
    for (const OutputColumn& column : columns)
      std::visit([&](const auto& cells) { object[column.title] = cells[row]; }, column.cells);
    rows.push_back(std::move(object));
  }
  return rows;
}

}  // namespace flexslip
