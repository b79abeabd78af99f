#include "cli/options.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "case/mechanics.h"
#include "case/toml.h"
#include "io/input_error.h"
#include "io/text.h"

namespace flexslip {
namespace {

// The value of a flag in the help.
std::string type_of(const CaseKey& key) {
  switch (key.holds) {
    case Holds::title:
      return "COLUMN";
    case Holds::whole_number:
      return "NUMBER";
    case Holds::place:
      return "ROW or LENGTH";
    case Holds::word:
      return std::string(key.words);
    case Holds::quantity:
    case Holds::estimate: {
      std::string name(key.kind->name.substr(key.kind->name.rfind(' ') + 1));  // "a length"
      std::transform(name.begin(), name.end(), name.begin(),
                     [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
      return key.words.empty() ? name : fmt::format("{}|{}", name, key.words);
    }
    default:
      return "TEXT";
  }
}

bool is_whole(std::string_view text) { return !text.empty() && std::all_of(text.begin(), text.end(), is_digit); }

bool has_flags(const TestRequest& request) {
  return std::any_of(request.flags.begin(), request.flags.end(),
                     [](const CaseFlag& flag) { return flag.value.has_value(); });
}

// True if the call names a case file; "-" is a case file if there are no flags.
bool names_case_file(const TestRequest& request) {
  return request.file.ends_with(".toml") || (request.file == "-" && !has_flags(request));
}

Test case_of_flags(const TestRequest& request) {
  std::string text;
  for (const std::string_view section : {"specimen", "rig", "record"}) {
    std::string body;
    for (const auto& [key, value] : request.flags)
      if (key->section == section && value) {
        const bool is_number = key->holds == Holds::whole_number || (key->holds == Holds::place && is_whole(*value));
        body += fmt::format("{} = {}\n", key->name, is_number ? *value : toml_text(*value));
      }
    if (section == "record") body += fmt::format("file = {}\n", toml_text(request.file));
    if (!body.empty()) text += fmt::format("[{}]\n{}", section, body);
  }
  Test test = read_case(text, "", request.changes);
  test.by_flags = true;
  return test;
}

}  // namespace

CLI::Validator number_between(double low, double high) {
  return {[=](const std::string& text) {
            double value = 0;
            const bool within = CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
            return within ? std::string() : fmt::format("'{}' is not a number from {:g} to {:g}", text, low, high);
          },
          ""};
}

CLI::Validator whole_number() {
  return {[](const std::string& text) {
            return is_whole(text) ? std::string() : fmt::format("'{}' is not a whole number of 0 or more", text);
          },
          ""};
}

void add_set_option(CLI::App& command, std::vector<std::string>& changes) {
  add_repeated(
      command, "--set KEY=VALUE", changes,
      "Change a key of the case, as in rig.stiffness=\"90 N/m\"; may be repeated. flexslip keys lists all keys");
}

void add_case(CLI::App& command, CaseRequest& request, const std::string& meaning) {
  add_option(command, "case CASE", request.file, meaning)->required();
  add_set_option(command, request.changes);
}

void add_test(CLI::App& command, TestRequest& request) {
  for (const CaseKey& key : case_keys())
    if (key.has_flag) request.flags.push_back({&key});
  add_option(command, "file FILE", request.file,
             "Case file (.toml), or a data file that the flags below describe; - is standard input")
      ->required();
  add_set_option(command, request.changes);
  for (auto& [key, value] : request.flags) {
    CLI::Option* option =
        add_option(command, fmt::format("{} {}", flag_of(key->name), type_of(*key)), value, capitalised(key->meaning))
            ->group("A data file instead of a case");
    if (key->holds == Holds::whole_number) option->check(CLI::TypeValidator<unsigned>(""));
  }
}

Test test_of(const TestRequest& request) {
  if (!names_case_file(request)) return case_of_flags(request);
  if (has_flags(request))
    throw InputError({.file = request.file,
                      .problem = "Flags describe the test, but this case file describes it itself",
                      .remedy = "write the change into the case file, or pass it as --set"});
  return request.read();
}

InputError in_words_of_call(const TestRequest& request, const InputError& error) {
  if (names_case_file(request)) return error;
  const auto say = [&](InputFault fault) {
    for (const auto& [key, value] : request.flags) {
      if (fault.key != fmt::format("{}.{}", key->section, key->name)) continue;
      fault.field = flag_of(key->name);
      if (fault.kind == FaultKind::missing)
        fault.remedy =
            fmt::format("add {} {}{}, or describe the test in a case file (.toml)", fault.field, type_of(*key),
                        key->range == Range::positive_or_infinite ? " (\"inf\" if rigid)" : "");
    }
    if (fault.file.empty()) fault.line = 0;
    return fault;
  };
  std::vector<InputFault> all{error.fault};
  if (error.fault.key == "rig") {  // no flag states a whole section: ask for both keys at once
    all.front().key = "rig.span";
    all.push_back(all.front());
    all.back().key = "rig.stiffness";
  }
  all.insert(all.end(), error.also.begin(), error.also.end());
  for (InputFault& each : all) each = say(std::move(each));
  return InputError(all.front(), {all.begin() + 1, all.end()});
}

const Supports& within_limits(const Supports& stated) {
  if (!(stated.half_depth >= 0 && 2 * stated.half_depth < thickest))
    throw InputError(
        {.field = "--thickness",
         .problem = fmt::format("A thickness of {:g} spans is not between 0 and {:g} spans, where beam theory holds",
                                2 * stated.half_depth, thickest),
         .remedy = "check its unit, and the span"});
  if (!(stated.radius >= 0 && stated.radius + stated.half_depth < widest_supports))
    throw InputError({.field = "--roller-radius",
                      .problem = fmt::format("The roller radius of {:g} spans and half the thickness of {:g} spans "
                                             "must not be negative, and must add up to less than {:g} spans",
                                             stated.radius, stated.half_depth, widest_supports),
                      .remedy = "check the units of both, and the span"});
  return stated;
}

void add_analysis_options(CLI::App& command, AnalysisChoice& choice) {
  add_option(command, "--model NAME", choice.model,
             "Friction model to fit: roughness, the default, or one of the paper's")
      ->check(CLI::IsMember(model_names()));
  add_option(command, "--false-alarms NUMBER", choice.options.drops.false_alarms_per_test,
             "Average number of drops expected in a test of this length without slips")
      ->check(number_between(1e-6, 1e3))
      ->capture_default_str();
  add_option(command, "--suspect-limit NUMBER", choice.options.suspect_limit,
             "Limit above which friction is implausible")
      ->check(number_between(0.01, 100))
      ->capture_default_str();
}

void add_reading_flags(CLI::App& command, ReadingWords& words, std::span<const ReadingFlag> flags,
                       const std::string& group) {
  for (const ReadingFlag& flag : flags) {
    const std::string name = flag.name;
    add_option(command, "--" + name, words[name.substr(0, name.find(' '))], flag.meaning)->group(group);
  }
}

namespace {

struct Outputs {
  std::vector<std::string> files;
  std::string report;  // the folder that the call makes
};

Outputs& outputs_of_this_call() {
  static Outputs outputs;
  return outputs;
}

}  // namespace

void require_folders_of_outputs() {
  namespace fs = std::filesystem;
  const auto& [files, report] = outputs_of_this_call();
  for (const std::string& file : files) {
    const fs::path folder = fs::path(file).parent_path();
    std::error_code error;
    if (folder.empty() || fs::is_directory(folder, error)) continue;
    if (report.empty() || folder.lexically_normal() != fs::path(report).lexically_normal())
      throw unwritable(file, fmt::format("There is no folder {}. Make it first", in_quotes(folder.string())));
  }
}

CLI::Option* add_output_file(CLI::App& command, const std::string& names, std::string& path,
                             const std::string& meaning) {
  CLI::Option* option = add_option(command, names + " FILE", path, meaning);
  return option->each([option](const std::string& file) {
    if (file == "-") return;
    files_of_this_call().writes(file, option->get_name());
    outputs_of_this_call().files.push_back(file);
  });
}

void add_output_option(CLI::App& command, std::string& path) {
  add_output_file(command, "-o,--output", path, "Write to this file; - is standard output")->capture_default_str();
}

void add_quiet_flag(CLI::App& command, Output& output) {
  command.add_flag("--quiet", output.quiet, "Write no remarks on standard error, only errors");
}

void add_output_flags(CLI::App& command, Output& output, const std::string& json) {
  command.add_flag("--json", output.json, json);
  add_quiet_flag(command, output);
}

void add_output_options(CLI::App& command, Output& output, std::string_view otherwise) {
  add_output_flags(command, output, fmt::format("Write JSON instead of {}", otherwise));
  add_output_option(command, output.path);
}

void add_csv_option(CLI::App& command, Output& output) {
  add_option(command, "--csv-decimal MARK", output.csv.decimal,
             "Decimal mark of written CSV: . or , (then ; between cells)")
      ->check(CLI::IsMember({".", ","}).description(""))
      ->capture_default_str();
}

void add_figure_option(CLI::App& command, std::string& path) {
  add_output_file(command, "--figure", path,
                  "Draw the result as FILE.svg, FILE.pdf or FILE.png, and write its gnuplot script and data next to it")
      ->each([](const std::string& file) {
        const std::filesystem::path picture(file);
        const std::string name = picture.stem().string();
        files_of_this_call().writes(picture.parent_path() / (name + ".gp"), "--figure");
        files_of_this_call().writes_like(picture.parent_path(), name + "-", ".csv", "--figure");
      });
}

void add_figure_width_option(CLI::App& command, double& width) {
  add_option(command, "--figure-width CM", width,
             "With --report, width of the figures in centimetres: 17 for a page, 8.5 for a column")
      ->check(number_between(min_figure_width / 10, max_figure_width / 10))
      ->capture_default_str();
}

void add_report_option(CLI::App& command, std::string& folder, const std::string& meaning,
                       void (*announce)(CallFiles&, const std::string& folder, const std::string& option)) {
  add_option(command, "--report FOLDER", folder, meaning)->each([announce](const std::string& path) {
    if (!path.empty()) announce(files_of_this_call(), path, "--report");
    outputs_of_this_call().report = path;
  });
}

void add_threads_option(CLI::App& command, std::string_view option, unsigned& threads, const std::string& meaning) {
  threads = std::max(1U, std::thread::hardware_concurrency());
  add_option(command, option, threads, meaning)->check(CLI::Range(1U, 1024U))->default_str("the number of cores");
}

}  // namespace flexslip
