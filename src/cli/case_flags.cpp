#include "cli/case_flags.h"

#include <algorithm>

#include <fmt/format.h>

namespace flexslip {
namespace {

constexpr std::string_view whole_number = "NUMBER";
constexpr std::string_view place = "ROW or LENGTH";

bool is_whole(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::string toml_string(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += byte < 0x20 || byte == 0x7f ? fmt::format("\\u{:04x}", byte) : std::string(1, c);
  }
  return quoted + '"';
}

bool has_flags(const CaseRequest& request) {
  return std::any_of(request.flags.begin(), request.flags.end(),
                     [](const CaseFlag& flag) { return flag.value.has_value(); });
}

Case case_of_flags(const CaseRequest& request) {
  std::string text;
  for (const std::string_view section : {"specimen", "rig", "record"}) {
    std::string body;
    for (const auto& flag : request.flags)
      if (flag.section == section && flag.value)
        body += fmt::format("{} = {}\n", flag.key,
                            flag.type == whole_number || (flag.type == place && is_whole(*flag.value))
                                ? *flag.value
                                : toml_string(*flag.value));
    if (section == "record") body += fmt::format("file = {}\n", toml_string(request.file));
    if (!body.empty()) text += fmt::format("[{}]\n{}", section, body);
  }
  return read_case(text, "");
}

}  // namespace

std::vector<CaseFlag> all_case_flags() {
  return {
      {"specimen", "diameter", "--diameter", "Of a round specimen", "LENGTH"},
      {"specimen", "inner_diameter", "--inner-diameter", "Of a tube, with --diameter", "LENGTH"},
      {"specimen", "wall", "--wall", "Thickness of the wall of a tube, instead of its inner diameter", "LENGTH"},
      {"specimen", "width", "--width", "Of a rectangular specimen, with --height", "LENGTH"},
      {"specimen", "height", "--height", "In the direction of bending", "LENGTH"},
      {"specimen", "modulus", "--modulus", "Young's modulus; not given: from the initial slope", "PRESSURE"},
      {"specimen", "bending_stiffness", "--bending-stiffness",
       "EI, instead of section and modulus; fit: from the initial slope", "STIFFNESS"},
      {"rig", "span", "--span", "Distance of the supports", "LENGTH"},
      {"rig", "stiffness", "--stiffness", "Of whatever carries the load cell; inf for displacement control",
       "STIFFNESS"},
      {"record", "stage", "--stage", "Column of the stage (crosshead) displacement, \"w_s [mm]\"", "COLUMN"},
      {"record", "deflection", "--deflection", "Column of the deflection at midspan", "COLUMN"},
      {"record", "force", "--force", "Column of the force, \"F [N]\"; of an export, name or number, if it is not found",
       "COLUMN"},
      {"record", "displacement", "--displacement",
       "Instead of columns, for the export of a testing machine: crosshead or deflection, what its displacement is",
       "WORD"},
      {"record", "specimen", "--specimen", "Which specimen of an export, counted from 1", whole_number},
      {"record", "displacement_column", "--displacement-column", "Of an export: name or number, if it is not found",
       "COLUMN"},
      {"record", "calibration", "--calibration", "Of a force that the export gives in volts, \"222 N/V\"",
       "CALIBRATION"},
      {"record", "sign", "--sign", "find, the default: reversed where compression is negative; keep; reverse", "WORD"},
      {"record", "zero", "--zero", "Zero of the force: find, the default, from rows before the contact; keep; a force",
       "FORCE"},
      {"record", "contact", "--contact",
       "Displacement at first contact, find, or first row; not given: found if the record begins before it", "LENGTH"},
      {"record", "failure", "--failure", "find, the default, or none", "WORD"},
      {"record", "decimal", "--decimal", "Decimal mark of the file, . or ,", "CHARACTER"},
      {"record", "first", "--first", "Where the record begins: a row, counted from 1, or a position of the stage",
       place},
      {"record", "until", "--until", "Where it ends, before failure, likewise; not given: found", place},
  };
}

void add_case_options(CLI::App& command, CaseRequest& request) {
  request.flags = all_case_flags();
  command
      .add_option("file", request.file,
                  "Case file (.toml), or a data file described by the flags below; - is standard input")
      ->type_name("FILE")
      ->required();
  for (auto& flag : request.flags) {
    CLI::Option* option = command.add_option(std::string(flag.flag), flag.value, std::string(flag.help))
                              ->type_name(std::string(flag.type))
                              ->group("A data file instead of a case");
    if (flag.type == whole_number) option->check(CLI::TypeValidator<unsigned>(""));
  }
}

bool names_case_file(const CaseRequest& request) {
  return request.file.ends_with(".toml") || (request.file == "-" && !has_flags(request));
}

Case case_of(const CaseRequest& request) {
  if (!names_case_file(request)) return case_of_flags(request);
  if (has_flags(request))
    throw InputError({.file = request.file,
                      .expected = "a data file beside flags that describe the test",
                      .found = "a case file, which describes it",
                      .remedy = "write the change into the case file"});
  return read_case(request.file);
}

InputError in_words_of_call(const CaseRequest& request, const InputError& error) {
  if (names_case_file(request)) return error;
  InputFault fault = error.fault;
  if (fault.field == "[rig]") fault.field = "[rig] span";
  for (const auto& flag : request.flags) {
    if (fault.field != fmt::format("[{}] {}", flag.section, flag.key)) continue;
    fault.field = flag.flag;
    if (fault.expected == "it in the file") {
      fault.expected = "this flag, as the file is no case";
      fault.remedy = fmt::format("add {} {}, or describe the test in a case file (.toml)", flag.flag, flag.type);
    }
  }
  if (fault.file.empty()) fault.line = 0;
  return InputError(fault);
}

}  // namespace flexslip
