#include "io/hdf5.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

#include <hdf5.h>

#include "io/input_error.h"

namespace flexslip {
namespace {

static_assert(std::is_same_v<hid_t, std::int64_t>);

constexpr hsize_t chunk_rows = 1 << 15;  // 256 KiB of numbers: what is kept in memory of each column
constexpr unsigned deflate_level = 1;    // higher ones make sweeps smaller by 2 %, measured, at up to thrice the time

// One thing that HDF5 has open.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;

  hid_t id() const { return id_; }
  bool is_open() const { return id_ >= 0; }

 private:
  hid_t id_;
  Close close_;
};

// Before any file is opened, as HDF5 looks only once whether to lock. It empties a file before it locks it, too late for the
// program that has the lock: so who writes it has to lock it, whatever the environment says. Errors are thrown, and not printed;
// HDF5 may do that before main.
void prepare() {
  setenv("HDF5_USE_FILE_LOCKING", "FALSE", 1);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

// What HDF5 says of the first thing that went wrong, the one that the others follow from.
std::string reason_of_failure() {
  std::string reason;
  const auto take = [](unsigned, const H5E_error2_t* error, void* first) -> herr_t {
    *static_cast<std::string*>(first) = error->desc;
    return 1;  // enough
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take, &reason);
  // Errors of the system come with much else: "..., errno = 28, error message = 'No space left on device', ...".
  constexpr std::string_view quote = "error message = '";
  if (const std::size_t at = reason.find(quote); at != std::string::npos) {
    const std::size_t begin = at + quote.size();
    reason = reason.substr(begin, reason.find('\'', begin) - begin);
  }
  return reason.empty() ? "an error of HDF5" : reason;
}

hid_t file_type(StoredAs stored_as) {
  switch (stored_as) {
    case StoredAs::float64:
      return H5T_IEEE_F64LE;
    case StoredAs::uint32:
      return H5T_STD_U32LE;
    case StoredAs::uint8:
      return H5T_STD_U8LE;
  }
  return H5I_INVALID_HID;
}

// Text as h5py and MATLAB expect it: UTF-8 of any length.
class TextType : public Handle {
 public:
  TextType() : Handle(H5Tcopy(H5T_C_S1), H5Tclose) {
    H5Tset_size(id(), H5T_VARIABLE);
    H5Tset_cset(id(), H5T_CSET_UTF8);
  }
};

}  // namespace

Hdf5File::Hdf5File(std::string path) : path_(std::move(path)) {
  prepare();
  file_ = H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  if (file_ < 0) refuse();
}

Hdf5File::~Hdf5File() {
  for (const auto& [path, column] : columns_) H5Dclose(column);
  if (file_ >= 0) H5Fclose(file_);
}

void Hdf5File::add_group(const std::string& path) {
  const Handle properties(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
  H5Pset_obj_track_times(properties.id(), false);
  const Handle group(H5Gcreate2(file_, path.c_str(), H5P_DEFAULT, properties.id(), H5P_DEFAULT), H5Gclose);
  if (!group.is_open()) refuse();
}

void Hdf5File::add_column(const std::string& path, std::uint64_t rows, StoredAs stored_as) {
  const hsize_t size = rows;
  const hsize_t chunk = std::min(size, chunk_rows);
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
  const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  const bool are_set = H5Pset_chunk(properties.id(), 1, &chunk) >= 0 && H5Pset_shuffle(properties.id()) >= 0 &&
                       H5Pset_deflate(properties.id(), deflate_level) >= 0 && H5Pset_fletcher32(properties.id()) >= 0 &&
                       H5Pset_obj_track_times(properties.id(), false) >= 0;
  constexpr std::size_t slots = 521;  // as HDF5 has it: more than the chunks that there are
  const Handle access(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose);
  if (!are_set || H5Pset_chunk_cache(access.id(), slots, chunk * sizeof(double), 1) < 0) refuse();
  const hid_t column =
      H5Dcreate2(file_, path.c_str(), file_type(stored_as), space.id(), H5P_DEFAULT, properties.id(), access.id());
  if (column < 0) refuse();
  columns_.emplace(path, column);
}

void Hdf5File::write_rows(const std::string& path, std::uint64_t first, std::span<const double> values) {
  const hsize_t begin = first;
  const hsize_t count = values.size();
  const hid_t column = columns_.at(path);
  const Handle there(H5Dget_space(column), H5Sclose);
  const Handle here(H5Screate_simple(1, &count, nullptr), H5Sclose);
  if (H5Sselect_hyperslab(there.id(), H5S_SELECT_SET, &begin, nullptr, &count, nullptr) < 0 ||
      H5Dwrite(column, H5T_NATIVE_DOUBLE, here.id(), there.id(), H5P_DEFAULT, values.data()) < 0)
    refuse();
}

void Hdf5File::describe(const std::string& path, const std::string& name, std::string_view text) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const TextType type;
  const std::string terminated(text);
  const char* const pointer = terminated.c_str();
  add_attribute(path, name, {space.id(), type.id(), type.id(), &pointer});
}

void Hdf5File::describe(const std::string& path, const std::string& name, std::span<const std::string> texts) {
  const hsize_t size = texts.size();
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
  const TextType type;
  std::vector<const char*> pointers;
  pointers.reserve(texts.size());
  for (const std::string& text : texts) pointers.push_back(text.c_str());
  add_attribute(path, name, {space.id(), type.id(), type.id(), pointers.data()});
}

void Hdf5File::describe(const std::string& path, const std::string& name, double number) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  add_attribute(path, name, {space.id(), H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, &number});
}

void Hdf5File::describe(const std::string& path, const std::string& name, std::uint64_t number) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  add_attribute(path, name, {space.id(), H5T_STD_U64LE, H5T_NATIVE_UINT64, &number});
}

void Hdf5File::describe(const std::string& path, const std::string& name, std::span<const std::uint64_t> numbers) {
  const hsize_t size = numbers.size();
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
  add_attribute(path, name, {space.id(), H5T_STD_U64LE, H5T_NATIVE_UINT64, numbers.data()});
}

void Hdf5File::add_attribute(const std::string& path, const std::string& name, const Attribute& attribute) {
  const Handle object(H5Oopen(file_, path.c_str(), H5P_DEFAULT), H5Oclose);
  if (!object.is_open()) refuse();
  const Handle added(
      H5Acreate2(object.id(), name.c_str(), attribute.stored_type, attribute.space, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  if (!added.is_open() || H5Awrite(added.id(), attribute.memory_type, attribute.values) < 0) refuse();
}

void Hdf5File::finish() {
  for (const auto& [path, column] : std::exchange(columns_, {}))
    if (H5Dclose(column) < 0) refuse();
  const hid_t file = std::exchange(file_, H5I_INVALID_HID);
  if (H5Fclose(file) < 0) refuse();
}

void Hdf5File::refuse() const { throw unwritable(path_, reason_of_failure()); }

std::optional<std::string> hdf5_text(const std::string& path, const std::string& name) {
  prepare();
  errno = 0;
  if (!std::ifstream(path) && errno != ENOENT) throw unreadable(path, std::generic_category().message(errno));
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!file.is_open()) return std::nullopt;
  const Handle attribute(H5Aopen(file.id(), name.c_str(), H5P_DEFAULT), H5Aclose);
  const Handle space(H5Aget_space(attribute.id()), H5Sclose);
  const TextType type;
  char* text = nullptr;
  if (H5Sget_simple_extent_npoints(space.id()) != 1 || H5Aread(attribute.id(), type.id(), &text) < 0 || !text)
    return std::nullopt;
  std::string copy(text);
  H5free_memory(text);
  return copy;
}

std::vector<double> hdf5_column(const std::string& path, const std::string& column) {
  prepare();
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  const Handle data(file.is_open() ? H5Dopen2(file.id(), column.c_str(), H5P_DEFAULT) : -1, H5Dclose);
  const Handle space(data.is_open() ? H5Dget_space(data.id()) : -1, H5Sclose);
  const hssize_t rows = space.is_open() ? H5Sget_simple_extent_npoints(space.id()) : -1;
  std::vector<double> values(rows > 0 ? static_cast<std::size_t>(rows) : 0);
  if (rows < 0 || H5Dread(data.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    throw InputError(
        {.file = path, .field = column, .expected = "a column that can be read", .found = reason_of_failure()});
  return values;
}

}  // namespace flexslip
