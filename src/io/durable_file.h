// Files that are there whole or not at all, whatever happens to the program or the computer while they are written.
#pragma once

#include <filesystem>
#include <string_view>

namespace flexslip {

// Is this the name of a file that was being written?
bool is_unfinished(const std::filesystem::path& file);

// Writes a whole file so.
// Fails:      InputError, with nothing left behind.
void write_durably(const std::filesystem::path& file, std::string_view bytes);

// A file that takes long to write: beside it, always under the same name, so that what a program left there that was killed is
// replaced by the next one; and locked, as two that wrote it at once would spoil it.
class UnfinishedFile {
 public:
  // Fails:      InputError if another program is writing it.
  explicit UnfinishedFile(std::filesystem::path file);
  ~UnfinishedFile();  // removes it unless it is finished
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  const std::filesystem::path& name() const { return name_; }

  // Gives it its name, replacing a file that is there. When this returns, it outlives a power cut.
  // Fails:      InputError.
  void finish();

 private:
  std::filesystem::path file_, name_;
  int lock_ = -1;  // descriptor
  bool is_finished_ = false;
};

}  // namespace flexslip
