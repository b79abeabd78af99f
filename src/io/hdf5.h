// Columns of numbers in an HDF5 file that describes itself, for h5py and MATLAB's h5read.
//
// The same calls give the same bytes: the file holds no times.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace flexslip {

enum class StoredAs { float64, uint32, uint8 };

// A file being written. What stands in it is named by its path, "/outcomes/snaps"; its root is "/".
// Fails:      every function with an InputError that names the file, if it cannot be written or the disk is full.
class Hdf5File {
 public:
  // Replaces a file that is there, and does not lock it: UnfinishedFile does.
  explicit Hdf5File(std::string path);
  ~Hdf5File();  // an unfinished file is closed, whatever it holds
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  void add_group(const std::string& path);

  // A column of so many rows, all 0: in chunks, shuffled, deflated and with checksums, in a group that is there.
  // Domain:     rows >= 1.
  void add_column(const std::string& path, std::uint64_t rows, StoredAs stored_as);

  // Writes rows of a column from `first` on.
  // Domain:     a column that was added; values that its type holds; rows that it has.
  // Cost:       about 20 µs, and 10 ns a row, where each call goes on from the last one; memory for one chunk of each column.
  void write_rows(const std::string& path, std::uint64_t first, std::span<const double> values);

  // Describes the root, a group or a column.
  // Domain:     texts without NUL, lists that are not empty.
  void describe(const std::string& path, const std::string& name, std::string_view text);
  void describe(const std::string& path, const std::string& name, std::span<const std::string> texts);
  void describe(const std::string& path, const std::string& name, double number);
  void describe(const std::string& path, const std::string& name, std::uint64_t number);
  void describe(const std::string& path, const std::string& name, std::span<const std::uint64_t> numbers);

  // All is written when this returns.
  void finish();

 private:
  struct Attribute {
    std::int64_t space, stored_type, memory_type;
    const void* values;
  };
  void add_attribute(const std::string& path, const std::string& name, const Attribute& attribute);
  // While what failed is still open: to close it would clear HDF5's reason.
  [[noreturn]] void refuse() const;

  std::string path_;
  std::int64_t file_ = -1;  // HDF5's identifiers; negative: none
  std::map<std::string, std::int64_t> columns_{};
};

// A text that describes the root of a file; none if it is no HDF5 file, or has no such text.
std::optional<std::string> hdf5_text(const std::string& path, const std::string& name);

// The numbers of a column, whatever they are stored as.
// Fails:      InputError that names the file and the column, if it has none of that path or cannot be read.
std::vector<double> hdf5_column(const std::string& path, const std::string& column);

}  // namespace flexslip
