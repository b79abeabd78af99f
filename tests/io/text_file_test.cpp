#include "io/text_file.h"

#include <cstdint>
#include <filesystem>
#include <string>

#include <doctest/doctest.h>

#include "tests/has.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

using namespace flexslip;

TEST_CASE("text file: one of more than 2 GiB is refused before it is read") {
  const TemporaryFolder folder;
  const std::string path = folder.file("long.csv", "1,2\n");
  std::filesystem::resize_file(path, (std::uintmax_t{1} << 31) + 1);  // takes no room on the disk
  CHECK(message_of([&] { bytes_of(path); }) ==
        path + ": The file has more than 2 GiB. Split it, or export fewer readings a second.");
}

TEST_CASE("text file: what begins with a MiB of NUL characters is not read to its end, which /dev/zero has not") {
  const TemporaryFolder folder;
  const std::string path = folder.file("zeros.csv", std::string(1 << 20, '\0') + "1,2\n");
  CHECK(has(message_of([&] { bytes_of(path); }),
            "The first MiB of the file holds nothing but NUL characters. Copy the file again"));
  CHECK(has(message_of([] { bytes_of("/dev/zero"); }),
            "/dev/zero: The first MiB of the file holds nothing but NUL characters"));
  CHECK(bytes_of(folder.file("some.csv", std::string(9, '\0'))).size() == 9);
}
