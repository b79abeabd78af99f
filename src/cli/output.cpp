#include "cli/output.h"

#include <filesystem>
#include <iostream>
#include <span>
#include <system_error>
#include <variant>

#include <fmt/format.h>

#include "io/input_error.h"

namespace flexslip {

void require_other_file(const CLI::App& command, const std::string& output, std::string_view option) {
  for (const CLI::Option* input : command.get_options()) {
    if (!input->get_positional()) continue;
    for (const std::string& file : input->results()) {
      std::error_code absent;
      if (std::filesystem::is_regular_file(output, absent) && std::filesystem::equivalent(file, output, absent))
        throw InputError({.field = std::string(option),
                          .expected = "another file than is read",
                          .found = in_quotes(output),
                          .remedy = "pass another name: nothing has been written"});
    }
  }
}

void add_output_options(CLI::App& command, Output& output) {
  command.add_flag("--json", output.json, "Write JSON instead of CSV");
  command.add_option("-o,--output", output.path, "Write to this file; - is standard output")
      ->type_name("FILE")
      ->capture_default_str();
  command.add_flag("--quiet", output.quiet, "No remarks on standard error, only errors");
  command.parse_complete_callback([&command, &output] { require_other_file(command, output.path, "--output"); });
}

void add_figure_option(CLI::App& command, std::string& path) {
  command
      .add_option("--figure", path,
                  "Draw the result: FILE.svg, FILE.pdf or FILE.png; gnuplot script and data beside it")
      ->type_name("FILE");
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
