// The studio page with tests in it: one HTML file, which tools/build-studio builds and a release
// includes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "case/case_file.h"

namespace flexslip {

struct GivenFile {
  std::string name;   // on the page; for files of a case "<test>/<file>"
  std::string bytes;  // unchanged
};

// A case file with the files that it names, or one table or export.
struct GivenTest {
  std::string open;  // the file to open
  std::vector<GivenFile> files;
};

// The built page of this version: next to the program, in share/flexslip of its installation, or in
// build/studio of the repository. Empty if none exists.
std::optional<std::filesystem::path> built_studio_page();

// A file and, for a case file, the files that it names. If these are in other folders, the case is
// rewritten with their names alone.
// Fails:      throws InputError if a file cannot be read or exceeds 300 MB.
GivenTest with_its_files(const std::string& file);

// A case with its files, under the name of a test.
// Fails:      as above.
GivenTest with_its_files(Test input, const std::string& test);

// Writes the page with tests in it.
// Fails:      throws InputError if it cannot be written, or if `built` is no studio page.
void write_studio_page(const std::string& path, const std::filesystem::path& built,
                       const std::vector<GivenTest>& tests);

}  // namespace flexslip
