#include "io/hdf5.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <limits>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

#include <doctest/doctest.h>

#include "io/child_process.h"
#include "io/text_file.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

namespace flexslip {
namespace {

constexpr std::uint64_t rows = 100'000;  // more than a chunk has

std::string write_some_file(const std::filesystem::path& path, std::uint64_t rows_at_a_time) {
  std::vector<double> values(rows);
  std::iota(values.begin(), values.end(), 0.5);
  values[1] = std::numeric_limits<double>::quiet_NaN();
  values[2] = std::numeric_limits<double>::infinity();
  Hdf5File file(path.string());
  file.describe("/", "title", "µ of it all");
  file.describe("/", "names", std::vector<std::string>{"one", "two words"});
  file.describe("/", "shape", std::vector<std::uint64_t>{20, 5000});
  file.describe("/", "seed", std::numeric_limits<std::uint64_t>::max());
  file.add_group("/outcomes");
  file.add_column("/outcomes/force", rows, StoredAs::float64);
  file.describe("/outcomes/force", "least", 0.1);
  file.add_column("/outcomes/snaps", rows, StoredAs::uint32);
  file.add_column("/outcomes/status", rows, StoredAs::uint8);
  const std::vector<double> counts(rows, 7);
  for (std::uint64_t first = 0; first < rows; first += rows_at_a_time) {
    const std::uint64_t count = std::min(rows_at_a_time, rows - first);
    file.write_rows("/outcomes/force", first, std::span(values).subspan(first, count));
    file.write_rows("/outcomes/snaps", first, std::span(counts).subspan(first, count));
    file.write_rows("/outcomes/status", first, std::span(counts).subspan(first, count));
  }
  file.finish();
  return bytes_of(path);
}

TEST_CASE("outside: h5py reads the numbers, types and descriptions that were written") {
  const TemporaryFolder folder;
  write_some_file(folder.path() / "some.h5", 30'000);
  const auto said = run_child({"/usr/bin/python3", "-c", R"(
import h5py, numpy
f = h5py.File("some.h5")
assert f.attrs["title"] == "µ of it all" and list(f.attrs["names"]) == ["one", "two words"]
assert list(f.attrs["shape"]) == [20, 5000] and f.attrs["seed"] == 2**64 - 1
force, snaps, status = (f["outcomes"][name] for name in ("force", "snaps", "status"))
assert (force.dtype, snaps.dtype, status.dtype) == ("f8", "u4", "u1")
expected = numpy.arange(100_000) + 0.5
expected[1:3] = numpy.nan, numpy.inf
assert numpy.array_equal(force[:], expected, equal_nan=True) and force.attrs["least"] == 0.1
assert (snaps[:] == 7).all() and (status[:] == 7).all()
assert force.compression == "gzip" and force.shuffle and force.fletcher32
)"},
                              folder.path().string());
  if (said.output.find("No module named 'h5py'") != std::string::npos) {
    MESSAGE("skipped: no python3-h5py");
    return;
  }
  CHECK(said.output == "");
  CHECK(said.exit_code == 0);
}

TEST_CASE("identity: the same bytes a second later, and in another file") {
  const TemporaryFolder folder;
  const std::string bytes = write_some_file(folder.path() / "a.h5", rows);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // the times of HDF5 are in seconds
  CHECK(write_some_file(folder.path() / "b.h5", rows) == bytes);
}

TEST_CASE("identity: a text of the root comes back; what is no such file has none") {
  const TemporaryFolder folder;
  const auto path = (folder.path() / "some.h5").string();
  write_some_file(path, rows);
  CHECK(hdf5_text(path, "title") == "µ of it all");
  CHECK(!hdf5_text(path, "nothing"));
  CHECK(!hdf5_text(path, "seed"));
  CHECK(!hdf5_text(path, "names"));  // two of them
  CHECK(!hdf5_text(folder.file("text.h5", "no HDF5"), "title"));
  CHECK(!hdf5_text((folder.path() / "absent.h5").string(), "title"));
}

TEST_CASE("identity: numbers of a column come back, whatever they are stored as; one that is not there is named") {
  const TemporaryFolder folder;
  const auto path = (folder.path() / "some.h5").string();
  write_some_file(path, 30'000);
  const auto force = hdf5_column(path, "/outcomes/force");
  REQUIRE(force.size() == rows);
  CHECK(force.front() == 0.5);
  CHECK(force[1] != force[1]);
  CHECK(force.back() == rows - 0.5);
  for (const char* counts : {"/outcomes/snaps", "/outcomes/status"})
    CHECK(hdf5_column(path, counts) == std::vector<double>(rows, 7));
  CHECK(message_of([&] { hdf5_column(path, "/outcomes/nothing"); }).find("/outcomes/nothing") != std::string::npos);
  CHECK(message_of([&] { hdf5_column(folder.file("text.h5", "no HDF5"), "/a"); }).find("text.h5") != std::string::npos);
}

TEST_CASE("table: a file that cannot be written is refused by its name, with the system's reason") {
  const TemporaryFolder folder;
  const auto path = (folder.path() / "absent" / "some.h5").string();
  const std::string message = message_of([&] { Hdf5File file(path); });
  CHECK(message.find("absent/some.h5") != std::string::npos);
  CHECK(message.find("No such file or directory") != std::string::npos);
  Hdf5File file((folder.path() / "some.h5").string());
  CHECK(message_of([&] { file.describe("/absent", "title", "some"); }).find("an error of HDF5") == std::string::npos);
  file.describe("/", "title", "some");
  CHECK(message_of([&] { file.describe("/", "title", "again"); }).find("already exists") != std::string::npos);
}

}  // namespace
}  // namespace flexslip
