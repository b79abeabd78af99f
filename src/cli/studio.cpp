#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/options.h"
#include "io/call_files.h"
#include "io/input_error.h"
#include "platform/child_process.h"
#include "report/studio_page.h"

namespace flexslip {
namespace {

struct StudioRequest {
  std::vector<std::string> files;
  std::string output = "flexslip-studio.html";
  bool stay_closed = false;
};

// Opens a file with the default program of this computer.
bool opened(const std::string& page) {
  for (const std::string program : {"xdg-open", "wslview", "open"}) {
    const ChildResult result = run_child({program, page});
    if (result.status == ChildStatus::exited && result.exit_code == 0) return true;
  }
  return false;
}

void run_studio(const StudioRequest& request) {
  const auto built = built_studio_page();
  if (!built)
    throw InputError({.field = "studio",
                      .problem =
                          "The studio's page of version " FLEXSLIP_VERSION
                          ", flexslip-studio.html, is neither in the folder of the program nor in share/flexslip",
                      .remedy = "take it from a release, or build it: tools/build-studio in FlexSlip's repository, "
                                "which installs Emscripten and takes a few minutes"});
  if (request.output != "-") files_of_this_call().writes(request.output, "--output");
  std::vector<GivenTest> tests;
  for (const std::string& file : request.files) tests.push_back(with_its_files(file));
  write_studio_page(request.output, *built, tests);
  if (request.output == "-") return;
  const std::string page = std::filesystem::absolute(request.output).lexically_normal().string();
  std::cout << fmt::format("The studio: {}\n", page);
  if (!request.stay_closed && !opened(page))
    note(Output{}, "no browser was found: open the page in one; it needs no network");
}

}  // namespace

void add_studio_command(CLI::App& app) {
  const auto [command, request] =
      add_command(app, "studio", "A page to see and fit tests in a browser, without a network", run_studio);
  add_option(command, "files FILE", request.files,
             "Tests to open in it: case files, with the files that they name, or data files");
  add_output_file(command, "-o,--output", request.output, "Write the page to this file; - is standard output")
      ->capture_default_str();
  command.add_flag("--no-open", request.stay_closed, "Do not open the page in the browser");
  command.footer(
      "Writes one HTML file that holds the program as WebAssembly, and opens it. The page sends nothing anywhere. It "
      "is\n"
      "built by tools/build-studio, or comes with a release.\n\n"
      "Examples:\n"
      "  flexslip studio\n"
      "  flexslip studio examples/simulated/case.toml --output studio.html --no-open");
}

}  // namespace flexslip
