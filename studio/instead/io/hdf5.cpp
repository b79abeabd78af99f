// A page writes no HDF5 file, nor reads one: the program does, on a computer of its own.
#include "io/hdf5.h"

#include "io/input_error.h"

namespace flexslip {
namespace {

[[noreturn]] void refuse_file(const std::string& path) {
  throw InputError({.file = path,
                    .expected = "a computation that the studio can do",
                    .found = "a file of a sweep, HDF5",
                    .remedy = "run the same command with the program flexslip, outside the studio"});
}

}  // namespace

Hdf5File::Hdf5File(std::string path) : path_(std::move(path)) { refuse(); }
Hdf5File::~Hdf5File() = default;
void Hdf5File::refuse() const { refuse_file(path_); }

// Nothing of these is reached, since there is no such file.
void Hdf5File::add_group(const std::string&) { refuse(); }
void Hdf5File::add_column(const std::string&, std::uint64_t, StoredAs) { refuse(); }
void Hdf5File::write_rows(const std::string&, std::uint64_t, std::span<const double>) { refuse(); }
void Hdf5File::describe(const std::string&, const std::string&, std::string_view) { refuse(); }
void Hdf5File::describe(const std::string&, const std::string&, std::span<const std::string>) { refuse(); }
void Hdf5File::describe(const std::string&, const std::string&, double) { refuse(); }
void Hdf5File::describe(const std::string&, const std::string&, std::uint64_t) { refuse(); }
void Hdf5File::describe(const std::string&, const std::string&, std::span<const std::uint64_t>) { refuse(); }
void Hdf5File::finish() { refuse(); }

std::optional<std::string> hdf5_text(const std::string& path, const std::string&) { refuse_file(path); }

}  // namespace flexslip
