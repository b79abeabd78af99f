// The studio's page with tests inside: one HTML file, which tools/build-studio builds and a release brings along.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "case/case_file.h"

namespace flexslip {

struct GivenFile {
  std::string name;   // in the page; of a case's files "<test>/<file>"
  std::string bytes;  // as they are
};

// A case file with the files that it names, or a table or export by itself.
struct GivenTest {
  std::string open;  // the file to open
  std::vector<GivenFile> files;
};

// The page as it was built: beside the program, installed with it in share/flexslip, or in build/studio of the repository that the program was built
// in. None if none of these holds one of this version.
std::optional<std::filesystem::path> built_studio_page();

// A file and, if it is a case file, the files that it names. A case whose files lie elsewhere than beside it is written anew, with their names alone.
// Fails:      InputError if one cannot be read, or is greater than 300 MB.
GivenTest taken_along(const std::string& file);

// A case with its files, under the name of a test. Likewise.
GivenTest taken_along(Test input, const std::string& test);

// Writes the page with tests inside.
// Fails:      InputError if it cannot be written, or the page is none.
void write_studio_page(const std::string& path, const std::filesystem::path& built,
                       const std::vector<GivenTest>& tests);

}  // namespace flexslip
